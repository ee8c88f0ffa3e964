#include "host/import/aifs/aifs_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <utility>
#include <vector>

#include "host/error.hpp"
#include "host/import/aifs/aifs_evaluator.hpp"
#include "host/import/aifs/aifs_slices.hpp"
#include "host/import/aifs/aifs_space.hpp"
#include "host/import/entries.hpp"
#include "host/import/imported_scene.hpp"
#include "host/import/plane_map.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

/// A line and a plane lie in z = 0. IFStile's space is right-handed with z up; pxm's is left-handed
/// with y up: y and z change places.
Affine shown_map(const AffineN& map) {
    const std::vector<double>& m = map.linear;
    const std::vector<double>& t = map.offset;
    if (map.dimension() == 1) return plane_map({m[0], 0, 0, m[0], t[0], 0});
    if (map.dimension() == 2) return plane_map({m[0], m[1], m[2], m[3], t[0], t[1]});
    Affine affine;
    affine.linear[0] = {m[0], m[6], m[3]};  // where x goes
    affine.linear[1] = {m[2], m[8], m[5]};  // where y goes: what is z there
    affine.linear[2] = {m[1], m[7], m[4]};
    affine.translation = {t[0], t[2], t[1]};
    return affine;
}

/// Maps and what may stand inside them, from the graph of sets and unions.
class SystemWriter {
  public:
    SystemWriter(const AifsSystem& system, const Position& place)
        : system_(system), place_(place), projection_(system, place) {}

    IfsBlock block() {
        block_.position = place_;
        for (const AifsSystem::Set& set : system_.sets) (void)number_of(set.value, set.name);
        for (std::size_t i = 0; i < nodes_.size(); ++i) write_node(i);  // more are found on the way
        if (nodes_.size() > 1) write_follow();
        return std::move(block_);
    }
    [[nodiscard]] std::size_t dimension() const { return projection_.dimension(); }
    [[nodiscard]] Space space() const { return dimension() == 3 ? Space::solid : Space::plane; }

  private:
    struct Node {
        const AifsNode* node = nullptr;
        std::string name;
        std::vector<std::size_t> maps;  // of the block
    };

    std::size_t number_of(const AifsUnion& node, const std::string& name) {
        const auto [found, added] = numbers_.emplace(node.get(), nodes_.size());
        if (added) nodes_.push_back({node.get(), name, {}});
        return found->second;
    }

    void write_node(std::size_t number) {
        const std::string name = nodes_[number].name;
        int inner = 0;
        for (const AifsEdge& edge : nodes_[number].node->edges) {
            std::size_t inside = 0;
            if (edge.set >= 0) {
                const AifsSystem::Set& set = system_.sets[static_cast<std::size_t>(edge.set)];
                inside = number_of(set.value, set.name);
            } else if (edge.inside) {
                inside = number_of(edge.inside, fmt::format("{}_{}", name, ++inner));
            } else {
                throw AifsMistake{place_, fmt::format("a part of '{}' is a map without a set to "
                                                      "map",
                                                      printable(name))};
            }
            if (block_.maps.size() == maps_an_ifs)
                throw AifsMistake{place_, fmt::format("more than {} maps", maps_an_ifs)};
            nodes_[number].maps.push_back(block_.maps.size());
            inside_.push_back(inside);
            MapBlock map;
            map.position = place_;
            map.commands = {{MatrixCommand{shown_map(projection_(edge.map))}, place_}};
            block_.maps.push_back(std::move(map));
        }
    }

    void write_follow() {
        std::size_t rules = 0;
        for (std::size_t m = 0; m < block_.maps.size(); ++m)
            rules += nodes_[inside_[m]].maps.size();
        if (rules > maps_a_scene)
            throw AifsMistake{place_, fmt::format("a graph of more than {} edges", maps_a_scene)};
        for (const Node& node : nodes_)
            for (std::size_t i = 0; i < node.maps.size(); ++i)
                block_.maps[node.maps[i]].name =
                    scene_name(fmt::format("{}_m{}", node.name, i + 1));
        const auto references = [&](const Node& node) {
            std::vector<MapReference> list;
            for (const std::size_t m : node.maps) list.push_back(reference(m));
            return list;
        };
        for (std::size_t m = 0; m < block_.maps.size(); ++m)
            block_.follow.push_back({reference(m), references(nodes_[inside_[m]])});
        block_.start = references(nodes_.front());
    }

