// The cells of an attractor, one after another: images of a shape under words of maps, as long as
// asked for. Nothing is kept but the word, so that any number of cells takes no memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/export/mesh.hpp"
#include "host/math/affine.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

struct SystemMap {
    Affine map;
    glm::dvec4 color{0.0};
    int inside = 0;  // the set of what may stand inside it
    double stretch = 1;
};

/// What may stand where a word has come to: the maps that go on from there, and the shape that
/// stands there if it goes no further.
struct SystemSet {
    std::vector<int> maps;
    CompiledVolume volume;
    Mesh shape;  // the volume's surface, or the user's mesh
};

/// An object to export, in the axes of the format.
struct ExportSystem {
    std::string name;
    std::vector<SystemMap> maps;
    std::vector<SystemSet> sets;
    int start = 0;
    Affine place;  // into the world
    glm::dvec3 color{0.9};
    bool similar = true;       // stretches of words are products of the maps'
    bool colored = false;      // maps have colours
    std::uint32_t levels = 0;  // a word ends after so many maps
    double detail = 0;         // or where what stands there is as small
};

struct Cell {
    Affine place;  // of the shape in the world
    glm::dvec3 color{0.9};
    int set = 0;
    double stretch = 1;
};

/// How far one may go down: a word of so many maps that do not contract one by one.
inline constexpr std::size_t longest_word = 100'000;

/// Calls `visit(cell)` for each cell, in the order of the words. False if a word got too long.
template <class Visit>
bool for_each_cell(const ExportSystem& system, const Visit& visit) {
    struct Open {
        Cell cell;
        std::size_t next = 0;  // of the set's maps
    };
    const auto ends = [&](const Cell& cell, std::size_t length) {
        const SystemSet& set = system.sets[static_cast<std::size_t>(cell.set)];
        if (length >= system.levels || set.maps.empty()) return true;
        if (system.detail <= 0) return false;
        const double stretch = system.similar ? cell.stretch : lipschitz_constant(cell.place);
        return stretch * set.volume.diameter <= system.detail;
    };
    const Cell first{system.place, system.color, system.start, lipschitz_constant(system.place)};
    if (ends(first, 0)) {
        visit(first);
        return true;
    }
    std::vector<Open> word{{first, 0}};
    while (!word.empty()) {
        Open& open = word.back();
        const std::vector<int>& maps = system.sets[static_cast<std::size_t>(open.cell.set)].maps;
        if (open.next == maps.size()) {
            word.pop_back();
            continue;
        }
        const SystemMap& map = system.maps[static_cast<std::size_t>(maps[open.next++])];
        Cell cell{then(map.map, open.cell.place), open.cell.color, map.inside,
                  open.cell.stretch * map.stretch};
        if (system.colored)
            cell.color = cell.color * (1 - map.color.a) + glm::dvec3{map.color} * map.color.a;
        if (ends(cell, word.size())) {
            visit(cell);
        } else if (word.size() == longest_word) {
            return false;
        } else {
            word.push_back({cell, 0});
        }
    }
    return true;
}

}  // namespace pxm::host
