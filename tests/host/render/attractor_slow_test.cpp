// The picture against the enumerated attractor, which knows maps and graph but no volumes.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/compile_text.hpp"
#include "tests/support/enumeration.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/oracle.hpp"

namespace pxm::test {
namespace {

using namespace host;

double pixel_size(const CompiledScene& scene, double depth) {
    return scene.camera.pixel_at_eye + scene.camera.pixel_growth * depth;
}

/// Every hit lies within one terminal cell, at most `detail` pixels across, of the attractor.
/// Precondition: Lip is not the determinant's lower bound.
void expect_hits_near_points(const CompiledScene& scene, const Frame& frame,
                             const Enumeration& points) {
    Oracle eye(scene, 0);  // for the lines of sight alone
    for (long y = 0; y < scene.size.rows; ++y) {
        for (long x = 0; x < scene.size.columns; ++x) {
            const PixelRecord& pixel = frame.at(x, y);
            if (pixel.alpha == 0) continue;
            const double key = static_cast<double>(pixel.z) / scene.unit;
            const Sight ray = eye.sight(x, y);
            const double p = pixel_size(scene, key);
            EXPECT_LE(points.distance(ray.origin + key * ray.direction, x, y, 2),
                      (scene.detail + 0.5) * p)
                << x << ' ' << y;
        }
    }
}

/// Where points of the attractor fall into a pixel, a ray of it or of a neighbour ends no deeper
/// than the points by more than a few p. Returns the share of pixels whose own ray does.
double expect_no_holes(const CompiledScene& scene, const Frame& frame, const Enumeration& points) {
    long filled = 0;
    long own = 0;
    for (long y = 1; y + 1 < scene.size.rows; ++y) {
        for (long x = 1; x + 1 < scene.size.columns; ++x) {
            double depth = INFINITY;
            for (const AttractorPoint& point : points.at(x, y)) {
                depth = std::min(depth, point.depth);
            }
            if (depth == INFINITY) continue;
            const double limit = (depth + 3 * pixel_size(scene, depth)) * scene.unit;
            double nearest = INFINITY;
            for (long j = y - 1; j <= y + 1; ++j) {
                for (long i = x - 1; i <= x + 1; ++i) {
                    nearest = std::min(nearest, static_cast<double>(frame.at(i, j).z));
                }
            }
            EXPECT_LE(nearest, limit) << x << ' ' << y;
            ++filled;
            own += static_cast<double>(frame.at(x, y).z) <= limit ? 1 : 0;
        }
    }
    return static_cast<double>(own) / static_cast<double>(filled);
}

class Attractor : public testing::TestWithParam<const char*> {};

TEST_P(Attractor, is_near_every_hit) {
    const CompiledScene scene = compile_text(scene_of(GetParam(), "", "size: 20,15"));
    const Enumeration points(scene);
    ASSERT_GT(points.points(), 100);
    for (const Numeric numeric : {Numeric::single, Numeric::double_}) {
        expect_hits_near_points(scene, render_natively(scene, numeric).frame, points);
    }
}

INSTANTIATE_TEST_SUITE_P(Systems, Attractor,
                         testing::Values("tetra", "octo", "menger", "dodec", "asymmetric",
                                         "hierarchical", "mirrored", "squashed", "bulging"));

/// Systems whose pieces are not thinner than a pixel: between rays those are rightly missed.
TEST(Attractor, is_shown_without_holes) {
    for (const char* name : {"tetra", "octo", "menger", "icos", "mirrored", "asymmetric"}) {
        const CompiledScene scene = compile_text(scene_of(name, "", "size: 20,15"));
        const Enumeration points(scene);
        for (const Numeric numeric : {Numeric::single, Numeric::double_}) {
            const Frame frame = render_natively(scene, numeric).frame;
            EXPECT_GE(expect_no_holes(scene, frame, points), 0.6) << name;
        }
    }
}

/// A camera of one pixel whose ray goes through `target`; p as in the scene.
CompiledScene aimed_at(CompiledScene scene, const glm::dvec3& target) {
    CompiledCamera& camera = scene.camera;
    scene.size = {1, 1};
    scene.crop = {0, 0, 1, 1};
    camera.across = camera.down = glm::dvec3{0.0};
    if (camera.projection == kernels::Projection::orthographic) {
        camera.corner = target - glm::dot(target, camera.forward) * camera.forward;
    } else {
        camera.corner = glm::normalize(target);
    }
    return scene;
}

/// A point of the attractor lies in every volume along its word, so its ray cannot miss.
void expect_rays_through_points_hit(const std::string& name, const CompiledScene& scene) {
    const bool orthographic = scene.camera.projection == kernels::Projection::orthographic;
    for (int object = 0; object < static_cast<int>(scene.objects.size()); ++object) {
        const auto shape =
            static_cast<std::size_t>(scene.objects[static_cast<std::size_t>(object)].shape);
        if (scene.shapes[shape].maps.empty()) continue;  // a volume is the object
        for (const glm::dvec3& point : random_points(scene, object, 10, 7)) {
            const double depth =
                orthographic ? glm::dot(point, scene.camera.forward) : glm::length(point);
            const CompiledScene aimed = aimed_at(scene, point);
            const PixelRecord twice = render_natively(aimed, Numeric::double_).frame.at(0, 0);
            EXPECT_LE(static_cast<double>(twice.z), (1 + 1e-6) * depth * scene.unit)
                << name << ' ' << object;
            const PixelRecord single = render_natively(aimed, Numeric::single).frame.at(0, 0);
            EXPECT_LE(static_cast<double>(single.z),
                      (depth + pixel_size(scene, depth)) * scene.unit)
                << name << ' ' << object;
        }
    }
}

TEST(Attractor, is_hit_by_every_ray_through_one_of_its_points) {
    for (const Example& example : example_scenes("64,48")) {
        expect_rays_through_points_hit(example.name, compile_text(example.text));
    }
}

/// A singular map has no inverse, yet its image is part of the attractor.
TEST(Attractor, of_singular_maps_is_shown_where_it_is) {
    const CompiledScene scene = compile_text(
        "ifs fern { newmap stem scale: 0,0.16,0 "
        "newmap scale: 0.85 rotate: z,-3 rotate: x,5 translate: 0,1.6,0 "
        "newmap scale: 0.3,0.34,0.3 rotate: z,50 translate: 0,1.6,0 "
        "newmap scale: 0.3,0.37,0.3 rotate: z,-50 rotate: y,30 translate: 0,0.44,0 } "
        "image { size: 32,24 }");
    ASSERT_TRUE(scene.shapes[0].lifted);
    expect_rays_through_points_hit("fern", scene);
    const Enumeration points(scene);
    for (const Numeric numeric : {Numeric::single, Numeric::double_}) {
        expect_hits_near_points(scene, render_natively(scene, numeric).frame, points);
    }
}

}  // namespace
}  // namespace pxm::test
