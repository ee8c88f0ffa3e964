// Laws of dsp_kernels/volume.hpp: where lines enter and leave bounding volumes of every kind, and
// the normals there, against another computation in double.
#include "dsp_kernels/volume.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/descend.hpp"
#include "host/compiled/bounding_volume.hpp"
#include "host/node_program/native_node.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "tests/support/crossing.hpp"

namespace pxm::test {
namespace {

using namespace host;
using kernels::Side;

constexpr int kinds = 6;

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3{normal(random), normal(random), normal(random)});
}

/// Some polytope: a box with its corners cut off askew.
Polytope random_polytope(std::mt19937& random, const glm::dvec3& center) {
    std::uniform_real_distribution<double> distance(0.3, 1);
    Polytope sides;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 u{0.0};
        u[axis] = 1;
        sides.push_back({u, glm::dot(u, center) + distance(random)});
        sides.push_back({-u, -glm::dot(u, center) + distance(random)});
    }
    for (int i = 0; i < 14; ++i) {
        const glm::dvec3 u = random_direction(random);
        sides.push_back({u, glm::dot(u, center) + distance(random)});
    }
    return sides;
}

CompiledVolume random_volume(int kind, std::mt19937& random) {
    std::uniform_real_distribution<double> size(0.1, 1);
    const glm::dvec3 center = random_direction(random) * size(random);
    const glm::dvec3 half{size(random), size(random), size(random)};
    const auto moved = [&](CompiledVolume volume) {
        volume.center = center;
        volume.radius = half.x;
        return volume;
    };
    switch (static_cast<kernels::Volume>(kind)) {
        case kernels::Volume::sphere:
            return sphere_volume(center, half.x);
        case kernels::Volume::box:
            return box_volume(center - half, center + half);
        case kernels::Volume::oriented: {
            const auto turn = glm::dmat3{
                glm::rotate(glm::dmat4{1.0}, 6 * size(random), random_direction(random))};
            return oriented_volume(
                {center, {turn[0] * half.x, turn[1] * half.y, turn[2] * half.z}});
        }
        case kernels::Volume::hull:
            return hull_volume(random_polytope(random, center), center);
        case kernels::Volume::cone:
            return moved(cone_volume());
        case kernels::Volume::cylinder:
            return moved(cylinder_volume());
    }
    return {};
}

/// A node that knows one volume.
template <class Real>
class VolumeNode {
  public:
    explicit VolumeNode(const CompiledVolume& volume)
        : block_(make_scene_block<Real>(scene_of_volume(volume))),
          node_(block_, no_textures, 1, sizeof(kernels::Cell<Real>)) {
        using Header = kernels::HeaderRecord<real_words<Real>>;
        using Object = kernels::ObjectRecord<real_words<Real>>;
        follow_set_ = node_.shape_word(node_.shape_word(Header::objects) + Object::start_set);
    }
    VolumeNode(const VolumeNode&) = delete;
    VolumeNode& operator=(const VolumeNode&) = delete;

    struct Result {
        std::optional<kernels::Interval<double>> inside;
        glm::dvec3 entry_normal{0.0};
        glm::dvec3 exit_normal{0.0};
    };
    Result cross(const glm::dvec3& o, const glm::dvec3& d) {
        using FollowSet = kernels::FollowSetRecord<real_words<Real>>;
        const auto center = kernels::read_vector(node_, follow_set_ + FollowSet::center);
        const kernels::Ray<Real> ray =
            kernels::rebase(node_, kernels::Ray<Real>{vector(o), vector(d)}, center);
        const auto inside = kernels::intersect_volume(node_, ray, follow_set_);
        if (!inside) return {};
        return {kernels::Interval<double>{to_double(inside->entry), to_double(inside->exit)},
                normal(ray, inside->entry, Side::entry), normal(ray, inside->exit, Side::exit)};
    }

  private:
    static CompiledScene scene_of_volume(const CompiledVolume& volume) {
        CompiledScene scene;
        CompiledShape shape;
        shape.sets.push_back({volume, {}});
        scene.shapes.push_back(shape);
        scene.objects.emplace_back();
        return scene;
    }
    static kernels::Vec3<Real> vector(const glm::dvec3& v) {
        return {from_double<Real>(v.x), from_double<Real>(v.y), from_double<Real>(v.z)};
    }
    glm::dvec3 normal(const kernels::Ray<Real>& ray, Real t, Side side) {
        const auto n = kernels::volume_normal(node_, ray, t, side, follow_set_);
        return glm::normalize(glm::dvec3{to_double(n.x), to_double(n.y), to_double(n.z)});
    }

