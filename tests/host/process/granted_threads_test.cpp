// Laws of the default number of threads: the affinity mask, the control groups' quotas in a folder
// that looks like /proc and /sys, and OpenMP's variables.
#include "host/process/granted_threads.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using host::cpu_quota;
using host::granted_threads;

constexpr const char* unified =
    "25 23 0:24 / /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n";
constexpr const char* cpu_alone =
    "32 31 0:29 / /sys/fs/cgroup/cpu,cpuacct rw - cgroup cgroup rw,cpu,cpuacct\n"
    "33 31 0:30 / /sys/fs/cgroup/cpuset rw - cgroup cgroup rw,cpuset\n";

/// A system's root with only what is written into it.
class FakeRoot {
  public:
    FakeRoot(const std::string& cgroup, const std::string& mountinfo) {
        write("proc/self/cgroup", cgroup);
        write("proc/self/mountinfo", "23 1 0:5 / / rw - ext4 /dev/sda1 rw\n" + mountinfo);
    }
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories(
            std::filesystem::path(folder_.path(name)).parent_path());
        folder_.write(name, text);
    }
    [[nodiscard]] std::optional<double> quota() const { return cpu_quota(folder_.path()); }
    [[nodiscard]] std::filesystem::path path() const { return folder_.path(); }

  private:
    Folder folder_;
};

TEST(CpuQuota, without_groups_there_is_none) {
    EXPECT_EQ(cpu_quota("/nowhere"), std::nullopt);
    EXPECT_EQ(FakeRoot("", "").quota(), std::nullopt);
    EXPECT_EQ(FakeRoot("nonsense\n::\n0::/a\n", "x - y\n- - - -\n").quota(), std::nullopt);
}

TEST(CpuQuota, the_smallest_limit_of_a_group_and_those_around_it_holds) {
    const FakeRoot root("0::/user/job\n", unified);
    EXPECT_EQ(root.quota(), std::nullopt);
    root.write("sys/fs/cgroup/user/job/cpu.max", "max 100000\n");
    EXPECT_EQ(root.quota(), std::nullopt);
    root.write("sys/fs/cgroup/user/cpu.max", "350000 100000\n");
    EXPECT_EQ(root.quota(), 3.5);
    root.write("sys/fs/cgroup/user/job/cpu.max", "150000 100000\n");
    EXPECT_EQ(root.quota(), 1.5);
    root.write("sys/fs/cgroup/user/other/cpu.max", "10000 100000\n");
    EXPECT_EQ(root.quota(), 1.5);
}

TEST(CpuQuota, the_first_version_has_it_in_two_files) {
    const FakeRoot root("5:cpuset:/elsewhere\n4:cpu,cpuacct:/job\n0::/\n", cpu_alone);
    root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "50000\n");
    root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "-1\n");
    EXPECT_EQ(root.quota(), std::nullopt);
    root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "100000\n");
    EXPECT_EQ(root.quota(), 2);
}

TEST(CpuQuota, of_two_versions_the_smaller_holds) {
    const FakeRoot root("4:cpu:/job\n0::/job\n", std::string(cpu_alone) + unified);
    root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
    root.write("sys/fs/cgroup/cpu,cpuacct/job/cpu.cfs_quota_us", "300000\n");
    root.write("sys/fs/cgroup/job/cpu.max", "200000 100000\n");
    EXPECT_EQ(root.quota(), 2);
}

