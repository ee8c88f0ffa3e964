// Laws of safe files: there whole or not at all.
#include "host/output/safe_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <stdexcept>

#include "host/error.hpp"
#include "host/interrupt.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

using test::Folder;
using Names = std::vector<std::string>;

/// The message of the Error(ExitCode::file) that `work` throws.
template <class Work>
std::string refusal(Work work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::file);
        return error.what();
    }
    return "(nothing was thrown)";
}

TEST(SafeFile, the_file_is_written_beside_and_put_into_place) {
    const Folder folder;
    folder.write("a.txt", "old");
    write_safely(folder.path("a.txt"), [&](const std::string& beside) {
        EXPECT_NE(beside, folder.path("a.txt"));
        EXPECT_EQ(std::filesystem::path(beside).parent_path(),
                  std::filesystem::path(folder.path("a.txt")).parent_path());
        EXPECT_TRUE(beside.ends_with(".txt")) << "the extension says what is written";
        folder.write(std::filesystem::path(beside).filename().string(), "new");
        EXPECT_EQ(folder.read("a.txt"), "old") << "until it is whole";
    });
    EXPECT_EQ(folder.read("a.txt"), "new");
    EXPECT_EQ(folder.names(), Names{"a.txt"});
}

TEST(SafeFile, a_failing_writer_leaves_everything_as_it_was) {
    const Folder folder;
    folder.write("a.txt", "old");
    const auto before = folder.contents();
    for (const char* name : {"a.txt", "b.txt"}) {
        EXPECT_THROW(write_safely(folder.path(name),
                                  [&](const std::string& beside) {
                                      folder.write(
                                          std::filesystem::path(beside).filename().string(),
                                          "half");
                                      throw std::runtime_error("the disk is full");
                                  }),
                     std::runtime_error);
        EXPECT_EQ(folder.contents(), before);
    }
}

TEST(SafeFile, a_writer_that_writes_nothing_is_an_error) {
    const Folder folder;
    const std::string path = folder.path("a.txt");
    EXPECT_EQ(refusal([&] { write_safely(path, [](const std::string&) {}); }),
              "cannot write " + path + ": No such file or directory");
    EXPECT_EQ(folder.names(), Names{});
}

TEST(SafeFile, what_cannot_be_written_is_told_before_and_nothing_is_touched) {
    const Folder folder;
    folder.write("file", "");
    mkdir(folder.path("folder").c_str(), 0777);
    const auto before = folder.contents();
    const auto expect = [&](const std::string& path, const std::string& why) {
        EXPECT_EQ(refusal([&] { require_writable(path); }), "cannot write " + path + ": " + why);
        EXPECT_EQ(refusal([&] { write_text_safely(path, "text"); }),
                  "cannot write " + path + ": " + why);
    };
    expect(folder.path("folder"), "it is a directory");
    expect(folder.path("nowhere/a.txt"), "its folder does not exist");
    expect(folder.path("file/a.txt"), "its folder is not a directory");
    expect("", "it names no file");
    expect(folder.path("nowhere/"), "it names no file");
    expect(folder.path(std::string(256, 'x')), "File name too long");
    EXPECT_NO_THROW(require_writable(folder.path("a.txt")));
    EXPECT_EQ(folder.contents(), before);
}

TEST(SafeFile, every_name_that_the_system_takes_can_be_written) {
    const Folder folder;
    const std::string longest(255, 'x');
    write_text_safely(folder.path(longest), "text");
    EXPECT_EQ(folder.read(longest), "text");
    EXPECT_EQ(folder.names(), Names{longest});
}

TEST(SafeFileDeathTest, a_signal_while_writing_removes_the_part) {
    const Folder folder;
    folder.write("a.txt", "old");
    const auto before = folder.contents();
    const auto write_until = [&](int signal) {
        catch_signals();
        write_safely(folder.path("a.txt"), [&](const std::string& beside) {
            folder.write(std::filesystem::path(beside).filename().string(), "half");
            raise(signal);
        });
    };
    EXPECT_EXIT(write_until(SIGTERM), testing::ExitedWithCode(143), "");
    EXPECT_EQ(folder.contents(), before);
    EXPECT_EXIT(write_until(SIGINT), testing::ExitedWithCode(130), "");
    EXPECT_EQ(folder.contents(), before);
}

}  // namespace
}  // namespace pxm::host
