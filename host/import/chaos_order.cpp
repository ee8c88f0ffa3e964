#include "host/import/chaos_order.hpp"

#include <algorithm>
#include <map>

namespace pxm::host {

std::vector<std::size_t> lasting_maps(const std::vector<std::size_t>& maps,
                                      const MayComeAfter& after) {
    std::map<std::size_t, std::size_t> inside;  // per map: how many may stand inside it
    std::vector<std::size_t> ended;
    for (const std::size_t next : maps) {
        inside[next] = static_cast<std::size_t>(
            std::ranges::count_if(maps, [&](std::size_t before) { return after(before, next); }));
        if (inside[next] == 0) ended.push_back(next);
    }
    for (std::size_t k = 0; k < ended.size(); ++k)
        for (const std::size_t next : maps)
            if (after(ended[k], next) && --inside[next] == 0) ended.push_back(next);
    std::vector<std::size_t> lasting;
    for (const std::size_t map : maps)
        if (inside[map] > 0) lasting.push_back(map);
    return lasting;
}

}  // namespace pxm::host
