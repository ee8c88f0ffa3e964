// EisenScript against the program that it belongs to: tests/data/import/structure_synth/ holds
// scripts, and every box and sphere that Structure Synth 1.5.0 makes of them, as
// tests/consumers/structure_synth lets it write them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/vec3.hpp>
#include <iterator>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "host/import/eisenscript/eisen_scene.hpp"
#include "host/import/import.hpp"
#include "host/math/affine.hpp"
#include "host/scene/scene.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

/// A box by its corner and its edges, a sphere by its middle and three times its radius along the
/// axes; then the colour, red, green and blue of sRGB.
using Part = std::array<double, 15>;

// The program computes in floats, and the colours of an imported scene have four digits.
constexpr double error = 5e-4;

double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Part part(const Affine& place, const glm::dvec3& rgb) {
    const glm::dvec3 corner = place.point({0, 0, 0});
    Part made{};
    std::size_t at = 0;
    const auto put = [&](const glm::dvec3& v, double z) {
        made[at++] = v.x;
        made[at++] = v.y;
        made[at++] = z * v.z;
    };
    put(corner, -1);
    put(place.direction({1, 0, 0}), -1);
    put(place.direction({0, 1, 0}), -1);
    put(place.direction({0, 0, -1}), -1);
    put({srgb(rgb.x), srgb(rgb.y), srgb(rgb.z)}, 1);
    return made;
}

std::vector<Part> boxes(const IfsBlock& ifs) {
    const std::size_t first_corner = ifs.maps.size() - 8;
    std::vector<Part> found;
    const auto walk = [&](const auto& self, std::size_t map, const Affine& place) -> void {
        const Affine here = then(compose(ifs.maps[map].commands), place);
        for (const MapReference& next : ifs.follow[map].followers) {
            const auto number = static_cast<std::size_t>(std::get<long>(next.map)) - 1;
            if (number >= first_corner) {
                found.push_back(part(here, glm::dvec3{ifs.maps[map].color.value()}));
                return;
            }
            self(self, number, here);
        }
    };
    for (const MapReference& start : ifs.start)
        walk(walk, static_cast<std::size_t>(std::get<long>(start.map)) - 1, Affine{});
    return found;
}

std::vector<Part> parts_of_scene(const std::string& script) {
    const Imported made = import_eisenscript({"f.es", script}, 1);
    std::vector<Part> parts;
    if (!made.scene.ifs.empty()) parts = boxes(made.scene.ifs[0]);
    for (const ObjectBlock& object : made.scene.objects) {
        if (object.ifs) continue;
        const auto& ball = std::get<SphereVolume>(object.volume.value());
        Affine place = compose(object.commands);
        place.translation = place.point(ball.center);
        place.linear *= ball.radius;
        parts.push_back(part(place, glm::dvec3{object.color.value()}));
    }
    return parts;
}

std::vector<Part> parts_of_program(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::vector<Part> parts;
    std::string kind;
    while (in >> kind) {
        Part made{};
        std::array<double, 16> m{};
        if (kind == "box") {
            for (double& number : m) in >> number;
            const std::array<std::size_t, 12> order{12, 13, 14, 0, 1, 2, 4, 5, 6, 8, 9, 10};
            for (std::size_t i = 0; i < order.size(); ++i) made[i] = m[order[i]];
        } else {
            double radius = 0;
            in >> made[0] >> made[1] >> made[2] >> radius;
            made[3] = made[7] = made[11] = radius;
        }
        in >> made[12] >> made[13] >> made[14];
        parts.push_back(made);
    }
    return parts;
}

double distance(const Part& a, const Part& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Pairs every part of one list with the nearest of the other; the largest distance of a pair.
double farthest_pair(const std::vector<Part>& ours, std::vector<Part> theirs) {
    double farthest = 0;
    for (const Part& one : ours) {
        const auto nearest = std::ranges::min_element(
            theirs, {}, [&](const Part& other) { return distance(one, other); });
        if (nearest == theirs.end()) return HUGE_VAL;
        farthest = std::max(farthest, distance(one, *nearest));
        theirs.erase(nearest);
    }
    return theirs.empty() ? farthest : HUGE_VAL;
}

TEST(StructureSynth, places_every_box_and_sphere_where_the_scene_has_it) {
    int scripts = 0;
    const std::filesystem::path folder =
        std::filesystem::path(test::source_dir) / "tests/data/import/structure_synth";
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        if (file.path().extension() != ".es") continue;
        ++scripts;
        std::ifstream in(file.path());
        const std::string script{std::istreambuf_iterator<char>(in), {}};
        const std::vector<Part> ours = parts_of_scene(script);
        const std::vector<Part> theirs =
            parts_of_program(std::filesystem::path(file.path()).replace_extension(".txt"));
        EXPECT_EQ(ours.size(), theirs.size()) << file.path();
        EXPECT_LT(farthest_pair(ours, theirs), error) << file.path();
    }
    EXPECT_EQ(scripts, 10);
}

}  // namespace
}  // namespace pxm::host
