// Laws of claims: one worker a part, and none that waits for the dead.
#include "host/parts/claims.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <thread>
#include <vector>

#include "host/error.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using host::Claim;
using host::Claims;
using std::chrono::milliseconds;

constexpr milliseconds expiry{240};
const std::string name = "part-1-of-2.pxmpart";

void sleep(milliseconds time) { std::this_thread::sleep_for(time); }

TEST(Claims, one_of_many_workers_gets_a_part) {
    const Folder folder;
    std::atomic<int> taken = 0, done = 0;
    std::vector<std::thread> workers;
    for (int i = 0; i < 8; ++i) {
        workers.emplace_back([&] {
            Claims claims(folder.path(), expiry);
            const std::unique_ptr<Claim> claim = claims.take(name);
            taken += claim ? 1 : 0;
            ++done;
            while (done < 8) sleep(milliseconds(1));
        });
    }
    for (std::thread& worker : workers) worker.join();
    EXPECT_EQ(taken, 1);
    EXPECT_TRUE(folder.names().empty()) << "it was given back";
}

TEST(Claims, the_living_keep_theirs) {
    const Folder folder;
    Claims mine(folder.path(), expiry), other(folder.path(), expiry);
    const std::unique_ptr<Claim> claim = mine.take(name);
    ASSERT_TRUE(claim);
    for (int i = 0; i < 12; ++i) {
        EXPECT_FALSE(other.take(name)) << i;
        sleep(expiry / 4);
    }
}

TEST(Claims, what_gives_no_sign_of_life_is_taken_over_once) {
    const Folder folder;
    folder.write(name + ".claim-0", "0000000007 nobody 1\n");
    Claims first(folder.path(), expiry), second(folder.path(), expiry);
    EXPECT_FALSE(first.take(name)) << "it may be alive";
    EXPECT_FALSE(second.take(name));
    sleep(expiry + expiry / 4);
    const std::unique_ptr<Claim> claim = first.take(name);
    EXPECT_TRUE(claim);
    EXPECT_FALSE(second.take(name)) << "the next generation is alive";
    first.forget(name);
    EXPECT_TRUE(folder.names().empty());
}

TEST(Claims, cannot_be_made_where_nothing_can) {
    const Folder folder;
    Claims claims(folder.path("nowhere"), expiry);
    EXPECT_THROW((void)claims.take(name), host::Error);
}

class ClaimedRender : public testing::Test {
  protected:
    ClaimedRender() {
        folder.write("tetra.pxm", tetra_scene);
        expect_done(folder, {"render", "tetra.pxm", "-o", "one.exr", "--size", "70x53"});
    }
    [[nodiscard]] static Arguments command(const Arguments& options = {}) {
        Arguments all{"render", "tetra.pxm", "--size", "70x53", "--claim", "parts"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    void expect_picture() const {
        expect_done(folder, {"join", "parts", "-o", "all.exr"});
        EXPECT_TRUE(folder.read("all.exr") == folder.read("one.exr"));
        for (const std::string& file : folder.names())
            EXPECT_EQ(file.find("claim-"), std::string::npos) << file;
    }
    Folder folder;
};

TEST_F(ClaimedRender, makes_all_parts_that_nobody_else_makes) {
    const std::string said = expect_done(folder, command({"--part", "any/5"}));
    EXPECT_TRUE(said.starts_with("5 of 5 parts made here in ")) << said;
    expect_picture();
    const std::string again = expect_done(folder, command({"--part", "any/5"}));
    EXPECT_TRUE(again.starts_with("0 of 5 parts made here in ")) << again;
}

TEST_F(ClaimedRender, waits_for_the_dead_and_takes_over) {
    std::filesystem::create_directories(folder.path("parts"));
    folder.write("parts/part-2-of-3.pxmpart.claim-0", "0000000007 nobody 1\n");
    expect_done(folder, command({"--part", "any/3", "--claim-expiry", "0.3"}));
    expect_picture();
}

TEST_F(ClaimedRender, makes_a_damaged_part_again) {
    expect_done(folder, command({"--part", "any/3"}));
    folder.write("parts/part-2-of-3.pxmpart", "");
    expect_done(folder, command({"--part", "any/3"}));
    expect_picture();
}

TEST_F(ClaimedRender, is_refused_where_it_makes_no_sense) {
    expect_refusal(folder, command({"--part", "2/3"}), 2,
                   "--part: found \"2/3\", expected any/N with 1 <= N <= 1000000 (--claim)");
    expect_refusal(folder, command({"-o", "x.png"}), 2,
                   "-o: the parts are put into the folder of --claim");
    expect_done(folder, command({"--part", "any/3"}));
    expect_refusal(folder, command({"--part", "any/3", "--samples", "2"}), 4,
                   "parts/part-1-of-3.pxmpart: is a part of another picture (its samples: as the "
                   "scene has it, not 2)");
}

}  // namespace
}  // namespace pxm::test
