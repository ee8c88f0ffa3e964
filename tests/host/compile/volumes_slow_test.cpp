// Laws of host/compile/volumes: which bounding volumes objects get, and that they contain what they
// bound.
#include "host/compile/volumes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "host/compile/compile.hpp"
#include "host/compile/computed_volume.hpp"
#include "host/compile/filled_volume.hpp"
#include "host/compiled/bounding_volume.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/host/fractal/systems.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/crossing.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;
using kernels::Volume;

constexpr const char* printed_grass = R"(
ifs grass {
    newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: -1,0,0
    newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: 1,0,0
    newmap scale: 0.25,0.01,0.01 rotate: z,90 translate: 0,0.707,0
}
object grass { sphere: (0,0,0) 3 ifs: grass )";

/// Of the first object's outermost cell.
Volume kind_of(const CompiledScene& scene) {
    const CompiledShape& shape =
        scene.shapes[static_cast<std::size_t>(scene.objects.front().shape)];
    return shape.sets[static_cast<std::size_t>(shape.start)].volume.kind;
}

std::string warnings_of(const std::string& text) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("s.pxm", text, diagnostics);
    (void)compile(scene, 1, diagnostics);
    return diagnostics.text(scene.files);
}

TEST(Volumes, of_every_kind_contain_the_points_of_the_attractor) {
    std::mt19937_64 random(5);
    for (const auto& [name, rifs] : systems::thesis_systems()) {
        const std::vector<Bounds> bounds = bound(rifs, prove_contraction(rifs));
        for (const Volume kind : {Volume::sphere, Volume::box, Volume::oriented, Volume::hull}) {
            VolumeComputer computer(rifs, bounds);
            for (std::size_t set = 0; set < bounds.size(); ++set) {
                const CompiledVolume volume = computer.make(kind, set);
                ASSERT_EQ(volume.kind, kind) << name;
                for (int i = 0; i < 60; ++i) {
                    const glm::dvec3 point =
                        systems::random_point(rifs, static_cast<int>(set), 700, random);
                    ASSERT_GE(depth_inside(volume, point), 0) << name << static_cast<int>(kind);
                }
            }
        }
    }
}

/// A polygon's own corners lie in its volume wherever it is. Far from the origin they are known to
/// fewer digits of its size; before these are those of the margin, nothing is found to be filled.
TEST(Volumes, of_polygons_contain_them_however_far_they_lie) {
    const glm::dmat3 turn =
        glm::mat3_cast(glm::angleAxis(0.7, glm::normalize(glm::dvec3{1, 2, 3})));
    const Points triangle{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}};
    for (const double far : {0.0, 1e4, 1e5, 1e6, 3e6, 1e7, 3e7}) {
        const glm::dvec3 place = far * glm::dvec3{0.48, -0.6, 0.64};
        Points corners;
        for (const glm::dvec3& corner : triangle) corners.push_back(place + turn * corner);
        // Halves at the corners, and the one turned by half a turn between them.
        std::vector<Affine> maps;
        for (const glm::dvec3& corner : corners) maps.push_back({glm::dmat3{0.5}, 0.5 * corner});
        const glm::dvec3 normal = turn * glm::dvec3{0, 0, 1};
        const glm::dmat3 half_turn = glm::outerProduct(normal, normal) * 2.0 - glm::dmat3{1.0};
        const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        maps.push_back({0.5 * half_turn, middle - 0.5 * (half_turn * middle)});
        const Rifs rifs = systems::complete(maps);
        const std::vector<Bounds> bounds = bound(rifs, prove_contraction(rifs));
        VolumeComputer computer(rifs, bounds);
        const auto volumes = filled_volumes(rifs, bounds, computer);
        EXPECT_TRUE(volumes || far > 1e6) << far;
        if (!volumes) continue;  // it is no longer found to be filled, and gets a usual volume
        for (const glm::dvec3& corner : corners)
            EXPECT_GT(depth_inside(volumes->front(), corner), 0) << far;
    }
}

/// The diameter decides where a descent ends: it is that of the volume, not of something around it.
TEST(Volumes, have_their_true_diameter) {
    EXPECT_DOUBLE_EQ(cone_volume().diameter, 2);
    EXPECT_DOUBLE_EQ(cylinder_volume().diameter, 2 * std::sqrt(2.0));
    const CompiledVolume box = oriented_volume({{1, 2, 3}, {{{3, 0, 0}, {0, 0, 2}, {0, 6, 0}}}});
    EXPECT_DOUBLE_EQ(box.diameter, 14);
    Polytope octahedron;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 u{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        octahedron.push_back({u / std::sqrt(3.0), (1 + u.x) / std::sqrt(3.0)});
    }
    EXPECT_NEAR(hull_volume(octahedron, {1, 0, 0}).diameter, 2, 1e-9);
}

