// The scene block read back: what a node finds in its words is what was compiled.
#include "host/node_program/write_scene_block.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "dsp_kernels/scene_block.hpp"
#include "host/node_program/native_node.hpp"
#include "tests/support/compile_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr const char* text = R"(
ifs a {
    newmap scale: 0.5 rotate: z,30 translate: 0.5,0,0 color: 0.2,0.4,0.6,0.5
    newmap scale: 0.4,0.3,0.2 translate: -0.5,0,0.1
    follow: 1 -> 2
}
ifs b { newmap scale: 0.5  newmap scale: 0.5 translate: 0,0.5,0  newmap scale: 0.5 translate: 1,0,0 }
object one { ifs: a }
object two { ifs: b translate: 3,0,0 color: 1,0,0,1 }
light sun { direction: 1,1,1 }
light lamp {
    position: 5,5,5
    shadow: on
}
)";

template <class Real>
class SceneBlock : public testing::Test {};
using Reals = testing::Types<float, double, dsp32::Float>;
TYPED_TEST_SUITE(SceneBlock, Reals);

template <class Real>
glm::dvec3 vector_at(const NativeNode<Real>& node, std::uint32_t address) {
    const auto at = [&](std::uint32_t i) {
        return to_double(node.shape_real(address + i * real_words<Real>));
    };
    return {at(0), at(1), at(2)};
}

TYPED_TEST(SceneBlock, a_node_reads_what_was_compiled) {
    using Real = TypeParam;
    using Header = kernels::HeaderRecord<real_words<Real>>;
    using Object = kernels::ObjectRecord<real_words<Real>>;
    using FollowSet = kernels::FollowSetRecord<real_words<Real>>;
    using Map = kernels::MapRecord<real_words<Real>>;
    const CompiledScene scene = compile_text(text);
    const std::vector<std::uint32_t> block = make_scene_block<Real>(scene);
    const NativeNode<Real> node(block, {}, 1, sizeof(kernels::Cell<Real>));
    const double tolerance = real_words<Real> == 1 ? 1e-6 : 1e-14;
    ASSERT_EQ(node.shape_word(Header::object_count), scene.objects.size());
    ASSERT_EQ(node.shape_word(Header::light_count), scene.lights.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const CompiledObject& object = scene.objects[i];
        const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
        const auto address =
            node.shape_word(Header::objects) + static_cast<std::uint32_t>(i) * Object::words;
        EXPECT_EQ(object_index<Real>(block, address), i);
        EXPECT_LT(glm::distance(vector_at(node, address + Object::color), object.color), tolerance);
        const std::uint32_t set = node.shape_word(address + Object::start_set);
        ASSERT_LT(set + FollowSet::words, block.size());
        const CompiledSet& compiled = shape.sets[static_cast<std::size_t>(object.start)];
        ASSERT_EQ(node.shape_word(set + FollowSet::map_count), compiled.maps.size());
        EXPECT_LT(glm::distance(vector_at(node, set + FollowSet::center), compiled.volume.center),
                  tolerance * 10);
        for (std::size_t m = 0; m < compiled.maps.size(); ++m) {
            const std::uint32_t map =
                node.shape_word(set + FollowSet::maps + static_cast<std::uint32_t>(m));
            ASSERT_LT(map + Map::words, block.size() + 1);
            const auto symbol = static_cast<std::size_t>(compiled.maps[m]);
            EXPECT_EQ(node.shape_word(map + Map::symbol), symbol);
            EXPECT_NEAR(to_double(node.shape_real(map + Map::constant)),
                        shape.maps[symbol].constant, tolerance);
            // The inverse undoes the map.
            const glm::dvec3 x{0.3, -0.7, 0.2}, y = shape.maps[symbol].map.point(x);
            glm::dvec3 back = vector_at(node, map + Map::inverse + 9 * real_words<Real>);
            for (std::uint32_t row = 0; row < 3; ++row)
                back += y[static_cast<int>(row)] *
                        vector_at(node, map + Map::inverse + 3 * row * real_words<Real>);
            EXPECT_LT(glm::distance(back, x), tolerance * 10);
        }
    }
}

TYPED_TEST(SceneBlock, its_hash_tells_scenes_apart) {
    using Real = TypeParam;
    const auto hash = [](const std::string& scene) {
        return block_hash(make_scene_block<Real>(compile_text(scene)));
    };
    EXPECT_EQ(hash(text), hash(text));
    EXPECT_NE(hash(text), hash(std::string(text) + "image { size: 8,8 }"));
}

}  // namespace
}  // namespace pxm::test
