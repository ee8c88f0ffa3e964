#include "host/inspect/exact_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/exact/exact_library.hpp"

namespace pxm::host {

namespace {

/// Of the maps of `part`: their places in `rifs`, and so in its block.
std::vector<std::size_t> places(const Rifs& rifs, const Rifs& part) {
    std::vector<std::size_t> places;
    for (const std::string& name : part.map_names)
        places.push_back(static_cast<std::size_t>(std::ranges::find(rifs.map_names, name) -
                                                  rifs.map_names.begin()));
    return places;
}

/// Between the dimension of a projection and the affinity dimension there may be no room.
void add_dimension_of_shadow(IfsFacts& facts) {
    constexpr double rounding = 1e-9;  // of roots of exact equations
    ExactFindings& exact = facts.exact;
    const Affinity& affinity = facts.dimensions.affinity;
    if (exact.hausdorff.value || !exact.shadow.value || !affinity.exact) return;
    if (*exact.shadow.value < affinity.value - rounding) return;
    exact.hausdorff = {exact.shadow.value,
                       "no more than the affinity dimension, and no less than " + exact.shadow.why};
    if (exact.interior.value == false)
        exact.boundary = {exact.hausdorff.value, "without inside, it is its own boundary"};
}

}  // namespace

ExactFindings exact_findings(const IfsBlock& block, const Scene* scene, const Rifs& rifs,
                             const Rifs& part, const std::vector<Bounds>& bounds,
                             const NeighbourLimits& limits) {
    const Scene none;
    try {
        return exact_library().find(
            {scene != nullptr ? *scene : none, block, part, places(rifs, part), bounds}, limits);
    } catch (const Error& error) {
        return nothing_exact(error.what());
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
    if (!open_set.value) {
        // Equal doubles may stand for numbers that are not.
        if (facts.open_set.why.ends_with("are the same map"))
            facts.open_set.why += " in the doubles that pictures are made of";
        return;
    }
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
    Decided<double>& hausdorff = facts.exact.hausdorff;
    Dimensions& dimensions = facts.dimensions;
    add_dimension_of_shadow(facts);
    if (!hausdorff.value || dimensions.exact) return;
    dimensions.exact = hausdorff.value;
    dimensions.upper = std::min(dimensions.upper, *hausdorff.value);
    dimensions.meaning = fmt::format("the Hausdorff and box-counting dimensions are {:.6g}: {}",
                                     *hausdorff.value, hausdorff.why);
}

}  // namespace pxm::host