TEST(Volumes, of_flat_attractors_have_a_thickness) {
    const Rifs rifs =
        systems::complete(systems::homotheties(0.5, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const std::vector<Bounds> bounds = bound(rifs, prove_contraction(rifs));
    VolumeComputer computer(rifs, bounds);
    for (const Volume kind : {Volume::box, Volume::oriented, Volume::hull}) {
        const auto across = cross_volume({0.5, 0.5, -9}, {0, 0, 1}, computer.make(kind, 0));
        ASSERT_TRUE(across);
        EXPECT_GT(across->exit - across->entry, 0.1);
    }
}

TEST(Volumes, are_as_asked_for_whatever_is_declared) {
    for (const char* declared : {"", "sphere: (0,0,0) 3", "cylinder", "hull"}) {
        const std::string object =
            ifs("octo") + "object a { ifs: octo " + declared + " } render { volume: ";
        EXPECT_EQ(kind_of(compile_text(object + "sphere }")), Volume::sphere);
        EXPECT_EQ(kind_of(compile_text(object + "box }")), Volume::box);
        EXPECT_EQ(kind_of(compile_text(object + "oriented }")), Volume::oriented);
        EXPECT_EQ(kind_of(compile_text(object + "hull }")), Volume::hull);
    }
}

TEST(Volumes, are_as_declared_if_they_contain_the_attractor) {
    const auto kind = [](const std::string& declared) {
        return kind_of(compile_text(ifs("narrow") + "object a { ifs: narrow " + declared + " }"));
    };
    EXPECT_EQ(kind("cone"), Volume::cone);
    EXPECT_EQ(kind("cylinder"), Volume::cylinder);
    EXPECT_EQ(kind("hull"), Volume::hull);
    EXPECT_EQ(kind("sphere: (0,0,0) 2"), Volume::sphere);
    EXPECT_EQ(kind("box: (-2,-2,-2)(2,2,2)"), Volume::box);
}

TEST(Volumes, that_fall_short_are_replaced_and_it_is_said_by_how_much) {
    const std::string cone = ifs("octo") + "object a { ifs: octo cone }";
    EXPECT_NE(warnings_of(cone).find("the cone of object \"a\" does not contain the attractor "
                                     "(short by 1): a computed volume is used instead"),
              std::string::npos);
    EXPECT_EQ(kind_of(compile_text(cone)), Volume::sphere);
    const std::string cylinder = ifs("octo") + "object a { ifs: octo cylinder }";
    EXPECT_EQ(warnings_of(cylinder), "");  // it touches mantle and ends
    EXPECT_EQ(kind_of(compile_text(cylinder)), Volume::cylinder);
}

TEST(Volumes, so_loose_that_rays_would_not_end_are_replaced) {
    const std::string text = printed_grass + std::string("}");
    EXPECT_NE(warnings_of(text).find("is so loose"), std::string::npos);
    const CompiledScene scene = compile_text(text);
    EXPECT_EQ(kind_of(scene), Volume::box);
    EXPECT_EQ(kind_of(compile_text(printed_grass + std::string("levels: 12 }"))), Volume::sphere);
}

TEST(Volumes, chosen_freely_are_spheres_where_the_attractor_is_flat) {
    EXPECT_EQ(kind_of(compile_text("ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 "
                                   "newmap scale: 0.5 translate: 0,1,0 }")),
              Volume::sphere);
    EXPECT_EQ(kind_of(compile_text(ifs("menger"))), Volume::box);
    EXPECT_EQ(kind_of(compile_text(ifs("icos"))), Volume::sphere);
    EXPECT_EQ(kind_of(compile_text(ifs("grass"))), Volume::box);
}

/// The same system in other coordinates: lengths `scale` times as long, moved by `shift`.
Rifs moved(Rifs rifs, double scale, const glm::dvec3& shift) {
    for (Affine& map : rifs.maps) {
        map.translation = scale * map.translation + shift - map.direction(shift);
    }
    return rifs;
}

std::vector<Volume> chosen_kinds(const Rifs& rifs) {
    Diagnostics diagnostics;
    std::vector<Volume> kinds;
    for (const CompiledVolume& volume : choose_volumes(
             {}, VolumeKind::automatic, rifs, bound(rifs, prove_contraction(rifs)), diagnostics)) {
        kinds.push_back(volume.kind);
    }
    return kinds;
}

TEST(Volumes, are_chosen_alike_however_large_the_attractor_is_and_wherever) {
    for (const auto& [name, rifs] : systems::thesis_systems()) {
        if (std::string(name) == "grass") continue;  // a test of its own: it takes long
        const std::vector<Volume> kinds = chosen_kinds(rifs);
        for (const double scale : {3.0, 1.4, 1e-20, 1e20}) {
            EXPECT_EQ(chosen_kinds(moved(rifs, scale, {0, 0, 0})), kinds) << name << " " << scale;
        }
        EXPECT_EQ(chosen_kinds(moved(rifs, 1, {1e6, -1e6, 1e6})), kinds) << name;
    }
}

TEST(Volumes, that_are_objects_are_what_they_are) {
    const CompiledScene scene = compile_text(
        "object a { sphere: (0,0,0) 1 } object b { box: (0,0,0)(1,2,3) } object c { cone } "
        "object d { cylinder } object e { cone scale: 2 } render { volume: sphere }");
    ASSERT_EQ(scene.objects.size(), 5U);
    ASSERT_EQ(scene.shapes.size(), 4U);  // both cones are one
    const Volume kinds[] = {Volume::sphere, Volume::box, Volume::cone, Volume::cylinder};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(scene.shapes[i].sets[0].volume.kind, kinds[i]);
        EXPECT_TRUE(scene.shapes[i].maps.empty());
        EXPECT_EQ(scene.objects[i].levels, 0U);
    }
}

/// What may follow any map of the case has the same attractor as the whole.
constexpr const char* two_sets = R"(
rifs s {
    newmap a scale: 1/4
    newmap b scale: 1/4 translate: 1/2,0,0
    newmap c scale: 1/4
    newmap d scale: 1/4 translate: 1/2,0,0
    follow: a -> c,d  follow: b -> c,d  follow: c -> a,b  follow: d -> a,b
    start: a,b
}
)";
constexpr const char* one_set =
    "ifs s { newmap scale: 1/4  newmap scale: 1/4 translate: 1/2,0,0 }\n";
