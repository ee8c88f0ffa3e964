// Laws of the size of a pixel for eye rays (Sec. 15.1).
#include "host/compile/view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace pxm::host {
namespace {

struct Lens {
    double fov_degrees;
    PixelSize size;
};

CompiledCamera camera_of(const Lens& lens) {
    CameraBlock camera;
    camera.fov = lens.fov_degrees;
    return compile_view(make_view(camera, lens.size, {{0, 0, 0}, 1}, 1), lens.size, 1);
}

const Lens lenses[] = {{20, {64, 64}}, {40, {640, 480}}, {90, {32, 48}}, {140, {25, 9}}};

/// Horizontal extent of a pixel of the plane one unit before the eye, once it is projected on the
/// sphere of radius t around the eye: to first order that of its middle line.
double extent_at_one(const CompiledCamera& camera, double x, double y) {
    const auto on_plane = [&](double column) {
        return camera.corner + column * camera.across + y * camera.down;
    };
    return glm::length(on_plane(x + 0.5) - on_plane(x - 0.5)) / glm::length(on_plane(x));
}

TEST(PixelSize, of_every_pixel_lies_between_the_bounds_of_eq_15_2) {
    for (const Lens& lens : lenses) {
        const CompiledCamera camera = camera_of(lens);
        const auto columns = static_cast<double>(lens.size.columns);
        const auto rows = static_cast<double>(lens.size.rows);
        const double half = std::tan(lens.fov_degrees / 360 * std::numbers::pi);
        const double aspect = columns / rows;
        const double upper = 2 * half / columns;
        const double cosine = std::cos(std::atan(half));
        const double lower =
            upper / std::sqrt(1 / (cosine * cosine) + half * half / (aspect * aspect));
        EXPECT_NEAR(camera.pixel_growth, upper, 1e-12 * upper);  // p(t) is the upper bound
        EXPECT_EQ(camera.pixel_at_eye, 0);
        for (double y = 0.5; y < rows; ++y) {
            for (double x = 0.5; x < columns; ++x) {
                const double extent = extent_at_one(camera, x, y);
                EXPECT_LE(extent, upper * (1 + 1e-12));
                EXPECT_GE(extent, lower * (1 - 1e-12));
            }
        }
    }
}

TEST(PixelSize, eq_15_1_is_the_smallest_of_the_middle_scan_line) {
    for (const Lens& lens : lenses) {
        const CompiledCamera camera = camera_of(lens);
        const auto columns = static_cast<double>(lens.size.columns);
        const double barr =
            2 * std::sin(lens.fov_degrees / 360 * std::numbers::pi) / columns;  // Eq. 15.1
        const double middle = static_cast<double>(lens.size.rows) / 2;
        EXPECT_NEAR(extent_at_one(camera, 0, middle), barr, 1e-12);
        for (double x = 0; x <= columns; ++x) {
            EXPECT_GE(extent_at_one(camera, x, middle), barr * (1 - 1e-12));
        }
    }
}

}  // namespace
}  // namespace pxm::host
