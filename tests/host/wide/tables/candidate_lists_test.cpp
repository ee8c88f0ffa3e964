// Lists of the cells that a ray may meet, by the place where it passes.
#include "host/wide/tables/candidate_views.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>
#include <set>

#include "host/engine/engine.hpp"
#include "host/wide/packet/ray_packet.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;
using namespace host::wide;

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    glm::dvec3 direction() {
        glm::dvec3 v{2};
        while (glm::dot(v, v) > 1) v = {between(-1, 1), between(-1, 1), between(-1, 1)};
        return glm::normalize(v);
    }
    /// In the disc of that radius.
    glm::dvec2 place(double radius) {
        glm::dvec2 p{2 * radius, 0};
        while (glm::dot(p, p) > radius * radius)
            p = {between(-radius, radius), between(-radius, radius)};
        return p;
    }

  private:
    std::mt19937 engine_;
};

ViewFrame looking_along(const glm::dvec3& w, double reach) {
    const glm::dvec3 other = std::abs(w.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(other, w));
    return {{u, glm::cross(w, u), w}, reach, true};
}

/// Rows are the axes.
glm::dmat3 frame_of(const ViewFrame& view) {
    glm::dmat3 frame;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 3; ++i) frame[i][axis] = view.axis[axis][i];
    }
    return frame;
}

/// How far the line through `p` at depth 0, that moves sideways by `slope`, passes from a point.
double distance(const glm::dvec2& p, const glm::dvec2& slope, const glm::dvec3& point) {
    const glm::dvec3 way = glm::normalize(glm::dvec3{slope, 1});
    return glm::length(glm::cross(point - glm::dvec3{p, 0}, way));
}

WideScene balls_of(const std::string& system) {
    return make_wide_scene(compile_text(scene_of(system, "volume: sphere")));
}

/// Of the pixels that the reference kernels and the wide engine hit.
double share_of_same_colors(const CompiledScene& scene) {
    EngineChoice clear;
    clear.numeric = Numeric::double_;
    clear.intersect = IntersectMethod::heap;
    const Frame expected = run_reference(scene, clear, {}).frame;
    const Frame found = run_wide(scene, {}, {}).frame;
    double hits = 0, same = 0;
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
        const PixelRecord &a = expected.pixels[i], &b = found.pixels[i];
        if (a.object < 0 || b.object < 0) continue;
        ++hits;
        bool close = true;
        for (int k = 0; k < 3; ++k)
            close = close && std::abs(a.color[k] - b.color[k]) <= 1.0F / 255;
        if (close) ++same;
    }
    return same / hits;
}

TEST(CandidateLists, lists_every_cell_that_a_ray_meets) {
    Random random(7);
    for (const char* system : {"tetra", "octo", "menger", "icos"}) {
        const WideScene scene = balls_of(system);
        const HomothetyTable& cells = scene.sets[0].composed.back();
        ASSERT_GT(cells.count, table_step) << system;
        for (const double reach : {0.0, 0.05, 0.4}) {
            const ViewFrame view = looking_along(random.direction(), reach);
            const glm::dmat3 frame = frame_of(view);
            CandidateLists table;
            table.make(cells, frame, view);
            for (int ray = 0; ray < 400; ++ray) {
                const glm::dvec2 place = random.place(1), slope = random.place(reach);
                const ListedCells listed =
                    table.at(cells, static_cast<float>(place.x), static_cast<float>(place.y));
                const std::set<int> lanes(listed.lane, listed.lane + listed.count);
                for (int i = 0; i < cells.count; ++i) {
                    const glm::dvec3 center =
                        frame *
                        glm::dvec3{cells.f64.row(0)[i], cells.f64.row(1)[i], cells.f64.row(2)[i]};
                    const double radius = cells.f64.row(HomothetyTable::scale)[i];
                    if (distance(place, slope, center) > radius) continue;
                    EXPECT_TRUE(lanes.contains(i)) << system << reach << " cell " << i;
                }
            }
        }
    }
}

TEST(CandidateLists, lists_are_short_and_go_from_front_to_back) {
    Random random(8);
    for (const char* system : {"tetra", "icos"}) {
        const WideScene scene = balls_of(system);
        const HomothetyTable& cells = scene.sets[0].composed.back();
        const ViewFrame view = looking_along(random.direction(), 0.05);
        CandidateLists table;
        table.make(cells, frame_of(view), view);
        double listed_cells = 0;
        constexpr int rays = 200;
        for (int ray = 0; ray < rays; ++ray) {
            const glm::dvec2 place = random.place(1);
            const ListedCells listed =
                table.at(cells, static_cast<float>(place.x), static_cast<float>(place.y));
            listed_cells += listed.count;
            for (int i = 1; i < listed.count; ++i) {
                EXPECT_LE(listed.z[i - 1] - listed.radius[i - 1], listed.z[i] - listed.radius[i]);
            }
        }
        EXPECT_LT(listed_cells / rays, 0.25 * cells.count) << system;
    }
}

