#include "tests/support/known_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

namespace pxm::test {

using namespace host;

namespace {

constexpr int reported = 4;

std::string numbers(const glm::dvec3& v) {
    return fmt::format("{:.17g},{:.17g},{:.17g}", v.x, v.y, v.z);
}

/// A turn about no axis by no round number of degrees.
glm::dmat3 askew() {
    const glm::dvec3 x = glm::normalize(glm::dvec3{0.8, -0.35, 0.41});
    const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3{0.3, 0.2, 0.9}, x));
    return {x, y, glm::cross(x, y)};
}

/// The line of sight through a pixel in the surface's coordinates.
Sight sight_of(const KnownView& view, const CompiledScene& scene, Oracle& eye, long x, long y) {
    const Sight seen = eye.sight(x, y);
    const glm::dmat3 back = glm::transpose(view.turn);
    return {view.eye + back * (seen.origin * scene.unit), back * seen.direction};
}

class Judge {
  public:
    Judge(const KnownSurface& surface, const KnownView& view, double most_degrees)
        : surface_(surface), view_(view), most_degrees_(most_degrees) {}

    /// `pixel` is its size at the surface, in the surface's units; `inner`: the rays of the pixels
    /// around come to the surface too.
    void look_at(const Sight& ray, const PixelRecord& record, double cell, double pixel, bool inner,
                 const std::string& place) {
        const auto hit = surface_.hit(ray, -1e-6);
        const double z = static_cast<double>(record.z);
        if (record.alpha > 0) {
            const double away = surface_.distance(ray.origin + z * ray.direction) / cell;
            verdict_.farthest = std::max(verdict_.farthest, away);
            if (away > 1 + 1e-3) {
                ++verdict_.beside;
                report(place, fmt::format("{:.3g} cells from the surface", away));
            }
        }
        if (!hit) return;
        ++verdict_.rays;
        if (record.alpha == 0 || z > hit->depth * (1 + 2e-6) + 1e-3 * cell) {
            ++verdict_.lost;
            report(place, fmt::format("depth {:.9g}, is {:.9g}", z, hit->depth));
            return;
        }
        if (inner) look_at_normal(ray, *hit, record, pixel, place);
    }
    SurfaceVerdict take() {
        if (verdict_.flat > 0) verdict_.mean_degrees /= static_cast<double>(verdict_.flat);
        return std::move(verdict_);
    }

  private:
    void look_at_normal(const Sight& ray, const SurfaceHit& hit, const PixelRecord& record,
                        double pixel, const std::string& place) {
        for (const double grown : {-2.0, 2.0}) {  // an edge nearby: another face, or none
            const auto other = surface_.hit(ray, grown * pixel);
            if (!other || glm::dot(other->normal, hit.normal) < 0.999) return;
        }
        ++verdict_.flat;
        if (record.alpha < 0.9999F) {
            ++verdict_.thin;
            verdict_.least_alpha =
                std::min(verdict_.least_alpha, static_cast<double>(record.alpha));
        }
        const glm::dvec3 normal = glm::transpose(view_.turn) *
                                  glm::dvec3{record.normal[0], record.normal[1], record.normal[2]};
        const double cosine = std::clamp(glm::dot(normal, hit.normal), -1.0, 1.0);
        const double degrees = std::acos(cosine) * 180 / std::acos(-1.0);
        verdict_.worst_degrees = std::max(verdict_.worst_degrees, degrees);
        verdict_.mean_degrees += degrees;
        if (degrees < most_degrees_) return;
        ++verdict_.turned;
        report(place, fmt::format("normal {} is {:.3g} degrees off {}", numbers(normal), degrees,
                                  numbers(hit.normal)));
    }
    void report(const std::string& place, const std::string& what) {
        if (reports_++ < reported) verdict_.report += place + ": " + what + "\n";
    }

    const KnownSurface& surface_;
    const KnownView& view_;
    double most_degrees_;
    SurfaceVerdict verdict_;
    int reports_ = 0;
};

}  // namespace

