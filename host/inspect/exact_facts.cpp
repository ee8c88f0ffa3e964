#include "host/inspect/exact_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "host/inspect/exact_scene.hpp"

namespace pxm::host {

namespace {

/// The maps of `part`, in its order.
exact::WrittenMaps written_part(const Scene& scene, const IfsBlock& block, const Rifs& rifs,
                                const Rifs& part) {
    exact::WrittenMaps all = written_maps(scene, block);
    std::vector<exact::Entries> maps;
    for (const std::string& name : part.map_names) {
        const auto place = std::ranges::find(rifs.map_names, name) - rifs.map_names.begin();
        maps.push_back(all.maps[static_cast<std::size_t>(place)]);
    }
    all.maps = std::move(maps);
    return all;
}

Scene scene_without_text() { return {}; }

}  // namespace

ExactFindings exact_findings(const IfsBlock& block, const Scene* scene, const Rifs& rifs,
                             const Rifs& part, const std::vector<Bounds>& bounds,
                             const NeighbourLimits& limits) {
    const Scene none = scene_without_text();
    try {
        if (!limits.as_written) throw exact::NotExact{"numbers were set from outside"};
        return find_exactly(written_part(scene != nullptr ? *scene : none, block, rifs, part), part,
                            bounds, limits);
    } catch (const exact::NotExact& reason) {
        return nothing_exact(reason.why);
    }
}

bool keep_numbers(const Settings& settings) {
    return std::ranges::all_of(settings, [](const Setting& setting) {
        return setting.key.find('.') != std::string::npos && !setting.key.starts_with("ifs.");
    });
}

void add_exact_facts(const IfsBlock& block, const Scene* scene, const Rifs& part,
                     const std::vector<Bounds>& bounds, const NeighbourLimits& limits,
                     IfsFacts& facts) {
    facts.exact_names = part.map_names;
    facts.exact = exact_findings(block, scene, facts.rifs, part, bounds, limits);
    const Decided<bool>& open_set = facts.exact.open_set;
    if (!open_set.value) return;
    const OpenSetCondition decided =
        *open_set.value ? OpenSetCondition::holds : OpenSetCondition::fails;
    // What was found up to rounding gives way to what is exact.
    const bool by_rounding = facts.open_set.why.find("up to") != std::string::npos;
    if (decided == facts.open_set.condition && !by_rounding) return;
    facts.open_set = {decided, open_set.why};
}

void add_exact_topology(IfsFacts& facts) {
    const Decided<bool>& exact = facts.exact.totally_disconnected;
    if (exact.value && exact.value != facts.disconnected.totally_disconnected)
        facts.disconnected = {exact.value, exact.why};
    Decided<bool>& connected = facts.exact.connected;
    if (!connected.value && facts.disconnected.totally_disconnected.value_or(false) &&
        facts.rifs.maps.size() > 1 && facts.exact.dimensions > 0)
        connected = {false, facts.disconnected.why};
    const Decided<double>& hausdorff = facts.exact.hausdorff;
    Dimensions& dimensions = facts.dimensions;
    if (!hausdorff.value || dimensions.exact) return;
    dimensions.exact = hausdorff.value;
    dimensions.upper = std::min(dimensions.upper, *hausdorff.value);
    dimensions.meaning = fmt::format("the Hausdorff and box-counting dimensions are {:.6g}: {}",
                                     *hausdorff.value, hausdorff.why);
}

}  // namespace pxm::host
