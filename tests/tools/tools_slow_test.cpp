// tools/pxm in a tree of its own, with stand-ins for cmake, dpkg, apt-get, sudo and id.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

struct Outcome {
    int exit_code;
    std::string out;
    std::string err;
};

/// A copy of tools/ in a tree with one source, and a folder of stand-ins that comes first in PATH.
class Tools : public testing::Test {
  protected:
    Tools() {
        std::string pattern =
            (fs::temp_directory_path() / ("pxm_tools_" + std::string(6, 'X'))).string();
        root_ = mkdtemp(pattern.data());
        fs::copy(fs::path(source_dir) / "tools", root_ / "tools");
        for (const char* folder : {"cmake", "pxm", "dsp_kernels", "host", "host/commands"})
            fs::create_directory(root_ / folder);
        for (const char* file : {"CMakeLists.txt", "CMakePresets.json", "host/commands/main.cpp"})
            write(root_ / file, "");
        fs::create_directory(root_ / "bin");
        stand_in("cmake",
                 "echo compiling; mkdir -p build/user/bin\n"
                 "printf '#!/bin/sh\\necho \"at $PWD: $*\"; exit 7\\n' > build/user/bin/pxm\n"
                 "chmod +x build/user/bin/pxm");
        stand_in("dpkg", "echo 'Status: install ok installed'");
        stand_in("apt-get", "echo apt-get \"$@\" >> \"" + log().string() + "\"");
        stand_in("sudo", "echo sudo >> \"" + log().string() + "\"; exec \"$@\"");
        stand_in("id", "echo 0");
    }
    ~Tools() override { fs::remove_all(root_); }
    Tools(const Tools&) = delete;
    Tools& operator=(const Tools&) = delete;

    static void write(const fs::path& path, const std::string& text) {
        std::ofstream(path) << text;
    }
    static std::string read(const fs::path& path) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    void stand_in(const std::string& name, const std::string& script) const {
        const fs::path path = root_ / "bin" / name;
        write(path, "#!/bin/bash\n" + script + "\n");
        fs::permissions(path, fs::perms::owner_all);
    }
    [[nodiscard]] fs::path log() const { return root_ / "log"; }

    /// Runs tools/pxm from the folder `host`, by a relative path.
    [[nodiscard]] Outcome run(const std::string& arguments) const {
        const std::string command = "cd '" + (root_ / "host").string() + "' && PATH='" +
                                    (root_ / "bin").string() + "':$PATH ../tools/pxm " + arguments +
                                    " </dev/null >../out 2>../err";
        const int status = std::system(command.c_str());
        return {WEXITSTATUS(status), read(root_ / "out"), read(root_ / "err")};
    }
    /// Makes a source newer than the last build.
    void edit(const fs::path& file) const {
        fs::last_write_time(root_ / file,
                            fs::file_time_type::clock::now() + std::chrono::seconds(5));
    }

    fs::path root_;
};

TEST_F(Tools, the_program_is_built_once_and_run_where_the_caller_is) {
    const std::string expected = "at " + (root_ / "host").string() + ": render a b.pxm --yes\n";
    const Outcome first = run("render 'a b.pxm' --yes");
    EXPECT_EQ(first.exit_code, 7) << "the program's own exit code";
    EXPECT_EQ(first.out, expected);
    EXPECT_THAT(first.err, HasSubstr("building pxm"));

    stand_in("cmake", "exit 1");
    stand_in("dpkg", "exit 1");
    const Outcome later = run("render 'a b.pxm' --yes");
    EXPECT_EQ(later.exit_code, 7);
    EXPECT_EQ(later.out, expected);
    EXPECT_THAT(later.err, IsEmpty()) << "nothing is looked up when the build is fresh";
}

