// What other programs read of an export: as many faces in the same box, the same silhouette, closed
// solids. A program that is not installed is told by a skipped test.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

/// Cubes that do not touch, of two maps that turn and one that mirrors.
const char* const cubes =
    "ifs a {\n"
    "newmap scale: 0.3 rotate: z,30 translate: 1,0,0\n"
    "newmap scale: 0.3 rotate: x,75 translate: -1,0.5,0\n"
    "newmap scale: -0.3,0.3,0.3 translate: 0,-0.5,1 }\n"
    "object a { ifs: a box: (-2,-2,-2)(2,2,2) color: 1,0,0,1 }\n"
    "camera { eye: 1,2,-6 look: 0,0,0 }\n"
    "image { size: 320,240 }\nrender { background: 0,0,1 ambient: 1,1,1 }\n";

bool has(const std::string& program) {
    return run_shell(Folder{}, "command -v " + program).exit_code == 0;
}

/// The first number behind a word.
double number_behind(const std::string& text, const std::string& word) {
    const std::size_t at = text.find(word);
    if (at == std::string::npos) return NAN;
    const std::size_t digit = text.find_first_of("-0123456789", at + word.size());
    return digit == std::string::npos ? NAN : std::atof(text.c_str() + digit);
}

struct Consumers : testing::Test {
    Consumers() { folder.write("cubes.pxm", cubes); }
    Folder folder;
};

TEST_F(Consumers, assimp_finds_the_faces_and_the_box) {
    if (!has("assimp")) GTEST_SKIP() << "no assimp (Debian: assimp-utils)";
    // Sheared, so that a .glb holds geometry: assimp 5.2.5 knows no instances.
    folder.write("sheared.pxm",
                 "ifs a { newmap scale: 0.5,0.25,0.5 rotate: z,30\n"
                 "newmap scale: -0.5,0.3,0.5 rotate: x,20 translate: 0,0,1 }\n"
                 "object a { ifs: a box: (-2,-2,-2)(2,2,2) }\n");
    std::string size;
    for (const char* file : {"a.ply", "a.obj", "a.stl", "a.glb", "a.gltf"}) {
        const std::string told =
            expect_done(folder, {"export", "sheared.pxm", "-o", file, "--levels", "4", "--quiet"});
        const Outcome outcome =
            run_shell(folder, fmt::format("assimp info {} | tr '\\r' '\\n'", file));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.out;
        const double faces = number_behind(outcome.out, "\nFaces:");
        EXPECT_TRUE(faces == 16 * 12 || faces == 16 * 6) << file << ": " << faces;
        std::vector<double> corners;
        for (const char* word : {"Minimum point", "Maximum point"}) {
            std::istringstream list(
                outcome.out.substr(outcome.out.find('(', outcome.out.find(word)) + 1));
            for (double x = 0; corners.size() % 3 < 3 && list >> x;) corners.push_back(x);
        }
        ASSERT_EQ(corners.size(), 6U) << outcome.out;
        const std::size_t comma = told.rfind(", ");
        std::istringstream extent(told.substr(comma + 2));
        for (std::size_t k = 0; k < 3; ++k) {
            double side = 0;
            std::string cross;
            extent >> side >> cross;
            EXPECT_NEAR(corners[3 + k] - corners[k], side, 1e-4) << file;
        }
    }
}

TEST_F(Consumers, admesh_finds_every_solid_closed_and_of_positive_volume) {
    if (!has("admesh")) GTEST_SKIP() << "no admesh (Debian: admesh)";
    (void)expect_done(folder, {"export", "cubes.pxm", "-o", "a.stl", "--levels", "3", "--quiet"});
    const Outcome outcome = run_shell(folder, "admesh a.stl");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.out;
    EXPECT_EQ(number_behind(outcome.out, "Number of facets"), 27 * 12) << outcome.out;
    EXPECT_EQ(number_behind(outcome.out, "Number of parts"), 27) << outcome.out;
    EXPECT_EQ(number_behind(outcome.out, "Facets reversed"), 0) << outcome.out;
    EXPECT_NEAR(number_behind(outcome.out, "Volume"), 64 * std::pow(3 * 0.027, 3), 1e-4)
        << outcome.out;
}

constexpr std::size_t pixels = 320 * 240;

/// Red where the object is, blue elsewhere. POV-Ray puts comments into the head.
std::vector<bool> silhouette(const std::string& ppm) {
    std::vector<bool> inside;
    EXPECT_TRUE(ppm.starts_with("P6") && ppm.size() > 3 * pixels);
    const std::size_t begin = ppm.size() - std::min(ppm.size(), 3 * pixels);
    for (std::size_t i = begin; i + 2 < ppm.size(); i += 3)
        inside.push_back(static_cast<unsigned char>(ppm[i]) >
                         static_cast<unsigned char>(ppm[i + 2]));
    return inside;
}

TEST_F(Consumers, povray_draws_the_silhouette_that_pxm_draws) {
    if (!has("povray")) GTEST_SKIP() << "no povray (Debian: povray)";
    // Volumes that hold the images of themselves: a render shows a cell along rays that meet the
    // cells around it, an export all of it.
    for (const std::string volume : {"box: (-2,-2,-2)(2,2,2)", "sphere: (0,0,0) 2"}) {
        std::string scene = cubes;
        const std::string declared = "box: (-2,-2,-2)(2,2,2)";
        folder.write("a.pxm", scene.replace(scene.find(declared), declared.size(), volume));
        (void)expect_done(folder, {"export", "a.pxm", "-o", "a.pov", "--levels", "2", "--quiet"});
        const Outcome outcome =
            run_shell(folder, "povray +Ia.pov +Oa.ppm +FP +W320 +H240 -D -GA 2>&1");
        ASSERT_EQ(outcome.exit_code, 0) << outcome.out;
        (void)expect_done(folder, {"render", "a.pxm", "-o", "b.ppm", "--quiet", "--set",
                                   "object.a.levels=2", "--numeric", "double"});
        const std::vector<bool> theirs = silhouette(folder.read("a.ppm"));
        const std::vector<bool> ours = silhouette(folder.read("b.ppm"));
        ASSERT_EQ(theirs.size(), ours.size());
        std::size_t covered = 0, different = 0;
        for (std::size_t i = 0; i < ours.size(); ++i) {
            covered += ours[i] ? 1 : 0;
            different += ours[i] != theirs[i] ? 1 : 0;
        }
        EXPECT_GT(covered, 300U) << volume;
        EXPECT_LT(different, covered / 20) << volume;  // pixels on edges
    }
}

}  // namespace
}  // namespace pxm::test
