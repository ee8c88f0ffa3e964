// Laws of pictures that are read: what is understood, within limits, and from no other place.
#define FMT_EXCEPTIONS 1  // OpenImageIO's headers would switch them off
#include "host/files/image_reader.hpp"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "host/files/exr_header.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

namespace fs = std::filesystem;

OIIO::ImageSpec spec_of(int width, int height, int channels,
                        OIIO::TypeDesc type = OIIO::TypeDesc::FLOAT) {
    return {width, height, channels, type};
}

/// A picture in which every number is another one, written by OpenImageIO.
std::vector<float> write_numbered(const std::string& path, const OIIO::ImageSpec& spec) {
    std::vector<float> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i) / static_cast<float>(values.size());
    const auto file = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(file && file->open(path, spec) &&
                file->write_image(OIIO::TypeDesc::FLOAT, values.data()) && file->close())
        << OIIO::geterror();
    return values;
}

/// The values of a picture, row by row.
std::vector<float> read_rows(const std::string& path) {
    ImageReader reader(path, any_image);
    const ImageHeader& header = reader.header();
    std::vector<float> values;
    for (int y = 0; y < header.height; ++y) {
        const float* row = reader.next_row();
        values.insert(values.end(), row,
                      row + static_cast<std::size_t>(header.width) * header.channels.size());
    }
    return values;
}

class Reading : public testing::Test {
  protected:
    [[nodiscard]] std::string refusal(const std::string& name,
                                      const ImageLimits& limits = any_image) const {
        const std::string path = folder.path(name);
        const std::string text = test::error_of([&] { ImageReader reader(path, limits); });
        const std::string told = "4: cannot read " + path + ": ";
        return text.starts_with(told) ? text.substr(told.size()) : text;
    }
    test::Folder folder;
};

TEST_F(Reading, rows_are_the_picture_whatever_pieces_it_is_kept_in) {
    OIIO::ImageSpec lines = spec_of(37, 150, 3);
    OIIO::ImageSpec tiles = lines;
    tiles.tile_width = 16;
    tiles.tile_height = 32;
    OIIO::ImageSpec moved = tiles;  // a data window with an origin of its own
    moved.x = 5;
    moved.y = -7;
    for (const OIIO::ImageSpec& spec : {lines, tiles, moved}) {
        const std::vector<float> values = write_numbered(folder.path("a.exr"), spec);
        EXPECT_EQ(read_rows(folder.path("a.exr")), values);
    }
    for (OIIO::ImageSpec spec : {lines, tiles}) {
        spec.attribute("tiff:RowsPerStrip", 50);
        const std::vector<float> values = write_numbered(folder.path("a.tif"), spec);
        EXPECT_EQ(read_rows(folder.path("a.tif")), values);
    }
}

TEST_F(Reading, a_format_is_known_by_its_content_whatever_the_name) {
    const OIIO::ImageSpec spec = spec_of(4, 3, 3, OIIO::TypeDesc::UINT8);
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.ppm", "a.exr"}) {
        (void)write_numbered(folder.path(name), spec);
        for (const char* other : {"b", "b.exr", "b.null?RES=64x64", "http:b"}) {
            fs::copy_file(folder.path(name), folder.path(other),
                          fs::copy_options::overwrite_existing);
            ImageReader reader(folder.path(other), any_image);
            EXPECT_EQ(reader.header().width, 4) << name << ' ' << other;
            EXPECT_EQ(reader.header().height, 3) << name << ' ' << other;
        }
    }
}

TEST_F(Reading, a_name_is_a_file_and_no_request) {
    for (const char* name : {"x.null?RES=8x8&CHANNELS=3&PIXEL=0.25,0.5,0.125", "x.null?RES=64x64",
                             "http://127.0.0.1:1/a.mp4", "none.png"})
        EXPECT_EQ(refusal(name), "no such file");
    ASSERT_EQ(mkfifo(folder.path("pipe.png").c_str(), 0666), 0);
    EXPECT_EQ(refusal("pipe.png"), "not a regular file");
    EXPECT_EQ(refusal("."), "is a directory");
    EXPECT_EQ(refusal("/dev/null"), "not a regular file");
}

TEST_F(Reading, what_pxm_does_not_read_is_told_by_its_name) {
    const OIIO::ImageSpec spec = spec_of(4, 3, 3, OIIO::TypeDesc::UINT8);
    for (const auto& [name, format] : {std::pair{"a.gif", "GIF"},
                                       {"a.bmp", "BMP"},
                                       {"a.hdr", "Radiance HDR"},
                                       {"a.sgi", "SGI"},
                                       {"a.dpx", "DPX"}}) {
        (void)write_numbered(folder.path(name), spec);
        EXPECT_EQ(refusal(name), fmt::format("it is {}, and pxm reads PNG, JPEG, OpenEXR, TIFF and "
                                             "PNM: convert it to one of these",
                                             format));
    }
    folder.write("volume.png", "DDS |");
    EXPECT_TRUE(refusal("volume.png").starts_with("it is DDS, and pxm reads PNG, "));
    folder.write("text.png", "no picture\n");
    folder.write("empty.png", "");
    for (const char* name : {"text.png", "empty.png"})
        EXPECT_EQ(refusal(name), "not a picture (PNG, JPEG, OpenEXR, TIFF or PNM)");
}

