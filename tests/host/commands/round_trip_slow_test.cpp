// Scenes as AIFS and as flames, and back: what has come back once comes back the same ever after,
// and systems that say nothing else come back with the same picture, to the last byte.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

class SystemsOut : public testing::Test {
  protected:
    /// The scene that comes back, without the comment that heads it; empty if the format cannot
    /// hold the scene.
    std::string back(const std::string& scene, const std::string& format, const std::string& out) {
        const std::string file = "through." + format;
        const Arguments export_it{"export", scene,     "-o",
                                  file,     "--allow", (fs::path(source_dir) / "scenes").string()};
        const Outcome exported = run(folder, export_it);
        if (exported.exit_code == 3) return "";
        EXPECT_EQ(exported.exit_code, 0) << exported.err;
        (void)expect_done(folder, {"import", file, "--entry", "#1", "-o", out, "--force"});
        std::istringstream lines(folder.read(out));
        std::string text;
        for (std::string line; std::getline(lines, line);)
            if (!line.starts_with('#')) text += line + "\n";
        return text;
    }
    std::string picture(const std::string& scene) {
        (void)expect_done(
            folder, {"render", scene, "-o", "a.png", "--size", "40x30", "--quiet", "--no-scene"});
        return folder.read("a.png");
    }
    Folder folder;
};

TEST_F(SystemsOut, of_every_scene_stays_what_it_became) {
    int kept = 0;
    const fs::path scenes = fs::path(source_dir) / "scenes";
    for (const auto& entry : fs::recursive_directory_iterator(scenes)) {
        const std::string name = fs::relative(entry.path(), scenes).string();
        if (entry.path().extension() != ".pxm" || name.starts_with("parts/")) continue;
        for (const char* format : {"aifs", "flame"}) {
            SCOPED_TRACE(name + " " + format);
            const std::string once = back(entry.path().string(), format, "once.pxm");
            if (once.empty()) continue;
            EXPECT_EQ(once, back("once.pxm", format, "twice.pxm"));
            ++kept;
        }
    }
    EXPECT_GT(kept, 30);
}

/// A system of the plane in the form of FRACTINT, of two to five maps.
std::string plane_scene(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-0.45, 0.45);
    const int maps = std::uniform_int_distribution(2, 5)(random);
    std::string text = "r {\n";
    for (int i = 0; i < maps; ++i)
        text +=
            fmt::format("{} {} {} {} {} {} {}\n", number(random), number(random), number(random),
                        number(random), 3 * number(random), 3 * number(random), 1.0 / maps);
    return text + "}\n";
}

TEST_F(SystemsOut, of_random_systems_gives_the_same_bytes) {
    std::mt19937 random(20);
    int shown = 0;
    for (int i = 0; i < 40; ++i) {
        folder.write("r.ifs", plane_scene(random));
        if (run(folder, {"import", "r.ifs", "-o", "first.pxm", "--force"}).exit_code != 0) continue;
        const std::string before = picture("first.pxm");
        for (const char* format : {"aifs", "flame"}) {
            SCOPED_TRACE(fmt::format("{} {}", i, format));
            ASSERT_NE(back("first.pxm", format, "second.pxm"), "");
            EXPECT_TRUE(before == picture("second.pxm"));
        }
        ++shown;
    }
    EXPECT_GT(shown, 20);
}

/// Space: maps that turn, stretch and mirror, with the camera that the scene has.
TEST_F(SystemsOut, of_random_solids_gives_the_same_bytes) {
    std::mt19937 random(21);
    std::uniform_real_distribution<double> number(-0.3, 0.3);
    const auto vector = [&](double scale) {
        return fmt::format("{},{},{}", scale * number(random), scale * number(random),
                           scale * number(random));
    };
    for (int i = 0; i < 20; ++i) {
        SCOPED_TRACE(i);
        std::string text = "ifs a {\n";
        for (int map = 0; map < 3; ++map)
            text += fmt::format("newmap matrix: {}, {}, {}, {}\n", vector(1), vector(1), vector(1),
                                vector(4));
        folder.write("first.pxm", text + "}\ncamera { eye: 1,2,-6 look: 0.1,0.2,0 fov: 35 }\n");
        ASSERT_NE(back("first.pxm", "aifs", "second.pxm"), "");
        EXPECT_TRUE(picture("first.pxm") == picture("second.pxm"));
    }
}

}  // namespace
}  // namespace pxm::test
