// Systems of known dimension, written as FRACTINT, flam3 and IFSRenderer write them: what is
// imported has the maps that were meant, and the dimension that is in the books.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "host/compile/build_rifs.hpp"
#include "host/fractal/dimension/similarity.hpp"
#include "host/import/flame/flame.hpp"
#include "host/import/ifsrenderer/ifsjson.hpp"
#include "host/import/import.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
namespace {

using Complex = std::complex<double>;

/// A similitude of the plane: mirrored about x or not, scaled, turned, moved.
struct Turn {
    double scale = 1;
    double degrees = 0;
    double x = 0;
    double y = 0;
    bool mirrored = false;

    [[nodiscard]] Complex operator()(const Complex& p) const {
        const double angle = degrees * std::numbers::pi / 180;
        return std::polar(scale, angle) * (mirrored ? std::conj(p) : p) + Complex{x, y};
    }
};

struct System {
    const char* name;
    std::vector<Turn> maps;
    double dimension;
};

std::vector<Turn> grid(int side, const std::vector<Complex>& cells) {
    std::vector<Turn> maps;
    for (const Complex& cell : cells)
        maps.push_back({1.0 / side, 0, cell.real() / side, cell.imag() / side});
    return maps;
}

std::vector<Turn> round_about(int count, double scale, double away) {
    std::vector<Turn> maps;
    for (int i = 0; i < count; ++i) {
        const Complex place = std::polar(away, 2 * std::numbers::pi * i / count);
        maps.push_back({scale, 0, place.real(), place.imag()});
    }
    return maps;
}

std::vector<System> known_systems() {
    const double half = std::sqrt(0.5);
    const double third = std::sqrt(1.0 / 3);
    const double phi = std::numbers::phi;
    std::vector<Turn> hexaflake = round_about(6, 1.0 / 3, 2.0 / 3);
    hexaflake.push_back({1.0 / 3, 0, 0, 0});
    return {
        {"cantor", grid(3, {{0, 0}, {2, 0}}), std::log(2) / std::log(3)},
        {"gasket", grid(2, {{0, 0}, {1, 0}, {0, 1}}), std::log(3) / std::log(2)},
        {"carpet", grid(3, {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {2, 1}, {0, 2}, {1, 2}, {2, 2}}),
         std::log(8) / std::log(3)},
        {"vicsek", grid(3, {{1, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 2}}), std::log(5) / std::log(3)},
        {"koch",
         {{1.0 / 3, 0, 0, 0},
          {1.0 / 3, 60, 1.0 / 3, 0},
          {1.0 / 3, -60, 0.5, std::sqrt(3) / 6},
          {1.0 / 3, 0, 2.0 / 3, 0}},
         std::log(4) / std::log(3)},
        {"dragon", {{half, 45, 0, 0}, {half, 135, 1, 0}}, 2},
        {"levy", {{half, 45, 0, 0}, {half, -45, 0.5, 0.5}}, 2},
        {"terdragon",
         {{third, -30, 0, 0}, {third, 90, 0.5, -third / 2}, {third, -30, 0.5, third / 2}},
         2},
        {"pentaflake", round_about(5, 1 / (phi * phi), 1 / phi), std::log(5) / (2 * std::log(phi))},
        {"hexaflake", hexaflake, std::log(7) / std::log(3)},
        {"golden dust", {{0.5, 0, 0, 0}, {0.25, 0, 0.75, 0}}, std::log(phi) / std::log(2)},
        {"right triangle",  // two mirrored copies of itself: 9/25 and 16/25 of the area
         {{0.6, std::atan2(3, 4) * 180 / std::numbers::pi + 90, 0, 0, true},
          {0.8, std::atan2(3, 4) * 180 / std::numbers::pi, 0.36, 0.48, true}},
         2},
    };
}

/// As rows: x' = a x + b y + e, y' = c x + d y + f.
struct Numbers {
    double a, b, c, d, e, f;
};
Numbers numbers_of(const Turn& map) {
    const Complex moved = map({0, 0});
    const Complex right = map({1, 0}) - moved;
    const Complex up = map({0, 1}) - moved;
    return {right.real(), up.real(), right.imag(), up.imag(), moved.real(), moved.imag()};
}

Imported from_fractint(const System& system) {
    std::string text = "known {\n";
    for (const Turn& map : system.maps) {
        const auto [a, b, c, d, e, f] = numbers_of(map);
        text += fmt::format("{} {} {} {} {} {} 1\n", a, b, c, d, e, f);
    }
    return import_fractint({"f.ifs", text + "}\n"}, FractintFormat::ifs, {});
}

/// In a flame y points down, and numbers stand by columns.
Imported from_flame(const System& system) {
    std::string text = "<flame name=\"known\">\n";
    for (const Turn& map : system.maps) {
        const auto [a, b, c, d, e, f] = numbers_of(map);
        text += fmt::format("<xform weight=\"1\" linear=\"1\" coefs=\"{} {} {} {} {} {}\"/>\n", a,
                            -c, -b, d, e, -f);
    }
    return import_flame({"f.flame", text + "</flame>\n"}, {});
}

/// The program turns x toward y first, then scales, then moves: what is mirrored is turned back.
Imported from_ifsrenderer(const System& system) {
    const auto vec = [](double x, double y, double z) {
        return fmt::format(R"({{"X":{},"Y":{},"Z":{}}})", x, y, z);
    };
    std::string iterators;
    for (const Turn& map : system.maps) {
        const double side = map.mirrored ? -1 : 1;
        iterators += iterators.empty() ? "" : ",";
        iterators +=
            fmt::format(R"({{"Transform":{{"Item1":"Affine","Item2":"1.1"}},"RealParams":{{}},)"
                        R"("Vec3Params":{{"Translate":{},"Scale":{},"Rotate":{}}}}})",
                        vec(map.x, map.y, 0), vec(map.scale, side * map.scale, map.scale),
                        vec(0, 0, side * map.degrees));
    }
    return import_ifsjson(
        {"f.ifsjson", fmt::format(R"({{"Title":"known","Iterators":[{}]}})", iterators)});
}

void expect_known(const System& system, const Imported& made) {
    ASSERT_EQ(made.scene.ifs.size(), 1U);
    const IfsBlock& ifs = made.scene.ifs[0];
    ASSERT_EQ(ifs.maps.size(), system.maps.size());
    for (std::size_t i = 0; i < ifs.maps.size(); ++i)
        for (const Complex& point : {Complex{0, 0}, Complex{1, 0}, Complex{0.3, 2}}) {
            const glm::dvec3 image =
                compose(ifs.maps[i].commands).point({point.real(), point.imag(), 0});
            EXPECT_NEAR(std::abs(Complex{image.x, image.y} - system.maps[i](point)), 0, 1e-12);
        }
    Diagnostics diagnostics;
    const Rifs rifs = build_rifs(ifs, diagnostics);
    ASSERT_FALSE(diagnostics.has_errors());
    EXPECT_NEAR(similarity_dimension(rifs)->middle(), system.dimension, 1e-6);
}

TEST(KnownSystemsOfFiles, have_their_maps_and_dimensions_in_three_formats) {
    const std::vector<System> systems = known_systems();
    ASSERT_GE(systems.size(), 10U);
    for (const System& system : systems) {
        SCOPED_TRACE(system.name);
        expect_known(system, from_fractint(system));
        expect_known(system, from_flame(system));
        expect_known(system, from_ifsrenderer(system));
    }
}

}  // namespace
}  // namespace pxm::host
