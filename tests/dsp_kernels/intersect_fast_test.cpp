// Laws of Ch. 13: for homotheties in spheres the fast intersection shows what Alg. 12.4 shows, in
// all numbers, with any heap, on the machine as natively.
#include "dsp_kernels/intersect_fast.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/node_program/native_node.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr const char* fast = "render { intersect: fast }";

/// Two systems that follow one another, with maps of several sizes.
constexpr const char* graph = R"(ifs graph {
    newmap one scale: 0.5 translate: -0.5,0,0.2
    newmap two scale: 0.3 translate: 0.7,0.1,-0.2 color: 1,0,0,0.5
    newmap scale: 0.45 translate: 0.1,-0.6,0
    newmap scale: 0.6 translate: 0,0.4,0.3 color: 0,0,1,0.3
    follow: one -> two, 3
    follow: two -> one, 4
    follow: 3 -> 4
    follow: 4 -> 1, 2, 3, 4
    start: one, two, 3
})";

std::vector<Example> homothetic_scenes(const std::string& image) {
    std::vector<Example> scenes;
    for (const char* name : {"tetra", "octo", "menger", "icos", "dodec"}) {
        scenes.push_back({name, ifs(name)});
    }
    const std::vector<Example> more = {
        {"graph", graph},
        {"inside", ifs("tetra") + "camera { eye: 0.05,0.02,0.11 look: 0.4,-0.2,1 fov: 70 }"},
        {"downward", ifs("octo") + "camera { eye: 0,4,0 look: 0,0,0 up: 0,0,1 orthographic: 2.1 }"},
        {"orthographic", ifs("menger") + "camera { eye: 1,2,-5 look: 0,0,0 orthographic: 3.4 }"},
        {"overlapping_maps",
         "ifs a { newmap scale: 0.8 translate: 0.3,0,0 newmap scale: 0.75 "
         "translate: -0.2,0.4,0.1 newmap scale: 0.7 translate: 0,-0.3,0.2 }"},
        {"objects", ifs("tetra") + ifs("icos") +
                        "object a { ifs: icos scale: 1,0.4,1.7 rotate: z,25 translate: -0.4,0.3,0 "
                        "color: 1,0,0,0.5 } object b { ifs: tetra scale: 0.8 rotate: y,30 } "
                        "object c { ifs: tetra rotate: x,180 levels: 3 sphere: (0,0,0) 1.4 }"},
        {"polar", ifs("octo") + "render { intersect: fast lipschitz: polar shading: high-pass }"
                                "object a { ifs: octo scale: 1,0.5,1.2 }"},
        {"mirror_and_shadow", ifs("tetra") + ifs("octo") +
                                  "object a { ifs: octo reflect: 0.4 levels: 1 } object b { ifs: "
                                  "tetra scale: 0.6 translate: 0.2,0.9,-0.7 } "
                                  "light { direction: 0.4,1,-0.5 shadow: on }"},
        {"levels", ifs("dodec") + "object a { ifs: dodec levels: 2 }"}};
    scenes.insert(scenes.end(), more.begin(), more.end());
    for (Example& scene : scenes) {
        if (scene.text.find("render {") == std::string::npos) scene.text += fast;
        scene.text += fmt::format(" image {{ size: {} }}", image);
    }
    return scenes;
}

class FastIntersection : public testing::TestWithParam<Example> {
  protected:
    const CompiledScene scene_ = compile_text(GetParam().text);
};

TEST_P(FastIntersection, in_double_is_the_oracles) {
    ASSERT_EQ(scene_.method, kernels::Method::fast);
    const Frame frame = render_natively(scene_, Numeric::double_).frame;
    const Verdict verdict = judge(scene_, frame, Numeric::double_);
    EXPECT_GT(verdict.hits, 0);
    EXPECT_GE(verdict.same_share(), 0.999) << verdict.report;
    EXPECT_EQ(verdict.admissible, verdict.pixels) << verdict.report;
    if (needs_plain_features(scene_)) {  // the oracle knows no shadows and mirrors
        if (needs_plain_features(scene_)) {
            EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
        }
    }
}