    [[nodiscard]] MapReference reference(std::size_t map) const {
        return {static_cast<long>(map + 1), place_};
    }

    const AifsSystem& system_;
    Position place_;
    AifsProjection projection_;
    std::vector<Node> nodes_;
    std::map<const AifsNode*, std::size_t> numbers_;
    std::vector<std::size_t> inside_;  // per map: the node of what stands inside
    IfsBlock block_;
};

/// $camera of three dimensions: place, target, up, and the angle of view.
void write_camera(const AifsSystem& system, Scene& scene) {
    const std::vector<double>& n = system.camera;
    if (n.size() != 10 || scene.ifs.empty()) return;
    const auto usable = std::ranges::all_of(n, [](double v) { return std::isfinite(v); });
    const glm::dvec3 view(n[3] - n[0], n[4] - n[1], n[5] - n[2]);
    const glm::dvec3 up(n[6], n[7], n[8]);
    const double across = glm::length(glm::cross(view, up));
    if (!usable || !(across > 1e-6 * glm::length(view) * glm::length(up)) || !(n[9] > 0) ||
        !(n[9] < 180))
        return;
    const auto at = [](double v) { return Decimal{v + 0.0, {}}; };
    CameraBlock camera;
    camera.eye = DecimalVec3{at(n[0]), at(n[2]), at(n[1])};
    camera.look = DecimalVec3{at(n[3]), at(n[5]), at(n[4])};
    camera.up = glm::dvec3{n[6] + 0.0, n[8] + 0.0, n[7] + 0.0};
    camera.fov = n[9];
    scene.camera = camera;
}

/// The blocks of a file, and which of them can be asked for by which name.
struct Choices {
    std::vector<AifsBlock> blocks;
    std::vector<AifsEntry> entries;
};

std::vector<std::string> names_of(const std::vector<AifsEntry>& entries) {
    std::vector<std::string> names;
    for (const AifsEntry& entry : entries) names.push_back(entry.name);
    return names;
}

struct Choice {
    std::size_t entry = 0;
    std::optional<std::string> set;
};

/// NAME, #3, or either with the name of a set behind a colon.
Choice choose(const std::vector<AifsEntry>& entries, const std::string& file,
              const std::optional<std::string>& wanted) {
    const std::vector<std::string> names = names_of(entries);
    if (wanted && wanted->find(':') != std::string::npos &&
        std::ranges::find(names, *wanted) == names.end()) {
        const std::size_t colon = wanted->rfind(':');
        const std::string name = wanted->substr(0, colon);
        const std::string set = wanted->substr(colon + 1);
        const std::size_t entry =
            choose_entry(names, file, name.empty() ? std::nullopt : std::optional(name));
        const std::vector<std::string>& sets = entries[entry].sets;
        if (std::ranges::find(sets, set) != sets.end()) return {entry, set};
        std::string list;
        for (const std::string& one : sets) list += (list.empty() ? "" : ", ") + printable(one);
        throw Error(ErrorKind::setting, fmt::format("\"{}\" of {} has no set \"{}\"; it has {}",
                                                    printable(names[entry]), printable_path(file),
                                                    printable(set), printable(list, 500)));
    }
    return {choose_entry(names, file, wanted), std::nullopt};
}

/// The blocks of a long file that may be chosen, and their places among the slices.
struct ListedBlocks {
    std::vector<std::string> names;
    std::vector<std::size_t> places;
};

ListedBlocks listed(const std::vector<AifsSlice>& slices) {
    ListedBlocks blocks;
    for (std::size_t i = 0; i < slices.size(); ++i) {
        const AifsSlice& slice = slices[i];
        if (slice.hidden) continue;
        blocks.names.push_back(!slice.name.empty() ? slice.name
                               : !slice.id.empty() ? slice.id
                                                   : fmt::format("block {}", i + 1));
        blocks.places.push_back(i);
    }
    return blocks;
}

