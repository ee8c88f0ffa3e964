// Laws of `pxm render`: what it writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "host/files/image_reader.hpp"
#include "host/output/pixel_values.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using host::LoadedImage;
using host::read_image;

class Render : public testing::Test {
  protected:
    Render() { folder.write("tetra.pxm", tetra_scene); }

    /// Renders tetra.pxm at 70x53, a size that is no multiple of a tile's.
    std::string render(const std::string& out, Arguments options = {},
                       const Environment& environment = {}) const {
        options.insert(options.begin(), {"render", "tetra.pxm", "-o", out, "--size", "70x53"});
        return expect_done(folder, options, environment);
    }
    [[nodiscard]] LoadedImage image(const std::string& name) const {
        return read_image(folder.path(name));
    }
    Folder folder;
};

const std::string all_channels = "Z,node,volumes,level,heap,alpha,object,word,N";

std::size_t pixels(const LoadedImage& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

TEST_F(Render, a_lone_ifs_is_framed_and_lit) {
    expect_done(folder, {"render", "tetra.pxm", "--size", "160x120", "-o", "a.exr", "--aov", "Z"});
    const LoadedImage a = image("a.exr");
    int left = a.width, right = -1, top = a.height, bottom = -1, hits = 0;
    std::set<int> greys;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const auto i = static_cast<std::size_t>(y * a.width + x);
            if (!std::isfinite(a.at(i, a.channel("Z")))) continue;
            ++hits;
            greys.insert(static_cast<int>(a.at(i, a.channel("R")) * 255));
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    }
    EXPECT_GT(hits, a.width * a.height / 20);
    EXPECT_LT(hits, a.width * a.height / 2);
    EXPECT_GE(greys.size(), 8U);
    EXPECT_LT(*greys.begin() + 60, *greys.rbegin());
    // The bounding ball fits with a tenth of margin: it fills most of the height, and touches no
    // side.
    EXPECT_GT(bottom - top, a.height / 2);
    EXPECT_GE(std::min({left, top, a.width - 1 - right, a.height - 1 - bottom}), 2);
}

TEST_F(Render, the_picture_does_not_depend_on_threads_or_runs) {
    render("1.exr", {"--threads", "1", "--aov", all_channels});
    render("3.exr", {"--threads", "3", "--aov", all_channels});
    EXPECT_TRUE(folder.read("1.exr") == folder.read("3.exr"));
    const std::string first = folder.read("3.exr");
    render("3.exr", {"--threads", "3", "--aov", all_channels});
    EXPECT_TRUE(folder.read("3.exr") == first);
    render("1.png", {"--threads", "1", "--no-scene"});
    render("3.png", {"--threads", "3", "--no-scene"});
    EXPECT_TRUE(folder.read("1.png") == folder.read("3.png"));
    render("m.png", {"--machine", "964dX", "--threads", "3", "--no-scene"});
    EXPECT_TRUE(folder.read("1.png") == folder.read("m.png")) << "machine and native";
}

TEST_F(Render, the_date_is_that_of_SOURCE_DATE_EPOCH) {
    render("a.exr", {}, {"SOURCE_DATE_EPOCH=1000000000"});
    EXPECT_NE(folder.read("a.exr").find("2001:09:09 01:46:40"), std::string::npos);
    render("b.exr");
    EXPECT_NE(folder.read("b.exr").find("1970:01:01 00:00:00"), std::string::npos);
}

TEST_F(Render, the_metadata_says_how_it_was_made) {
    render("a.exr", {"--machine", "964dX", "--numeric", "double", "--levels", "3"});
    const LoadedImage a = image("a.exr");
    const auto told = [&](const char* name) {
        const std::string* text = a.find(name);
        return text ? *text : "(nothing)";
    };
    EXPECT_EQ(told("scene"), "tetra.pxm");
    EXPECT_EQ(told("engine"), "machine");
    EXPECT_EQ(told("model"), "964dX");
    EXPECT_EQ(told("numeric"), "double");
    EXPECT_EQ(told("options"), "--size 70x53 --levels 3");
    EXPECT_EQ(told("version"), PXM_VERSION);
}

