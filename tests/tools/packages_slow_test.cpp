// A library that is not there ends the configuration with the name of the package that brings it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

using testing::HasSubstr;

/// The text of several lines with single spaces: CMake breaks a message's lines where it likes.
std::string in_one_line(const std::string& text) {
    return std::regex_replace(text, std::regex(R"(\s+)"), " ");
}

/// What CMake says of cmake/dependencies.cmake with these definitions.
std::string configured(const Folder& folder, const std::string& definitions) {
    const std::string command = "cmake -G Ninja -S '" + folder.path() + "' -B '" +
                                folder.path("build") + "' " + definitions + " >'" +
                                folder.path("said") + "' 2>&1";
    const int status = std::system(command.c_str());
    return (WEXITSTATUS(status) == 0 ? "done " : "failed ") + in_one_line(folder.read("said"));
}

TEST(Packages, a_missing_library_is_named_with_the_package_that_brings_it) {
    const Folder folder;
    folder.write("CMakeLists.txt",
                 "cmake_minimum_required(VERSION 3.25)\nproject(libraries LANGUAGES CXX)\n"
                 "include(" +
                     source_dir + "/cmake/dependencies.cmake)\n");
    EXPECT_THAT(configured(folder, ""), HasSubstr("done "));

    const std::string text =
        text_of(std::filesystem::path(source_dir) / "cmake/dependencies.cmake");
    static const std::regex needed(R"(\nneeds\((\S+) (\S+) (\w+))");
    int libraries = 0;
    for (std::sregex_iterator it(text.begin(), text.end(), needed), end; it != end; ++it) {
        const std::string disable = "CMAKE_DISABLE_FIND_PACKAGE_" + (*it)[3].str();
        const std::string said = configured(folder, "-D" + disable + "=ON");
        EXPECT_THAT(said, HasSubstr("failed "));
        EXPECT_THAT(said, HasSubstr((*it)[1].str() + " is missing: install Debian's " +
                                    (*it)[2].str() + " "));
        EXPECT_THAT(configured(folder, "-D" + disable + "=OFF"), HasSubstr("done "));
        ++libraries;
    }
    EXPECT_GT(libraries, 8);
}

}  // namespace
}  // namespace pxm::test
