// Going down the hierarchy, against maps that are composed in double: the ray that a cell has is
// the scene's ray seen from the cell, its constant is the product, its word the way down.
#include "dsp_kernels/descend.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "host/node_program/native_node.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "tests/support/compile_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr const char* text = R"(
ifs turning {
    newmap scale: 0.5,0.3,0.4 rotate: x,20 rotate: z,-50 translate: 0.4,0.1,-0.2
    newmap scale: 0.4 rotate: y,70 translate: -0.3,0.5,0.1
    newmap matrix: 0.3,0.2,0, -0.1,0.35,0.1, 0,0.1,0.4, 0.1,-0.4,0.3
    follow: 1 -> 2, 3
    follow: 2 -> 1, 2, 3
    follow: 3 -> 1
}
render { lipschitz: polar }
)";

template <class Real>
class Descend : public testing::Test {};
using Reals = testing::Types<float, double, dsp32::Float>;
TYPED_TEST_SUITE(Descend, Reals);

template <class Real>
glm::dvec3 to_glm(const kernels::Vec3<Real>& v) {
    return {to_double(v.x), to_double(v.y), to_double(v.z)};
}

TYPED_TEST(Descend, the_ray_of_a_cell_is_the_ray_of_the_scene_seen_from_it) {
    using Real = TypeParam;
    using Map = kernels::MapRecord<real_words<Real>>;
    using FollowSet = kernels::FollowSetRecord<real_words<Real>>;
    using Header = kernels::HeaderRecord<real_words<Real>>;
    const CompiledScene scene = compile_text(text);
    const std::vector<std::uint32_t> block = make_scene_block<Real>(scene);
    NativeNode<Real> node(block, {}, 1, sizeof(kernels::Cell<Real>));
    const CompiledShape& shape = scene.shapes.at(0);
    const double tolerance = real_words<Real> == 1 ? 2e-5 : 1e-13;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    for (int trial = 0; trial < 200; ++trial) {
        const glm::dvec3 o{anywhere(random), anywhere(random), anywhere(random)};
        const glm::dvec3 d =
            glm::normalize(glm::dvec3{anywhere(random), anywhere(random), anywhere(random)});
        const auto real = [](double x) { return from_double<Real>(x); };
        kernels::Search<Real> search{};
        search.ray = {{real(o.x), real(o.y), real(o.z)}, {real(d.x), real(d.y), real(d.z)}, {}};
        kernels::Cell<Real> cell;
        kernels::outermost_cell(node, search, node.shape_word(Header::objects), cell);
        Affine composed = scene.objects[0].instance;
        double constant = scene.objects[0].constant;
        for (std::uint32_t level = 0; level < 4; ++level) {
            const std::uint32_t maps = node.shape_word(cell.follow_set + FollowSet::map_count);
            ASSERT_GT(maps, 0U);
            const std::uint32_t map = node.shape_word(cell.follow_set + FollowSet::maps +
                                                      static_cast<std::uint32_t>(random() % maps));
            const auto symbol = node.shape_word(map + Map::symbol);
            kernels::Cell<Real> child;
            kernels::child_cell(node, search, cell, map, child);
            kernels::complete_child(node, cell, map, child);
            kernels::approach(node, child);
            // x w_child M_parent: first the child's own map, then those it stands inside.
            composed = then(shape.maps[symbol].map, composed);
            constant *= shape.maps[symbol].constant;
            EXPECT_EQ(child.level, level + 1);
            EXPECT_EQ(child.word.get(level, child.bits), symbol);
            EXPECT_NEAR(to_double(child.constant), constant, 2 * tolerance * constant);
            const double base = to_double(child.ray.base);
            const glm::dvec3 seen = inverse(composed).point(o + base * d);
            const double size = glm::length(seen) + std::abs(base) / constant + 1;
            EXPECT_LT(glm::distance(to_glm(child.ray.origin), seen), tolerance * size);
            const glm::dvec3 way = inverse(composed).linear * d;
            EXPECT_LT(glm::distance(to_glm(child.ray.direction), way),
                      tolerance * glm::length(way) * 10);
            kernels::copy_cell(cell, child);
        }
    }
}

}  // namespace
}  // namespace pxm::test