TEST_P(FastIntersection, in_float_and_dsp32_is_admissible) {
    for (const Numeric numeric : {Numeric::single, Numeric::dsp32}) {
        const Verdict verdict = judge(scene_, render_natively(scene_, numeric).frame, numeric);
        EXPECT_GE(verdict.admissible_share(), 0.999) << verdict.report;
        if (needs_plain_features(scene_)) {
            EXPECT_EQ(verdict.wrong_colors, 0) << verdict.report;
        }
    }
}

/// A ray for whose cells there is no room goes back to Alg. 12.4.
TEST_P(FastIntersection, shows_the_same_cells_with_any_heap_and_on_the_machine) {
    const Frame roomy = render_natively(scene_, Numeric::double_).frame;
    CompiledScene narrow = scene_;
    for (const long heap : {1L, 5L, 256L}) {
        narrow.heap = heap;
        const Frame frame = render_natively(narrow, Numeric::double_).frame;
        const Frame machine = render_on("964", narrow, Numeric::double_).frame;
        for (std::size_t i = 0; i < roomy.pixels.size(); ++i) {
            EXPECT_EQ(frame.pixels[i].z, machine.pixels[i].z);
            EXPECT_EQ(frame.pixels[i].word, machine.pixels[i].word);
            EXPECT_EQ(frame.pixels[i].alpha, roomy.pixels[i].alpha);
        }
        EXPECT_GE(judge(narrow, frame, Numeric::double_).same_share(), 0.999) << heap;
    }
}

std::string name_of(const testing::TestParamInfo<Example>& example) { return example.param.name; }

INSTANTIATE_TEST_SUITE_P(Homothetic, FastIntersection,
                         testing::ValuesIn(homothetic_scenes("16,12")), name_of);

/// Fewer tests than a heap would need are no aim: a fixed order opens more cells where they
/// overlap. But every test is cheaper, and the sum is what the machine pays.
TEST(FastIntersectionCost, is_fewer_cycles_than_the_heap) {
    for (const char* name : {"tetra", "menger"}) {
        CompiledScene scene = compile_text(ifs(name) + fast + "image { size: 24,24 }");
        const auto cycles = [&](kernels::Method method) {
            scene.method = method;
            const EngineResult result = render_on("964dX", scene, Numeric::dsp32);
            std::uint64_t sum = 0;
            for (const NodeStatistics& node : result.machine->nodes) sum += node.cycles;
            return sum;
        };
        EXPECT_LT(cycles(kernels::Method::fast), cycles(kernels::Method::heap)) << name;
    }
}

/// Eq. 13.2 must take the ray to the z-axis (Erratum 20).
TEST(ProjectedRay, has_a_plane_across_it_in_every_direction) {
    const std::vector<std::uint32_t> nothing(1);
    NativeNode<double> node(nothing, {}, 1, sizeof(kernels::Cell<double>));
    using Vec = kernels::Vec3<double>;
    for (const Vec& d :
         {Vec{0.6, 0, 0.8}, Vec{0, 1, 0}, Vec{0, -1, 0}, Vec{-1, 0, 0}, Vec{0, 0, -1},
          Vec{0.48, -0.64, 0.6}, Vec{1e-9, 1, 0}, Vec{0, 1, -1e-200}}) {
        kernels::ProjectedRay<double> ray{};
        ray.along = d;
        kernels::set_plane(node, ray);
        const auto dot = [&](const Vec& a, const Vec& b) { return kernels::dot(node, a, b); };
        EXPECT_NEAR(dot(ray.u, ray.u), 1, 1e-15);
        EXPECT_NEAR(dot(ray.v, ray.v), 1, 1e-15);
        EXPECT_NEAR(dot(ray.u, ray.v), 0, 1e-15);
        EXPECT_NEAR(dot(ray.u, d), 0, 1e-15);
        EXPECT_NEAR(dot(ray.v, d), 0, 1e-15);
    }
}

}  // namespace
}  // namespace pxm::test