TEST_F(Render, a_png_holds_the_srgb_curve_of_the_exr) {
    render("a.exr");
    render("a.png");
    const LoadedImage linear = image("a.exr");
    const LoadedImage bytes = image("a.png");
    ASSERT_EQ(bytes.channels, (std::vector<std::string>{"R", "G", "B"}));
    ASSERT_EQ(pixels(linear), pixels(bytes));
    for (std::size_t i = 0; i < pixels(bytes); ++i) {
        for (int c = 0; c < 3; ++c) {
            ASSERT_EQ(std::lround(host::srgb_from_linear(linear.at(i, c)) * 255),
                      std::lround(bytes.at(i, c) * 255));
        }
    }
}

TEST_F(Render, the_channels_say_what_happened) {
    render("a.exr", {"--aov", all_channels, "--intersect", "heap"});
    const LoadedImage a = image("a.exr");
    std::size_t hits = 0;
    for (std::size_t i = 0; i < pixels(a); ++i) {
        const auto at = [&](const char* name) { return a.at(i, a.channel(name)); };
        const int x = static_cast<int>(i) % a.width, y = static_cast<int>(i) / a.width;
        ASSERT_EQ(at("node.V"), static_cast<float>(y % 8 * 8 + x % 8)) << x << "," << y;
        const bool hit = std::isfinite(at("Z"));
        hits += hit;
        ASSERT_EQ(at("alpha.V"), hit ? 1 : 0);
        ASSERT_EQ(at("object.V"), hit ? 0 : -1);
        ASSERT_GE(at("volumes.V"), 1);
        if (hit) {
            ASSERT_GT(at("Z"), 0);
            ASSERT_GE(at("level.V"), 1);
            ASSERT_NE(at("word.V"), 0);
            ASSERT_GE(at("heap.V"), 1);
            ASSERT_GT(std::hypot(at("N.X"), at("N.Y"), at("N.Z")), 0);
        } else {
            ASSERT_TRUE(at("Z") > 0) << "infinite, not a NaN";
            ASSERT_EQ(at("level.V"), -1);
            ASSERT_EQ(at("word.V"), 0);
        }
    }
    EXPECT_GT(hits, 0U);
    EXPECT_LT(hits, pixels(a));
}

TEST_F(Render, a_crop_is_that_window_of_the_whole) {
    render("whole.exr", {"--aov", "Z,word"});
    render("part.exr", {"--aov", "Z,word", "--crop", "21,13,50,40"});
    const LoadedImage whole = image("whole.exr");
    const LoadedImage part = image("part.exr");
    ASSERT_EQ(part.width, 29);
    ASSERT_EQ(part.height, 27);
    for (std::size_t i = 0; i < pixels(part); ++i) {
        const std::size_t x = i % 29 + 21, y = i / 29 + 13;
        for (int c = 0; c < 5; ++c) ASSERT_EQ(part.at(i, c), whole.at(y * 70 + x, c));
    }
}

TEST_F(Render, an_existing_picture_is_replaced_and_nothing_else_is_left) {
    folder.write("a.png", "an older picture");
    const std::string told = render("a.png");
    EXPECT_EQ(folder.read("a.png").substr(0, 4), "\x89PNG");
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "tetra.pxm"}));
    EXPECT_EQ(told.rfind("a.png: 70x53 in ", 0), 0U) << told;
    EXPECT_EQ(std::ranges::count(told, '\n'), 1);
}

TEST_F(Render, without_out_the_picture_has_the_scenes_name) {
    expect_done(folder, {"render", "tetra.pxm", "--size", "8x8"});
    EXPECT_TRUE(folder.has("tetra.png"));
}

TEST_F(Render, off_a_terminal_there_is_no_progress_bar_and_quiet_is_silent) {
    EXPECT_EQ(render("a.png").find_first_of("\r\033"), std::string::npos);
    EXPECT_EQ(render("a.png", {"--quiet"}), "");
}

}  // namespace
}  // namespace pxm::test
