#include "host/text/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace pxm::host {

namespace {

/// Insertions, deletions, replacements and exchanges of neighbours that turn `a` into `b`.
int edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                cost[i][j] = static_cast<int>(i + j);
                continue;
            }
            const int replaced = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
        }
    }
    return cost[a.size()][b.size()];
}

}  // namespace

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
    constexpr std::size_t longest = 32;  // no word that is known is near a longer one
    constexpr int far = 3;
    if (word.size() > longest) return {};
    std::string_view found;
    int least = far;
    for (const std::string_view candidate : candidates) {
        const int distance = edit_distance(word, candidate);
        // A short word shares too little with what is two edits away.
        const bool near = distance <= 1 ? word.size() > 1 : word.size() > 4;
        if (!near || distance >= least) continue;
        least = distance;
        found = candidate;
    }
    return found;
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& candidates) {
    const std::string_view found = nearest(word, candidates);
    return found.empty() ? "" : fmt::format(" (did you mean '{}'?)", found);
}

}  // namespace pxm::host