std::vector<KnownView> known_views() {
    const glm::dmat3 straight{1.0};
    const glm::dvec3 middle{0.5, 0.5, 0.5};
    // Half a pixel of 1/32 aside: rays through multiples of 1/32.
    const glm::dvec3 aside{0.5 + 1.0 / 64, 0.5 + 1.0 / 64, 0};
    return {
        {"along_z", aside - glm::dvec3{0, 0, 4}, aside, 1.5, 0, straight},
        {"along_z_back", aside + glm::dvec3{0, 0, 5}, aside, 1.5, 0, straight},
        {"along_y",
         middle + glm::dvec3{1.0 / 64, 5, 1.0 / 64},
         middle + glm::dvec3{1.0 / 64, 0, 1.0 / 64},
         1.5,
         0,
         {}},
        {"along_faces", middle + glm::dvec3{-3, 0, -3}, middle, 1.75, 0, straight},
        {"along_edges", middle + glm::dvec3{-3, 3, -3}, middle, 1.75, 0, straight},
        {"along_edges_back", middle + glm::dvec3{3, -3, 3}, middle, 1.75, 0, straight},
        {"from_somewhere", middle + glm::dvec3{1.3, 2.1, -2.7}, middle, 1.8, 0, straight, true},
        {"near", {0.5, 0.5, -1.5}, {0.5, 0.5, 0.5}, 0, 45, straight},
        {"near_a_corner", {1.5, 1.5, -1.25}, {0.5, 0.5, 0.5}, 0, 40, straight},
        {"near_somewhere", {-0.7, 1.6, 2.2}, {0.5, 0.45, 0.4}, 0, 40, straight, true},
        {"along_z_thirds", middle - glm::dvec3{0, 0, 4}, middle, 48.0 / 27, 0, straight},
        {"along_z_fifths", middle - glm::dvec3{0, 0, 4}, middle, 48.0 / 25, 0, straight},
        {"along_faces_thirds", middle + glm::dvec3{-3, 0, -3}, middle, 48.0 / 27, 0, straight},
        {"turned", middle + glm::dvec3{0, 0, -4}, middle, 1.5, 0, askew()},
        {"turned_thirds", middle + glm::dvec3{0, 0, -4}, middle, 48.0 / 27, 0, askew()},
        {"turned_near", {0.5, 0.5, -1.5}, middle, 0, 45, askew()},
    };
}

std::string text_of(const KnownSurface& surface, const KnownView& view, int side,
                    const std::string& render) {
    const auto place = [&](const glm::dvec3& p) { return numbers(view.turn * (p - view.eye)); };
    const glm::dvec3 up = std::abs(glm::normalize(view.look - view.eye).y) > 0.9
                              ? glm::dvec3{0, 0, 1}
                              : glm::dvec3{0, 1, 0};
    std::string text = "ifs it {\n" + surface.maps + "}\n";
    text += fmt::format("object it {{ ifs: it matrix: {}, {}, {}, {} }}\n", numbers(view.turn[0]),
                        numbers(view.turn[1]), numbers(view.turn[2]), place({0, 0, 0}));
    const std::string lens = view.fov > 0 ? fmt::format("fov: {}", view.fov)
                                          : fmt::format("orthographic: {:.17g}", view.width);
    text += fmt::format("camera {{ eye: 0,0,0 look: {} up: {} {} }}\n", place(view.look),
                        numbers(view.turn * up), lens);
    text += fmt::format("image {{ size: {},{} }}\nrender {{ {} }}\n", side, side, render);
    return text;
}

namespace {

/// Whether the rays of a pixel and of those around it come to the surface: it is not seen past.
bool is_inner(const std::vector<std::optional<SurfaceHit>>& hits, const PixelSize& size, long x,
              long y) {
    for (long row = y - 1; row <= y + 1; ++row) {
        for (long column = x - 1; column <= x + 1; ++column) {
            if (row < 0 || column < 0 || row >= size.rows || column >= size.columns) continue;
            if (!hits[static_cast<std::size_t>(row * size.columns + column)]) return false;
        }
    }
    return true;
}

}  // namespace

SurfaceVerdict judge(const KnownSurface& surface, const KnownView& view, const CompiledScene& scene,
                     const Frame& frame, double most_degrees) {
    Oracle eye(scene, 0);  // for the lines of sight alone
    Judge judge(surface, view, most_degrees);
    std::vector<std::optional<SurfaceHit>> hits;
    for (long y = 0; y < scene.size.rows; ++y) {
        for (long x = 0; x < scene.size.columns; ++x) {
            hits.push_back(surface.hit(sight_of(view, scene, eye, x, y), 1e-6));
        }
    }
    for (long y = 0; y < scene.size.rows; ++y) {
        for (long x = 0; x < scene.size.columns; ++x) {
            const Sight ray = sight_of(view, scene, eye, x, y);
            const PixelRecord& record = frame.at(x, y);
            const auto& hit = hits[static_cast<std::size_t>(y * scene.size.columns + x)];
            const double depth = record.alpha > 0 ? static_cast<double>(record.z)
                                 : hit            ? hit->depth
                                                  : 0.0;
            const double pixel =
                scene.camera.pixel_at_eye * scene.unit + scene.camera.pixel_growth * depth;
            judge.look_at(ray, record, scene.detail * pixel, pixel,
                          is_inner(hits, scene.size, x, y),
                          fmt::format("{} {} pixel {},{}", surface.name, view.name, x, y));
        }
    }
    return judge.take();
}

}  // namespace pxm::test