/// Of a long file: the block that was asked for, and those that it needs. Blocks are listed whether
/// or not they define a set. `wanted` becomes what is to be chosen of these.
std::vector<AifsBlock> chosen_family(const SourceFile& source, std::optional<std::string>& wanted,
                                     Diagnostics& diagnostics) {
    const std::vector<AifsSlice> slices = slice_aifs(source.text, diagnostics);
    diagnostics.throw_if_errors({source});
    const auto [names, places] = listed(slices);
    std::optional<std::string> set;
    std::optional<std::string> name = wanted;
    const std::size_t colon = wanted ? wanted->rfind(':') : std::string::npos;
    if (colon != std::string::npos && std::ranges::find(names, *wanted) == names.end()) {
        set = wanted->substr(colon + 1);
        name = wanted->substr(0, colon);
        if (name->empty()) name.reset();
    }
    const std::size_t entry = choose_entry(names, source.name, name);
    std::size_t chosen = places[entry];
    std::vector<AifsBlock> blocks = parse_aifs_family(slices, chosen, diagnostics);
    if (names.size() > 1)
        blocks[chosen].definitions.push_back({"$n", {}, names[entry], blocks[chosen].position});
    wanted = set ? std::optional(":" + *set) : std::nullopt;
    return blocks;
}

bool is_nameless(const AifsBlock& block) { return block.text_of("$n").empty() && block.id.empty(); }

constexpr std::size_t parsed_whole_bytes = std::size_t{4} << 20U;  // longer files block by block

/// What a file may be asked for; of a long one, what was asked for. `wanted` becomes what is to be
/// chosen of these.
Choices choices_of(const SourceFile& source, std::optional<std::string>& wanted) {
    Diagnostics diagnostics;
    Choices choices{source.text.size() > parsed_whole_bytes
                        ? chosen_family(source, wanted, diagnostics)
                        : parse_aifs(source.text, diagnostics),
                    {}};
    diagnostics.throw_if_errors({source});
    choices.entries = aifs_entries(choices.blocks);
    if (choices.entries.size() == 1 && is_nameless(choices.blocks[choices.entries[0].block]))
        choices.entries[0].name = bare_name(source.name);
    return choices;
}

}  // namespace

std::vector<std::string> aifs_names(const SourceFile& source) {
    if (source.text.size() <= parsed_whole_bytes) {
        std::optional<std::string> any;
        return names_of(choices_of(source, any).entries);
    }
    Diagnostics diagnostics;
    const std::vector<AifsSlice> slices = slice_aifs(source.text, diagnostics);
    diagnostics.throw_if_errors({source});
    return listed(slices).names;
}

Imported import_aifs(const SourceFile& source, const std::optional<std::string>& asked) {
    std::optional<std::string> entry = asked;
    const auto [blocks, entries] = choices_of(source, entry);
    const Choice choice = choose(entries, source.name, entry);
    const AifsEntry& chosen = entries[choice.entry];
    const AifsBlock& block = blocks[chosen.block];
    block.diagnostics.throw_if_errors({source});
    try {
        const AifsSystem system = evaluate_aifs(blocks, chosen.block, choice.set);
        SystemWriter writer(system, block.position);
        IfsBlock maps = writer.block();
        Scene scene = imported_scene(std::move(maps), chosen.name, writer.space(), source);
        if (writer.space() == Space::solid) write_camera(system, scene);
        return finished(std::move(scene),
                        fmt::format("{}: set {} of \"{}\" of {} (AIFS, {} of {} dimensions shown)",
                                    scene_name(chosen.name), system.sets.front().name,
                                    printable(chosen.name, 200), file_name(source.name),
                                    writer.dimension(), system.dimension));
    } catch (const AifsMistake& mistake) {
        Diagnostics diagnostics;
        diagnostics.error(mistake.position, mistake.message);
        diagnostics.throw_if_errors({source});
        throw;
    }
}

}  // namespace pxm::host
