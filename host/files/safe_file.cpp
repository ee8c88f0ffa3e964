#include "host/files/safe_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "host/files/new_folder.hpp"
#include "host/files/new_part.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

constexpr mode_t permissions = 0777;
constexpr mode_t of_group = 0070, of_others = 0007;
constexpr int others_to_group = 3;  // bits

std::string temporary_folder() {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    return error ? "/tmp" : folder.string();
}

}  // namespace

void require_writable(const std::string& path) { (void)find_destination(path); }

PartFile::PartFile(const std::string& path, Places places, LeftParts left)
    : destination_(find_destination(path)) {
    if (destination_.is_file || places == Places::any) {
        make(left);
        return;
    }
    file_ = std::make_unique<CheckedFile>(open_destination(destination_), path, Places::in_order);
}

/// Nobody may read what will be in a file that was closed to him.
void PartFile::make(LeftParts left) {
    constexpr mode_t own = 0600, by_umask = 0666;
    const std::string folder = destination_.is_file ? destination_.folder() : temporary_folder();
    if (left == LeftParts::remove) remove_left_parts(folder);
    NewPart part = make_part(folder, fs::path(destination_.named).extension().string(),
                             destination_.is_file && !destination_.existing ? by_umask : own);
    if (!part.error.empty()) cannot_write(destination_.named, part.error);
    beside_.swap(part.path);
    // What is thrown from here on is thrown by a constructor, after which no destructor runs.
    try {
        guard_.emplace(beside_);
        file_ = std::make_unique<CheckedFile>(part.descriptor, destination_.named, Places::any);
    } catch (...) {
        unlink(beside_.c_str());
        throw;
    }
}

PartFile::~PartFile() {
    if (!beside_.empty()) unlink(beside_.c_str());
}

void PartFile::commit() {
    file_->sync();
    if (beside_.empty()) return;
    if (!destination_.is_file) return copy_to_destination();
    keep_owner_and_mode();
    if (rename(beside_.c_str(), destination_.path.c_str()) != 0)
        cannot_write(destination_.named, strerror(errno));
    beside_.clear();
    sync_folder(destination_.folder());
}

/// Only root can give files away. A group that cannot be kept loses its rights to another one.
void PartFile::keep_owner_and_mode() {
    if (!destination_.existing) return;
    const struct stat& old = *destination_.existing;
    mode_t mode = old.st_mode & permissions;
    const bool owner_kept = fchown(file_->descriptor(), old.st_uid, old.st_gid) == 0;
    if (!owner_kept && fchown(file_->descriptor(), static_cast<uid_t>(-1), old.st_gid) != 0) {
        mode = (mode & ~of_group) | (mode & of_others) << others_to_group;
    }
    if (fchmod(file_->descriptor(), mode) != 0) cannot_write(destination_.named, strerror(errno));
}

void PartFile::copy_to_destination() {
    CheckedFile target(open_destination(destination_), destination_.named, Places::in_order);
    std::array<char, 1 << 16> bytes;
    std::int64_t at = 0;
    while (const std::size_t got = file_->read_at(at, bytes.data(), bytes.size())) {
        target.append(bytes.data(), got);
        at += static_cast<std::int64_t>(got);
    }
    if (at != file_->size()) cannot_write(destination_.named, "what was to be copied is gone");
    target.sync();
}

void write_safely(const std::string& path, const std::function<void(CheckedFile&)>& write) {
    PartFile part(path, Places::in_order);
    write(part.file());
    part.commit();
}

void write_text_safely(const std::string& path, const std::string& text) {
    write_safely(path, [&](CheckedFile& file) { file.append(text.data(), text.size()); });
}

}  // namespace pxm::host