    inline static const std::vector<std::uint32_t> no_textures;
    std::vector<std::uint32_t> block_;
    NativeNode<Real> node_;
    std::uint32_t follow_set_ = 0;
};

template <class Real>
class VolumeKernel : public testing::Test {};
using Reals = testing::Types<dsp32::Float, float, double>;
TYPED_TEST_SUITE(VolumeKernel, Reals);

template <class Real>
constexpr double digits = real_words<Real> == 1 ? 1e-3 : 1e-9;

/// A number that all numbers of nodes hold: the ray is the same for both sides.
double rounded(double x) { return std::ldexp(std::round(std::ldexp(x, 12)), -12); }
glm::dvec3 rounded(const glm::dvec3& v) { return {rounded(v.x), rounded(v.y), rounded(v.z)}; }

/// A ray near a volume, now and then along an axis.
struct Line {
    Line(const CompiledVolume& volume, std::mt19937& random) {
        std::uniform_real_distribution<double> part(-1, 1);
        direction = rounded(random_direction(random));
        if (random() % 4 == 0) direction = axis(random() % 3, random() % 2 == 0 ? 1 : -1);
        const glm::dvec3 aim{part(random), part(random), part(random)};
        origin =
            rounded(volume.center + aim * (volume.diameter / 2) - 3 * part(random) * direction);
    }
    static glm::dvec3 axis(unsigned long number, double sign) {
        glm::dvec3 result{0.0};
        result[static_cast<int>(number)] = sign;
        return result;
    }
    [[nodiscard]] glm::dvec3 at(double t) const { return origin + t * direction; }

    glm::dvec3 origin;
    glm::dvec3 direction;
};

/// Calls `law(kind, volume, node)` for random volumes of every kind.
template <class Real, class Law>
void for_all_volumes(unsigned seed, const Law& law) {
    std::mt19937 random(seed);
    for (int kind = 0; kind < kinds; ++kind) {
        SCOPED_TRACE("kind " + std::to_string(kind) + " seed " + std::to_string(seed));
        for (int i = 0; i < 10; ++i) {
            const CompiledVolume volume = random_volume(kind, random);
            VolumeNode<Real> node(volume);
            law(volume, node, random);
        }
    }
}

TYPED_TEST(VolumeKernel, is_entered_and_left_where_another_computation_says) {
    for_all_volumes<TypeParam>(11, [](const auto& volume, auto& node, auto& random) {
        for (int rays = 0; rays < 60; ++rays) {
            const Line line(volume, random);
            const auto expected = cross_volume(line.origin, line.direction, volume);
            const auto found = node.cross(line.origin, line.direction);
            if (!expected ||
                expected->exit - expected->entry < 0.03) {  // grazing: rounding decides
                if (found.inside) {
                    ASSERT_LT(found.inside->exit - found.inside->entry, 0.04);
                }
                continue;
            }
            ASSERT_TRUE(found.inside);
            ASSERT_NEAR(found.inside->entry, expected->entry, digits<TypeParam>);
            ASSERT_NEAR(found.inside->exit, expected->exit, digits<TypeParam>);
        }
    });
}

TYPED_TEST(VolumeKernel, holds_the_points_inside_and_no_others) {
    for_all_volumes<TypeParam>(12, [](const auto& volume, auto& node, auto& random) {
        std::uniform_real_distribution<double> place(-4, 4);
        for (int rays = 0; rays < 60; ++rays) {
            const Line line(volume, random);
            const auto found = node.cross(line.origin, line.direction);
            for (int points = 0; points < 20; ++points) {
                const double t = place(random);
                const double depth = depth_inside(volume, line.at(t));
                if (std::abs(depth) < 1e-4) continue;
                const bool inside =
                    found.inside && found.inside->entry <= t && t <= found.inside->exit;
                ASSERT_EQ(inside, depth > 0) << depth;
            }
        }
    });
}

