// A picture too large to be kept in memory as a frame is rendered in bands of rows.
#include <gtest/gtest.h>

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

TEST(Bands, together_are_the_picture) {
    const Folder folder;
    const RenderRequest request = large_request(folder);
    const RenderResult whole = render(request, {});
    Frame joined;
    joined.size = whole.frame.size;
    joined.crop = whole.window;
    int bands = 0;
    const RenderResult parts = render(request, {}, [&](const RenderResult& band) {
        const auto& pixels = band.frame.pixels;
        joined.pixels.insert(joined.pixels.end(), pixels.begin(), pixels.end());
        ++bands;
    });
    EXPECT_GT(bands, 1);
    EXPECT_EQ(parts.window, whole.window);
    ASSERT_EQ(joined.pixels.size(), whole.frame.pixels.size());
    EXPECT_TRUE(same_picture(joined, whole.frame));
    EXPECT_EQ(parts.statistics.rays.hits, whole.statistics.rays.hits);
    EXPECT_EQ(parts.statistics.rays.volumes_tested, whole.statistics.rays.volumes_tested);
}

TEST(Bands, are_no_larger_than_128_megabytes) {
    const Folder folder;
    (void)render(large_request(folder), {}, [](const RenderResult& band) {
        EXPECT_LE(band.frame.pixels.size() * sizeof(PixelRecord), std::size_t{128} << 20);
    });
}

TEST(Bands, make_the_file_that_the_whole_frame_makes) {
    const Folder folder;
    const RenderRequest request = large_request(folder);
    for (const char* name : {"picture.png", "picture.exr"}) {
        ImageWriter writer(folder.path(name), {1994, 1894}, {}, {});
        (void)render(request, {}, [&](const RenderResult& band) { writer.append(band.frame); });
        writer.finish();
        const LoadedImage banded = read_image(folder.path(name));
        write_image(folder.path(name), render(request, {}).frame, {}, {});
        const LoadedImage whole = read_image(folder.path(name));
        EXPECT_EQ(banded.width, 1994);
        EXPECT_EQ(banded.values, whole.values) << name;
    }
}

TEST(Bands, leave_nothing_behind_when_the_picture_is_not_finished) {
    const Folder folder;
    {
        ImageWriter writer(folder.path("picture.png"), {8, 8}, {}, {});
        writer.append(Frame({8, 8}, {0, 0, 8, 4}));
    }
    EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace pxm::test
