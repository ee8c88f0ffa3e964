#include "host/scene/parse/resolve_blends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <unordered_map>

#include "host/math/blend.hpp"
#include "host/scene/check/range_check.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t deepest = 64;

bool is_blend(const Command& command) { return std::holds_alternative<BlendCommand>(command.kind); }

/// Names to places, the first of each.
template <class Block>
std::unordered_map<std::string, std::size_t> places_of(const std::vector<Block>& blocks) {
    std::unordered_map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < blocks.size(); ++i) places.emplace(blocks[i].name, i);
    return places;
}

class Resolver {
  public:
    Resolver(Scene& scene, Diagnostics& diagnostics)
        : scene_(scene), diagnostics_(diagnostics), ifs_(places_of(scene.ifs)) {
        for (const IfsBlock& ifs : scene.ifs) maps_.emplace(&ifs, places_of(ifs.maps));
    }

    void resolve(IfsBlock& ifs, MapBlock& map) {
        if (std::ranges::none_of(map.commands, is_blend)) return;
        if (open_.contains(&map))
            return diagnostics_.error(map.position, "the map is a blend of itself");
        if (open_.size() > deepest)
            return diagnostics_.error(
                map.position, fmt::format("blends of blends nested deeper than {}", deepest));
        open_.insert(&map);
        for (Command& command : map.commands) {
            if (!is_blend(command)) continue;
            const BlendCommand blend = std::get<BlendCommand>(command.kind);
            command.kind = MatrixCommand{blended(ifs, blend, command.position)};
        }
        open_.erase(&map);
    }

  private:
    Affine blended(IfsBlock& ifs, const BlendCommand& command, const Position& position) {
        const std::optional<Affine> from = map_of(ifs, command.from), to = map_of(ifs, command.to);
        if (!from || !to) return {};
        const std::variant<Affine, std::string> map = blend(*from, *to, command.share);
        if (const auto* why = std::get_if<std::string>(&map)) {
            diagnostics_.error(position, "blend: " + *why);
            return {};
        }
        return std::get<Affine>(map);
    }

    /// Nothing if it cannot be told, which is reported here or by the scene's check.
    std::optional<Affine> map_of(IfsBlock& own, const BlendEnd& end) {
        IfsBlock* ifs = &own;
        if (!end.ifs.empty()) {
            const auto found = ifs_.find(end.ifs);
            if (found == ifs_.end())
                return missing(end, fmt::format("there is no {}", block_name("ifs", end.ifs)));
            ifs = &scene_.ifs[found->second];
        }
        const auto place = place_of(*ifs, end.map);
        if (!place)
            return missing(end, fmt::format("{} has no such map", block_name("ifs", ifs->name)));
        MapBlock& map = ifs->maps[*place];
        resolve(*ifs, map);
        try {
            return compose(map.commands);
        } catch (const std::domain_error&) {
            return std::nullopt;
        }
    }

    std::optional<Affine> missing(const BlendEnd& end, const std::string& what) {
        diagnostics_.error(end.map.position, "blend: " + what);
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::size_t> place_of(const IfsBlock& ifs,
                                                      const MapReference& reference) const {
        if (const auto* name = std::get_if<std::string>(&reference.map)) {
            const auto& places = maps_.at(&ifs);
            const auto found = places.find(*name);
            return found == places.end() ? std::nullopt : std::optional(found->second);
        }
        const long number = std::get<long>(reference.map);
        if (number < 1 || number > std::ssize(ifs.maps)) return std::nullopt;
        return static_cast<std::size_t>(number - 1);
    }

    Scene& scene_;
    Diagnostics& diagnostics_;
    std::unordered_map<std::string, std::size_t> ifs_;
    std::unordered_map<const IfsBlock*, std::unordered_map<std::string, std::size_t>> maps_;
    std::set<const MapBlock*> open_;  // being resolved: one that is met again is its own blend
};

}  // namespace

void resolve_blends(Scene& scene, Diagnostics& diagnostics) {
    const bool any = std::ranges::any_of(scene.ifs, [](const IfsBlock& ifs) {
        return std::ranges::any_of(ifs.maps, [](const MapBlock& map) {
            return std::ranges::any_of(map.commands, is_blend);
        });
    });
    if (!any) return;
    Resolver resolver(scene, diagnostics);
    for (IfsBlock& ifs : scene.ifs)
        for (MapBlock& map : ifs.maps) resolver.resolve(ifs, map);
}

}  // namespace pxm::host
