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

/// Maps one after another through the graph, each the next of those that may come there: all in
/// turn, where all may. From `round` on the walk goes round for ever.
struct Walk {
    std::vector<int> maps;
    std::size_t round = 0;
};
Walk walk_from(const Rifs& rifs, int set, int last) {
    Walk walk;
    std::map<int, std::size_t> seen;  // a map, and where the walk was when it had taken it
    for (;;) {
        const std::vector<int>& maps = rifs.follow_sets[static_cast<std::size_t>(set)].maps;
        const auto next = std::ranges::upper_bound(maps, last);
        last = next == maps.end() ? maps.front() : *next;
        walk.maps.push_back(last);
        const auto [before, is_new] = seen.emplace(last, walk.maps.size());
        if (!is_new) {
            walk.round = before->second;
            return walk;
        }
        set = rifs.follow_of[static_cast<std::size_t>(last)];
    }
}

}  // namespace

PreciseVec3 exact_point(const Scene& scene, const ObjectBlock& object,
                        const std::vector<int>& word) {
    Diagnostics diagnostics;
    const Rifs rifs =
        build_rifs(*std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name), diagnostics);
    const int set =
        word.empty() ? rifs.start : rifs.follow_of[static_cast<std::size_t>(word.back())];
    const Walk walk = walk_from(rifs, set, word.empty() ? -1 : word.back());
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
