#include "tests/support/folder.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace pxm::test {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string text_of(std::FILE* file) {
    std::string text;
    char buffer[4096];
    std::rewind(file);
    for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, file)) > 0;) {
        text.append(buffer, n);
    }
    return text;
}

Folder::Folder() {
    std::string pattern = (fs::temp_directory_path() / "pxm-test-").string();
    pattern.append(6, 'X');  // mkdtemp replaces them
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string Folder::path(const std::string& name) const { return (path_ / name).string(); }

void Folder::write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const { return text_of(path_ / name); }

bool Folder::has(const std::string& name) const { return fs::exists(path_ / name); }

std::map<std::string, std::string> Folder::contents() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(path_)) {
        all[fs::relative(entry.path(), path_).string()] =
            entry.is_regular_file() ? text_of(entry.path()) : "";
    }
    return all;
}

std::vector<std::string> Folder::names() const {
    std::vector<std::string> list;
    for (const auto& [name, text] : contents()) list.push_back(name);
    return list;
}

}  // namespace pxm::test
