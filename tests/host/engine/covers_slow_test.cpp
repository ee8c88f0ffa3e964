// Laws of local covers, translucent volumes and samples (Ch. 18).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/compile/samples.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/render_text.hpp"
#include "tests/support/solid_square.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr long side = square_side;

RenderResult rendered(const std::string& text) {
    RenderRequest request;
    request.overrides.size = host::PixelSize{side, side};
    request.overrides.intersect = IntersectMethod::heap;
    request.threads = 2;
    return render_text(text, request);
}

TEST(Samples, opacity_is_the_share_of_the_area) {
    for (const double degrees : {0.0, 17.0, 40.0}) {
        const AreaError error = area_error(
            rendered(square_text(degrees) + "render { samples: 64 numeric: double }").frame,
            degrees);
        EXPECT_LT(std::abs(error.mean), 0.03) << degrees;
        EXPECT_LT(error.rms, 0.06) << degrees;
        EXPECT_EQ(error.not_solid, 0) << degrees;
    }
}

/// Local covers make a set wider by part of a pixel and soften its edge: inside, all is opaque; a
/// pixel away nothing shows. docs/measurements/local-covers.md compares them with samples.
TEST(Covers, stand_between_the_set_and_a_pixel_around_it) {
    for (const char* volume : {"sphere", "box"}) {
        long soft = 0;
        for (const double degrees : {0.0, 17.0, 40.0}) {
            const Frame frame =
                rendered(square_text(degrees) +
                         "render { covers: on numeric: double volume: " + volume + " }")
                    .frame;
            for (long y = 1; y + 1 < side; ++y) {
                for (long x = 1; x + 1 < side; ++x) {
                    const double opacity = frame.at(x, y).alpha;
                    double around = 0;
                    for (long i = 0; i < 9; ++i) {
                        around += area_of_square(degrees, x + i % 3 - 1, y + i / 3 - 1);
                    }
                    if (area_of_square(degrees, x, y) == 1) {
                        EXPECT_EQ(opacity, 1) << x << "," << y << " " << volume;
                    } else if (around == 0) {
                        EXPECT_EQ(opacity, 0) << x << "," << y << " " << volume;
                    }
                    soft += opacity > 0.01 && opacity < 0.99 ? 1 : 0;
                }
            }
        }
        EXPECT_GT(soft, 3) << volume;
    }
}

/// One volume shown alone with opacity k; two behind each other leave (1 - k)^2.
TEST(Translucent, volumes_leave_what_their_opacity_lets_through) {
    const std::string object = "object s { ifs: cube box: (-1,-1,-1)(1,1,1) opacity: 0.3 levels: ";
    const std::string camera = "} camera { eye: 0.3,0.2,-5 look: 0.3,0.2,0 orthographic: 0.2 }";
    const Frame one = rendered(cube_text() + object + "0" + camera).frame;
    const Frame three =
        rendered(cube_text() + object + "1" + camera).frame;  // the cube and two in it
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        EXPECT_NEAR(one.pixels[i].alpha, 0.3, 1e-6);
        EXPECT_NEAR(three.pixels[i].alpha, 1 - 0.7 * 0.7 * 0.7, 1e-6);
    }
}

TEST(Translucent, an_opaque_object_is_shown_as_without_opacity) {
    const std::string faint = " object far { ifs: tetra translate: 90,0,0 opacity: 0.5 } ";
    const std::string object = "object t { ifs: tetra sphere: (0,0,0) 1.1 }";
    const std::string camera = "camera { eye: 1,1,-4 look: 0,0,0 }";
    const std::string solid = " object far { ifs: tetra translate: 90,0,0 } ";
    const Frame with = rendered(tetra_text + object + faint + camera).frame;
    const Frame without = rendered(tetra_text + object + solid + camera).frame;
    EXPECT_TRUE(same_picture(with, without));
}

/// Cells are handed over in order, so what the heap holds does not matter.
TEST(Covers, give_the_same_picture_with_any_heap) {
    for (const char* name : {"octo", "icos", "squashed", "hierarchical"}) {
        for (const std::string setting : {"covers: on", "covers: 0.3,6"}) {
            RenderRequest request;
            request.overrides.size = host::PixelSize{24, 18};
            const auto with = [&](long heap) {
                request.overrides.heap = heap;
                return render_text(scene_of(name, setting, "size: 24,18"), request);
            };
            const RenderResult all = with(4096);
            for (const long heap : {1L, 3L}) {
                const RenderResult few = with(heap);
                EXPECT_GT(few.statistics.rays.heap_overflows, 0U) << name;
                EXPECT_TRUE(same_picture(all.frame, few.frame)) << name << " heap " << heap;
            }
        }
    }
}

/// A speck of a 30th of a pixel by a map from a hundred pixels down to it, alone in the view: no
/// ray meets it, and without volumes thought in between it and its parent nothing at all would
/// show.
TEST(Covers, of_a_map_that_jumps_over_the_band_are_no_all_or_nothing) {
    const std::string speck =
        "ifs speck { newmap scale: 0.5 translate: 0,0.5,0 newmap scale: 0.5 translate: 0,-0.5,0 "
        "newmap scale: 0.5 translate: 0.45,0.45,0 newmap scale: 0.0001 translate: 0.9,0,0 }";
    for (const char* look : {"0.903,0.002", "0.9,0", "0.895,-0.007"}) {
        const std::string camera =
            fmt::format("camera {{ eye: {0},-9 look: {0},0 orthographic: 0.4 }}", look);
        const Frame frame = rendered(speck + "object s { ifs: speck sphere: (0,0,0) 1.6 }" +
                                     camera + "render { covers: on numeric: double }")
                                .frame;
        double sum = 0;
        long seen = 0;
        for (const PixelRecord& pixel : frame.pixels) {
            EXPECT_LT(pixel.alpha, 0.99);
            sum += pixel.alpha;
            seen += pixel.alpha > 0 ? 1 : 0;
        }
        // By Eq. 18.9 a cone about the speck: at a pixel's distance its ball is two pixels wide.
        EXPECT_GE(seen, 1) << look;
        EXPECT_LE(seen, 4) << look;
        EXPECT_NEAR(sum, std::acos(-1) / 3, 0.3) << look;
    }
}

TEST(Samples, have_one_place_in_each_column_and_row_of_the_pixel) {
    for (const long count : {1L, 2L, 7L, 16L, 64L, 100L}) {
        std::vector<bool> columns(static_cast<std::size_t>(count), false);
        std::vector<bool> rows = columns;
        for (const glm::dvec2& place : sample_places(count)) {
            const auto slot = [&](double v) {
                return static_cast<std::size_t>(v * static_cast<double>(count));
            };
            columns[slot(place.x)] = true;
            rows[slot(place.y)] = true;
        }
        EXPECT_TRUE(std::ranges::all_of(columns, std::identity{})) << count;
        EXPECT_TRUE(std::ranges::all_of(rows, std::identity{})) << count;
    }
}

TEST(Samples, are_the_same_on_the_machine_and_natively) {
    const std::string text = tetra_text + std::string("render { samples: 5 covers: on }") +
                             "light l { direction: 1,1,-1 shadow: on }";
    EXPECT_TRUE(same_on_machine_and_natively(text));
}

}  // namespace
}  // namespace pxm::test
