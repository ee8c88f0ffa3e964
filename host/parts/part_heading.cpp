#include "host/parts/part_heading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <variant>

#include "host/scene/print/print.hpp"
#include "host/text/digest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr const char* of_scene = "scene";  // the names of digests, whose values say nothing
constexpr const char* of_words = "compiled scene";
constexpr const char* of_costs = "cost model";

std::string hexadecimal(std::uint64_t digest) { return fmt::format("{:016x}", digest); }

/// A texture's picture counts, not where it lies: its words are hashed instead of its path.
Scene without_paths(Scene scene) {
    for (TextureBlock& texture : scene.textures)
        if (texture.source && std::holds_alternative<FileTexture>(*texture.source))
            texture.source = FileTexture{};
    return scene;
}

/// The text of all that is to be seen, however it is spread over files, and its pictures.
std::string scene_digest(const Prepared& prepared) {
    Scene scene = without_paths(prepared.scene);
    scene.image.reset();
    scene.render.reset();
    const std::vector<std::uint32_t>& textures = prepared.compiled.texture_words;
    const std::string_view bytes(reinterpret_cast<const char*>(textures.data()),
                                 textures.size() * sizeof(std::uint32_t));
    return fmt::format("{:016x}{:016x}", digest_of(print_scene(scene)), digest_of(bytes));
}

/// The directives of the image and render blocks, each for itself, so that a difference has a name.
void add_directives(const Scene& of, std::vector<CommonThing>& common) {
    Scene scene;
    scene.image = of.image;
    scene.render = of.render;
    std::istringstream lines(print_scene(scene));
    for (std::string line; std::getline(lines, line);) {
        const auto begin = line.find_first_not_of(' ');
        const auto colon = line.find(": ");
        if (begin == std::string::npos || colon == std::string::npos) continue;
        common.push_back({line.substr(begin, colon - begin), line.substr(colon + 2)});
    }
}

std::string costs_digest(const CostTable& table) {
    std::string text = fmt::format("{} {}", table.plain_share, table.compiled_code_factor);
    for (const OperationCost& cost : table.operations)
        text += fmt::format(" {} {}", cost.tight, cost.plain);
    return hexadecimal(digest_of(text));
}

std::string channels_text(const std::vector<Aov>& channels) {
    std::vector<std::string_view> names;
    for (const Aov aov : channels) names.emplace_back(aov_name(aov));
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ","));
}

const std::string* value_in(const PartHeading& heading, const std::string& name) {
    const auto found = std::ranges::find(heading.common, name, &CommonThing::name);
    return found == heading.common.end() ? nullptr : &found->value;
}

std::string told(const std::string* value) {
    return value == nullptr ? "as the scene has it" : printable(*value);
}

}  // namespace

PartHeading heading_of(const StartedRender& started, const RenderRequest& request,
                       const std::vector<Aov>& channels, const Metadata& metadata) {
    const CompiledScene& compiled = started.prepared.compiled;
    PartHeading heading;
    heading.grid = started.loaded->grid(compiled.crop);
    heading.channels = channels;
    heading.alarms = started.alarms;
    heading.cell_cap = compiled.cell_cap;
    heading.statistics = started.result.statistics;
    heading.statistics.machine = started.loaded->machine();
    heading.metadata = metadata;
    const Statistics& statistics = heading.statistics;
    std::vector<CommonThing>& common = heading.common;
    common = {{"version", PXM_VERSION},
              {of_scene, scene_digest(started.prepared)},
              {"engine", statistics.model.empty() ? "native" : statistics.model},
              {"channels", channels_text(channels)},
              {"zoom", fmt::format("{}", request.overrides.zoom)}};
    add_directives(started.prepared.scene, common);
    common.push_back({"numbers", statistics.numeric});
    common.push_back({"method", statistics.intersect});
    common.push_back({"cap of cells", fmt::format("{}", compiled.cell_cap)});
    if (request.machine) common.push_back({of_costs, costs_digest(request.costs.table)});
    if (request.code == NodeCode::assembled) common.push_back({"program of the nodes", "asm"});
    common.push_back({of_words, hexadecimal(statistics.scene_block_hash)});
    return heading;
}

std::string why_apart(const PartHeading& one, const PartHeading& other) {
    for (const PartHeading* side : {&one, &other}) {
        for (const CommonThing& thing : side->common) {
            const std::string* a = value_in(one, thing.name);
            const std::string* b = value_in(other, thing.name);
            if (thing.name == of_words || (a != nullptr && b != nullptr && *a == *b)) continue;
            if (thing.name == of_scene || thing.name == of_costs)
                return fmt::format("its {} is another one", thing.name);
            return fmt::format("its {}: {}, not {}", printable(thing.name), told(a), told(b));
        }
    }
    // Last, as this differs with most others; but also alone, where the mathematics of two
    // computers rounds differently.
    const std::string *a = value_in(one, of_words), *b = value_in(other, of_words);
    if (a == nullptr || b == nullptr || *a != *b) return "it was compiled to other numbers";
    const bool same = one.grid == other.grid && one.alarms == other.alarms;
    return same ? "" : "it is cut otherwise";
}

}  // namespace pxm::host
