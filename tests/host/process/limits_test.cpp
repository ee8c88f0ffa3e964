// Laws of the memory that a run may take by default, in a folder that looks like /proc and /sys.
#include "host/process/limits.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "tests/support/folder.hpp"

namespace pxm::test {
namespace {

using host::granted_memory;

void write(const Folder& root, const std::string& name, const std::string& text) {
    std::filesystem::create_directories(std::filesystem::path(root.path(name)).parent_path());
    root.write(name, text);
}

TEST(GrantedMemory, is_unknown_where_the_system_says_nothing) {
    EXPECT_FALSE(granted_memory("/nowhere"));
}

TEST(GrantedMemory, is_three_quarters_of_the_computers) {
    const Folder root;
    write(root, "proc/meminfo", "MemTotal:        4000 kB\nMemFree:           10 kB\n");
    const auto memory = granted_memory(root.path());
    ASSERT_TRUE(memory);
    EXPECT_EQ(memory->bytes, 3000U * 1024);
    EXPECT_EQ(memory->because, "3/4 of the computer's memory");
}

TEST(GrantedMemory, is_three_quarters_of_the_smallest_control_group) {
    const Folder root;
    write(root, "proc/meminfo", "MemTotal:        4000 kB\n");
    write(root, "proc/self/cgroup", "0::/user/job\n");
    write(root, "proc/self/mountinfo",
          "25 23 0:24 / /sys/fs/cgroup rw shared:4 - cgroup2 cgroup2 rw\n");
    write(root, "sys/fs/cgroup/user/memory.max", "1024000\n");
    write(root, "sys/fs/cgroup/user/job/memory.max", "max\n");
    const auto memory = granted_memory(root.path());
    ASSERT_TRUE(memory);
    EXPECT_EQ(memory->bytes, 768'000U);
    EXPECT_EQ(memory->because, "3/4 of the control group's memory");
}

TEST(MemoryInUse, grows_with_what_is_written) {
    const std::uint64_t before = host::memory_in_use();
    ASSERT_GT(before, 0U);
    constexpr std::size_t bytes = std::size_t{64} << 20U;
    const std::vector<char> held(bytes, 'x');
    EXPECT_GE(host::memory_in_use(), before + bytes / 2);
    EXPECT_EQ(held.back(), 'x');
}

}  // namespace
}  // namespace pxm::test
