// Laws of safe files: there whole or not at all.
#include "host/files/safe_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include "host/error.hpp"
#include "host/process/interrupt.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

using test::FileSizeLimit;
using test::Folder;
using Names = std::vector<std::string>;

/// The message of the Error(ErrorKind::file) that `work` throws.
template <class Work>
std::string refusal(Work work) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        return error.what();
    }
    return "(nothing was thrown)";
}

/// The only part in the folder; empty if there is none.
std::string part_in(const Folder& folder) {
    for (const std::string& name : folder.names()) {
        if (name.starts_with(".pxm-part-")) return name;
    }
    return "";
}

void append(CheckedFile& file, const std::string& text) { file.append(text.data(), text.size()); }

mode_t mode_of(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(stat(path.c_str(), &status), 0) << path;
    return status.st_mode & 0777;
}

TEST(SafeFile, the_file_is_written_beside_and_put_into_place) {
    const Folder folder;
    folder.write("a.txt", "old");
    write_safely(folder.path("a.txt"), [&](CheckedFile& file) {
        append(file, "ne");
        EXPECT_NE(part_in(folder), "") << "in the same folder";
        EXPECT_TRUE(part_in(folder).ends_with(".txt")) << "the extension says what is written";
        EXPECT_EQ(folder.read("a.txt"), "old") << "until it is whole";
        append(file, "w");
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
                                  [&](CheckedFile& file) {
                                      append(file, "half");
                                      throw std::runtime_error("the disk is full");
                                  }),
                     std::runtime_error);
        EXPECT_EQ(folder.contents(), before);
    }
}