TEST_F(Reading, the_first_of_several_pictures_is_read) {
    const std::string path = folder.path("a.tif");
    const std::vector<float> first = write_numbered(path, spec_of(4, 3, 3));
    const auto file = OIIO::ImageOutput::create(path);
    const OIIO::ImageSpec second = spec_of(9, 9, 1);
    const std::vector<float> values(81, 0.5F);
    ASSERT_TRUE(file->open(path, spec_of(4, 3, 3)) &&
                file->write_image(OIIO::TypeDesc::FLOAT, first.data()) &&
                file->open(path, second, OIIO::ImageOutput::AppendSubimage) &&
                file->write_image(OIIO::TypeDesc::FLOAT, values.data()) && file->close());
    EXPECT_EQ(read_rows(path), first);
}

TEST_F(Reading, what_is_larger_than_a_limit_is_refused_before_it_is_unpacked) {
    for (const char* name : {"a.png", "a.jpg", "a.tif", "a.ppm", "a.exr"}) {
        (void)write_numbered(folder.path(name), spec_of(6, 4, 3, OIIO::TypeDesc::UINT8));
        EXPECT_EQ(refusal(name, {6, 24}), "") << name;
        EXPECT_EQ(refusal(name, {5, 24}), "6 x 4 pixels are more than 24 in all or 5 a side");
        EXPECT_EQ(refusal(name, {6, 23}), "6 x 4 pixels are more than 23 in all or 6 a side");
        if (std::string(name) == "a.jpg") continue;  // what is cut off is no JPEG to its reader
        fs::resize_file(folder.path(name), fs::file_size(folder.path(name)) * 9 / 10);
        EXPECT_EQ(refusal(name, {6, 23}), "6 x 4 pixels are more than 23 in all or 6 a side")
            << "the claim is enough";
    }
    (void)write_numbered(folder.path("many.exr"), spec_of(1, 1, most_channels + 1));
    EXPECT_EQ(refusal("many.exr"), "257 channels are more than 256");
    (void)write_numbered(folder.path("wide.exr"), spec_of(row_values / 16 + 1, 1, 16));
    EXPECT_EQ(refusal("wide.exr", {100'000, 100'000}),
              "65537 x 1 pixels of 16 channels are more than pxm takes at a time (1048576 values a "
              "row, 67108864 in a row of tiles)");
}

TEST_F(Reading, the_sizes_of_an_exr_are_those_of_its_header) {
    OIIO::ImageSpec spec = spec_of(70, 50, 5);
    spec.x = -3;
    spec.tile_width = 16;
    spec.tile_height = 32;
    (void)write_numbered(folder.path("a.exr"), spec);
    const ExrSizes sizes = largest_exr_sizes(RegularFile(folder.path("a.exr")));
    EXPECT_EQ(sizes.width, 70);
    EXPECT_EQ(sizes.height, 50);
    EXPECT_EQ(sizes.channels, 5);
    EXPECT_EQ(sizes.tile_width, 16);
    EXPECT_EQ(sizes.tile_height, 32);
    const std::string whole = folder.read("a.exr");
    for (std::size_t bytes = 5; bytes < 250; bytes += 7) {
        folder.write("cut.exr", whole.substr(0, bytes));
        EXPECT_EQ(refusal("cut.exr"), "its OpenEXR header is broken or cut off") << bytes;
    }
}

TEST_F(Reading, a_picture_that_is_cut_off_is_an_error_and_no_guess) {
    for (const char* name : {"a.png", "a.tif", "a.ppm", "a.exr"}) {
        (void)write_numbered(folder.path(name), spec_of(50, 40, 3, OIIO::TypeDesc::UINT16));
        fs::resize_file(folder.path(name), fs::file_size(folder.path(name)) / 2);
        const std::string text = test::error_of([&] { (void)read_rows(folder.path(name)); });
        EXPECT_TRUE(text.starts_with("4: cannot read " + folder.path(name) + ": ")) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
}

TEST_F(Reading, only_the_channels_that_are_wanted_are_kept) {
    OIIO::ImageSpec spec = spec_of(3, 2, 5);
    spec.channelnames = {"R", "G", "B", "A", "Z"};
    const std::vector<float> values = write_numbered(folder.path("a.exr"), spec);
    const LoadedImage image = read_image(folder.path("a.exr"), {"B", "Z"});
    EXPECT_EQ(image.channels, (std::vector<std::string>{"R", "B", "Z"})) << "the first is always";
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(image.at(i, 0), values[5 * i]);
        EXPECT_EQ(image.at(i, 1), values[5 * i + 2]);
        EXPECT_EQ(image.at(i, 2), values[5 * i + 4]);
    }
}

TEST(Srgb, the_curve_back_undoes_the_curve) {
    EXPECT_EQ(linear_from_srgb(0), 0);
    EXPECT_EQ(linear_from_srgb(1), 1);
    EXPECT_NEAR(linear_from_srgb(0.461356F), 0.18, 1e-6);
}

}  // namespace
}  // namespace pxm::host
