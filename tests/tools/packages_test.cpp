// The lists of packages, the libraries that CMake looks for and those that `pxm --version` names
// agree.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(fs::path(source_dir) / path).rdbuf();
    return text.str();
}

std::set<std::string> packages_of(const std::string& list) {
    std::set<std::string> packages;
    std::istringstream lines(text_of(list));
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && !line.starts_with('#')) packages.insert(line);
    return packages;
}

struct Library {
    std::string name;
    std::string package;
};

/// What `needs(NAME PACKAGE ...)` and `missing(NAME PACKAGE)` say in a file of CMake.
std::vector<Library> libraries_of(const std::string& text) {
    static const std::regex call(R"re(^ *(needs|missing)\((\w[\w.-]*|"[^"]*") ([\w+.-]+))re",
                                 std::regex::multiline);
    std::vector<Library> libraries;
    for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it)
        libraries.push_back({(*it)[2], (*it)[3]});
    return libraries;
}

TEST(Packages, every_library_of_the_program_names_a_package_that_the_program_lists) {
    const std::set<std::string> listed = packages_of("tools/packages.txt");
    const std::vector<Library> libraries = libraries_of(text_of("cmake/dependencies.cmake"));
    EXPECT_GT(libraries.size(), 10U);
    for (const Library& library : libraries)
        EXPECT_TRUE(listed.contains(library.package)) << library.name << " " << library.package;
}

TEST(Packages, no_library_is_looked_for_without_naming_its_package) {
    const std::regex bare(R"(find_(package|library)\()");
    for (const char* folder : {"cmake", "pxm", "dsp_kernels", "host"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / folder)) {
            const fs::path& path = entry.path();
            if (path.extension() != ".cmake" && path.filename() != "CMakeLists.txt") continue;
            const std::string text = text_of(fs::relative(path, source_dir));
            const auto found = std::distance(std::sregex_iterator(text.begin(), text.end(), bare),
                                             std::sregex_iterator());
            // needs() has the one call; the Python module and the one for OpenVDB, which may be
            // left out, have two each and name their packages when they are.
            const bool may_be_left_out =
                path.filename() == "python.cmake" || path.filename() == "openvdb.cmake";
            EXPECT_EQ(found, path.filename() == "dependencies.cmake" ? 1
                             : may_be_left_out                       ? 2
                                                                     : 0)
                << path << ": use needs()";
        }
    }
}

TEST(Packages, no_package_is_in_both_lists) {
    for (const std::string& package : packages_of("tools/packages-test.txt"))
        EXPECT_FALSE(packages_of("tools/packages.txt").contains(package)) << package;
}

TEST(Packages, the_version_names_every_library) {
    const Folder folder;
    const std::string out = run(folder, {"--version"}).out;
    const std::regex looked_for(R"(\nneeds\((\S+))");
    const std::string text = text_of("cmake/dependencies.cmake");
    for (std::sregex_iterator it(text.begin(), text.end(), looked_for), end; it != end; ++it)
        EXPECT_NE(out.find((*it)[1]), std::string::npos) << (*it)[1] << " in " << out;
    EXPECT_NE(out.find("Random123"), std::string::npos) << out;
}

}  // namespace
}  // namespace pxm::test
