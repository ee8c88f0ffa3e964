#include "host/import/imported_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/compile/build_rifs.hpp"
#include "host/error.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/grammar.hpp"
#include "host/scene/print/print.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr double margin = 1.1;  // a tenth around the picture
constexpr std::size_t longest_name = 60;

/// Three digits, rounded away from zero or to nearest: nobody measures a camera.
double rounded(double value, double unit) { return std::round(value / unit) * unit + 0.0; }

double power_of_ten_below(double value) { return std::pow(10, std::floor(std::log10(value))); }

/// A number that prints short: units are powers of ten, so text is the way to the nearest double.
/// Bounds err outwards, so that what is 0 may come as a number below this.
constexpr double no_size = std::numeric_limits<double>::min();

/// With six digits.
Decimal decimal(double value) {
    return {std::abs(value) < no_size ? 0 : std::stod(fmt::format("{:.6g}", value)), {}};
}

bool is_finite(const Box& box) {
    const glm::dvec3 extent = box.high - box.low;
    return std::isfinite(extent.x) && std::isfinite(extent.y) && std::isfinite(extent.z);
}

/// Facing the plane z = 0 from the front, x to the right and y up.
void face_plane(const Box& box, Scene& scene) {
    const PixelSize size;
    const double aspect = static_cast<double>(size.columns) / static_cast<double>(size.rows);
    const glm::dvec3 extent = box.high - box.low;
    double width = margin * std::max(extent.x, extent.y * aspect);
    if (!(width > 1e9 * no_size)) width = 1;
    const double unit = power_of_ten_below(width) / 100;
    width = std::ceil(width / unit) * unit;
    // Symmetric pictures have lines through their middle: not where two pixels meet.
    const double aside = 0.0007 * width;  // about half a pixel of 640
    const Decimal x = decimal(rounded((box.low.x + box.high.x) / 2, unit) + aside);
    const Decimal y = decimal(rounded((box.low.y + box.high.y) / 2, unit) + aside);
    CameraBlock camera;
    camera.eye = DecimalVec3{x, y, decimal(-power_of_ten_below(width) * 10)};
    camera.look = DecimalVec3{x, y, decimal(0)};
    camera.orthographic = decimal(width).value;
    scene.camera = camera;
    LightBlock light;
    light.direction = glm::dvec3{0, 0, -1};
    scene.lights.push_back(light);
}

/// By what factor a level of maps multiplies area, copies that overlap counted twice. Maps of the
/// plane scale z by the square root of their plane part's determinant.
double area_growth(const Rifs& rifs) {
    constexpr int levels = 60;
    std::vector<double> area(rifs.follow_sets.size(), 1.0);  // of what a set's maps cover
    double growth = 0;
    for (int level = 0; level < levels; ++level) {
        std::vector<double> next(area.size(), 0.0);
        for (std::size_t s = 0; s < area.size(); ++s)
            for (const int m : rifs.follow_sets[s].maps)
                next[s] += std::pow(std::abs(determinant(rifs.maps[m])), 2.0 / 3) *
                           area[static_cast<std::size_t>(rifs.follow_of[m])];
        growth = *std::ranges::max_element(next);
        if (!(growth > 0)) return 0;
        for (std::size_t s = 0; s < area.size(); ++s) area[s] = next[s] / growth;
    }
    return growth;
}

/// Rays that stand on the plane miss curves; they meet balls of about two pixels around their
/// points. Where copies lie on each other in the same depth, balls cost too much, and areas need
/// none.
void show_curves(const Rifs& rifs, Scene& scene) {
    if (area_growth(rifs) > 1 + 1e-6) return;
    RenderBlock render;
    render.volume = VolumeKind::sphere;
    render.detail = 2;
    scene.render = render;
}

}  // namespace

std::string scene_name(std::string_view text) {
    std::string name;
    for (const char c : text.substr(0, longest_name)) {
        const bool digit = c >= '0' && c <= '9';
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (digit && name.empty()) name.push_back('_');
        name.push_back(digit || letter ? c : '_');
    }
    if (name.empty()) name = "imported";
    if (is_keyword(name)) name.push_back('_');
    return name;
}

Scene imported_scene(IfsBlock maps, const std::string& name, Space space,
                     const SourceFile& source) {
    Scene scene;
    scene.files = {source};  // what the blocks' positions refer to
    maps.name = scene_name(name);
    const Position place = maps.position;
    scene.ifs.push_back(std::move(maps));
    Diagnostics diagnostics;
    check_scene(scene, diagnostics);
    diagnostics.throw_if_errors({source});
    const Rifs rifs = build_rifs(scene.ifs[0], diagnostics);
    diagnostics.throw_if_errors({source});
    const Contraction contraction = prove_contraction(rifs);
    if (contraction.proof == ContractionProof::none) {
        diagnostics.error(place,
                          fmt::format("\"{}\" is no linear fractal: it could not be shown to "
                                      "contract: {}",
                                      printable(name), contraction.obstacle));
        diagnostics.throw_if_errors({source});
    }
    if (space == Space::plane) {
        const auto bounds = bound(rifs, contraction);
        const Box& box = bounds[static_cast<std::size_t>(rifs.start)].box;
        if (!is_finite(box)) {
            diagnostics.error(place, fmt::format("\"{}\" has no view: its points lie so far from "
                                                 "the origin that they could not be bounded",
                                                 printable(name)));
            diagnostics.throw_if_errors({source});
        }
        face_plane(box, scene);
        show_curves(rifs, scene);
    }
    return scene;
}

std::string imported_text(const Scene& scene, const std::string& heading) {
    std::string text;
    for (std::size_t begin = 0; begin < heading.size();) {
        const std::size_t end = std::min(heading.find('\n', begin), heading.size());
        text.append("# ").append(heading, begin, end - begin).append("\n");
        begin = end + 1;
    }
    return text.append("\n").append(print_scene(scene));
}

}  // namespace pxm::host
