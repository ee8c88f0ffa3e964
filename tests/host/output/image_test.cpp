// Laws of pictures as files.
#include "host/output/image.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "host/error.hpp"
#include "host/files/image_reader.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// A frame of a crop window in which every number is another one.
Frame numbered_frame() {
    Frame frame({8, 8}, {2, 1, 5, 3});
    float n = 0;
    for (PixelRecord& pixel : frame.pixels) {
        for (float& c : pixel.color) c = (n += 1) / 20;
        pixel.alpha = n += 1;
        pixel.z = n += 1;
        for (float& c : pixel.normal) c = -(n += 1);
        pixel.object = static_cast<std::int32_t>(n += 1);
        pixel.level = static_cast<std::int32_t>(n += 1);
        pixel.word = 0xFF'FF00U + static_cast<std::uint32_t>(n += 1);
        pixel.node = static_cast<std::uint16_t>(n += 1);
        pixel.volumes = static_cast<std::uint32_t>(n += 1);
        pixel.heap = static_cast<std::uint32_t>(n += 1);
        pixel.cycles = static_cast<std::uint64_t>(n += 1);
    }
    return frame;
}

TEST(Image, an_exr_gives_back_every_channel_and_the_metadata) {
    const test::Folder folder;
    const Frame frame = numbered_frame();
    write_image(folder.path("a.exr"), frame, all_aovs(), {{"scene", "a \"b\".pxm"}, {"x", "1"}});
    const LoadedImage a = read_image(folder.path("a.exr"));
    ASSERT_EQ(a.width, 3);
    ASSERT_EQ(a.height, 2);
    EXPECT_EQ(a.channels.size(), 4 + 10 + 3U);
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        const PixelRecord& pixel = frame.pixels[i];
        const auto at = [&](const char* name) {
            EXPECT_GE(a.channel(name), 0) << name;
            return a.at(i, a.channel(name));
        };
        EXPECT_EQ(at("R"), pixel.color[0]);
        EXPECT_EQ(at("G"), pixel.color[1]);
        EXPECT_EQ(at("B"), pixel.color[2]);
        EXPECT_EQ(at("A"), 1);
        EXPECT_EQ(at("Z"), pixel.z);
        EXPECT_EQ(at("node.V"), static_cast<float>(pixel.node));
        EXPECT_EQ(at("cycles.V"), static_cast<float>(pixel.cycles));
        EXPECT_EQ(at("volumes.V"), static_cast<float>(pixel.volumes));
        EXPECT_EQ(at("level.V"), static_cast<float>(pixel.level));
        EXPECT_EQ(at("heap.V"), static_cast<float>(pixel.heap));
        EXPECT_EQ(at("alpha.V"), pixel.alpha);
        EXPECT_EQ(at("object.V"), static_cast<float>(pixel.object));
        EXPECT_EQ(static_cast<std::uint32_t>(at("word.V")), pixel.word) << "24 bits are exact";
        EXPECT_EQ(at("N.X"), pixel.normal[0]);
        EXPECT_EQ(at("N.Y"), pixel.normal[1]);
        EXPECT_EQ(at("N.Z"), pixel.normal[2]);
    }
    ASSERT_NE(a.find("scene"), nullptr);
    EXPECT_EQ(*a.find("scene"), "a \"b\".pxm");
    EXPECT_EQ(a.find("y"), nullptr);
}

TEST(Image, the_names_in_an_exr_are_those_that_other_programs_take) {
    const test::Folder folder;
    write_image(folder.path("a.exr"), numbered_frame(), {Aov::word}, {{"scene", "s"}});
    const LoadedImage a = read_image(folder.path("a.exr"));
    EXPECT_EQ(a.channels, (std::vector<std::string>{"R", "G", "B", "A", "word.V"}));
    for (const Aov aov : all_aovs()) {
        for (const AovChannel& channel : channels_of(aov)) {
            EXPECT_TRUE(channel.name == "Z" || channel.name.find('.') != std::string::npos);
            EXPECT_EQ(channel.name.find(':'), std::string::npos);
        }
    }
    const std::string bytes = folder.read("a.exr");
    EXPECT_NE(bytes.find("pxm_scene"), std::string::npos);
    EXPECT_EQ(bytes.find("pxm:"), std::string::npos);
}

TEST(Image, a_miss_is_infinitely_far_in_the_file_too) {
    const test::Folder folder;
    write_image(folder.path("a.exr"), Frame({1, 1}, {0, 0, 1, 1}), {Aov::z}, {});
    const LoadedImage a = read_image(folder.path("a.exr"));
    EXPECT_EQ(a.at(0, a.channel("Z")), infinity);
}

TEST(Image, colors_beyond_one_are_kept_in_an_exr_and_clipped_in_a_png) {
    const test::Folder folder;
    Frame frame({1, 1}, {0, 0, 1, 1});
    frame.pixels[0].color[0] = 4;
    frame.pixels[0].color[1] = -1;
    frame.pixels[0].color[2] = 0.5F;
    write_image(folder.path("a.exr"), frame, {}, {});
    write_image(folder.path("a.png"), frame, {}, {});
    EXPECT_EQ(read_image(folder.path("a.exr")).values, (std::vector<float>{4, -1, 0.5F, 1}));
    EXPECT_EQ(read_image(folder.path("a.png")).values, (std::vector<float>{1, 0, 188 / 255.0F}));
}

TEST(Image, equal_pictures_are_equal_png_files_whatever_made_them) {
    const test::Folder folder;
    write_image(folder.path("a.png"), numbered_frame(), {}, {{"engine", "native"}});
    write_image(folder.path("b.png"), numbered_frame(), {}, {{"engine", "machine"}});
    EXPECT_TRUE(folder.read("a.png") == folder.read("b.png"));
}

TEST(Image, the_extension_decides_and_its_case_does_not_matter) {
    const test::Folder folder;
    for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg", "A.PNG", "a.b.Exr"}) {
        EXPECT_NO_THROW(require_image_format(folder.path(name), {})) << name;
        write_image(folder.path(name), numbered_frame(), {}, {});
        EXPECT_EQ(read_image(folder.path(name)).width, 3) << name;
    }
    for (const char* name : {"a", "a.", "folder.png/a", "a.txt", "a.null", "a.term"}) {
        EXPECT_THROW(require_image_format(name, {}), Error) << name;
    }
    EXPECT_THROW(require_image_format("a.png", {Aov::z}), Error);
    EXPECT_NO_THROW(require_image_format("a.EXR", {Aov::z}));
}

TEST(Image, a_picture_that_cannot_be_written_leaves_nothing) {
    const test::Folder folder;
    // An icon has at most 256 pixels a side.
    const Frame wide({300, 1}, {0, 0, 300, 1});
    try {
        write_image(folder.path("a.ico"), wide, {}, {});
        FAIL() << "it was written";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        EXPECT_NE(std::string(error.what()).find("cannot write " + folder.path("a.ico")),
                  std::string::npos);
        EXPECT_EQ(std::string(error.what()).find("part"), std::string::npos) << error.what();
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace pxm::host