TEST(SafeFile, a_write_that_failed_is_told_however_late_anybody_asks) {
    const Folder folder;
    folder.write("a.txt", "old");
    const auto before = folder.contents();
    const FileSizeLimit limit(4096);
    EXPECT_EQ(refusal([&] {
                  PartFile part(folder.path("a.txt"), Places::any);
                  const std::string text(5000, 'x');
                  for (const long place : {0L, 10'000L, 0L})  // as a library that does not look
                      part.file().write_at(place, text.data(), text.size());
                  part.commit();
              }),
              "cannot write " + folder.path("a.txt") + ": File too large");
    EXPECT_EQ(folder.contents(), before);
}

TEST(SafeFile, any_order_of_writes_gives_the_bytes_of_a_plain_array) {
    const Folder folder;
    std::mt19937 random(14);
    std::string expected;
    PartFile part(folder.path("a"), Places::any);
    for (int i = 0; i < 200; ++i) {
        const std::size_t at = random() % (expected.size() + 1);
        const std::string text(1 + random() % (i % 10 == 0 ? 100'000 : 100),
                               static_cast<char>('a' + i % 26));
        if (expected.size() < at + text.size()) expected.resize(at + text.size());
        expected.replace(at, text.size(), text);
        EXPECT_TRUE(part.file().write_at(static_cast<std::int64_t>(at), text.data(), text.size()));
    }
    EXPECT_EQ(part.file().size(), static_cast<std::int64_t>(expected.size()));
    part.commit();
    EXPECT_TRUE(folder.read("a") == expected);
}

TEST(SafeFile, an_existing_file_keeps_its_mode_and_a_new_one_gets_it_from_the_umask) {
    const Folder folder;
    folder.write("a.txt", "old");
    for (const mode_t mode : {0600U, 0640U, 0444U, 0755U}) {
        chmod(folder.path("a.txt").c_str(), mode);
        write_safely(folder.path("a.txt"), [&](CheckedFile& file) {
            append(file, "new");
            EXPECT_EQ(mode_of(folder.path(part_in(folder))), 0600U) << "closed until then";
        });
        EXPECT_EQ(mode_of(folder.path("a.txt")), mode);
    }
    const mode_t before = umask(027);
    write_text_safely(folder.path("b.txt"), "text");
    umask(before);
    EXPECT_EQ(mode_of(folder.path("b.txt")), 0640U);
}

TEST(SafeFile, parts_of_runs_that_are_over_are_removed_and_others_never) {
    const Folder folder;
    folder.write(".pxm-part-aaaabbbbcccc.png", "of a run that was killed");
    folder.write(".pxm-part-aaaabbbbcccc", "another");
    const Names others{".pxm-part-1234.png", ".pxm-part-aaaabbbb", ".pxm-part-aaaabbbbccccd.png",
                       "pxm-part-aaaabbbbcccc.png"};
    for (const std::string& name : others) folder.write(name, "somebody's");
    symlink("pxm-part-aaaabbbbcccc.png", folder.path(".pxm-part-aaaabbbbdddd").c_str());
    PartFile living(folder.path("living.txt"), Places::any);
    const std::string part = part_in(folder);
    write_text_safely(folder.path("a.txt"), "text");
    EXPECT_TRUE(std::filesystem::exists(living.beside()));
    append(living.file(), "alive");
    living.commit();
    EXPECT_EQ(folder.read("living.txt"), "alive");
    EXPECT_FALSE(folder.has(".pxm-part-aaaabbbbcccc.png"));
    EXPECT_FALSE(folder.has(".pxm-part-aaaabbbbcccc"));
    for (const std::string& name : others) EXPECT_TRUE(folder.has(name)) << name;
    EXPECT_TRUE(folder.has(".pxm-part-aaaabbbbdddd")) << "a link is no part";
}

TEST(SafeFile, many_at_once_in_one_folder_do_not_meet) {
    const Folder folder;
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread) {
        threads.emplace_back([&folder, thread] {
            for (int i = 0; i < 20; ++i) {
                const std::string name = std::to_string(thread) + "-" + std::to_string(i);
                write_text_safely(folder.path(name), name);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(folder.names().size(), 80U);
    for (const std::string& name : folder.names()) EXPECT_EQ(folder.read(name), name);
}

TEST(SafeFile, a_link_leads_to_the_file_that_is_replaced) {
    const Folder folder;
    mkdir(folder.path("there").c_str(), 0777);
    folder.write("there/a.txt", "old");
    symlink("there/b", folder.path("a.txt").c_str());
    symlink("a.txt", folder.path("there/b").c_str());
    symlink("there/new.txt", folder.path("new.txt").c_str());
    symlink("round", folder.path("round").c_str());
    write_text_safely(folder.path("a.txt"), "new");
    write_text_safely(folder.path("new.txt"), "made");
    EXPECT_EQ(folder.read("there/a.txt"), "new");
    EXPECT_EQ(folder.read("there/new.txt"), "made");
    for (const char* link : {"a.txt", "there/b", "new.txt"})
        EXPECT_TRUE(std::filesystem::is_symlink(folder.path(link))) << link;
    EXPECT_EQ(refusal([&] { require_writable(folder.path("round")); }),
              "cannot write " + folder.path("round") + ": Too many levels of symbolic links");
}

/// What comes out of a pipe that `write` is given.
std::string through_a_pipe(const Folder& folder, const std::function<void(std::string)>& write) {
    const std::string path = folder.path("pipe");
    EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
    std::string text;
    std::thread reader([&] { text = test::text_of(std::filesystem::path(path)); });
    write(path);
    reader.join();
    EXPECT_TRUE(std::filesystem::is_fifo(path)) << "not replaced";
    std::filesystem::remove(path);
    return text;
}

TEST(SafeFile, a_pipe_is_written_to_and_stays_a_pipe) {
    const Folder folder;
    const std::string long_text(200'000, 'x');
    EXPECT_EQ(through_a_pipe(folder, [&](auto path) { write_text_safely(path, long_text); }),
              long_text);
    EXPECT_EQ(through_a_pipe(folder,
                             [](auto path) {
                                 PartFile part(path, Places::any);
                                 part.file().write_at(3, "def", 3);
                                 part.file().write_at(0, "abc", 3);
                                 part.commit();
                             }),
              "abcdef");
}

TEST(SafeFile, devices_stay_devices_and_a_full_one_is_told) {
    const auto kind = [](const char* path) { return std::filesystem::status(path).type(); };
    for (const Places places : {Places::any, Places::in_order}) {
        PartFile null("/dev/null", places);
        null.file().write_at(0, "text", 4);
        null.commit();
        EXPECT_EQ(refusal([&] {
                      PartFile full("/dev/full", places);
                      full.file().write_at(0, "text", 4);
                      full.commit();
                  }),
                  "cannot write /dev/full: No space left on device");
    }
    EXPECT_EQ(kind("/dev/null"), std::filesystem::file_type::character);
    EXPECT_EQ(kind("/dev/full"), std::filesystem::file_type::character);
}

TEST(SafeFile, an_open_descriptor_by_its_name_is_written_to_where_it_stands) {
    const Folder folder;
    const int descriptor = open(folder.path("log").c_str(), O_CREAT | O_RDWR, 0600);
    EXPECT_EQ(write(descriptor, "before ", 7), 7);
    write_text_safely("/dev/fd/" + std::to_string(descriptor), "text ");
    EXPECT_EQ(write(descriptor, "after", 5), 5);
    close(descriptor);
    EXPECT_EQ(folder.read("log"), "before text after");
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
        write_safely(folder.path("a.txt"), [&](CheckedFile& file) {
            append(file, "half");
            raise(signal);
        });
    };
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
        EXPECT_EXIT(write_until(signal), testing::ExitedWithCode(128 + signal), "");
        EXPECT_EQ(folder.contents(), before);
    }
}

TEST(SafeFileDeathTest, several_parts_are_removed_together) {
    const Folder folder;
    const auto write_two = [&] {
        catch_signals();
        PartFile one(folder.path("a"), Places::any);
        PartFile two(folder.path("b"), Places::any);
        raise(SIGTERM);
    };
    EXPECT_EXIT(write_two(), testing::ExitedWithCode(143), "");
    EXPECT_EQ(folder.names(), Names{});
}

}  // namespace
}  // namespace pxm::host