TEST_F(Tools, a_newer_source_and_a_removed_one_build_again) {
    ASSERT_EQ(run("").exit_code, 7);
    edit("host/commands/main.cpp");
    EXPECT_THAT(run("").err, HasSubstr("building pxm"));
    fs::last_write_time(root_ / "host/commands/main.cpp",
                        fs::file_time_type::clock::now() - std::chrono::hours(1));
    ASSERT_EQ(run("").err, "");
    edit("host");  // the time of a folder tells of files added and removed
    EXPECT_THAT(run("").err, HasSubstr("building pxm"));
}

TEST_F(Tools, a_failed_build_shows_its_output_and_runs_nothing) {
    ASSERT_EQ(run("").exit_code, 7);
    edit("host/commands/main.cpp");
    stand_in("cmake", "echo main.cpp: no such thing; exit 1");
    for (int attempt = 0; attempt < 2; ++attempt) {
        const Outcome outcome = run("");
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_THAT(outcome.out, IsEmpty());
        EXPECT_THAT(outcome.err, HasSubstr("no such thing"));
    }
}

TEST_F(Tools, a_build_that_stopped_goes_on_where_it_was) {
    // A tree of three steps with the real cmake; the second fails until there is a file `mended`.
    fs::remove(root_ / "bin/cmake");
    write(root_ / "CMakePresets.json",
          R"({"version": 6, "configurePresets": [{"name": "user", "generator": "Ninja",
              "binaryDir": "${sourceDir}/build/user"}],
              "buildPresets": [{"name": "user", "configurePreset": "user"}]})");
    write(root_ / "CMakeLists.txt", R"(cmake_minimum_required(VERSION 3.25)
project(steps NONE)
file(GLOB sources CONFIGURE_DEPENDS host/*.cpp)
set(top ${CMAKE_SOURCE_DIR})
add_custom_command(OUTPUT one COMMAND echo one >> ${top}/done COMMAND touch one)
add_custom_command(OUTPUT two DEPENDS one COMMAND test -e ${top}/mended COMMAND touch two)
add_custom_command(OUTPUT bin/pxm DEPENDS two COMMAND mkdir -p bin
                   COMMAND cp ${top}/host/commands/main.cpp bin/pxm COMMAND chmod +x bin/pxm)
add_custom_target(all_of_it ALL DEPENDS bin/pxm)
)");
    write(root_ / "host/commands/main.cpp", "#!/bin/sh\nexit 7\n");
    const Outcome stopped = run("");
    EXPECT_EQ(stopped.exit_code, 1);
    EXPECT_THAT(stopped.err, HasSubstr("building pxm: 3 steps, about"));
    EXPECT_THAT(stopped.err, HasSubstr("the build failed"));

    write(root_ / "mended", "");
    const Outcome again = run("");
    EXPECT_EQ(again.exit_code, 7) << again.err;
    EXPECT_THAT(again.err, HasSubstr("building pxm: 2 steps, about"));
    EXPECT_EQ(read(root_ / "done"), "one\n") << "the first step is not taken again";
}

TEST_F(Tools, a_terminal_shows_steps_and_the_time_left_and_a_file_does_not) {
    const std::string as_before = read(root_ / "bin/cmake");
    stand_in("cmake", "printf '[1/4] a.cpp\\n[2/4] b.cpp\\n[4/4] pxm\\n'\n" +
                          as_before.substr(as_before.find('\n') + 1));
    stand_in("dpkg", "exit 1");
    stand_in(
        "apt-get",
        "[[ $2 == install ]] && printf 'dlstatus:3:40.5:Retrieving file 3 of 9 (5s remaining)\\n"
        "pmstatus:g++:62.0:Unpacking g++\\n'");
    const std::string command = "cd '" + root_.string() + "' && PATH='" + (root_ / "bin").string() +
                                "':$PATH script -qec 'tools/pxm render' /dev/null </dev/null >out";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 7);
    const std::string shown = read(root_ / "out");
    EXPECT_THAT(shown, HasSubstr("fetching packages, 40 %: Retrieving file 3 of 9 (5s remaining)"));
    EXPECT_THAT(shown, HasSubstr("installing packages, 62 %: Unpacking g++"));
    EXPECT_THAT(shown, HasSubstr("building pxm: 4 steps, about "));
    EXPECT_THAT(shown, HasSubstr("step 2 of 4, about 0 seconds left"));

    edit("host/commands/main.cpp");
    const Outcome quiet = run("render");
    EXPECT_EQ(quiet.exit_code, 7);
    EXPECT_THAT(quiet.err, HasSubstr("building pxm: 4 steps, about "));
    EXPECT_THAT(quiet.err, testing::Not(HasSubstr("step 2 of 4")));
    EXPECT_THAT(quiet.err, testing::Not(HasSubstr("\033")));
}

TEST_F(Tools, root_installs_what_is_missing_without_asking) {
    stand_in("dpkg", "[[ $2 != libglm-dev ]] && echo 'Status: install ok installed'");
    EXPECT_EQ(run("").exit_code, 7);
    const std::string calls = read(log());
    EXPECT_THAT(calls, HasSubstr("update"));
    EXPECT_THAT(calls, HasSubstr("install -y --no-install-recommends"));
    EXPECT_THAT(calls, HasSubstr("libglm-dev\n"));
    EXPECT_THAT(calls, testing::Not(HasSubstr("g++")));
    EXPECT_THAT(calls, testing::Not(HasSubstr("sudo")));
}

TEST_F(Tools, others_are_asked_before_sudo_unless_yes_comes_first) {
    stand_in("id", "echo 1000");
    stand_in("dpkg", "exit 1");
    const Outcome refused = run("render --yes");
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr("give --yes first"));
    EXPECT_FALSE(fs::exists(log())) << "nothing was installed";

    const Outcome agreed = run("--yes render");
    EXPECT_EQ(agreed.exit_code, 7);
    EXPECT_THAT(agreed.out, HasSubstr(": render\n")) << "--yes is not the program's";
    EXPECT_THAT(read(log()), HasSubstr("sudo\napt-get -q install"));
}

TEST_F(Tools, a_failed_installation_shows_why) {
    stand_in("dpkg", "exit 1");
    stand_in("apt-get", "echo E: no network; exit 100");
    const Outcome outcome = run("");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("E: no network"));
    EXPECT_THAT(outcome.err, HasSubstr("could not be installed"));
}

TEST_F(Tools, a_wrong_option_of_try_fresh_is_code_2_and_without_root_nothing_is_made) {
    const auto try_fresh = [&](const std::string& arguments) {
        const std::string command = "cd '" + root_.string() + "' && TMPDIR='" + root_.string() +
                                    "/host' PATH='" + (root_ / "bin").string() +
                                    "':$PATH tools/try_fresh " + arguments + " >out 2>err";
        const int status = std::system(command.c_str());
        return Outcome{WEXITSTATUS(status), read(root_ / "out"), read(root_ / "err")};
    };
    for (const char* wrong : {"--frob", "--as", "--as nobody", "--size 0", "--size ten"}) {
        const Outcome outcome = try_fresh(wrong);
        EXPECT_EQ(outcome.exit_code, 2) << wrong;
        EXPECT_THAT(outcome.err, HasSubstr("try_fresh: ")) << wrong;
    }
    stand_in("id", "echo 1000");
    const Outcome outcome = try_fresh("--first");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("needs root"));
    EXPECT_EQ(std::distance(fs::directory_iterator(root_ / "host"), fs::directory_iterator()), 1);
}

TEST_F(Tools, a_wrong_option_of_try_package_or_a_folder_without_packages_is_code_2) {
    for (const char* wrong : {"--frob", "", "--logs", "--size 0 host", "host"}) {
        const std::string command = "cd '" + root_.string() + "' && tools/try_package " +
                                    std::string(wrong) + " >out 2>err";
        const int status = std::system(command.c_str());
        EXPECT_EQ(WEXITSTATUS(status), 2) << wrong;
        EXPECT_THAT(read(root_ / "err"), HasSubstr("try_package: ")) << wrong;
    }
}

}  // namespace
}  // namespace pxm::test
