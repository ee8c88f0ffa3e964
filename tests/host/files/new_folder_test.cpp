// Laws of new folders; that they are on the disk is asked of the whole program
// (tests/faults/power_loss).
#include "host/files/new_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

TEST(NewFolder, is_made_with_those_above_it) {
    const test::Folder folder;
    EXPECT_FALSE(make_folders(folder.path("a/b/c")));
    EXPECT_TRUE(std::filesystem::is_directory(folder.path("a/b/c")));
    EXPECT_FALSE(make_folders(folder.path("a/d/")));
    EXPECT_TRUE(std::filesystem::is_directory(folder.path("a/d")));
}

TEST(NewFolder, may_be_there_already) {
    const test::Folder folder;
    EXPECT_FALSE(make_folders(folder.path("a")));
    EXPECT_FALSE(make_folders(folder.path("a")));
    EXPECT_FALSE(make_folders("."));
}

TEST(NewFolder, is_not_made_of_a_file_or_below_one) {
    const test::Folder folder;
    folder.write("file", "text");
    EXPECT_EQ(make_folders(folder.path("file")), std::errc::not_a_directory);
    EXPECT_EQ(make_folders(folder.path("file/a/b")), std::errc::not_a_directory);
    EXPECT_EQ(folder.read("file"), "text");
}

TEST(NewFolder, needs_a_name_that_the_system_takes) {
    const test::Folder folder;
    EXPECT_EQ(make_folders(folder.path(std::string(300, 'a'))), std::errc::filename_too_long);
    EXPECT_TRUE(make_folders(""));
}

}  // namespace
}  // namespace pxm::host
