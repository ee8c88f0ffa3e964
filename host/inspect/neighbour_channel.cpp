#include "host/inspect/neighbour_channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "host/compile/proven_rifs.hpp"
#include "host/error.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/inspect/exact_facts.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_states = 65'535;  // a picture's numbers of them

/// The follow set of a cell, and the types that it is the first of, rising, without those of cells
/// that coincide with it.
struct Neighbourhood {
    int set = 0;
    std::vector<int> types;
    auto operator<=>(const Neighbourhood&) const = default;
};

/// Neighbourhoods that follow from one another by the maps, from the whole on, which has none.
class Walk {
  public:
    Walk(const ExactFindings& found, const Rifs& part, const CompiledShape& shape)
        : found_(found), part_(part), shape_(shape) {}

    /// Nothing if they are too many.
    std::shared_ptr<const NeighbourWalk> run() {
        std::vector<std::size_t> number;  // of the part's maps, in the shape
        for (const std::string& name : part_.map_names)
            number.push_back(static_cast<std::size_t>(std::ranges::find(shape_.map_names, name) -
                                                      shape_.map_names.begin()));
        auto walk = std::make_shared<NeighbourWalk>();
        number_of({part_.start, {}});
        for (std::size_t k = 0; k < all_.size(); ++k) {
            if (all_.size() > most_states) return nullptr;
            auto& next = walk->next.emplace_back(shape_.map_names.size(), -1);
            for (auto& [map, state] : smaller(*all_[k]))
                next[number[static_cast<std::size_t>(map)]] = number_of(std::move(state));
        }
        return walk;
    }

  private:
    std::int32_t number_of(Neighbourhood one) {
        const auto [place, added] =
            numbers_.emplace(std::move(one), static_cast<std::int32_t>(numbers_.size()));
        if (added) all_.push_back(&place->first);
        return place->second;
    }

    [[nodiscard]] bool is_other(int type) const {
        return !found_.graph[static_cast<std::size_t>(type)].identity;
    }

    /// Of the cells that its maps make. Edges that leave a cell whole are followed until one
    /// divides it.
    [[nodiscard]] std::map<int, Neighbourhood> smaller(const Neighbourhood& whole) const {
        std::map<int, Neighbourhood> after;
        const auto set = static_cast<std::size_t>(whole.set);
        for (const int m : part_.follow_sets[set].maps)
            after[m].set = part_.follow_of[static_cast<std::size_t>(m)];
        for (const auto& [first, second, type] : found_.own[set])
            if (is_other(type)) after[first].types.push_back(type);
        std::vector<int> waiting = whole.types;
        while (!waiting.empty()) {
            const auto t = static_cast<std::size_t>(waiting.back());
            waiting.pop_back();
            for (const auto& [first, second, type] : found_.graph[t].edges) {
                if (!is_other(type)) continue;
                if (first < 0) {
                    waiting.push_back(type);
                } else {
                    after[first].types.push_back(type);
                }
            }
        }
        for (auto& [map, one] : after) {
            std::ranges::sort(one.types);
            one.types.erase(std::unique(one.types.begin(), one.types.end()), one.types.end());
        }
        return after;
    }

    const ExactFindings& found_;
    const Rifs& part_;
    const CompiledShape& shape_;
    std::map<Neighbourhood, std::int32_t> numbers_;
    std::vector<const Neighbourhood*> all_;
};

[[noreturn]] void refuse(const std::string& ifs, const std::string& why) {
    throw Error(ErrorKind::setting,
                fmt::format("--aov neighbours: ifs {}: {}", printable(ifs), why));
}

}  // namespace

NeighbourWalks neighbour_walks(const Scene& scene, bool as_written, const CompiledScene& compiled) {
    NeighbourLimits limits;
    limits.as_written = as_written;
    NeighbourWalks walks;
    for (const CompiledShape& shape : compiled.shapes) {
        walks.emplace_back();
        if (shape.ifs.empty()) continue;
        const auto block = std::ranges::find(scene.ifs, shape.ifs, &IfsBlock::name);
        Diagnostics diagnostics;
        const auto proven = prove_rifs(*block, diagnostics);
        diagnostics.throw_if_errors(scene.files);
        const Rifs part = reachable_part(proven->rifs);
        const auto bounds = bound(part, prove_contraction(part));
        const ExactFindings found =
            exact_findings(*block, &scene, proven->rifs, part, bounds, limits);
        if (!found.finite.value.value_or(false)) refuse(shape.ifs, found.finite.why);
        walks.back() = Walk(found, part, shape).run();
        if (!walks.back())
            refuse(shape.ifs,
                   fmt::format("its cells have more than {} sets of neighbours", most_states));
    }
    return walks;
}

}  // namespace pxm::host
