// Laws of EXR files: OpenEXR alone writes what OpenImageIO would write with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host/files/picture_library.hpp"

namespace pxm::host {
namespace {

/// A file in memory, of which so many bytes can be written.
class Bytes : public FileBytes {
  public:
    explicit Bytes(std::size_t room) : room_(room) {}

    bool write_at(std::int64_t place, const void* data, std::size_t count) noexcept override {
        const auto end = static_cast<std::size_t>(place) + count;
        if (full_ || end > room_) return full_ = true, false;
        if (text.size() < end) text.resize(end);
        std::memcpy(text.data() + place, data, count);
        return true;
    }
    std::size_t read_at(std::int64_t place, void* data, std::size_t count) noexcept override {
        const auto at = static_cast<std::size_t>(place);
        if (at >= text.size()) return 0;
        const std::size_t got = std::min(count, text.size() - at);
        std::memcpy(data, text.data() + at, got);
        return got;
    }
    std::int64_t size() noexcept override { return static_cast<std::int64_t>(text.size()); }

    std::string text;

  private:
    std::size_t room_;
    bool full_ = false;
};

PictureSpec some_spec(int width, int height) {
    PictureSpec spec;
    spec.width = width;
    spec.height = height;
    spec.floats = true;
    spec.color_space = "Linear";
    spec.channels = {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "word.V"};
    spec.metadata = {{"DateTime", "1970:01:01 00:00:00"},
                     {"Software", "pxm"},
                     {"compression", "zip"},
                     {"pxm_scene", "a scene.pxm"},
                     {"pxm_model", ""}};
    return spec;
}

std::vector<float> some_values(const PictureSpec& spec) {
    std::mt19937 random(static_cast<unsigned>(spec.width));
    std::vector<float> values(static_cast<std::size_t>(spec.width * spec.height) *
                              spec.channels.size());
    for (float& value : values) value = static_cast<float>(random() % 100) / 8;
    values.back() = std::numeric_limits<float>::infinity();
    return values;
}

/// In bands of 64 rows; false if it failed.
bool write(PictureLibrary& library, const PictureSpec& spec, Bytes& bytes) {
    std::string error;
    const auto output = library.create("a.exr", error);
    if (!output->takes(bytes) || !output->open("a.exr", spec)) return false;
    const std::vector<float> values = some_values(spec);
    const std::size_t row = static_cast<std::size_t>(spec.width) * spec.channels.size();
    bool whole = true;
    for (int first = 0; first < spec.height; first += 64) {
        const int end = std::min<int>(first + 64, static_cast<int>(spec.height));
        whole = output->write_floats(first, end,
                                     values.data() + row * static_cast<std::size_t>(first)) &&
                whole;  // goes on after a failure
    }
    return output->close() && whole;
}

TEST(Exr, is_the_file_that_the_image_library_writes) {
    for (const auto& [width, height] : {std::pair{1, 1}, {70, 53}, {33, 200}, {257, 130}}) {
        const PictureSpec spec = some_spec(width, height);
        Bytes own(1 << 24), library(1 << 24);
        ASSERT_TRUE(write(exr_library(), spec, own));
        ASSERT_TRUE(write(picture_library(), spec, library));
        EXPECT_GT(own.text.size(), 400U);
        EXPECT_TRUE(own.text == library.text) << width << "x" << height;
    }
}

TEST(Exr, that_cannot_be_written_fails_and_ends) {
    const PictureSpec spec = some_spec(64, 300);
    for (const std::size_t room : {0U, 100U, 1000U, 5000U, 50'000U}) {
        Bytes full(room);
        EXPECT_FALSE(write(exr_library(), spec, full)) << room;
    }
}

}  // namespace
}  // namespace pxm::host
