#include "host/inspect/attractor_point.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/compile/build_rifs.hpp"
#include "host/error.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/math/lipschitz.hpp"
#include "host/math/precise.hpp"
#include "host/scene/default_objects.hpp"
#include "host/text/number_text.hpp"

namespace pxm::host {

namespace {

constexpr int decimals = 60;

[[noreturn]] void refuse(const std::string& why) {
    throw Error(ErrorKind::setting, fmt::format("--point: {}", why));
}

/// The index of a map that is called by its name or by its number from 1.
int map_called(const Rifs& rifs, const std::string& name) {
    const auto found = std::ranges::find(rifs.map_names, name);
    if (found != rifs.map_names.end()) return static_cast<int>(found - rifs.map_names.begin());
    const auto number = number_of_text<std::size_t>(name);
    if (number && *number >= 1 && *number <= rifs.maps.size()) return static_cast<int>(*number - 1);
    refuse(fmt::format("ifs \"{}\" has no map \"{}\"", rifs.name, name));
}

void require_allowed(const Rifs& rifs, int set, int map, const char* where) {
    const std::vector<int>& maps = rifs.follow_sets[static_cast<std::size_t>(set)].maps;
    if (std::ranges::find(maps, map) != maps.end()) return;
    refuse(fmt::format("{} may not come {}", spoken_name(rifs, map), where));
}

PreciseAffine composed(const Rifs& rifs, const std::vector<std::string>& word) {
    PreciseAffine all = precise(Affine{});
    int set = rifs.start;
    int first = -1;
    for (const std::string& name : word) {
        const int map = map_called(rifs, name);
        require_allowed(rifs, set, map, first < 0 ? "first" : "there");
        if (first < 0) first = map;
        set = rifs.follow_of[static_cast<std::size_t>(map)];
        all = then(precise(rifs.maps[static_cast<std::size_t>(map)]), all);
    }
    require_allowed(rifs, set, first, "after the last one");
    return all;
}

}  // namespace

std::string attractor_point(const Scene& scene, const std::vector<std::string>& word) {
    const std::vector<ObjectBlock> objects = objects_of(scene);
    const auto object =
        std::ranges::find_if(objects, [](const auto& o) { return o.ifs.has_value(); });
    if (object == objects.end()) refuse("no object of the scene has an ifs");
    Diagnostics diagnostics;
    const auto block = std::ranges::find(scene.ifs, *object->ifs, &IfsBlock::name);
    const Rifs rifs = build_rifs(*block, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    const PreciseAffine map = composed(rifs, word);
    if (!(lipschitz_constant({rounded_linear(map), glm::dvec3{0}}) < 1)) {
        refuse("the maps together do not contract: repeat them, or choose others");
    }
    const PreciseVec3 at = image(precise(compose(object->commands)), fixed_point(map));
    return fmt::format("{},{},{}", text_of(at[0], decimals), text_of(at[1], decimals),
                       text_of(at[2], decimals));
}

}  // namespace pxm::host
