// Where the printed algorithms and formulas would give another picture (docs/thesis-errata.md).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;

double mean_level(const Frame& frame) {
    double sum = 0;
    long hits = 0;
    for (const PixelRecord& pixel : frame.pixels) {
        if (pixel.alpha == 0) continue;
        sum += pixel.level;
        ++hits;
    }
    return sum / static_cast<double>(hits);
}

/// With the printed keys a cell outside of its parent's interval is popped, and first.
TEST(Erratum3, a_cell_that_sticks_out_of_its_parent_is_not_shown_there) {
    // Shrinking the outermost volume changes no entry of an inner cell, but clips its interval.
    CompiledScene scene = compile_text(scene_of("octo", "", "size: 24,18"));
    CompiledShape& shape = scene.shapes[0];
    // A system of one set: its volume also bounds what stands inside the maps, so split it.
    shape.sets.push_back(shape.sets[0]);
    shape.start = 1;
    scene.objects[0].start = 1;
    CompiledVolume& outer = shape.sets[1].volume;
    ASSERT_EQ(outer.kind, kernels::Volume::sphere);
    outer.radius *= 0.7;
    outer.diameter *= 0.7;
    const Frame frame = render_natively(scene, Numeric::double_).frame;
    const Verdict verdict = judge(scene, frame, Numeric::double_);
    EXPECT_EQ(verdict.same + verdict.tied, verdict.pixels) << verdict.report;

    CompiledScene printed = scene;  // an outermost volume that clips nothing: entries as printed
    printed.shapes[0].sets[1].volume.radius *= 4;
    const Frame other = render_natively(printed, Numeric::double_).frame;
    long nearer = 0;
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        EXPECT_GE(frame.pixels[i].z, other.pixels[i].z);
        nearer += other.pixels[i].z < frame.pixels[i].z && frame.pixels[i].alpha > 0 ? 1 : 0;
    }
    EXPECT_GT(nearer, 0);
}

/// Eq. 16.3 is a lower bound of Sec. 16.2's constant, Eq. 16.1 an upper one: the larger the
/// diameters, the deeper the search.
TEST(Erratum6, the_product_is_an_upper_bound_and_the_determinant_a_lower) {
    for (const char* name : {"squashed", "bulging"}) {
        double level[3];
        int i = 0;
        for (const char* method : {"determinant", "polar", "product"}) {
            const CompiledScene scene = compile_text(
                scene_of(name, std::string("volume: sphere lipschitz: ") + method, "size: 24,18"));
            level[i++] = mean_level(render_natively(scene, Numeric::double_).frame);
        }
        EXPECT_LT(level[0], level[1]) << name;
        EXPECT_LT(level[1], level[2]) << name;
    }
}

/// All cells on the path count, each with its diameter's weight, and none beside it: one level
/// down, from the two volumes of the path.
TEST(Erratum13, shading_sums_over_the_path_of_cells_that_contain_the_hit) {
    for (const char* shading : {"constant", "low-pass", "high-pass", "facet"}) {
        CompiledScene scene =
            compile_text(scene_of("octo", std::string("shading: ") + shading, "size: 24,18") +
                         "object a { ifs: octo levels: 1 }");
        const Frame frame = render_natively(scene, Numeric::double_).frame;
        Oracle oracle(scene, 0);
        const double share = std::string(shading) == "constant"   ? 1.0 / 2
                             : std::string(shading) == "low-pass" ? 2.0 / 3  // diameters 2 : 1
                                                                  : 0.0;
        const CompiledVolume& ball = scene.shapes[0].sets[0].volume;
        const Affine& instance = scene.objects[0].instance;
        const glm::dvec3 center = instance.point(ball.center);
        const double radius = instance.linear[0][0] * ball.radius;
        long hits = 0;
        for (long y = 0; y < 18; ++y) {
            for (long x = 0; x < 24; ++x) {
                const PixelRecord& pixel = frame.at(x, y);
                if (pixel.alpha == 0) continue;
                const Sight ray = oracle.sight(x, y);
                const auto seen = oracle.look(ray);
                ASSERT_EQ(seen.front().word.size(), 1U);
                const CompiledMap& map =
                    scene.shapes[0].maps[static_cast<std::size_t>(seen.front().word[0])];
                const glm::dvec3 inner = instance.point(map.map.point(ball.center));
                const auto normal = [&](const glm::dvec3& c, double r) {
                    const double along = glm::dot(c, ray.direction);
                    const double t = along - std::sqrt(along * along - glm::dot(c, c) + r * r);
                    return (t * ray.direction - c) / r;
                };
                const glm::dvec3 total = glm::normalize(share * normal(center, radius) +
                                                        (1 - share) * normal(inner, radius / 2));
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixel.normal[c], total[c], 1e-5);
                ++hits;
            }
        }
        EXPECT_GT(hits, 50) << shading;
    }
}

