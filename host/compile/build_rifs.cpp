#include "host/compile/build_rifs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "host/fractal/system/components.hpp"
#include "host/process/give_up.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

namespace {

/// Turns the references of a block into map indices, and reports those that name no map.
class MapNames {
  public:
    MapNames(const IfsBlock& block, Diagnostics& diagnostics)
        : block_(block), diagnostics_(diagnostics) {
        for (std::size_t i = 0; i < block.maps.size(); ++i) {
            if (!block.maps[i].name.empty()) index_.emplace(block.maps[i].name, i);
        }
    }

    std::optional<int> find(const MapReference& reference) {
        const std::optional<int> found = std::holds_alternative<long>(reference.map)
                                             ? by_number(std::get<long>(reference.map))
                                             : by_name(std::get<std::string>(reference.map));
        if (!found) report(reference);
        return found;
    }

    /// The maps named, rising, each once. Unknown ones are reported and left out.
    std::vector<int> find_all(const std::vector<MapReference>& references) {
        std::vector<int> maps;
        for (const MapReference& reference : references) {
            if (const auto map = find(reference)) maps.push_back(*map);
        }
        std::sort(maps.begin(), maps.end());
        maps.erase(std::unique(maps.begin(), maps.end()), maps.end());
        return maps;
    }

  private:
    [[nodiscard]] std::optional<int> by_number(long number) const {
        if (number < 1 || number > static_cast<long>(block_.maps.size())) return std::nullopt;
        return static_cast<int>(number - 1);
    }

    [[nodiscard]] std::optional<int> by_name(const std::string& name) const {
        const auto found = index_.find(name);
        if (found == index_.end()) return std::nullopt;
        return static_cast<int>(found->second);
    }

    void report(const MapReference& reference) {
        if (const long* number = std::get_if<long>(&reference.map)) {
            diagnostics_.error(reference.position,
                               fmt::format("ifs \"{}\" has no map {} (its maps are 1 to {})",
                                           block_.name, *number, block_.maps.size()));
        } else {
            diagnostics_.error(reference.position,
                               fmt::format("ifs \"{}\" has no map \"{}\"", block_.name,
                                           std::get<std::string>(reference.map)));
        }
    }

    const IfsBlock& block_;
    Diagnostics& diagnostics_;
    std::unordered_map<std::string, std::size_t> index_;
};

/// The follow sets of a system under construction: equal lists of maps become one set.
class FollowSets {
  public:
    explicit FollowSets(std::vector<FollowSet>& sets) : sets_(sets) {}

    int add(std::vector<int> maps) {
        std::vector<int>& same_hash = by_hash_[hash(maps)];
        for (const int set : same_hash) {
            if (sets_[set].maps == maps) return set;
        }
        same_hash.push_back(static_cast<int>(sets_.size()));
        sets_.push_back({std::move(maps)});
        return same_hash.back();
    }

  private:
    static std::uint64_t hash(const std::vector<int>& maps) {
        Digest digest;
        for (const int map : maps) digest.add(static_cast<std::uint64_t>(map));
        return digest.value();
    }

