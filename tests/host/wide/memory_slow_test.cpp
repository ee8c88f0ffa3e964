// The program in little memory, on scenes whose numbers ask for much: tables have bounds.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/support/crowds.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/program.hpp"

namespace pxm::test {
namespace {

/// While it lives, a process that is started may have so much address space.
class AddressSpace {
  public:
    explicit AddressSpace(rlim_t bytes) {
        getrlimit(RLIMIT_AS, &before_);
        rlimit less = before_;
        less.rlim_cur = bytes;
        setrlimit(RLIMIT_AS, &less);
    }
    ~AddressSpace() { setrlimit(RLIMIT_AS, &before_); }
    AddressSpace(const AddressSpace&) = delete;
    AddressSpace& operator=(const AddressSpace&) = delete;

  private:
    rlimit before_{};
};

constexpr rlim_t two_gigabytes = rlim_t{2'000'000} * 1024;
constexpr double patience_seconds = 300;  // a run that takes longer has no bound

constexpr const char* halves =
    "ifs a { newmap scale: 0.5 translate: 0,0.5,0  newmap scale: 0.5 translate: 0.5,-0.25,0\n"
    "newmap scale: 0.5 translate: -0.5,-0.25,0.3  newmap scale: 0.5 translate: 0,-0.25,-0.5 }\n";
constexpr const char* turning_halves =
    "ifs a { newmap scale: 0.5 rotate: x,20 translate: 0,0.5,0\n"
    "newmap scale: 0.5,0.4,0.5 rotate: z,50 translate: 0.5,-0.25,0\n"
    "newmap scale: 0.5 translate: -0.5,-0.25,0.3  newmap scale: 0.5 translate: 0,-0.25,-0.5 }\n";

std::string very_many_lights() {
    std::string text = halves;
    for (int i = 0; i < 100'000; ++i) {
        text += fmt::format("light {{ direction: {},1,{} color: 1e-5,1e-5,1e-5 shadow: {} }}\n",
                            i % 300 - 150, i / 300 - 150, i % 100 == 0 ? "on" : "off");
    }
    return text;
}

/// A ring in which every map has a follow set of its own, each with tables of several levels.
std::string very_many_follow_sets() {
    std::string text = "rifs a {\n";
    constexpr int maps = 60;
    for (int i = 0; i < maps; ++i) {
        text += fmt::format("newmap m{} scale: 0.4 translate: {},{},{}\n", i, i % 5 * 0.2,
                            i / 5 % 5 * 0.2, i / 25 * 0.2);
    }
    for (int i = 0; i < maps; ++i) {
        text += fmt::format("follow: m{} -> m{},m{},m{},m{},m{}\n", i, i, (i + 1) % maps,
                            (i + 7) % maps, (i + 19) % maps, (i + 30 + i % 7) % maps);
    }
    return text + "}\n";
}

struct Hungry {
    std::string name;
    std::string text;
};
void PrintTo(const Hungry& scene, std::ostream* out) { *out << scene.name; }

std::vector<Hungry> hungry_scenes() {
    std::vector<Hungry> scenes;
    for (const auto& [kind, maps] : {std::pair{"halves", halves}, {"turning", turning_halves}}) {
        for (const char* volume : {"sphere", "box"}) {
            const auto add = [&](const char* what, const std::string& more) {
                scenes.push_back(
                    {fmt::format("{}_{}_{}", kind, volume, what), fmt::format("{}{}", maps, more)});
            };
            add("detail", fmt::format("render {{ detail: 1e-4 volume: {} }}", volume));
            add("fov", fmt::format("camera c {{ eye: 0.1,0.2,-5 look: 0,0.5,0 fov: 1e-300 }}\n"
                                   "render {{ volume: {} }}",
                                   volume));
            add("orthographic",
                fmt::format("camera c {{ orthographic: 1e-300 }} render {{ volume: {} }}", volume));
        }
    }
    scenes.push_back({"lights", very_many_lights()});
    scenes.push_back({"follow_sets", very_many_follow_sets()});
    scenes.push_back({"crowded", fat_square(16)});
    return scenes;
}

class LittleMemory : public testing::TestWithParam<Hungry> {};

TEST_P(LittleMemory, is_enough_for_small_pictures) {
    const Folder folder;
    folder.write("s.pxm", GetParam().text);
    const AddressSpace limit(two_gigabytes);
    Process process(folder, {"render", "s.pxm", "--size", "16x16", "--quiet", "-o", "s.png"});
    const Outcome outcome = process.wait(patience_seconds);
    EXPECT_FALSE(outcome.timed_out);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err.substr(0, 2000);
    EXPECT_TRUE(folder.has("s.png"));
}

std::string name_of(const testing::TestParamInfo<Hungry>& scene) { return scene.param.name; }

INSTANTIATE_TEST_SUITE_P(Scenes, LittleMemory, testing::ValuesIn(hungry_scenes()), name_of);

}  // namespace
}  // namespace pxm::test
