// Laws of `pxm render --aov neighbours`: cells are told by the neighbours that they have.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "host/files/image_reader.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using host::LoadedImage;
using host::read_image;

/// A filled square of nine, seen from above, one pixel of detail for 3x3 cells at level `levels`.
std::string square_scene(int levels) {
    std::string text = "ifs square {\n";
    for (int i = 0; i < 9; ++i)
        text += "newmap scale: 1/3 translate: " + std::to_string(i % 3) + "/3," +
                std::to_string(i / 3) + "/3,0\n";
    return text + "}\nobject a { ifs: square auto levels: " + std::to_string(levels) +
           " }\ncamera { orthographic: 1 eye: 0.5,0.5,5 look: 0.5,0.5,0 up: 0,1,0 }\n"
           "image { size: 90,90 }\n";
}

class NeighbourChannel : public testing::Test {
  protected:
    LoadedImage render(const std::string& scene, Arguments options = {}) {
        folder.write("a.pxm", scene);
        options.insert(options.begin(),
                       {"render", "a.pxm", "-o", "a.exr", "--aov", "neighbours,word"});
        expect_done(folder, options);
        return read_image(folder.path("a.exr"));
    }
    Folder folder;
};

/// Of nine squares of a level the middle one has eight neighbours, those at the sides five and
/// those in the corners three: of nine kinds. At the next level no kinds are added.
TEST_F(NeighbourChannel, squares_have_nine_kinds_of_neighbourhoods) {
    for (const int levels : {1, 2}) {
        const LoadedImage a = render(square_scene(levels), {"--volume", "box"});
        std::map<int, int> pixels;
        std::map<int, std::set<int>> kinds_of_words;
        const int side = a.width / (levels == 1 ? 3 : 9);
        std::map<int, int> kind_of_place;  // by row and column: low, middle or high
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) {
                const auto i = static_cast<std::size_t>(y * a.width + x);
                const int kind = static_cast<int>(a.at(i, a.channel("neighbours.V")));
                ++pixels[kind];
                kinds_of_words[static_cast<int>(a.at(i, a.channel("word.V")))].insert(kind);
                const auto third = [&](int at) {
                    const int cell = at / side, last = a.width / side - 1;
                    return cell == 0 ? 0 : cell == last ? 2 : 1;
                };
                const bool on_edge =
                    x % side == 0 || y % side == 0 || x % side == side - 1 || y % side == side - 1;
                if (on_edge) continue;
                const auto [place, added] = kind_of_place.emplace(3 * third(y) + third(x), kind);
                EXPECT_EQ(place->second, kind) << x << "," << y;
            }
        EXPECT_EQ(pixels.size(), 9U) << levels;
        EXPECT_EQ(pixels.count(0), 0U);
        EXPECT_EQ(kind_of_place.size(), 9U);
        for (const auto& [word, kinds] : kinds_of_words) EXPECT_EQ(kinds.size(), 1U) << word;
    }
}

TEST_F(NeighbourChannel, what_shows_no_cell_has_none) {
    const LoadedImage a = render(tetra_scene, {"--size", "40x30"});
    for (std::size_t i = 0; i < 1200; ++i)
        EXPECT_EQ(a.at(i, a.channel("neighbours.V")) > 0, a.at(i, a.channel("word.V")) > 0);
}

TEST_F(NeighbourChannel, cells_that_are_proven_apart_by_intervals_have_no_neighbours) {
    folder.write("a.pxm", "ifs a { newmap scale: 1/pi newmap scale: 1/pi translate: 1,0,0 }\n");
    const Outcome made =
        run(folder, {"render", "a.pxm", "-o", "a.exr", "--aov", "neighbours", "--size", "16x12"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_TRUE(folder.has("a.exr"));
}

TEST_F(NeighbourChannel, where_there_is_no_finite_graph_it_says_why) {
    folder.write("a.pxm", "ifs a { newmap scale: 2/pi newmap scale: 2/pi translate: 0.3,0,0 }\n");
    expect_refusal(folder, {"render", "a.pxm", "-o", "a.exr", "--aov", "neighbours"}, 2,
                   "--aov neighbours: ifs a: the images of map 1 and map 2 were not told apart, in "
                   "intervals of 60 digits, which do not decide equality");
    EXPECT_FALSE(folder.has("a.exr"));
    folder.write("a.pxm", "ifs a { newmap scale: 3/4 newmap scale: 3/4 translate: 1/4,0,0 }\n");
    expect_refusal(folder, {"render", "a.pxm", "-o", "a.exr", "--aov", "neighbours"}, 2,
                   "--aov neighbours: ifs a: not finite within 10000 types");
    expect_refusal(folder,
                   {"render", "a.pxm", "-o", "a.exr", "--aov", "neighbours", "--machine", "964"}, 2,
                   "--aov neighbours: only native renders read the words of cells (no --machine)");
}

}  // namespace
}  // namespace pxm::test
