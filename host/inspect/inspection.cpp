#include "host/inspect/inspection.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/compile/proven_rifs.hpp"
#include "host/compile/short_by.hpp"
#include "host/compile/volumes.hpp"
#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/bounds/inner_points.hpp"
#include "host/fractal/dimension/default_weights.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/inspect/exact_facts.hpp"
#include "host/process/granted_threads.hpp"
#include "host/scene/default_objects.hpp"

namespace pxm::host {

namespace {

constexpr int longest_word = 4;  // of the comparison of the Lipschitz methods

std::optional<glm::dvec3> single_fixed_point(const Affine& map) {
    constexpr double residue = 1e-9;
    const glm::dvec3 point = fixed_point(map);
    const double size = 1 + glm::length(point) + glm::length(map.translation);
    if (!(glm::distance(map.point(point), point) <= residue * size)) return std::nullopt;
    // Where directions stand still too, points near it do as well.
    const glm::dmat3 rest = glm::dmat3{1.0} - map.linear;
    if (singular_values(rest).values[2] <= residue) return std::nullopt;
    return point;
}

MapFacts facts_of(const Affine& map) {
    MapFacts facts;
    facts.kind = classify(map);
    facts.determinant = determinant(map);
    facts.singular_values = singular_values(map.linear).values;
    facts.lipschitz = facts.singular_values[0];
    facts.determinant_bound = determinant_constant(map);
    facts.fixed_point = single_fixed_point(map);
    return facts;
}

/// The bounds of the reachable part's follow sets, from those of the whole.
std::vector<Bounds> bounds_of_part(const Rifs& whole, const std::vector<Bounds>& bounds,
                                   const Rifs& part) {
    if (part.follow_sets.size() == whole.follow_sets.size()) return bounds;
    return bound(part, prove_contraction(part));
}

const char* volume_name(const std::optional<DeclaredVolume>& volume) {
    constexpr std::array names{"auto", "sphere", "box", "cone", "cylinder", "hull"};
    return names[volume ? volume->index() : 0];
}

const char* volume_name(kernels::Volume kind) {
    constexpr std::array names{"sphere", "box", "oriented", "hull", "cone", "cylinder"};
    return names[static_cast<std::size_t>(kind)];
}

ObjectFacts inspect_object(const ObjectBlock& object, const Scene& scene,
                           const std::vector<IfsFacts>& systems) {
    ObjectFacts facts;
    facts.name = object.name;
    facts.ifs = object.ifs;
    if (object.volume && !std::holds_alternative<AutoVolume>(*object.volume)) {
        facts.declared = object.volume;
    }
    if (!object.ifs) {
        facts.volume = volume_name(object.volume);
        return facts;
    }
    const auto system =
        std::ranges::find(systems, *object.ifs, [](const IfsFacts& s) { return s.rifs.name; });
    const VolumeKind kind =
        scene.render.value_or(RenderBlock{}).volume.value_or(VolumeKind::automatic);
    Diagnostics repeated;  // the warnings are those of the compiler
    const auto volumes = choose_volumes(object, kind, system->rifs, system->bounds, repeated);
    facts.volume = volume_name(volumes[system->rifs.start].kind);
    if (facts.declared) {
        facts.short_by = std::max(
            0.0, short_by(system->rifs, system->bounds, system->rifs.start, *facts.declared));
    }
    facts.ball_slack = system->bounds[system->rifs.start].ball_slack;
    return facts;
}

/// Of the maps of `part`: the scene's, or what spreads the measure evenly.
std::vector<double> weights_of(const IfsBlock& block, const Rifs& rifs, const Rifs& part) {
    std::vector<double> weights = natural_weights(part);
    for (std::size_t m = 0; m < weights.size(); ++m) {
        const auto place = std::ranges::find(rifs.map_names, part.map_names[m]);
        const MapBlock& map = block.maps[static_cast<std::size_t>(place - rifs.map_names.begin())];
        if (map.weight) weights[m] = *map.weight;
    }
    return weights;
}

}  // namespace

std::optional<IfsFacts> inspect_ifs(const IfsBlock& block, Diagnostics& diagnostics,
                                    const Scene* scene, const NeighbourLimits& limits) {
    auto proven = prove_rifs(block, diagnostics);
    if (!proven) return std::nullopt;
    IfsFacts facts;
    facts.rifs = std::move(proven->rifs);
    facts.contraction = proven->contraction;
    for (const Affine& map : facts.rifs.maps) facts.maps.push_back(facts_of(map));
    facts.graph = graph_facts(facts.rifs);
    const Rifs part = reachable_part(facts.rifs);
    facts.words = word_lipschitz(part, longest_word);
    for (WordLipschitz& word : facts.words) {
        // Names are unique in a system, so they lead back to its own numbers.
        for (std::vector<int>* maps : {&word.product_word, &word.determinant_word}) {
            for (int& m : *maps) {
                m = static_cast<int>(std::ranges::find(facts.rifs.map_names, part.map_names[m]) -
                                     facts.rifs.map_names.begin());
            }
        }
    }
    facts.bounds = bound(facts.rifs, facts.contraction);
    const std::vector<Bounds> bounds = bounds_of_part(facts.rifs, facts.bounds, part);
    const std::vector<AffineHull> hulls = affine_hulls(part);
    facts.subspace = hulls[static_cast<std::size_t>(part.start)];
    const Rifs plain = as_similitudes(part, hulls);
    const bool as_given = plain.maps == part.maps;
    facts.open_set =
        decide_open_set(plain, bounds, as_given ? MapNumbers::given : MapNumbers::computed);
    add_exact_facts(block, scene, part, bounds, limits, facts);
    facts.dimensions = dimensions(plain, facts.open_set.condition);
    facts.dimensions.box_counting = count_boxes(plain, bounds, granted_threads().threads);
    facts.disconnected = decide_disconnected(plain, bounds, facts.dimensions.upper);
    add_exact_topology(facts);
    add_topology(facts.dimensions, facts.disconnected.totally_disconnected);
    facts.moments = moments(part, weights_of(block, facts.rifs, part));
    facts.diameter = diameter(part, bounds, inner_points(part));
    return facts;
}

Inspection inspect(const Scene& scene, const std::string& path, Diagnostics& diagnostics,
                   const NeighbourLimits& limits) {
    Inspection inspection;
    inspection.scene = path;
    Diagnostics found;
    for (const IfsBlock& block : scene.ifs) {
        if (auto facts = inspect_ifs(block, found, &scene, limits))
            inspection.ifs.push_back(std::move(*facts));
    }
    if (found.has_errors()) {
        diagnostics.append(found);
        return inspection;
    }
    inspection.needs = node_needs(scene, diagnostics);  // finds the same warnings, and more
    for (const ObjectBlock& object : objects_of(scene)) {
        inspection.objects.push_back(inspect_object(object, scene, inspection.ifs));
    }
    return inspection;
}

}  // namespace pxm::host