/// What a part's lists are made for: no ray of it goes farther aside than `reach`.
TEST(CandidateView, of_a_part_of_the_picture_holds_all_its_rays) {
    for (const char* view : {"fov: 3", "fov: 40", "fov: 140", "orthographic: 2"}) {
        const CompiledScene compiled =
            compile_text(scene_of("tetra", "volume: sphere", "size: 333,207") +
                         fmt::format("camera {{ eye: 0.4,1.6,-3 look: 0,1,0 {} }}", view));
        const WideScene scene = make_wide_scene(compiled);
        const CompiledCamera& camera = compiled.camera;
        std::vector<CandidateView> candidate_views;
        RayPacket packet;
        std::set<std::uint64_t> views;
        for (long top = 0; top < compiled.size.rows; top += tile_side) {
            for (long left = 0; left < compiled.size.columns; left += tile_side) {
                aim_at_tile(packet, camera, compiled.crop, {left, top}, {0.5, 0.5});
                const CandidateView& candidate_view =
                    candidate_view_of(scene, packet, candidate_views);
                views.insert(candidate_view.number);
                for (const glm::dvec2& corner : {glm::dvec2{0, 0}, {8, 0}, {0, 8}, {8, 8}}) {
                    const double column = std::min(static_cast<double>(left) + corner.x, 333.0);
                    const double row = std::min(static_cast<double>(top) + corner.y, 207.0);
                    const glm::dvec3 way =
                        camera.projection == kernels::Projection::perspective
                            ? camera.corner + camera.across * column + camera.down * row
                            : camera.forward;
                    const double ahead = glm::dot(way, candidate_view.view.axis[2]);
                    const glm::dvec2 aside{glm::dot(way, candidate_view.view.axis[0]) / ahead,
                                           glm::dot(way, candidate_view.view.axis[1]) / ahead};
                    EXPECT_GT(ahead, 0);
                    EXPECT_LE(glm::length(aside), candidate_view.view.reach + 1e-9) << view;
                }
            }
        }
        EXPECT_TRUE(candidate_view_side(camera, compiled.size) % tile_side == 0);
        EXPECT_EQ(views.size() > 1,
                  std::string(view) == "fov: 40" || std::string(view) == "fov: 140");
    }
}

/// Few pixels that see far around: no part of such a picture has an axis that all its rays follow.
TEST(CandidateView, of_a_very_wide_view_is_each_bundles_own) {
    const std::string camera = "camera { eye: 0.2,0.9,-0.3 look: 0.1,0.5,0.4 fov: 150 }";
    const CompiledScene scene =
        compile_text(scene_of("tetra", "volume: sphere", "size: 40,40") + camera);
    std::vector<CandidateView> candidate_views;
    RayPacket packet;
    aim_at_tile(packet, scene.camera, scene.crop, {0, 0}, {0.5, 0.5});
    EXPECT_FALSE(candidate_view_of(make_wide_scene(scene), packet, candidate_views).view.shared);
    const Verdict verdict = judge(scene, run_wide(scene, {}, {}).frame, Numeric::double_);
    EXPECT_EQ(verdict.admissible, verdict.pixels) << verdict.report;
    EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
}

/// Each object has lists of its own, until they are too many.
TEST(WideObjects, that_are_turned_in_many_ways_are_seen) {
    for (const int count : {3, 11}) {
        std::string text = ifs("tetra");
        for (int i = 0; i < count; ++i) {
            text += fmt::format(
                "object it{} {{ ifs: tetra rotate: x,{} rotate: y,{} rotate: z,{} translate: "
                "{},{},{} }}\n",
                i, 31 * i, 17 * i + 5, 7 * i, 2 * (i % 4) - 3, 2 * (i / 4) - 2, 0.3 * i);
        }
        text +=
            "image { size: 64,48 }\nrender { volume: sphere }\n"
            "camera { eye: 0.4,0.6,-9 look: 0,0,0 fov: 45 }\n"
            "light { direction: 1,2,-1 color: 1,1,1 shadow: on }\n";
        const CompiledScene scene = compile_text(text);
        const Verdict verdict = judge(scene, run_wide(scene, {}, {}).frame, Numeric::double_);
        EXPECT_GE(verdict.admissible_share(), 0.999) << count << verdict.report;
        EXPECT_GE(share_of_same_colors(scene), 0.98) << count;
    }
}

/// A ray may find a cell of the one first and then a nearer one of the other.
TEST(WideObjects, of_homotheties_and_of_other_maps_may_overlap) {
    const std::string text = ifs("tetra") + ifs("elm") + ifs("menger") +
                             "object a { ifs: tetra }\nobject b { ifs: elm }\n"
                             "object c { ifs: menger scale: 0.5 translate: 0.3,0.4,0.2 }\n"
                             "image { size: 80,60 }\nrender { volume: sphere }\n"
                             "camera { eye: 0.4,1.6,-4 look: 0,0.7,0 fov: 40 }\n";
    const CompiledScene scene = compile_text(text);
    const Verdict verdict = judge(scene, run_wide(scene, {}, {}).frame, Numeric::double_);
    EXPECT_GE(verdict.admissible_share(), 0.999) << verdict.report;
    EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
}

/// Parts are those of the whole picture, whatever the window.
TEST(WideParts, a_window_shows_what_the_whole_picture_shows) {
    const auto shown = [](const std::string& image) {
        return run_wide(compile_text(scene_of("octo", "volume: sphere", image) +
                                     "light { direction: 1,2,-1 color: 1,1,1 shadow: on }\n"),
                        {}, {})
            .frame;
    };
    const Frame whole = shown("size: 150,110");
    const Frame part = shown("size: 150,110 crop: 37,21,118,93");
    for (long y = part.crop.y0; y < part.crop.y1; ++y) {
        for (long x = part.crop.x0; x < part.crop.x1; ++x) {
            const PixelRecord &a = whole.at(x, y), &b = part.at(x, y);
            EXPECT_EQ(a.word, b.word) << x << " " << y;
            EXPECT_EQ(a.z, b.z);
            for (int k = 0; k < 3; ++k) EXPECT_EQ(a.color[k], b.color[k]);
        }
    }
}

}  // namespace
}  // namespace pxm::test
