#include "host/math/alias_table.hpp"

#include <algorithm>
#include <numeric>

namespace pxm::host {

AliasTable::AliasTable(std::span<const double> weights) : columns_(weights.size()) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const auto count = static_cast<double>(weights.size());
    std::vector<double> share(weights.size());  // of a column's height
    std::vector<std::uint32_t> low;
    std::vector<std::uint32_t> high;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
        share[i] = weights[i] / sum * count;
        (share[i] < 1 ? low : high).push_back(i);
        columns_[i] = {0xFFFF'FFFF, i};
    }
    while (!low.empty() && !high.empty()) {
        const std::uint32_t small = low.back();
        const std::uint32_t large = high.back();
        low.pop_back();
        columns_[small] = {static_cast<std::uint32_t>(std::min(share[small] * 0x1p32, 0x1p32 - 1)),
                           large};
        share[large] -= 1 - share[small];
        if (share[large] < 1) {
            high.pop_back();
            low.push_back(large);
        }
    }
}

}  // namespace pxm::host
