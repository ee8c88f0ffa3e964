// A picture that is taken while it is rendered is the one that a whole frame holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "host/files/image_reader.hpp"
#include "host/output/image.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

/// More than a band, and no whole number of tiles.
RenderRequest large_request(const Folder& folder) {
    folder.write("scene.pxm", tetra_text);
    RenderRequest request;
    request.scene_path = folder.path("scene.pxm");
    request.overrides.size = PixelSize{2003, 1901};
    request.overrides.crop = CropWindow{5, 3, 1999, 1897};
    request.threads = 2;
    return request;
}

/// Puts the parts together.
class Joiner : public PictureTaker {
  public:
    void begin(const RenderResult& known) override {
        window = known.window;
        joined = Frame(known.statistics.size, known.window);
        taken.assign(joined.pixels.size(), 0);
    }
    void take(const Frame& part) override {
        const std::lock_guard lock(mutex);
        ++parts;
        most_pixels = std::max(most_pixels, part.pixels.size());
        for (long y = part.crop.y0; y < part.crop.y1; ++y) {
            for (long x = part.crop.x0; x < part.crop.x1; ++x) {
                joined.at(x, y) = part.at(x, y);
                ++taken[static_cast<std::size_t>(&joined.at(x, y) - joined.pixels.data())];
            }
        }
    }

    Frame joined;
    CropWindow window;
    std::vector<int> taken;
    int parts = 0;
    std::size_t most_pixels = 0;

  private:
    std::mutex mutex;
};

class PictureParts : public testing::TestWithParam<IntersectMethod> {};

TEST_P(PictureParts, together_are_the_picture) {
    const Folder folder;
    RenderRequest request = large_request(folder);
    request.overrides.intersect = GetParam();
    const RenderResult whole = render(request, {});
    Joiner joiner;
    const RenderResult parts = render(request, {}, &joiner);
    EXPECT_GT(joiner.parts, 1);
    EXPECT_TRUE(parts.frame.pixels.empty());
    EXPECT_EQ(parts.window, whole.window);
    EXPECT_EQ(joiner.window, whole.window);
    EXPECT_EQ(std::ranges::count(joiner.taken, 1), std::ssize(whole.frame.pixels));
    EXPECT_TRUE(same_picture(joiner.joined, whole.frame));
    EXPECT_EQ(parts.statistics.rays.hits, whole.statistics.rays.hits);
    EXPECT_EQ(parts.statistics.rays.volumes_tested, whole.statistics.rays.volumes_tested);
}

TEST_P(PictureParts, fit_a_cache) {
    const Folder folder;
    RenderRequest request = large_request(folder);
    request.overrides.intersect = GetParam();
    Joiner joiner;
    (void)render(request, {}, &joiner);
    EXPECT_LE(joiner.most_pixels * sizeof(PixelRecord), std::size_t{256} << 10);
}

INSTANTIATE_TEST_SUITE_P(OfNativeEngines, PictureParts,
                         testing::Values(IntersectMethod::wide, IntersectMethod::fast),
                         [](const auto& test) {
                             return test.param == IntersectMethod::wide ? "wide" : "reference";
                         });

TEST(PictureParts, make_the_file_that_the_whole_frame_makes) {
    class Writer : public PictureTaker {
      public:
        explicit Writer(const std::string& path) : path_(path) {}
        void begin(const RenderResult& known) override {
            writer.emplace(path_, known.window, std::vector<Aov>{}, Metadata{});
        }
        void take(const Frame& part) override { writer->append(part); }
        std::optional<ImageWriter> writer;

      private:
        std::string path_;
    };
    const Folder folder;
    const RenderRequest request = large_request(folder);
    for (const char* name : {"picture.png", "picture.exr"}) {
        Writer writer(folder.path(name));
        (void)render(request, {}, &writer);
        writer.writer->finish();
        const std::string in_parts = folder.read(name);
        write_image(folder.path(name), render(request, {}).frame, {}, {});
        EXPECT_TRUE(folder.read(name) == in_parts) << name;
        EXPECT_EQ(read_image(folder.path(name)).width, 1994);
    }
}

TEST(PictureParts, leave_nothing_behind_when_the_picture_is_not_finished) {
    const Folder folder;
    {
        ImageWriter writer(folder.path("picture.png"), {0, 0, 8, 8}, {}, {});
        writer.append(Frame({8, 8}, {0, 0, 8, 4}));
    }
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace pxm::test