constexpr const char* seen_from_the_front =
    "camera c { eye: 0,0,-5  look: 0,0,0  orthographic: 2.4 } image { size: 30,30 }\n";

TEST(Volumes, declared_for_a_recurrent_system_stand_on_all_its_levels) {
    for (const char* declared : {"box", "sphere: (0,0,0) 1", "cylinder", "cone scale: 3"}) {
        const std::string object =
            std::string("object o { ifs: s  levels: 1 ") + declared + " }" + seen_from_the_front;
        const EngineResult graph =
            render_natively(compile_text(two_sets + object), Numeric::double_);
        const EngineResult plain =
            render_natively(compile_text(one_set + object), Numeric::double_);
        EXPECT_GT(plain.rays.hits, 20U) << declared;
        EXPECT_TRUE(same_picture(graph.frame, plain.frame)) << declared;
    }
}

/// Translucent cells show on every level.
TEST(Volumes, declared_for_a_recurrent_system_stand_for_translucent_cells_too) {
    const std::string object =
        std::string("object o { ifs: s  levels: 2  box  opacity: 0.4 }") + seen_from_the_front;
    EXPECT_TRUE(
        same_picture(render_natively(compile_text(two_sets + object), Numeric::double_).frame,
                     render_natively(compile_text(one_set + object), Numeric::double_).frame));
}

TEST(Volumes, that_hold_for_some_maps_only_are_computed_inside_the_others) {
    const std::string text =
        "rifs s { newmap a scale: 1/4  newmap c scale: 1/4 translate: 3,0,0\n"
        "follow: a -> a,c  follow: c -> c  start: a }\n"
        "object o { ifs: s  sphere: (0,0,0) 1.5 }";
    EXPECT_EQ(warnings_of(text),
              "s.pxm:3:20: warning: the sphere of object \"o\" does not contain what may stand "
              "inside map \"a\" (short by 2.5): a computed volume is used there\n"
              "    object o { ifs: s  sphere: (0,0,0) 1.5 }\n"
              "                       ^");
    const CompiledScene scene = compile_text(text);
    const std::vector<CompiledSet>& sets = scene.shapes[0].sets;
    for (std::size_t set = 0; set < sets.size(); ++set) {
        const bool start = static_cast<int>(set) == scene.shapes[0].start;
        EXPECT_EQ(sets[set].volume == sets[static_cast<std::size_t>(scene.shapes[0].start)].volume,
                  start);
    }
}

}  // namespace
}  // namespace pxm::test