    std::vector<FollowSet>& sets_;
    std::unordered_map<std::uint64_t, std::vector<int>> by_hash_;
};

void add_maps(const IfsBlock& block, Rifs& rifs, Diagnostics& diagnostics) {
    for (const MapBlock& map : block.maps) {
        const std::size_t number = rifs.maps.size() + 1;
        rifs.map_names.push_back(map.name.empty() ? std::to_string(number) : map.name);
        try {
            rifs.maps.push_back(compose(map.commands));
        } catch (const std::domain_error& error) {
            rifs.maps.emplace_back();
            diagnostics.error(map.position,
                              fmt::format("{}: {}", spoken_name(rifs, static_cast<int>(number) - 1),
                                          error.what()));
        }
    }
}

std::vector<int> all_maps(const Rifs& rifs) {
    std::vector<int> maps(rifs.maps.size());
    for (std::size_t i = 0; i < maps.size(); ++i) maps[i] = static_cast<int>(i);
    return maps;
}

/// The followers each rule of a map names, in one list. Rules may be given several times for one
/// map.
struct Followers {
    const MapReference* first_rule = nullptr;  // null: no rule, so all maps may follow
    std::vector<MapReference> references;
};

void add_follow_sets(const IfsBlock& block, MapNames& names, FollowSets& sets, Rifs& rifs,
                     Diagnostics& diagnostics) {
    std::vector<Followers> followers(rifs.maps.size());
    for (const FollowRule& rule : block.follow) {
        const auto map = names.find(rule.map);
        if (!map) continue;
        Followers& of_map = followers[*map];
        if (of_map.first_rule == nullptr) of_map.first_rule = &rule.map;
        of_map.references.insert(of_map.references.end(), rule.followers.begin(),
                                 rule.followers.end());
    }
    int everything = -1;  // the set of all maps, made when the first map needs it
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        give_up_if_asked();
        if (followers[m].first_rule == nullptr) {
            if (everything < 0) everything = sets.add(all_maps(rifs));
            rifs.follow_of.push_back(everything);
            continue;
        }
        if (followers[m].references.empty()) {
            diagnostics.error(followers[m].first_rule->position,
                              fmt::format("no map may follow {} of ifs \"{}\"",
                                          spoken_name(rifs, static_cast<int>(m)), rifs.name));
        }
        rifs.follow_of.push_back(sets.add(names.find_all(followers[m].references)));
    }
}

/// The maps of the components that no edge enters (Sec. 7.2.2).
std::vector<int> source_maps(const Rifs& rifs) {
    const int maps = static_cast<int>(rifs.maps.size());
    const std::vector<int> component = component_numbers(descent_graph(rifs));
    std::vector<char> entered(component.size(), 0);
    for (int m = 0; m < maps; ++m) {
        // A set in another component than its map is entered; so is a map in another than its set.
        const int set = maps + rifs.follow_of[m];
        if (component[m] != component[set]) entered[component[set]] = 1;
    }
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        const int own = component[static_cast<std::size_t>(maps) + s];
        for (const int m : rifs.follow_sets[s].maps) {
            if (component[m] != own) entered[component[m]] = 1;
        }
    }
    std::vector<int> sources;
    for (int m = 0; m < maps; ++m) {
        if (!entered[component[m]]) sources.push_back(m);
    }
    return sources;
}

void warn_of_unreached_maps(const IfsBlock& block, const Rifs& rifs, Diagnostics& diagnostics) {
    std::vector<char> set_reached(rifs.follow_sets.size(), 0);
    std::vector<char> map_reached(rifs.maps.size(), 0);
    std::vector<int> waiting{rifs.start};
    set_reached[rifs.start] = 1;
    while (!waiting.empty()) {
        const int set = waiting.back();
        waiting.pop_back();
        for (const int m : rifs.follow_sets[set].maps) {
            map_reached[m] = 1;
            if (std::exchange(set_reached[rifs.follow_of[m]], char{1})) continue;
            waiting.push_back(rifs.follow_of[m]);
        }
    }
    for (std::size_t m = 0; m < rifs.maps.size(); ++m) {
        if (map_reached[m]) continue;
        diagnostics.warning(block.maps[m].position,
                            fmt::format("{} of ifs \"{}\" is not reached from its start maps",
                                        spoken_name(rifs, static_cast<int>(m)), rifs.name));
    }
}

}  // namespace

Rifs build_rifs(const IfsBlock& block, Diagnostics& diagnostics) {
    Rifs rifs;
    rifs.name = block.name;
    if (block.maps.empty()) {
        diagnostics.error(block.position, fmt::format("ifs \"{}\" has no maps", block.name));
        return rifs;
    }
    MapNames names(block, diagnostics);
    add_maps(block, rifs, diagnostics);
    FollowSets sets(rifs.follow_sets);
    add_follow_sets(block, names, sets, rifs, diagnostics);
    const std::vector<int> start =
        block.start.empty() ? source_maps(rifs) : names.find_all(block.start);
    rifs.start = sets.add(start);
    if (!block.start.empty() && !start.empty()) {
        warn_of_unreached_maps(block, rifs, diagnostics);
    }
    return rifs;
}

}  // namespace pxm::host