/// p is 2 tan(theta / 2) / N_h at distance 1, and decides which cells are terminal.
TEST(Erratum14, a_pixel_spans_two_tan_of_half_the_angle_over_the_columns) {
    const CompiledScene scene = compile_text(scene_of("tetra", "detail: 2", "size: 40,30") +
                                             "camera { eye: 1,1.5,-4 look: 0,0,0 fov: 50 }");
    const double growth = 2 * std::tan(25 * std::numbers::pi / 180) / 40;
    EXPECT_DOUBLE_EQ(scene.camera.pixel_growth, growth);
    const Frame frame = render_natively(scene, Numeric::double_).frame;
    const double diameter = scene.objects[0].diameter * scene.unit;
    for (const PixelRecord& pixel : frame.pixels) {
        if (pixel.alpha == 0) continue;
        const double p = growth * static_cast<double>(pixel.z);
        EXPECT_LE(std::exp2(-pixel.level) * diameter, 2 * p * (1 + 1e-6));
        EXPECT_GT(std::exp2(1 - pixel.level) * diameter, 2 * p * 0.9);  // the parent is nearer
    }
}

/// Where the outermost cell is terminal all weights of Eq. 17.6 vanish.
TEST(Erratum18, high_pass_of_the_outermost_cell_is_the_constant_weighting) {
    for (const char* volume : {"sphere", "box"}) {
        Frame frames[2];
        int i = 0;
        for (const char* shading : {"constant", "high-pass"}) {
            const std::string render = std::string("volume: ") + volume + " shading: " + shading;
            const CompiledScene scene = compile_text(scene_of("octo", render, "size: 24,18") +
                                                     "object a { ifs: octo levels: 0 }");
            frames[i++] = render_natively(scene, Numeric::single).frame;
        }
        long lit = 0;
        for (std::size_t p = 0; p < frames[0].pixels.size(); ++p) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(frames[0].pixels[p].color[c], frames[1].pixels[p].color[c]);
            }
            lit += frames[0].pixels[p].alpha > 0 && frames[0].pixels[p].color[0] > 0.2F ? 1 : 0;
        }
        EXPECT_GT(lit, 50);
    }
}

/// A ray that would meet too many cells ends, and is counted.
TEST(HopelessScene, ends_at_the_cap_on_cells_and_counts_its_rays) {
    CompiledScene scene = compile_text(
        scene_of("grass", "volume: sphere lipschitz: polar detail: 0.1", "size: 16,12"));
    scene.cell_cap = 500;
    for (const long heap : {256L, 4L}) {
        scene.heap = heap;
        const EngineResult native = render_natively(scene, Numeric::single, 2);
        EXPECT_GT(native.rays.capped_rays, 0);
        // What is left of the path's siblings is still tested.
        for (const PixelRecord& pixel : native.frame.pixels) EXPECT_LE(pixel.volumes, 600U);
        EXPECT_EQ(render_on("964", scene, Numeric::single).rays.capped_rays,
                  native.rays.capped_rays);
    }
}

TEST(HopelessScene, with_few_levels_is_not_capped) {
    const CompiledScene scene =
        compile_text(scene_of("grass", "volume: sphere lipschitz: polar", "size: 16,12") +
                     "object lawn { ifs: grass scale: 4,0.1,4 levels: 6 }");
    const EngineResult result = render_natively(scene, Numeric::double_);
    EXPECT_EQ(result.rays.capped_rays, 0);
    const Verdict verdict = judge(scene, result.frame, Numeric::double_);
    EXPECT_EQ(verdict.same + verdict.tied, verdict.pixels) << verdict.report;
}

}  // namespace
}  // namespace pxm::test
