// Rays that pass beside the silhouette of an attractor meet none of its cells.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

namespace pxm::host::wide {

/// The silhouette of the hull of an object's attractor on the plane across the packet, in radii
/// of its ball: the places (px, py) with x px + y py <= height for each edge. No edges: no cull.
struct SilhouetteCull {
    static constexpr int most_edges = 6;
    int edges = 0;
    template <class T>
    struct Edge {
        T x, y, height;
    };
    std::array<Edge<double>, most_edges> f64;
    std::array<Edge<float>, most_edges> f32;  // the same

    void put(int edge, const Edge<double>& at) {
        const auto i = static_cast<std::size_t>(edge);
        f64[i] = at;
        f32[i] = {static_cast<float>(at.x), static_cast<float>(at.y),
                  static_cast<float>(at.height)};
    }
    template <class T>
    [[nodiscard]] const Edge<T>& edge(int i) const {
        const auto at = static_cast<std::size_t>(i);
        if constexpr (std::is_same_v<T, float>) {
            return f32[at];
        } else {
            return f64[at];
        }
    }
};

}  // namespace pxm::host::wide
