// Laws of --limit-seconds and --limit-memory: a run that reaches one ends soon, with a message,
// exit code 7 and what is done so far.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host/files/image_reader.hpp"
#include "tests/support/command.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

using testing::HasSubstr;

constexpr double patience_seconds = 60;

class Limits : public testing::Test {
  protected:
    Limits() { folder.write("tetra.pxm", tetra_scene); }

    /// A render that would take minutes, ended by a limit.
    [[nodiscard]] Outcome ended(const Arguments& more) const {
        Arguments arguments{"render",  "tetra.pxm", "--size", "3000x2000",
                            "--quiet", "--samples", "256"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return Process(folder, arguments).wait(patience_seconds);
    }
    Folder folder;
};

TEST_F(Limits, a_picture_is_there_with_black_in_the_places_that_are_missing) {
    for (const char* name : {"a.png", "a.exr"}) {
        const Outcome outcome = ended({"--limit-seconds", "2", "-o", name});
        EXPECT_FALSE(outcome.timed_out);
        EXPECT_EQ(outcome.exit_code, 7) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("pxm: the limit of 2 s is reached: "));
        EXPECT_THAT(outcome.err, HasSubstr(std::string(" of 6000000 pixels of ") + name));
        const host::LoadedImage picture = host::read_image(folder.path(name));
        EXPECT_EQ(picture.width, 3000);
        EXPECT_EQ(picture.height, 2000);
        const bool any = std::ranges::any_of(picture.values, [](float x) { return x != 0; });
        EXPECT_TRUE(any);
    }
}

TEST_F(Limits, on_the_machine_too) {
    const Outcome outcome =
        Process(folder, {"render", "tetra.pxm", "--machine", "964dX", "--samples", "64", "--quiet",
                         "--limit-seconds", "2", "-o", "a.png"})
            .wait(patience_seconds);
    EXPECT_EQ(outcome.exit_code, 7) << outcome.err;
    EXPECT_EQ(host::read_image(folder.path("a.png")).width, 640);
}

TEST_F(Limits, memory_is_one_too) {
    const Outcome outcome = ended({"--limit-memory", "1000", "-o", "a.png"});
    EXPECT_EQ(outcome.exit_code, 7);
    EXPECT_EQ(
        outcome.err.rfind("pxm: the limit of 1000 bytes of memory (--limit-memory) is reached", 0),
        0U)
        << outcome.err;
}

TEST_F(Limits, what_is_kept_goes_on_from_there) {
    const Outcome outcome = ended({"--limit-seconds", "1", "--keep", "kept", "-o", "a.png"});
    EXPECT_EQ(outcome.exit_code, 7) << outcome.err;
    EXPECT_FALSE(folder.has("a.png"));
    EXPECT_THAT(outcome.err, HasSubstr("the same command goes on from there"));
}

TEST_F(Limits, a_run_within_them_is_as_without) {
    const Arguments render{"render", "tetra.pxm", "--size", "32x32", "--quiet", "-o"};
    Arguments bounded = render, free = render;
    free.push_back("free.png");
    bounded.insert(bounded.end(), {"bounded.png", "--limit-seconds", "1000"});
    EXPECT_EQ(run_program(folder, free).exit_code, 0);
    EXPECT_EQ(run_program(folder, bounded).exit_code, 0);
    EXPECT_EQ(folder.read("free.png"), folder.read("bounded.png"));
}

TEST_F(Limits, points_that_nobody_keeps_leave_no_file) {
    const Outcome outcome = Process(folder, {"points", "tetra.pxm", "-n", "100000000000", "--quiet",
                                             "--limit-seconds", "1", "-o", "a.ply"})
                                .wait(patience_seconds);
    EXPECT_EQ(outcome.exit_code, 7);
    EXPECT_EQ(outcome.err, "pxm: the limit of 1 s is reached: no points were written\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"tetra.pxm"});
}

TEST_F(Limits, what_a_render_takes_is_said_beforehand) {
    const Outcome outcome = run_program(folder, {"inspect", "tetra.pxm", "--needs", "--json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("\"seconds\":"));
    EXPECT_THAT(outcome.out, HasSubstr("\"bytes\":"));
}

}  // namespace
}  // namespace pxm::test
