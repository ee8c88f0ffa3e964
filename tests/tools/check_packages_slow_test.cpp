// tools/check_packages on this build, with lists from which lines were taken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr int not_checked = 77;  // no dpkg, or not a build of ninja's

struct Verdict {
    int exit_code;
    std::string text;
};

/// A list of tools/ without some of its packages.
std::string list_without(const std::string& list, const std::set<std::string>& packages) {
    std::istringstream lines(text_of(fs::path(source_dir) / "tools" / list));
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!packages.contains(line)) kept += line + '\n';
    return kept;
}

/// What is said of this build if neither list had these packages.
Verdict check_without(const std::set<std::string>& packages) {
    const Folder folder;
    folder.write("program", list_without("packages.txt", packages));
    folder.write("tests", list_without("packages-test.txt", packages));
    const fs::path build = fs::path(binary).parent_path().parent_path();
    const std::string command = "'" + source_dir + "/tools/check_packages' '" + build.string() +
                                "' --packages '" + folder.path("program") + "' --packages-test '" +
                                folder.path("tests") + "' >'" + folder.path("said") + "' 2>&1";
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), folder.read("said")};
}

TEST(CheckPackages, the_lists_bring_what_this_build_used) {
    const Verdict verdict = check_without({});
    if (verdict.exit_code == not_checked) GTEST_SKIP() << verdict.text;
    EXPECT_EQ(verdict.exit_code, 0) << verdict.text;
    EXPECT_THAT(verdict.text, HasSubstr("are of packages that the lists bring"));
}

TEST(CheckPackages, a_package_that_is_missing_from_a_list_is_named) {
    const std::set<std::string> taken{"libboost-dev", "libglm-dev", "ninja-build", "libgtest-dev",
                                      "librapidcheck-dev"};
    const Verdict verdict = check_without(taken);
    if (verdict.exit_code == not_checked) GTEST_SKIP() << verdict.text;
    EXPECT_EQ(verdict.exit_code, 1);
    const std::string program = "tools/packages.txt lacks ";
    const std::string tests = "tools/packages.txt or tools/packages-test.txt lacks ";
    // A header, headers alone behind a package of another name, a tool, and two of the tests'
    // alone.
    EXPECT_THAT(verdict.text, HasSubstr(program + "libglm-dev: /usr/include/glm/"));
    EXPECT_THAT(verdict.text, HasSubstr(program + "libboost1."));
    EXPECT_THAT(verdict.text, HasSubstr(program + "ninja-build: "));
    EXPECT_THAT(verdict.text, HasSubstr(tests + "librapidcheck-dev: "));
    EXPECT_THAT(verdict.text, Not(HasSubstr(program + "librapidcheck-dev")));
    EXPECT_THAT(verdict.text, Not(HasSubstr("libeigen3-dev")));
}

TEST(CheckPackages, a_library_that_a_module_loads_is_looked_at) {
    const Verdict verdict = check_without({"libopenimageio-dev", "openimageio-tools"});
    if (verdict.exit_code == not_checked) GTEST_SKIP() << verdict.text;
    EXPECT_EQ(verdict.exit_code, 1);
    EXPECT_THAT(verdict.text, HasSubstr("used by lib/pxm/pxm_openimageio.so, when it starts"));
}

}  // namespace
}  // namespace pxm::test
