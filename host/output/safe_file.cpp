#include "host/output/safe_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "host/error.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
    throw Error(ExitCode::file, fmt::format("cannot write {}: {}", path, why));
}

fs::path folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

void require_writable(const std::string& path) {
    std::error_code error;
    const fs::path folder = folder_of(path);
    if (path.empty() || fs::path(path).filename().empty()) cannot_write(path, "it names no file");
    if (fs::is_directory(path, error)) cannot_write(path, "it is a directory");
    if (error == std::errc::filename_too_long) cannot_write(path, error.message());
    if (!fs::exists(folder, error)) cannot_write(path, "its folder does not exist");
    if (!fs::is_directory(folder, error)) cannot_write(path, "its folder is not a directory");
    if (access(folder.c_str(), W_OK | X_OK) != 0) cannot_write(path, std::strerror(errno));
}

// The name is short, so that any name that can be written can be written beside.
PartFile::PartFile(const std::string& path)
    : path_((require_writable(path), path)),
      beside_((folder_of(path) /
               fmt::format(".pxm-part-{}{}", getpid(), fs::path(path).extension().string()))
                  .string()),
      guard_(beside_) {}

PartFile::~PartFile() {
    std::error_code ignored;
    if (!committed_) fs::remove(beside_, ignored);
}

void PartFile::commit() {
    std::error_code error;
    fs::rename(beside_, path_, error);
    if (error) cannot_write(path_, error.message());
    committed_ = true;
}

void write_safely(const std::string& path, const std::function<void(const std::string&)>& write) {
    PartFile file(path);
    write(file.beside());
    file.commit();
}

void write_text_safely(const std::string& path, const std::string& text) {
    write_safely(path, [&](const std::string& beside) {
        std::ofstream file(beside, std::ios::binary);
        file << text;
        file.close();
        if (!file) cannot_write(path, "the disk may be full");
    });
}

}  // namespace pxm::host
