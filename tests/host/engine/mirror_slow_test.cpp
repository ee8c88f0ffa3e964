// Laws of mirrors (Sec. 15.3): a mirror shows what a mirrored copy of the scene shows through it.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "dsp_kernels/reflection.hpp"
#include "host/node_program/native_node.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr long side = 40;

const std::string cube = [] {
    std::string text = "ifs cube {\n";
    for (int i = 0; i < 8; ++i) {
        text += "newmap scale: 0.5 translate: " + std::to_string((i & 1) - 0.5) + "," +
                std::to_string((i >> 1 & 1) - 0.5) + "," + std::to_string((i >> 2) - 0.5) + "\n";
    }
    return text + "}\n";
}();
const std::string rest = "light sun { direction: 0.4,0.3,-1 } ";
const std::string camera = "camera { eye: 0.3,1.5,-5 look: 0,0,0 fov: 30 } ";
const std::string orthographic = "camera { eye: 0.6,3,-10 look: 0,0,0 orthographic: 3.5 } ";
/// Above the mirror, whose top is the plane y = 0.
const std::string above =
    "object above { ifs: cube box: (-1,-1,-1)(1,1,1) scale: 0.5 rotate: x,30 rotate: y,25 "
    "translate: 0.1,0.8,0.4 color: 0.9,0.4,0.2,1 } ";
const std::string mirrored_above =
    "object above { ifs: cube box: (-1,-1,-1)(1,1,1) scale: 0.5 rotate: x,30 rotate: y,25 "
    "translate: 0.1,0.8,0.4 scale: 1,-1,1 color: 0.9,0.4,0.2,1 } ";

Frame picture(const std::string& objects, const std::string& view, const std::string& setting) {
    RenderRequest request;
    request.overrides.size = host::PixelSize{side, side};
    return render_text(cube + objects + view + setting, request).frame;
}

void expect_mirrored(const std::string& view, const std::string& setting) {
    const std::string mirror =
        "object mirror { ifs: cube box: (-1,-1,-1)(1,1,1) translate: 0,-1,0 scale: 20,0.5,20 "
        "reflect: 1 } ";
    const Frame seen = picture(mirror + above + rest, view, setting);
    // The mirror turns the light around, too.
    const Frame copy =
        picture(mirrored_above + "light sun { direction: 0.4,-0.3,-1 } ", view, setting);
    long reflected = 0;
    long differing = 0;
    for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
        if (seen.pixels[i].object != 0) continue;  // the mirror itself
        const float difference = std::abs(seen.pixels[i].color[0] - copy.pixels[i].color[0]);
        reflected += copy.pixels[i].alpha > 0.5F ? 1 : 0;
        differing += difference > 0.02F ? 1 : 0;
    }
    EXPECT_GT(reflected, 100);
    // The mirror's own cells are as large as a pixel: at edges the ray may start beside its place.
    EXPECT_LT(differing, reflected / 12) << reflected;
}

TEST(Mirror, shows_what_a_mirrored_scene_shows) {
    expect_mirrored(camera, "render { numeric: double detail: 0.05 }");
}

TEST(Mirror, shows_the_same_in_an_orthographic_view) {
    expect_mirrored(orthographic, "render { numeric: double detail: 0.05 }");
}

TEST(Mirror, facing_another_ends_after_the_bounces_that_were_asked_for) {
    const std::string facing =
        "object floor { ifs: cube box: (-1,-1,-1)(1,1,1) translate: 0,-1,0 scale: 20,0.5,20 "
        "reflect: "
        "1 } object ceiling { ifs: cube box: (-1,-1,-1)(1,1,1) translate: 0,1,0 scale: 20,0.5,20 "
        "translate: 0,2,0 reflect: 1 } camera { eye: 0,1,-1 look: 0,0,0 fov: 20 } ";
    RenderRequest request;
    request.overrides.size = host::PixelSize{8, 8};
    for (const long bounces : {0L, 1L, 3L}) {
        const auto result = render_text(
            cube + facing + "render { bounces: " + std::to_string(bounces) + " }", request);
        EXPECT_EQ(result.statistics.rays.reflect_rays, static_cast<std::uint64_t>(64 * bounces));
    }
}

/// A faint mirror is a small share of each of many samples.
TEST(Mirror, shows_as_much_in_many_samples_as_in_one) {
    const std::string faint =
        "object mirror { ifs: cube box: (-1,-1,-1)(1,1,1) translate: 0,-1,0 scale: 20,0.5,20 "
        "reflect: 0.1 color: 0,0,0,1 } ";
    constexpr long top = side * 2 / 3;  // below it is nothing but the mirror
    const auto mean = [&](const std::string& samples) {
        RenderRequest request;
        request.overrides.size = host::PixelSize{side, side};
        request.overrides.crop = host::CropWindow{side / 4, top, 3 * side / 8, (top + side) / 2};
        const Frame frame =
            render_text(cube + faint + above + rest + camera + "render { " + samples + " }",
                        request)
                .frame;
        double sum = 0;
        for (const PixelRecord& pixel : frame.pixels) sum += pixel.color[0];
        return sum;
    };
    const double one = mean("samples: 1");
    EXPECT_GT(one, 1);
    EXPECT_NEAR(mean("samples: 64") / one, 1, 0.1);
}

/// Eq. 15.6 as printed, with the mirrored viewpoint of Eq. 15.5 without its absolute value.
TEST(Mirror, pixels_grow_as_seen_from_the_mirrored_viewpoint) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return glm::dvec3{normal(random), normal(random), normal(random)}; };
    NativeNode<double> node({}, {}, 1, 1);
    const auto of = [](const glm::dvec3& v) { return kernels::Vec3<double>{v.x, v.y, v.z}; };
    const auto to = [](const kernels::Vec3<double>& v) { return glm::dvec3{v.x, v.y, v.z}; };
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 eye = vector();
        const double t = 0.5 + std::abs(normal(random));
        const double growth = 0.001;
        kernels::Search<double> search{};
        search.ray = {of(eye), of(glm::normalize(vector())), 0};
        search.pixel = {0, growth};
        const glm::dvec3 point = eye + t * to(search.ray.direction);
        const glm::dvec3 plane = glm::normalize(vector());  // its normal, towards the eye or away
        const auto mirror = kernels::mirrored(node, search, of(point), growth * t, of(plane));
        const glm::dvec3 viewpoint = eye - 2 * glm::dot(plane, eye - point) * plane;  // Eq. 15.5
        const double behind = glm::distance(point, viewpoint);
        EXPECT_LT(glm::distance(to(mirror.ray.direction), (point - viewpoint) / behind), 1e-12);
        for (const double further : {0.0, 0.7, 20.0}) {
            const double printed = growth * t / behind * (further + behind);  // Eq. 15.6
            EXPECT_NEAR(kernels::pixel_size(node, mirror.pixel, further, 0.0), printed, 1e-12);
        }
    }
}

}  // namespace
}  // namespace pxm::test
