#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "host/inspect/neighbour_files.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_drawn = 60;    // types
constexpr std::size_t most_points = 700;  // of a piece
constexpr int rounds = 14;                // of maps applied to points
constexpr double picture_pixels = 220;
constexpr double edge_pixels = 10;

using Points = std::vector<glm::dvec3>;

/// Points near each E_s: images of one point, thinned evenly.
std::vector<Points> pieces_of(const IfsFacts& ifs) {
    const Rifs& rifs = ifs.rifs;
    std::vector<Points> pieces(rifs.follow_sets.size());
    for (std::size_t s = 0; s < pieces.size(); ++s) pieces[s].push_back(ifs.bounds[s].ball.center);
    for (int round = 0; round < rounds; ++round) {
        std::vector<Points> next(pieces.size());
        for (std::size_t s = 0; s < pieces.size(); ++s) {
            Points all;
            for (const int m : rifs.follow_sets[s].maps) {
                const auto map = static_cast<std::size_t>(m);
                const auto inside = static_cast<std::size_t>(rifs.follow_of[map]);
                for (const glm::dvec3& p : pieces[inside]) all.push_back(rifs.maps[map].point(p));
            }
            const std::size_t kept = std::min(all.size(), most_points);
            for (std::size_t i = 0; i < kept; ++i) next[s].push_back(all[i * all.size() / kept]);
        }
        pieces = std::move(next);
    }
    return pieces;
}

/// In the coordinates of the types' maps; those that are not used are 0.
glm::dvec3 in_axes(const ExactFindings& exact, const glm::dvec3& p) {
    glm::dvec3 q{0.0};
    for (int i = 0; i < exact.dimensions; ++i) q[i] = p[exact.axes[static_cast<std::size_t>(i)]];
    return q;
}

glm::dvec3 moved(const ExactFindings& exact, const TouchingType& type, const glm::dvec3& p) {
    const int n = exact.dimensions;
    glm::dvec3 q{0.0};
    for (int r = 0; r < n; ++r) {
        const auto row = static_cast<std::size_t>(r * (n + 1));
        q[r] = type.entries[row + static_cast<std::size_t>(n)];
        for (int c = 0; c < n; ++c) q[r] += type.entries[row + static_cast<std::size_t>(c)] * p[c];
    }
    return q;
}

/// A plane as it is, space seen aslant.
glm::dvec2 seen(const ExactFindings& exact, const glm::dvec3& p) {
    constexpr double sideways = 0.45, upward = 0.3;
    if (exact.dimensions < 3) return {p.x, -p.y};
    return {p.x - sideways * p.z, -p.y + upward * p.z};
}

std::string dots(const ExactFindings& exact, const Points& points, const char* color,
                 double radius) {
    std::string text = fmt::format("<g fill=\"{}\">", color);
    for (const glm::dvec3& p : points) {
        const glm::dvec2 at = seen(exact, p);
        text +=
            fmt::format("<circle cx=\"{:.5g}\" cy=\"{:.5g}\" r=\"{:.4g}\"/>", at.x, at.y, radius);
    }
    return text + "</g>";
}

std::string drawing(const ExactFindings& exact, const Points& first, const Points& second,
                    double size) {
    constexpr double near_share = 0.03, dot_share = 0.006, large_dot = 2;
    Points common;
    for (const glm::dvec3& a : first)
        if (std::ranges::any_of(second, [&](const glm::dvec3& b) {
                return glm::distance(a, b) < near_share * size;
            }))
            common.push_back(a);
    glm::dvec2 low{INFINITY}, high{-INFINITY};
    for (const Points* points : {&first, &second})
        for (const glm::dvec3& p : *points) {
            low = glm::min(low, seen(exact, p));
            high = glm::max(high, seen(exact, p));
        }
    const double widest = std::max({high.x - low.x, high.y - low.y, near_share * size});
    const double edge = widest * edge_pixels / picture_pixels;
    const glm::dvec2 corner = (low + high) / 2.0 - glm::dvec2{widest / 2 + edge};
    std::string text = fmt::format(
        "<svg width=\"{0}\" height=\"{0}\" viewBox=\"{1:.5g} {2:.5g} {3:.5g} {3:.5g}\">",
        picture_pixels, corner.x, corner.y, widest + 2 * edge);
    text += dots(exact, first, "#889", dot_share * widest);
    text += dots(exact, second, "#27c", dot_share * widest);
    text += dots(exact, common, "#d30", large_dot * dot_share * widest);
    return text + "</svg>";
}

}  // namespace

std::string neighbour_page(const IfsFacts& ifs) {
    const ExactFindings& exact = ifs.exact;
    std::vector<Points> pieces = pieces_of(ifs);
    for (Points& piece : pieces)
        for (glm::dvec3& p : piece) p = in_axes(exact, p);
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Neighbours of "
        "{0}</title>\n<style>body{{font-family:sans-serif}}figure{{display:inline-block;"
        "margin:6px}}</style></head>\n<body><h1>Neighbours of {0}</h1>\n<p>{1} types that touch. "
        "Grey: a cell. Blue: its neighbour. Red: where they are near each other.</p>\n",
        ifs.rifs.name, exact.types);
    for (std::size_t t = 0; t < std::min(exact.graph.size(), most_drawn); ++t) {
        const TouchingType& type = exact.graph[t];
        const Points& first = pieces[static_cast<std::size_t>(type.first)];
        Points second = pieces[static_cast<std::size_t>(type.second)];
        for (glm::dvec3& p : second) p = moved(exact, type, p);
        text += fmt::format("<figure>{}<figcaption>type {}{}</figcaption></figure>\n",
                            drawing(exact, first, second, ifs.diameter.value), t,
                            type.identity ? ", the same cell" : "");
    }
    if (exact.graph.size() > most_drawn)
        text += fmt::format("<p>The first {} are drawn.</p>\n", most_drawn);
    return text + "</body></html>\n";
}

}  // namespace pxm::host
