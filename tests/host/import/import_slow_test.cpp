// Round trips: an attractor is rendered, its picture imported, and the maps' collage is good. And
// imported scenes render to pictures with something in them.
#include "host/import/import.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <span>

#include "host/import/moments/moment_search.hpp"
#include "host/import/moments/picture.hpp"
#include "host/render/render.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

const std::string data = pxm::test::source_dir + "/tests/data/import/";

Frame rendered(const std::string& file, const std::string& entry, long columns, long rows) {
    ImportRequest request;
    request.path = data + file;
    request.entry = entry;
    RenderRequest render_request;
    render_request.overrides.size = PixelSize{columns, rows};
    return test::render_text(import_file(request).text, render_request).frame;
}

LoadedImage image_of(const Frame& frame) {
    LoadedImage image;
    image.width = static_cast<int>(frame.columns());
    image.height = static_cast<int>(frame.rows());
    image.channels = {"Y"};
    for (const PixelRecord& pixel : frame.pixels) image.values.push_back(pixel.color[1]);
    return image;
}

struct Shown {
    const char* file;
    const char* entry;
    double least;  // share of pixels that are hit
    double most;
};

class ImportedPictures : public testing::TestWithParam<Shown> {};

TEST_P(ImportedPictures, fill_the_view_as_they_should) {
    const Shown& shown = GetParam();
    const Frame frame = rendered(shown.file, shown.entry, 160, 120);
    const PlaneMeasure picture = picture_of(image_of(frame));
    const double share = static_cast<double>(picture.points.size()) / (160.0 * 120.0);
    EXPECT_GE(share, shown.least) << shown.entry;
    EXPECT_LE(share, shown.most) << shown.entry;
    double low = 1;
    double high = -1;
    for (const WeightedPoint& p : picture.points) {
        low = std::min({low, p.x, p.y / 0.75});
        high = std::max({high, p.x, p.y / 0.75});
    }
    EXPECT_LT(low, -0.8) << "it is seen whole, and large";
    EXPECT_GT(high, 0.8);
    EXPECT_GT(low, -0.99);
    EXPECT_LT(high, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Classics, ImportedPictures,
                         testing::Values(Shown{"classic.ifs", "fern", 0.05, 0.3},
                                         Shown{"classic.ifs", "dragon", 0.2, 0.6},
                                         Shown{"classic.l", "Koch", 0.01, 0.1},
                                         Shown{"classic.l", "Dragon", 0.15, 0.5},
                                         Shown{"classic.l", "Hilbert", 0.5, 0.65},
                                         Shown{"classic.l", "Tree", 0.01, 0.2}));

/// What is found in the picture of an entry; its picture's width is 2.
MomentResult found(const std::string& entry, int maps) {
    const PlaneMeasure picture = picture_of(image_of(rendered("classic.ifs", entry, 256, 192)));
    MomentRequest request;
    request.maps = maps;
    request.finest = picture.finest;
    request.seconds = 60;  // far more than is needed
    return search_moments(picture.points, request);
}

TEST(RoundTrip, the_gasket_comes_back_from_its_picture) {
    const MomentResult gasket = found("Triangle", 3);
    EXPECT_LE(gasket.collage_distance, 3 * gasket.cell);  // of about 200 cells
    EXPECT_LE(gasket.bound, 0.04 * gasket.size);
    for (const PlaneMap& map :
         gasket.maps) {  // each may be turned by a third: the set is symmetric
        EXPECT_NEAR(std::abs(map.determinant()), 0.25, 0.02);
        EXPECT_NEAR(map.lipschitz(), 0.5, 0.05);
    }
}

TEST(RoundTrip, the_dragon_comes_back_from_its_picture) {
    const MomentResult dragon = found("dragon", 2);
    EXPECT_LE(dragon.collage_distance, 0.03 * dragon.size);
    for (const PlaneMap& map : dragon.maps) EXPECT_NEAR(std::abs(map.determinant()), 0.5, 0.05);
}

}  // namespace
}  // namespace pxm::host
