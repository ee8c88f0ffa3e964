// A folder for one test.
#pragma once

#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace pxm::test {

/// A new empty folder, removed with all it holds at the end of the test.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string path(const std::string& name = "") const;
    void write(const std::string& name, const std::string& text) const;
    [[nodiscard]] std::string read(const std::string& name) const;
    [[nodiscard]] bool has(const std::string& name) const;
    /// Everything in it by name, hidden files too, with the files' bytes.
    [[nodiscard]] std::map<std::string, std::string> contents() const;
    /// The names alone, sorted.
    [[nodiscard]] std::vector<std::string> names() const;

  private:
    std::filesystem::path path_;
};

/// What was written to a stream so far.
[[nodiscard]] std::string text_of(std::FILE* file);
/// The bytes of a file; empty if there is none.
[[nodiscard]] std::string text_of(const std::filesystem::path& path);

}  // namespace pxm::test
