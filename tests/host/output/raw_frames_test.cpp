// Laws of frames as other programs take them from a pipe.
#include "host/output/raw_frames.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/folder.hpp"

namespace pxm::host {
namespace {

std::string written(RawFormat format, const FilmShape& shape,
                    const std::vector<std::vector<unsigned char>>& frames) {
    const test::Folder folder;
    {
        CheckedFile file(open(folder.path("out").c_str(), O_CREAT | O_WRONLY, 0600), "out",
                         Places::in_order);
        const auto stream = make_raw_stream(file, format, shape);
        for (const auto& frame : frames) stream->frame(frame);
        stream->finish();
    }
    return folder.read("out");
}

TEST(RawFrames, a_ppm_is_a_head_and_the_bytes_of_each_frame) {
    const std::vector<unsigned char> a{1, 2, 3, 4, 5, 6}, b{7, 8, 9, 10, 11, 12};
    const std::string head = "P6\n2 1\n255\n";
    EXPECT_EQ(written(RawFormat::ppm, {2, 1, 25}, {a, b}),
              head + std::string(a.begin(), a.end()) + head + std::string(b.begin(), b.end()));
}

TEST(RawFrames, a_y4m_tells_its_rate_as_a_fraction) {
    const auto head = [](double rate) {
        const std::string all = written(RawFormat::y4m, {2, 1, rate}, {});
        return all.substr(0, all.find('\n'));
    };
    EXPECT_EQ(head(25), "YUV4MPEG2 W2 H1 F25:1 Ip A1:1 C444 XCOLORRANGE=LIMITED");
    EXPECT_EQ(head(12.5).substr(15, 12), " F12500:1000");
    EXPECT_EQ(head(30000.0 / 1001).substr(15, 12), " F30000:1001");
}

TEST(RawFrames, y4m_is_BT_709_to_the_nearest_byte) {
    std::mt19937 random(5);
    std::vector<unsigned char> rgb{0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255};
    while (rgb.size() < 3 * 1000) rgb.push_back(static_cast<unsigned char>(random() % 256));
    const std::string all = written(RawFormat::y4m, {1000, 1, 25}, {rgb});
    const std::size_t at = all.find("\nFRAME\n") + 7;
    ASSERT_EQ(all.size(), at + 3000);
    for (std::size_t i = 0; i < 1000; ++i) {
        const double r = rgb[3 * i] / 255.0, g = rgb[3 * i + 1] / 255.0, b = rgb[3 * i + 2] / 255.0;
        const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
        const double values[] = {16 + 219 * y, 128 + 224 * (b - y) / 1.8556,
                                 128 + 224 * (r - y) / 1.5748};
        for (std::size_t plane = 0; plane < 3; ++plane) {
            const int byte = static_cast<unsigned char>(all[at + 1000 * plane + i]);
            EXPECT_NEAR(byte, values[plane], 0.51) << i << " " << plane;
        }
    }
}

}  // namespace
}  // namespace pxm::host
