// A recurrent iterated function system (Ch. 4) ready for mathematics: maps in double, and the graph
// in descent order (inside the image of map a, map b may come next).
// Maps that may be followed by the same maps share one *follow set*; the attractor piece that may
// stand inside such a map depends on the follow set alone, so bounds are kept per follow set.
#pragma once

#include <string>
#include <vector>

#include "host/math/affine.hpp"

namespace pxm::host {

/// E_s = union over m in maps of w_m(E_{follow_of[m]}): what may stand where the set s is allowed.
struct FollowSet {
    std::vector<int> maps;  // indices into Rifs::maps, rising, not empty
    bool operator==(const FollowSet&) const = default;
};

struct Rifs {                            // maps and the graph of what may follow what
    std::string name;                    // as the scene calls it
    std::vector<Affine> maps;            // each as the scene composes it
    std::vector<std::string> map_names;  // "1", "2", ... where the scene gives none
    std::vector<FollowSet> follow_sets;  // all different from each other
    std::vector<int> follow_of;          // per map: the follow set of what may stand inside it
    int start = 0;                       // the follow set of the outermost maps
};

/// What messages call a map: `map "stem"`, or `map 3` where the scene gives no name.
[[nodiscard]] std::string spoken_name(const Rifs& rifs, int map);

/// Strongly connected components of the map graph in descent order, each a rising list of map
/// indices, in an order where every edge between components leads from an earlier to a later one.
[[nodiscard]] std::vector<std::vector<int>> strong_components(const Rifs& rifs);

}  // namespace pxm::host
