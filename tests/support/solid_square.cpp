#include "tests/support/solid_square.hpp"

#include <cmath>

namespace pxm::test {

std::string cube_text() {
    std::string text = "ifs cube {\n";
    for (int i = 0; i < 8; ++i) {
        text += "newmap scale: 0.5 translate: " + std::to_string((i & 1) - 0.5) + "," +
                std::to_string((i >> 1 & 1) - 0.5) + "," + std::to_string((i >> 2) - 0.5) + "\n";
    }
    return text + "}\n";
}

std::string square_text(double degrees) {
    return cube_text() + "object s { ifs: cube box: (-1,-1,-1)(1,1,1) rotate: z," +
           std::to_string(degrees) + " } camera { eye: 0,0,-5 look: 0,0,0 orthographic: 4 }\n";
}

double area_of_square(double degrees, long x, long y) {
    constexpr int points = 32;
    constexpr auto side = static_cast<double>(square_side);
    const double angle = degrees * std::acos(-1) / 180;
    int inside = 0;
    for (int i = 0; i < points; ++i) {
        for (int j = 0; j < points; ++j) {
            const double u = (static_cast<double>(x) + (i + 0.5) / points) / side * 4 - 2;
            const double v = 2 - (static_cast<double>(y) + (j + 0.5) / points) / side * 4;
            const double a = u * std::cos(angle) + v * std::sin(angle);
            const double b = -u * std::sin(angle) + v * std::cos(angle);
            inside += std::abs(a) < 1 && std::abs(b) < 1 ? 1 : 0;
        }
    }
    return inside / static_cast<double>(points * points);
}

AreaError area_error(const host::Frame& frame, double degrees) {
    AreaError error;
    for (long y = 0; y < square_side; ++y) {
        for (long x = 0; x < square_side; ++x) {
            const double area = area_of_square(degrees, x, y);
            const double opacity = static_cast<double>(frame.at(x, y).alpha);
            if (area == 1 && std::abs(opacity - 1) > 1e-5) ++error.not_solid;
            if ((area == 0 && opacity == 0) || area == 1) continue;
            ++error.pixels;
            error.mean += opacity - area;
            error.rms += (opacity - area) * (opacity - area);
        }
    }
    if (error.pixels == 0) return error;
    error.mean /= static_cast<double>(error.pixels);
    error.rms = std::sqrt(error.rms / static_cast<double>(error.pixels));
    return error;
}

}  // namespace pxm::test
