#include "host/fractal/neighbours/crystal_group.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "host/fractal/exact/lattice.hpp"

namespace pxm::host {

namespace {

using exact::ExactMap;
using exact::Polynomial;

constexpr std::size_t most_turns = 48;  // of a crystallographic group of three dimensions

/// An element of the group with its inverse, and its linear part.
struct Element {
    ExactMap map;
    ExactMap inverse;
    ExactMap turn;
};

class Group {
  public:
    Group(const exact::ExactSystem& system, const NeighbourGraph& graph) : system_(system) {
        const ExactMap identity = ExactMap::identity(system.field);
        turns_.push_back({identity, identity, identity});
        add_generators(graph);
    }

    /// Whether the turns are finitely many and the translations a lattice.
    bool close() {
        std::vector<exact::Lattice::Vector> translations;
        for (std::size_t k = 0; k < turns_.size(); ++k)
            for (const Element& generator : generators_) {
                const ExactMap map = composed(turns_[k].map, generator.map);
                const ExactMap turn = turn_of(map);
                const Element* same = find(turn);
                if (same == nullptr) {
                    if (turns_.size() >= most_turns) return false;
                    turns_.push_back({map, composed(generator.inverse, turns_[k].inverse), turn});
                } else {
                    add_translation(composed(map, same->inverse), translations);
                }
            }
        lattice_ = exact::Lattice::generated(system_, translations);
        return lattice_.has_value();
    }

    [[nodiscard]] bool contains(const ExactMap& map) const {
        const Element* same = find(turn_of(map));
        return same != nullptr && lattice_->contains(translation_of(composed(map, same->inverse)));
    }

    [[nodiscard]] double cell() const {
        return lattice_->cell() / static_cast<double>(turns_.size());
    }

  private:
    /// Both orders of two neighbours are types, so that the inverses are there too.
    void add_generators(const NeighbourGraph& graph) {
        std::vector<const ExactMap*> maps;
        for (const NeighbourType& type : graph.types)
            if (type.touches && !type.identity) maps.push_back(&type.map);
        for (std::size_t i = 0; i < maps.size(); ++i)
            for (std::size_t j = i; j < maps.size(); ++j)
                if (composed(*maps[i], *maps[j]) == turns_[0].map)
                    generators_.push_back({*maps[i], *maps[j], turn_of(*maps[i])});
    }

    [[nodiscard]] ExactMap composed(const ExactMap& outer, const ExactMap& inner) const {
        return ExactMap::composed(system_.field, outer, inner);
    }

    [[nodiscard]] ExactMap turn_of(const ExactMap& map) const {
        const int n = system_.field.dimensions;
        std::vector<Polynomial> entries;
        for (int r = 0; r < n; ++r)
            for (int c = 0; c <= n; ++c)
                entries.push_back(c < n ? map.entry(system_.field, r, c) : Polynomial());
        return {system_.field, entries};
    }

    [[nodiscard]] exact::Lattice::Vector translation_of(const ExactMap& map) const {
        const int n = system_.field.dimensions;
        exact::Lattice::Vector v;
        for (int r = 0; r < n; ++r) v.push_back(map.entry(system_.field, r, n));
        return v;
    }

    void add_translation(const ExactMap& map,
                         std::vector<exact::Lattice::Vector>& translations) const {
        exact::Lattice::Vector v = translation_of(map);
        if (std::ranges::all_of(v, &Polynomial::is_zero)) return;
        if (std::ranges::find(translations, v) == translations.end())
            translations.push_back(std::move(v));
    }

    [[nodiscard]] const Element* find(const ExactMap& turn) const {
        const auto found = std::ranges::find(turns_, turn, &Element::turn);
        return found == turns_.end() ? nullptr : &*found;
    }

    const exact::ExactSystem& system_;
    std::vector<Element> generators_;
    std::vector<Element> turns_;  // one of each
    std::optional<exact::Lattice> lattice_;
};

/// All maps shrink volumes alike, so that cells of a level are divided at once.
bool one_size(const exact::ExactSystem& system, const NeighbourGraph& graph) {
    const auto same = [&](const Polynomial& p) {
        return p == system.volume_ratio[0] || p == Polynomial(0) - system.volume_ratio[0];
    };
    const auto both = [](const NeighbourType& type) {
        return std::ranges::all_of(
            type.edges, [](const NeighbourEdge& e) { return e.first >= 0 && e.second >= 0; });
    };
    return std::ranges::all_of(system.volume_ratio, same) && std::ranges::all_of(graph.types, both);
}

}  // namespace

Decided<double> crystal_cell(const exact::ExactSystem& system, const NeighbourGraph& graph) {
    constexpr std::size_t most_types = 200;  // every two of them are composed
    if (graph.types.size() > most_types) return {std::nullopt, "too many neighbours"};
    if (!one_size(system, graph)) return {std::nullopt, "cells are of different sizes"};
    Group group(system, graph);
    if (!group.close())
        return {std::nullopt, "the neighbours' maps make no crystallographic group"};
    for (std::size_t i = 0; i < system.maps.size(); ++i)
        for (std::size_t j = 0; j < system.maps.size(); ++j)
            if (i != j && group.contains(
                              ExactMap::composed(system.field, system.maps[j], system.inverses[i])))
                return {std::nullopt,
                        "the maps are no representatives of different classes of the neighbours' "
                        "group"};
    return {group.cell(),
            "a fundamental domain of the group that the neighbours' maps generate [Gelbrich94]"};
}

}  // namespace pxm::host
