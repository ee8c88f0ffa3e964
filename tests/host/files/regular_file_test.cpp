// Laws of files that are read.
#include "host/files/regular_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>

#include "tests/support/folder.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

std::string refusal(const std::string& path) {
    return test::error_of([&] { (void)read_file(path); });
}

TEST(RegularFile, gives_its_bytes_and_no_more) {
    const test::Folder folder;
    folder.write("a", "0123456789");
    EXPECT_EQ(read_file(folder.path("a")), "0123456789");
    const RegularFile file(folder.path("a"));
    EXPECT_EQ(file.bytes(), 10U);
    EXPECT_EQ(file.read(2, 3), "234");
    EXPECT_EQ(file.read(8, 30), "89");
    EXPECT_EQ(file.read(30, 3), "");
}

TEST(RegularFile, is_the_same_file_when_its_name_is_given_to_another) {
    const test::Folder folder;
    folder.write("a", "first");
    const RegularFile file(folder.path("a"));
    folder.write("b", "second");
    std::filesystem::rename(folder.path("b"), folder.path("a"));
    EXPECT_EQ(file.read(0, 100), "first");
}

TEST(RegularFile, what_is_no_regular_file_is_refused_at_once) {
    const test::Folder folder;
    ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0666), 0);
    std::filesystem::create_symlink(folder.path("pipe"), folder.path("link"));
    std::filesystem::create_symlink(folder.path("gone"), folder.path("dangling"));
    EXPECT_EQ(refusal(folder.path("pipe")), "4: " + folder.path("pipe") + ": not a regular file");
    EXPECT_EQ(refusal(folder.path("link")), "4: " + folder.path("link") + ": not a regular file");
    EXPECT_EQ(refusal(folder.path("dangling")), "4: " + folder.path("dangling") + ": no such file");
    EXPECT_EQ(refusal(folder.path("pipe/a")), "4: " + folder.path("pipe/a") + ": no such file");
    EXPECT_EQ(refusal(folder.path()), "4: " + folder.path() + ": is a directory");
    EXPECT_EQ(refusal("/dev/null"), "4: /dev/null: not a regular file");
}

TEST(RegularFile, a_file_that_is_no_text_for_its_size_is_not_read) {
    const test::Folder folder;
    folder.write("a", "");
    std::filesystem::resize_file(folder.path("a"), text_bytes + 1);  // no block of the disk
    EXPECT_EQ(refusal(folder.path("a")), "4: " + folder.path("a") + ": larger than 64 MB");
}

}  // namespace
}  // namespace pxm::host