TEST(CpuQuota, a_container_sees_its_own_group_at_the_mount) {
    const FakeRoot bound("4:cpu:/docker/abc\n",
                         "32 31 0:29 /docker/abc /sys/fs/cgroup/cpu ro - cgroup cgroup rw,cpu\n");
    bound.write("sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n");
    bound.write("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "250000\n");
    EXPECT_EQ(bound.quota(), 2.5);
    const FakeRoot outside("0::/../other\n", unified);
    outside.write("sys/fs/cgroup/cpu.max", "100000 100000\n");
    outside.write("sys/fs/other/cpu.max", "1000 100000\n");
    EXPECT_EQ(outside.quota(), 1);
}

TEST(CpuQuota, what_cannot_be_read_as_a_quota_is_none) {
    const FakeRoot root("0::/\n", unified);
    for (const char* text :
         {"", "\n", "100000\n", "0 100000\n", "1 0\n", "0x10 1\n", "a b\n", "1 2 3\n", "nan 1\n"}) {
        root.write("sys/fs/cgroup/cpu.max", text);
        EXPECT_EQ(root.quota(), std::nullopt) << text;
    }
}

/// While it lives, the process may run on its first `cores` cores only.
class Mask {
  public:
    explicit Mask(int cores) {
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t some;
        CPU_ZERO(&some);
        for (int i = 0; i < CPU_SETSIZE && CPU_COUNT(&some) < cores; ++i)
            if (CPU_ISSET(i, &before_)) CPU_SET(i, &some);
        sched_setaffinity(0, sizeof some, &some);
    }
    ~Mask() { sched_setaffinity(0, sizeof before_, &before_); }
    Mask(const Mask&) = delete;
    Mask& operator=(const Mask&) = delete;
    [[nodiscard]] int before() const { return CPU_COUNT(&before_); }

  private:
    cpu_set_t before_{};
};

class GrantedThreads : public testing::Test {
  protected:
    GrantedThreads() { forget(); }
    ~GrantedThreads() override { forget(); }
    static void forget() {
        unsetenv("OMP_NUM_THREADS");
        unsetenv("OMP_THREAD_LIMIT");
    }
};

TEST_F(GrantedThreads, are_no_more_than_the_cores_of_the_affinity_mask) {
    const Mask one(1);
    const auto choice = granted_threads("/nowhere");
    EXPECT_EQ(choice.threads, 1);
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    EXPECT_EQ(choice.because, cores == 1 ? std::string("the computer has 1 core")
                                         : fmt::format("the process may run on 1 of the computer's "
                                                       "{} cores",
                                                       cores));
}

TEST_F(GrantedThreads, are_no_more_than_the_quota_rounded_up) {
    const FakeRoot root("0::/\n", unified);
    root.write("sys/fs/cgroup/cpu.max", "20000 100000\n");
    const int cores = granted_threads("/nowhere").threads;
    EXPECT_EQ(granted_threads(root.path()).threads, 1);
    if (cores > 1) {
        EXPECT_EQ(granted_threads(root.path()).because,
                  "the control group's CPU quota is 0.2 cores");
        root.write("sys/fs/cgroup/cpu.max", "110000 100000\n");
        EXPECT_EQ(granted_threads(root.path()).threads, 2);
    }
    root.write("sys/fs/cgroup/cpu.max", "90000000 1\n");
    EXPECT_EQ(granted_threads(root.path()).threads, cores);
}

TEST_F(GrantedThreads, are_no_more_than_openmp_is_told) {
    const int cores = granted_threads("/nowhere").threads;
    for (const char* variable : {"OMP_NUM_THREADS", "OMP_THREAD_LIMIT"}) {
        for (const char* text : {"1", "01", "1,4", " 1 "}) {
            setenv(variable, text, 1);
            EXPECT_EQ(granted_threads("/nowhere").threads, 1) << text;
            if (cores > 1) {
                EXPECT_EQ(granted_threads("/nowhere").because, std::string(variable) + " is 1");
            }
        }
        for (const char* text : {"", "0", "-1", "x", "99999999999999999999", "100000"}) {
            setenv(variable, text, 1);
            EXPECT_EQ(granted_threads("/nowhere").threads, cores) << text;
        }
        unsetenv(variable);
    }
}

TEST_F(GrantedThreads, are_what_a_render_takes_and_says) {
    Folder folder;
    folder.write("tetra.pxm", tetra_scene);
    const auto told = [&](const Arguments& more) {
        Arguments words{"render", "tetra.pxm", "--size", "8x8", "--quiet", "--stats", "s.json"};
        words.insert(words.end(), more.begin(), more.end());
        expect_done(folder, words);
        const auto json = nlohmann::json::parse(folder.read("s.json"));
        return std::pair(json["threads"].get<int>(), json["threads_because"].get<std::string>());
    };
    for (const Arguments& engine : {Arguments{"--native"}, {"--machine", "964"}}) {
        const Mask mask(1);
        EXPECT_EQ(told(engine), std::pair(1, granted_threads().because));
        Arguments three = engine;
        three.insert(three.end(), {"--threads", "3"});
        EXPECT_EQ(told(three), std::pair(3, std::string("it was asked for")));
    }
}

TEST_F(GrantedThreads, do_not_bind_who_asks_for_a_number) {
    const Mask one(1);
    setenv("OMP_NUM_THREADS", "1", 1);
    EXPECT_EQ(host::choose_threads(7).threads, 7);
    EXPECT_EQ(host::choose_threads(7).because, "it was asked for");
    EXPECT_EQ(host::choose_threads(0).threads, 1);
}

}  // namespace
}  // namespace pxm::test
