#include "host/studio/exact_point.hpp"

#include <algorithm>
#include <map>

#include "host/compile/build_rifs.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/scene/diagnostics.hpp"

namespace pxm::host {

namespace {

PreciseAffine composed(const Rifs& rifs, const std::vector<int>& word, std::size_t from,
                       std::size_t to) {
    PreciseAffine all = precise(Affine{});
    for (std::size_t i = from; i < to; ++i)
        all = then(precise(rifs.maps[static_cast<std::size_t>(word[i])]), all);
    return all;
}

/// A word that a walk through the graph takes, up to where it comes to a follow set again, and
/// where it was there before: from there on it goes round for ever.
struct Walk {
    std::vector<int> maps;
    std::size_t round = 0;
};
Walk walk_from(const Rifs& rifs, int set) {
    Walk walk;
    std::map<int, std::size_t> seen;
    while (!seen.contains(set)) {
        seen[set] = walk.maps.size();
        const int map = rifs.follow_sets[static_cast<std::size_t>(set)].maps.front();
        walk.maps.push_back(map);
        set = rifs.follow_of[static_cast<std::size_t>(map)];
    }
    walk.round = seen[set];
    return walk;
}

}  // namespace

PreciseVec3 exact_point(const Scene& scene, const ObjectBlock& object,
                        const std::vector<int>& word) {
    Diagnostics diagnostics;
    const Rifs rifs =
        build_rifs(*std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name), diagnostics);
    const int set =
        word.empty() ? rifs.start : rifs.follow_of[static_cast<std::size_t>(word.back())];
    const Walk walk = walk_from(rifs, set);
    // Rounds contract, so that exactly one point stands still in them.
    const PreciseVec3 still = fixed_point(composed(rifs, walk.maps, walk.round, walk.maps.size()));
    const PreciseVec3 inside = image(composed(rifs, walk.maps, 0, walk.round), still);
    const PreciseVec3 in_system = image(composed(rifs, word, 0, word.size()), inside);
    return image(precise(compose(object.commands)), in_system);
}

std::array<std::string, 3> decimal_texts(const PreciseVec3& point) {
    return {text_of(point[0], point_decimals), text_of(point[1], point_decimals),
            text_of(point[2], point_decimals)};
}

}  // namespace pxm::host
