// Systems that numbers make hard, given to the program: small files, small answers, bounded memory.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <string>

#include "tests/support/folder.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

constexpr rlim_t two_gigabytes = rlim_t{2} << 30U;

/// While it lives, programs that are started have no more address space than that.
class AddressSpace {
  public:
    explicit AddressSpace(rlim_t bytes) {
        getrlimit(RLIMIT_AS, &before_);
        const rlimit limited{std::min(bytes, before_.rlim_max), before_.rlim_max};
        setrlimit(RLIMIT_AS, &limited);
    }
    ~AddressSpace() { setrlimit(RLIMIT_AS, &before_); }
    AddressSpace(const AddressSpace&) = delete;
    AddressSpace& operator=(const AddressSpace&) = delete;

  private:
    rlimit before_{};
};

class HardSystem : public testing::Test {
  protected:
    Outcome outcome(const std::string& scene, const Arguments& arguments) const {
        folder.write("a.pxm", scene);
        const AddressSpace limited(two_gigabytes);
        return run_program(folder, arguments);
    }
    Folder folder;
};

const Arguments inspect{"inspect", "a.pxm"};
const Arguments render{"render", "a.pxm", "--size", "16x16", "--quiet", "-o", "a.png"};
const Arguments points{"points", "a.pxm", "-n", "100", "-o", "a.ply"};

TEST_F(HardSystem, strong_shears_are_inspected_rendered_and_sampled) {
    for (const char* scene : {
             "ifs a { newmap matrix: 0.5,0,1e7, 0,0.5,0, 0,0,0.5, 0,0,0 }",
             "ifs a { newmap matrix: 0.5,0,1e7, 0,0.5,0, 0,0,0.5, 0,0,0 "
             "newmap matrix: 0.5,0,1e7, 0,0.5,0, 0,0,0.5, 1,1,1 }",
             "ifs a { newmap matrix: 0,1e8,0, 0,0,1e8, 0,0,0, 1,0,0 newmap scale: 0.5 }",
         }) {
        for (const Arguments& arguments : {inspect, render, points}) {
            const Outcome end = outcome(scene, arguments);
            EXPECT_EQ(end.exit_code, 0) << arguments.front() << ' ' << scene << '\n' << end.err;
        }
    }
}

TEST_F(HardSystem, a_system_that_expands_by_words_is_refused_by_every_command) {
    for (const char* middle : {"0", "0.1"}) {
        const std::string scene = std::string("ifs a { newmap matrix: 0,0,2, 0,") + middle +
                                  ",0, 0,0,0, 0,0,0 newmap matrix: 0,0,0, 0," + middle +
                                  ",0, 2,0,0, 1,0,0 }";
        for (const Arguments& arguments : {inspect, render, points}) {
            const Outcome end = outcome(scene, arguments);
            EXPECT_EQ(end.exit_code, 3) << arguments.front();
            EXPECT_NE(end.err.find("could not be shown to contract"), std::string::npos) << end.err;
        }
    }
}

/// 59 maps in a block and one far away: nearly all pairs of cells overlap, at any depth.
std::string with_one_far_away(const std::string& place) {
    std::string scene = "ifs a {\n";
    for (int i = 0; i < 59; ++i) {
        scene += "newmap scale: 0.3 translate: " + std::to_string(i % 4) + ',' +
                 std::to_string(i / 4 % 4) + ',' + std::to_string(i / 16) + '\n';
    }
    return scene + "newmap scale: 0.3 translate: 0,0," + place + "\n}";
}

TEST_F(HardSystem, many_maps_of_which_one_is_far_away_take_little_memory) {
    const Outcome far = outcome(with_one_far_away("1e90"), inspect);
    EXPECT_EQ(far.exit_code, 0) << far.err;
    EXPECT_NE(far.out.find("totally disconnected unknown"), std::string::npos) << far.out;
    const Outcome too_far = outcome(with_one_far_away("1e160"), inspect);
    EXPECT_EQ(too_far.exit_code, 3);
    EXPECT_NE(too_far.err.find("is too large or too far away"), std::string::npos) << too_far.err;
}

}  // namespace
}  // namespace pxm::test