/// A little further out along the normal is outside, and the normal is across the surface: along a
/// direction across it, depth changes with the square of the way only, but for edges.
TYPED_TEST(VolumeKernel, has_normals_outward_and_across_its_surface) {
    constexpr double step = 0.01;
    for_all_volumes<TypeParam>(13, [](const auto& volume, auto& node, auto& random) {
        for (int rays = 0; rays < 60; ++rays) {
            const Line line(volume, random);
            const auto expected = cross_volume(line.origin, line.direction, volume);
            if (!expected || expected->exit - expected->entry < 0.1) continue;
            const auto found = node.cross(line.origin, line.direction);
            ASSERT_TRUE(found.inside);
            for (const Side side : {Side::entry, Side::exit}) {
                const bool entry = side == Side::entry;
                const glm::dvec3 normal = entry ? found.entry_normal : found.exit_normal;
                const glm::dvec3 at = line.at(entry ? expected->entry : expected->exit);
                ASSERT_NEAR(glm::length(normal), 1, 1e-6);
                ASSERT_LT(depth_inside(volume, at + step * normal), 0);
                ASSERT_LE(glm::dot(normal, line.direction) * (entry ? 1 : -1), 1e-3);
                const double in = depth_inside(volume, at - step * normal);
                if (in < 0.99 * step && volume.kind != kernels::Volume::sphere)
                    continue;  // an edge
                const glm::dvec3 other = entry ? expected->entry_normal : expected->exit_normal;
                ASSERT_GT(glm::dot(normal, glm::normalize(other)), 1 - 1e-4);
            }
        }
    });
}

TYPED_TEST(VolumeKernel, is_crossed_alike_from_far_away) {
    for_all_volumes<TypeParam>(14, [](const auto& volume, auto& node, auto& random) {
        for (int rays = 0; rays < 30; ++rays) {
            Line line(volume, random);
            const double away = 256;
            const auto near = cross_volume(line.origin, line.direction, volume);
            if (!near || near->exit - near->entry < 0.1) continue;
            const auto found = node.cross(line.origin - away * line.direction, line.direction);
            ASSERT_TRUE(found.inside);
            ASSERT_NEAR(found.inside->entry, near->entry + away, 30 * digits<TypeParam>);
            ASSERT_NEAR(found.inside->exit, near->exit + away, 30 * digits<TypeParam>);
        }
    });
}

TYPED_TEST(VolumeKernel, of_a_cone_is_crossed_along_its_axis_its_mantle_and_its_base) {
    VolumeNode<TypeParam> node(cone_volume());
    const auto down = node.cross({0, 4, 0}, {0, -1, 0});
    ASSERT_TRUE(down.inside);
    EXPECT_NEAR(down.inside->entry, 3, digits<TypeParam>);
    EXPECT_NEAR(down.inside->exit, 4, digits<TypeParam>);
    EXPECT_GT(down.entry_normal.y, 0);
    EXPECT_LT(down.exit_normal.y, -0.99);
    const auto inside_mantle = node.cross({0.5, 0, 0}, {-1, 1, 0});  // parallel to the other side
    ASSERT_TRUE(inside_mantle.inside);
    EXPECT_NEAR(inside_mantle.inside->entry, 0, digits<TypeParam>);
    EXPECT_NEAR(inside_mantle.inside->exit, 0.75, digits<TypeParam>);
    EXPECT_FALSE(node.cross({1.5, 0, 0}, {-1, 1, 0}).inside);  // parallel to the mantle, outside
    EXPECT_FALSE(node.cross({0, 1.5, -3}, {0, 0, 1}).inside);  // the nappe above the apex
    EXPECT_FALSE(node.cross({0.25, -0.125, -3}, {0, 0, 1}).inside);
    const auto above_base = node.cross({0, 0.25, -3}, {0, 0, 1});
    ASSERT_TRUE(above_base.inside);
    EXPECT_NEAR(above_base.inside->entry, 2.25, digits<TypeParam>);
    EXPECT_NEAR(above_base.entry_normal.y, std::sqrt(0.5), 1e-3);
}

TYPED_TEST(VolumeKernel, of_a_cylinder_is_crossed_along_its_axis) {
    VolumeNode<TypeParam> node(cylinder_volume());
    const auto up = node.cross({0.5, -4, 0.25}, {0, 1, 0});
    ASSERT_TRUE(up.inside);
    EXPECT_NEAR(up.inside->entry, 3, digits<TypeParam>);
    EXPECT_NEAR(up.inside->exit, 5, digits<TypeParam>);
    EXPECT_LT(up.entry_normal.y, -0.99);
    EXPECT_GT(up.exit_normal.y, 0.99);
    EXPECT_FALSE(node.cross({1.25, -4, 0}, {0, 1, 0}).inside);
    EXPECT_FALSE(node.cross({-4, 1.25, 0}, {1, 0, 0}).inside);
    const auto through = node.cross({-4, 0.75, 0}, {1, 0, 0});
    ASSERT_TRUE(through.inside);
    EXPECT_NEAR(through.inside->entry, 3, digits<TypeParam>);
}

}  // namespace
}  // namespace pxm::test
