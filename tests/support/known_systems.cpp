#include "tests/support/known_systems.hpp"

#include "tests/support/figures.hpp"

namespace pxm::host::systems {

namespace {

using std::log;

constexpr double phi = std::numbers::phi;
const double root_half = std::sqrt(0.5);
const double root_third = std::sqrt(1.0 / 3);
const double root_seventh = std::sqrt(1.0 / 7);

std::vector<glm::dvec3> signs_and_turns(double a, double b) {
    std::vector<glm::dvec3> result;
    for (const double s : {a, -a}) {
        for (const double t : {b, -b}) {
            result.push_back({0, s, t});
            result.push_back({s, t, 0});
            result.push_back({t, 0, s});
        }
    }
    return result;
}

std::vector<glm::dvec3> dodecahedron() {
    std::vector<glm::dvec3> corners = signs_and_turns(1 / phi, phi);
    for (const double x : {-1, 1}) {
        for (const double y : {-1, 1}) {
            for (const double z : {-1, 1}) corners.push_back({x, y, z});
        }
    }
    return corners;
}

void add_dusts(std::vector<KnownSystem>& known) {
    const auto ends = [](int n) { return [n](int i) { return i == 0 || i == n - 1; }; };
    known.push_back({"Cantor set", digits(3, ends(3)), log(2) / log(3)});
    known.push_back({"Cantor set of quarters", digits(4, ends(4)), 0.5});
    known.push_back(
        {"even digits in base 5", digits(5, [](int i) { return i % 2 == 0; }), log(3) / log(5)});
    known.push_back({"interval", digits(2, [](int) { return true; }), 1});
    known.push_back({"halves and quarters",
                     complete({scaling(glm::dvec3{0.5}),
                               map({scaling(glm::dvec3{0.25}), translation({0.75, 0, 0})})}),
                     log(phi) / log(2)});
    for (const int n : {3, 4}) {
        known.push_back(
            {"Cantor dust in the plane, " + std::to_string(n),
             cells(n,
                   [n](int i, int j) { return (i == 0 || i == n - 1) && (j == 0 || j == n - 1); }),
             log(4) / log(n)});
    }
    known.push_back({"Cantor dust in space",
                     cells_3d(3, [](int i, int j, int k) { return i != 1 && j != 1 && k != 1; }),
                     3 * log(2) / log(3)});
    known.push_back({"three ratios",
                     complete({scaling(glm::dvec3{0.5}),
                               map({scaling(glm::dvec3{0.3}), translation({0.7, 0, 0})}),
                               map({scaling(glm::dvec3{0.25}), translation({0, 0.75, 0})})}),
                     moran({0.5, 0.3, 0.25})});
}

void add_curves(std::vector<KnownSystem>& known) {
    const double third = 1.0 / 3;
    const Complex i{0, 1};
    known.push_back({"von Koch curve",
                     path({0, third, Complex{0.5, std::sqrt(3) / 6}, 2 * third, 1}),
                     log(4) / log(3)});
    const double angle = 85 * std::numbers::pi / 180;
    const double edge = 1 / (2 + 2 * std::cos(angle));
    known.push_back({"Cesaro's curve of 85 degrees",
                     path({0, edge, edge + std::polar(edge, angle), 1 - edge, 1}),
                     -log(4) / log(edge)});
    known.push_back({"quadratic curve of 5 edges",
                     path({0, third, third + third * i, 2 * third + third * i, 2 * third, 1}),
                     log(5) / log(3)});
    const double q = 0.25;
    known.push_back(
        {"Minkowski's sausage",
         path({0, q, q + q * i, 2 * q + q * i, 2 * q, 2 * q - q * i, 3 * q - q * i, 3 * q, 1}),
         1.5});
    known.push_back({"Levy's curve",
                     complete({plane_map(root_half, 45, 0), plane_map(root_half, -45, {0.5, 0.5})}),
                     2});
    known.push_back({"Heighway's dragon",
                     complete({plane_map(root_half, 45, 0), plane_map(root_half, 135, 1)}), 2});
    known.push_back(
        {"twindragon", complete({plane_map(root_half, 45, 0), plane_map(root_half, 45, 1)}), 2});
    known.push_back({"terdragon",
                     complete({plane_map(root_third, 30, 0),
                               plane_map(root_third, -90, {0.5, std::sqrt(3) / 6}),
                               plane_map(root_third, 30, {0.5, -std::sqrt(3) / 6})}),
                     2});
    const double r = std::pow(phi, -1 / phi);
    const double s = r * r;
    known.push_back(
        {"golden dragon",
         complete({plane_map(r, degrees(std::acos((1 + r * r - s * s) / (2 * r))), 0),
                   plane_map(s, 180 - degrees(std::acos((1 + s * s - r * r) / (2 * s))), 1)}),
         phi});
    const double turn = -std::atan(std::sqrt(3) / 5);
    const Complex first = std::polar(root_seventh, turn);
    const Complex second = first + std::polar(root_seventh, turn + std::numbers::pi / 3);
    known.push_back(
        {"an edge of Gosper's island", path({0, first, second, 1}), log(3) / -log(root_seventh)});
}

void add_plane_figures(std::vector<KnownSystem>& known) {
    const auto all = [](int, int) { return true; };
    known.push_back({"Sierpinski gasket", towards(0.5, polygon(3)), log(3) / log(2)});
    known.push_back(
        {"right gasket", cells(2, [](int i, int j) { return i + j < 2; }), log(3) / log(2)});
    known.push_back({"Sierpinski carpet", cells(3, [](int i, int j) { return i != 1 || j != 1; }),
                     log(8) / log(3)});
    known.push_back(
        {"Vicsek cross", cells(3, [](int i, int j) { return i == 1 || j == 1; }), log(5) / log(3)});
    known.push_back({"Vicsek saltire", cells(3, [](int i, int j) { return (i + j) % 2 == 0; }),
                     log(5) / log(3)});
    for (const int p : {3, 5}) {
        known.push_back({"Pascal's triangle modulo " + std::to_string(p),
                         cells(p, [p](int i, int j) { return i + j < p; }),
                         log(p * (p + 1) / 2) / log(p)});
    }
    known.push_back(
        {"Durer's pentagons", towards(1 / (1 + phi), polygon(5)), log(5) / log(1 + phi)});
    Rifs flake = towards(1 / (1 + phi), polygon(5));
    flake.maps.push_back(plane_map(1 / (1 + phi), 180, 0));
    known.push_back({"pentaflake", complete(flake.maps), log(6) / log(1 + phi)});
    known.push_back({"hexagons", towards(1.0 / 3, polygon(6)), log(6) / log(3)});
    std::vector<glm::dvec3> six = polygon(6);
    six.push_back({0, 0, 0});
    known.push_back({"hexaflake", towards(1.0 / 3, six), log(7) / log(3)});
    known.push_back({"square", cells(2, all), 2});
    known.push_back({"chair",
                     complete({plane_map(0.5, 0, 0), plane_map(0.5, 0, {0.25, 0.25}),
                               plane_map(0.5, 90, 1), plane_map(0.5, -90, {0, 1})}),
                     2});
    Rifs snow = towards(1.0 / 3, polygon(6));
    snow.maps.push_back(plane_map(root_third, 30, 0));
    known.push_back({"snowflake of 7 snowflakes", complete(snow.maps), 2});
    const double turn = std::atan(std::sqrt(3) / 5);
    std::vector<Affine> island{plane_map(root_seventh, degrees(turn), 0)};
    for (int k = 0; k < 6; ++k) {
        island.push_back(plane_map(root_seventh, degrees(turn),
                                   std::polar(root_seventh, turn + k * std::numbers::pi / 3)));
    }
    known.push_back({"Gosper's island", complete(island), 2});
}

void add_solids(std::vector<KnownSystem>& known) {
    known.push_back({"tetra", tetra(), 2});
    known.push_back({"octo", octo(), log(6) / log(2)});
    known.push_back({"Menger sponge", menger(1.0 / 3, 2.0 / 3), log(20) / log(3)});
    known.push_back(
        {"Sierpinski pyramid",
         complete(homotheties(
             0.5, {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}, {0.25, 0.25, 0.5}})),
         log(5) / log(2)});
    known.push_back(
        {"icosahedra", towards(1 / (1 + phi), signs_and_turns(1, phi)), log(12) / log(1 + phi)});
    known.push_back(
        {"dodecahedra", towards(1 / (2 + phi), dodecahedron()), log(20) / log(2 + phi)});
    known.push_back(
        {"cross in space",
         cells_3d(3, [](int i, int j, int k) { return (i != 1) + (j != 1) + (k != 1) < 2; }),
         log(7) / log(3)});
    known.push_back({"Mosely snowflake",
                     cells_3d(3,
                              [](int i, int j, int k) {
                                  const int away = (i != 1) + (j != 1) + (k != 1);
                                  return away == 1 || away == 2;
                              }),
                     log(18) / log(3)});
    known.push_back({"cube", cells_3d(2, [](int, int, int) { return true; }), 3});
}

void add_affine(std::vector<KnownSystem>& known) {
    known.push_back(carpet("carpet of 3 by 2", 3, 2, {{0, 0}, {2, 0}, {1, 1}}));
    known.push_back(
        carpet("carpet of 4 by 3, a row empty", 4, 3, {{0, 0}, {2, 0}, {1, 2}, {3, 2}}));
    known.push_back(carpet("carpet of 5 by 2", 5, 2, {{0, 0}, {2, 0}, {4, 0}, {1, 1}}));
    known.push_back(carpet("carpet of 4 by 3", 4, 3, {{0, 0}, {1, 1}, {2, 2}, {3, 0}, {0, 2}}));
    const double third = 1.0 / 3;
    known.push_back({"graph of the Cantor function (Ex. 5.3)",
                     complete({scaling({third, 0.5, 0}),
                               map({scaling({third, 0, 0}), translation({third, 0.5, 0})}),
                               map({scaling({third, 0.5, 0}), translation({2 * third, 0.5, 0})})}),
                     1});
    const auto quarter = [](double height, double x, double y) {
        return map({scaling({0.25, height, 0}), translation({x, y, 0})});
    };
    known.push_back({"graph of Kiesswetter's function",
                     complete({quarter(-0.5, 0, 0), quarter(0.5, 0.25, -0.5), quarter(0.5, 0.5, 0),
                               quarter(0.5, 0.75, 0.5)}),
                     1.5});
    const Affine up{{{0.5, 0.25, 0}, {0, 0.6, 0}, {0, 0, 0}}, {0, 0, 0}};
    const Affine down{{{0.5, -0.25, 0}, {0, 0.6, 0}, {0, 0, 0}}, {0.5, 0.25, 0}};
    known.push_back({"graph of an interpolation", complete({up, down}), 1 + log(1.2) / log(2)});
}

void add_graphs(std::vector<KnownSystem>& known) {
    known.push_back(
        {"2-D pound sign",
         with_graph(homotheties(0.5, {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}}),
                    {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}),
         log(3) / log(2)});
    known.push_back({"golden mean graph",
                     with_graph(homotheties(0.5, {{0, 0, 0}, {0.5, 0, 0}}), {{0, 1}, {0}}),
                     log(phi) / log(2)});
}

}  // namespace

std::vector<KnownSystem> known_systems() {
    std::vector<KnownSystem> known;
    add_dusts(known);
    add_curves(known);
    add_plane_figures(known);
    add_solids(known);
    add_affine(known);
    add_graphs(known);
    return known;
}

}  // namespace pxm::host::systems
