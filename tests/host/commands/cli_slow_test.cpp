// Laws of the signals that end a run: soon, 128 and their number, and no file.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <string>
#include <thread>

#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

constexpr double soon_seconds = 5;  // "within a second", on a computer that is busy

/// Grass (App. B.2.1): minutes of work at this size.
const char* const grass_scene =
    "ifs grass {\n"
    "    newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: -1,0,0\n"
    "    newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: 1,0,0\n"
    "    newmap scale: 0.25,0.01,0.01 rotate: z,90 translate: 0,0.707,0\n"
    "}\n"
    "object grass { ifs: grass color: 0,0.7,0.2,1 scale: 4,0.1,4 }\n"
    "camera { eye: 0,1.2,-9 look: 0,0,-4 fov: 40 }\n"
    "image { size: 2000,1000 }\n";

class Interrupted : public testing::TestWithParam<int> {
  protected:
    Interrupted() {
        folder.write("grass.pxm", grass_scene);
        folder.write("old.png", "an older picture");
    }
    /// Starts the program, sends the signal after `delay`, expects the signal's exit code and
    /// nothing new in the folder.
    void interrupt(const Arguments& arguments, std::chrono::milliseconds delay) const {
        const auto before = folder.contents();
        Process program(folder, arguments);
        program.wait_until_it_catches(GetParam());
        std::this_thread::sleep_for(delay);
        program.send(GetParam());
        const Outcome outcome = program.wait(soon_seconds);
        EXPECT_FALSE(outcome.timed_out) << arguments.back();
        EXPECT_EQ(outcome.exit_code, 128 + GetParam()) << arguments.back();
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(folder.contents(), before);
    }
    Folder folder;
};

TEST_P(Interrupted, a_long_render_leaves_no_file_and_the_older_picture) {
    for (const int milliseconds : {0, 50, 1500}) {
        interrupt({"render", "grass.pxm", "-o", "old.png", "--stats", "s.json"},
                  std::chrono::milliseconds(milliseconds));
    }
}

TEST_P(Interrupted, so_does_the_machine) {
    interrupt({"render", "grass.pxm", "-o", "new.exr", "--size", "1000x500", "--machine", "964dX"},
              std::chrono::milliseconds(1500));
}

TEST_P(Interrupted, a_large_scene_that_is_still_being_prepared) {
    std::string large = "ifs large {\n";
    for (int i = 0; i < 60'000; ++i) {
        large += "newmap scale: 0.004,0.003,0.002 rotate: x," + std::to_string(i % 360) +
                 " translate: " + std::to_string(i % 256) + "/256," + std::to_string(i / 256) +
                 "/256,0\n";
    }
    folder.write("large.pxm", large + "}\n");
    interrupt({"render", "large.pxm", "--size", "4000x4000", "--numeric", "double"},
              std::chrono::milliseconds(300));
}

INSTANTIATE_TEST_SUITE_P(BySignal, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP, SIGXCPU),
                         [](const auto& test) {
                             return std::string("SIG") + sigabbrev_np(test.param);
                         });

TEST(Nohup, a_signal_that_is_ignored_stays_ignored) {
    const Folder folder;
    folder.write("grass.pxm", grass_scene);
    const Outcome outcome = run_shell(
        folder,
        "trap '' HUP; $PXM render grass.pxm --size 40x20 -o a.png --quiet & sleep 0.2; kill -HUP "
        "$!; wait $!");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(folder.has("a.png"));
}

}  // namespace
}  // namespace pxm::test
