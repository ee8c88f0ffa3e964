// Laws of shadow rays (Sec. 15.2): the shadow of a box on a floor is where geometry puts it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "tests/support/compile_text.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

constexpr long side = 48;
constexpr double width = 4;  // of the orthographic picture that looks straight down

/// A solid cube, the attractor of eight maps, as a floor with its top at y = 0 and as a box of half
/// edge 0.5 in the air.
std::string cubes() {
    std::string text = "ifs cube {\n";
    for (int i = 0; i < 8; ++i) {
        text += "newmap scale: 0.5 translate: " + std::to_string((i & 1) - 0.5) + "," +
                std::to_string((i >> 1 & 1) - 0.5) + "," + std::to_string((i >> 2) - 0.5) + "\n";
    }
    return text +
           "}\nobject floor { ifs: cube box: (-1,-1,-1)(1,1,1) translate: 0,-1,0 scale: 4,1,4 }\n"
           "object crate { ifs: cube box: (-1,-1,-1)(1,1,1) scale: 0.5 translate: 0.2,1,-0.1 }\n"
           "camera { eye: 0,10,0 look: 0,0,0 up: 0,0,1 orthographic: 4 }\n";
}

glm::dvec3 on_floor(long x, long y) {
    const double step = width / static_cast<double>(side);
    return {(static_cast<double>(x) + 0.5) * step - width / 2, 0,
            width / 2 - (static_cast<double>(y) + 0.5) * step};
}

/// How far inside the box a segment from `from` along `way` (to t = 1, or without end) comes:
/// positive if it crosses the box, by the thickness of what it must be moved to miss it.
double depth_in_box(const glm::dvec3& from, const glm::dvec3& way) {
    const auto crosses = [&](double half) {
        double entry = 0;
        double exit = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = glm::dvec3{0.2, 1, -0.1}[axis] - half;
            const double a = (low - from[axis]) / way[axis];
            const double b = (low + 2 * half - from[axis]) / way[axis];
            entry = std::max(entry, std::min(a, b));
            exit = std::min(exit, std::max(a, b));
        }
        return entry <= exit;
    };
    const double margin = 3 * width / static_cast<double>(side);
    return crosses(0.5 - margin) ? 1 : crosses(0.5 + margin) ? 0 : -1;
}

/// Whether a pixel of the box's top is more than two pixels away from its edges.
bool clear_of_edges(long x, long y) {
    const glm::dvec3 from_center = on_floor(x, y) - glm::dvec3{0.2, 0, -0.1};
    const double margin = 2 * width / static_cast<double>(side);
    return std::max(std::abs(from_center.x), std::abs(from_center.z)) < 0.5 - margin;
}

/// Renders the floor with a light; checks every pixel that lies clear of the shadow's edge.
void expect_shadow(const std::string& light, const std::string& setting, auto way_to_light) {
    RenderRequest request;
    request.overrides.size = host::PixelSize{side, side};
    const Frame lit = render_text(cubes() + "light l { " + light + " }" + setting, request).frame;
    const Frame dark =
        render_text(cubes() + "light l { " + light + " shadow: on }" + setting, request).frame;
    long in_shadow = 0;
    long in_light = 0;
    for (long y = 0; y < side; ++y) {
        for (long x = 0; x < side; ++x) {
            ASSERT_GE(lit.at(x, y).object, 0);
            const float share = dark.at(x, y).color[1] / lit.at(x, y).color[1];
            if (lit.at(x, y).object == 1) {
                if (clear_of_edges(x, y)) {  // the box's top does not shadow itself
                    EXPECT_EQ(share, 1) << x << "," << y;
                }
                continue;
            }
            const glm::dvec3 point = on_floor(x, y);
            const double depth = depth_in_box(point, way_to_light(point));
            if (depth == 0) continue;
            (depth > 0 ? in_shadow : in_light) += 1;
            if (depth > 0) {
                EXPECT_LT(share, 0.5F) << x << "," << y;
            } else {
                EXPECT_EQ(share, 1) << x << "," << y;
            }
        }
    }
    EXPECT_GT(in_shadow, 40);
    EXPECT_GT(in_light, 1000);
}

const glm::dvec3 sun{0.6, 1, 0.3};
const glm::dvec3 lamp{-1.4, 3, 0.9};
const std::string sunny = "direction: 0.6,1,0.3";
const std::string lamplit = "position: -1.4,3,0.9";
const auto to_sun = [](const glm::dvec3&) { return 10.0 * sun; };
const auto to_lamp = [](const glm::dvec3& point) { return lamp - point; };

TEST(Shadow, of_a_box_in_the_sun_is_where_it_should_be) {
    expect_shadow(sunny, "render { numeric: double }", to_sun);
}

TEST(Shadow, of_a_box_under_a_lamp_is_where_it_should_be) {
    expect_shadow(lamplit, "render { numeric: double }", to_lamp);
}

TEST(Shadow, with_local_covers_is_the_same_away_from_its_edge) {
    expect_shadow(sunny, "render { numeric: double covers: on }", to_sun);
    expect_shadow(lamplit, "render { numeric: double covers: on }", to_lamp);
}

TEST(Shadow, of_what_is_behind_a_lamp_does_not_fall) {
    RenderRequest request;
    request.overrides.size = host::PixelSize{side, side};
    request.overrides.intersect = IntersectMethod::heap;
    const std::string low = "light l { position: 0.2,0.3,-0.1 shadow: on }";  // under the box
    const std::string off = "light l { position: 0.2,0.3,-0.1 }";
    const Frame with = render_text(cubes() + low, request).frame;
    const Frame without = render_text(cubes() + off, request).frame;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        if (with.pixels[i].object != 0) continue;
        EXPECT_EQ(with.pixels[i].color[0], without.pixels[i].color[0]) << i;
    }
}

TEST(Shadow, rays_are_counted_once_for_each_light_that_a_surface_faces) {
    RenderRequest request;
    request.overrides.size = host::PixelSize{side, side};
    const auto result = render_text(
        cubes() +
            "light a { direction: 0,1,0.1 shadow: on } light b { direction: 0,-1,0.1 shadow: "
            "on } light c { direction: 0,1,-0.1 }",
        request);
    EXPECT_EQ(result.statistics.rays.light_rays, side * side);
}

}  // namespace
}  // namespace pxm::test
