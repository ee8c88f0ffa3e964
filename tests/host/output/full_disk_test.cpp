// Laws of pictures on a disk that is full: whatever the format and wherever it is full, the write
// is an error, and the picture of before stays.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "host/error.hpp"
#include "host/files/image_reader.hpp"
#include "host/output/image.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

using test::FileSizeLimit;
using test::Folder;

/// Every kind of file that a picture can be.
const std::vector<std::string> formats{"png",  "exr", "tif", "jpg", "bmp", "gif", "tga", "sgi",
                                       "fits", "jp2", "hdr", "ppm", "dpx", "rla", "ico", "webp"};

/// Noise, of which no format makes little.
Frame noise(long columns, long rows) {
    std::mt19937 random(14);
    Frame frame({columns, rows}, {0, 0, columns, rows});
    for (PixelRecord& pixel : frame.pixels) {
        for (float& c : pixel.color) c = static_cast<float>(random() % 1000) / 1000.0F;
    }
    return frame;
}

/// As a render writes it: in bands.
void write_in_bands(const std::string& path, const Frame& frame) {
    ImageWriter writer(path, frame.crop, {}, {});
    for (long top = 0; top < frame.rows(); top += 8) {
        Frame band(frame.size, {0, top, frame.columns(), std::min(top + 8, frame.rows())});
        for (std::size_t i = 0; i < band.pixels.size(); ++i)
            band.pixels[i] = frame.pixels[static_cast<std::size_t>(top * frame.columns()) + i];
        writer.append(band);
    }
    writer.finish();
}

std::string refusal(const std::string& path, const Frame& frame) {
    try {
        write_in_bands(path, frame);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        return error.what();
    }
    return "";
}

class FullDiskIn : public testing::TestWithParam<std::string> {};

TEST_P(FullDiskIn, loses_no_picture_wherever_it_is_full) {
    const Folder folder;
    const std::string path = folder.path("a." + GetParam());
    const Frame frame = noise(64, 48);
    write_in_bands(path, frame);
    const std::size_t whole = folder.read("a." + GetParam()).size();
    folder.write("a." + GetParam(), "old");
    const auto before = folder.contents();
    for (const std::size_t room : {std::size_t{0}, whole / 3, whole - 1}) {
        const FileSizeLimit limit(room);
        const std::string why = refusal(path, frame);
        EXPECT_EQ(why.rfind("cannot write " + path + ": ", 0), 0U) << room << ": " << why;
    }
    EXPECT_EQ(folder.contents(), before);
    const FileSizeLimit limit(4 * whole);  // some writers begin with more than they keep
    EXPECT_EQ(refusal(path, frame), "");
    EXPECT_EQ(folder.read("a." + GetParam()).size(), whole);
}

TEST(FullDisk, without_it_the_picture_can_be_read_back) {
    const Folder folder;
    const Frame frame = noise(40, 24);
    for (const char* name : {"a.png", "a.tif", "a.exr"}) {
        write_in_bands(folder.path(name), frame);
        const LoadedImage image = read_image(folder.path(name));
        ASSERT_EQ(image.width * image.height, 40 * 24) << name;
        for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                const float written = frame.pixels[i].color[c];
                const float read = image.at(i, c);
                EXPECT_NEAR(image.srgb ? linear_from_srgb(read) : read, written, 0.01) << name;
            }
        }
    }
}

TEST(FullDisk, equal_pictures_are_equal_files_in_every_format) {
    const Folder folder;
    const Frame frame = noise(24, 16);
    for (const std::string& format : formats) {
        // OpenImageIO's writer of SGI leaves bytes of the header as they were in memory.
        if (format == "sgi") continue;
        const std::string name = "a." + format;
        write_in_bands(folder.path(name), frame);
        const std::string first = folder.read(name);
        write_in_bands(folder.path(name), frame);
        EXPECT_TRUE(folder.read(name) == first) << format;
    }
}

INSTANTIATE_TEST_SUITE_P(EveryFormat, FullDiskIn, testing::ValuesIn(formats),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace pxm::host
