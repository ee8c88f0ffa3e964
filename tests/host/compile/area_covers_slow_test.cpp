// Laws of local covers by area (dsp_kernels/beam.hpp, host/compile/area_covers.cpp).
#include "host/compile/area_covers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host/compile/trial.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/render_text.hpp"
#include "tests/support/solid_square.hpp"

namespace pxm::test {
namespace {

using namespace host;

RenderResult rendered(const std::string& text, long columns, long rows) {
    RenderRequest request;
    request.overrides.size = host::PixelSize{columns, rows};
    request.overrides.intersect = IntersectMethod::heap;
    request.threads = 2;
    return render_text(text, request);
}

double rmse(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double d = static_cast<double>(a.pixels[i].color[c]) -
                             static_cast<double>(b.pixels[i].color[c]);
            sum += d * d;
        }
    }
    return std::sqrt(sum / static_cast<double>(3 * a.pixels.size()));
}

TEST(AreaCovers, opacity_is_the_share_of_the_area) {
    for (const char* volume : {"box", "sphere"}) {
        for (const double degrees : {0.0, 17.0, 40.0}) {
            const std::string setting =
                std::string("render { covers: area numeric: double volume: ") + volume + " }";
            const AreaError error = area_error(
                rendered(square_text(degrees) + setting, square_side, square_side).frame, degrees);
            EXPECT_TRUE(degrees == 0 || error.pixels > 50) << error.pixels;
            EXPECT_LT(std::abs(error.mean), volume[0] == 'b' ? 0.03 : 0.15) << volume << degrees;
            EXPECT_LT(error.rms, volume[0] == 'b' ? 0.09 : 0.3) << volume << degrees;
            if (volume[0] == 'b') {
                EXPECT_EQ(error.not_solid, 0) << degrees;
            }
        }
    }
}

/// The bar for local covers: half the error of one sample, and less than four samples have.
TEST(AreaCovers, have_less_than_half_the_error_of_one_sample) {
    for (const char* name : {"tetra", "menger"}) {
        const auto with = [&](const char* setting) {
            return rendered(scene_of(name, setting), 48, 36).frame;
        };
        const Frame reference = with("samples: 144");
        const double one = rmse(with("samples: 1"), reference);
        const double four = rmse(with("samples: 4"), reference);
        const double area = rmse(with("covers: area"), reference);
        EXPECT_LT(area, one / 2) << name;
        EXPECT_LT(area, four) << name;
    }
}

TEST(AreaCovers, are_the_same_on_the_machine_and_natively) {
    const std::string text = tetra_text + std::string("render { covers: area samples: 5 }") +
                             "light l { direction: 1,1,-1 shadow: on }";
    EXPECT_TRUE(same_on_machine_and_natively(text));
}

/// What a small heap has no room for is looked at place by place: nothing is lost, and what shows
/// changes by less than one sample differs from many.
TEST(AreaCovers, lose_nothing_with_a_small_heap) {
    for (const char* name : {"octo", "squashed", "hierarchical"}) {
        RenderRequest request;
        request.overrides.intersect = IntersectMethod::heap;
        request.overrides.size = host::PixelSize{24, 18};
        const auto with = [&](const char* setting, long heap) {
            request.overrides.heap = heap;
            return render_text(scene_of(name, setting, "size: 24,18"), request);
        };
        const RenderResult all = with("covers: area", 4096);
        const double one = rmse(with("samples: 1", 4096).frame, with("samples: 64", 4096).frame);
        for (const long heap : {1L, 3L}) {
            const RenderResult few = with("covers: area", heap);
            EXPECT_GT(few.statistics.rays.restarts, 0U) << name;
            EXPECT_LT(rmse(all.frame, few.frame), 0.6 * one) << name << " heap " << heap;
        }
    }
}

TEST(AreaCovers, take_no_translucent_objects_and_a_word_of_places) {
    const std::string object = ifs("tetra") + "object t { ifs: tetra opacity: 0.5 } ";
    EXPECT_NE(error_of([&] {
                  (void)rendered(object + "render { covers: area }", 8, 8);
              }).find("covers: area takes no translucent objects; covers: on does"),
              std::string::npos);
    const std::string many = ifs("tetra") + "render { covers: area samples: 33 }";
    EXPECT_NE(error_of([&] {
                  (void)rendered(many, 8, 8);
              }).find("covers: area asks for at most 32 places in a pixel, and 'samples' is 33"),
              std::string::npos);
    EXPECT_EQ(error_of([&] {
                  (void)rendered(ifs("tetra") + "render { covers: area samples: 32 }", 8, 8);
              }),
              "");
}

/// Of a cube in its box all, of a cube in a ball the ratio of their mean shadows (Cauchy: a quarter
/// of their surfaces), 6 to 3 pi.
TEST(AreaCovers, mean_coverage_is_the_share_of_the_shadow) {
    const auto coverage = [](const std::string& volume) {
        const CompiledScene scene = compile_text(cube_text() + "render { volume: " + volume + " }");
        return mean_coverage(scene.shapes.at(0), 0, {});
    };
    EXPECT_NEAR(coverage("box"), 1, 0.01);
    EXPECT_NEAR(coverage("sphere"), 6 / (3 * std::acos(-1)), 0.1);
}

TEST(AreaCovers, are_measured_for_every_follow_set) {
    const CompiledScene scene = compile_text(scene_of("hierarchical", "covers: area"));
    for (const CompiledShape& shape : scene.shapes) {
        for (const CompiledSet& set : shape.sets) {
            EXPECT_GT(set.coverage, 0.05);
            EXPECT_LE(set.coverage, 1);
        }
    }
}

}  // namespace
}  // namespace pxm::test
