// Systems of whole numbers: x -> (M x + d) / base, where M permutes and reflects the axes and d is
// a vector of whole numbers. What their words are is counted in integers, by nothing of the
// library.
#pragma once

#include <array>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {

/// Row r of M has `sign[r]` in column `column[r]`.
struct WholeMap {
    std::array<int, 3> column{0, 1, 2};
    std::array<long, 3> sign{1, 1, 1};
    std::array<long, 3> offset{};
    auto operator<=>(const WholeMap&) const = default;
};

struct WholeTurningSystem {
    int dimensions = 2;
    long base = 2;
    std::vector<WholeMap> maps;

    [[nodiscard]] std::string text() const {
        std::vector<std::string> lines;
        const std::string by = "/" + std::to_string(base);
        for (const WholeMap& map : maps) {
            std::string line = "matrix: ";
            for (int from = 0; from < 3; ++from)  // the scene's rows are what a coordinate goes to
                for (std::size_t to = 0; to < 3; ++to)
                    line += (map.column[to] == from ? std::to_string(map.sign[to]) + by : "0") +
                            (from == 2 && to == 2 ? ", " : ",");
            for (std::size_t i = 0; i < 3; ++i)
                line += std::to_string(map.offset[i]) + by + (i < 2 ? "," : "");
            lines.push_back(line);
        }
        return system_of(lines);
    }

    /// A word's map: base^length times its offset, which stays whole.
    [[nodiscard]] WholeMap word(const std::vector<int>& word) const {
        WholeMap result;
        for (const int m : word) result = longer(result, maps[static_cast<std::size_t>(m)]);
        return result;
    }

    /// `outer` with `inner` inside of it.
    [[nodiscard]] WholeMap longer(const WholeMap& outer, const WholeMap& inner) const {
        WholeMap result;
        for (std::size_t r = 0; r < 3; ++r) {
            const auto c = static_cast<std::size_t>(outer.column[r]);
            result.column[r] = inner.column[c];
            result.sign[r] = outer.sign[r] * inner.sign[c];
            result.offset[r] = base * outer.offset[r] + outer.sign[r] * inner.offset[c];
        }
        return result;
    }

    /// All words of that length; equal maps are there once.
    [[nodiscard]] std::set<WholeMap> level(int length) const {
        std::set<WholeMap> words{WholeMap{}};
        for (int i = 0; i < length; ++i) {
            std::set<WholeMap> next;
            for (const WholeMap& word : words)
                for (const WholeMap& map : maps) next.insert(longer(word, map));
            words = next;
        }
        return words;
    }
};

/// Different maps of one base, drawn at random.
inline WholeTurningSystem random_whole_system(std::mt19937& random) {
    const auto draw = [&](long low, long high) {
        return std::uniform_int_distribution<long>(low, high)(random);
    };
    WholeTurningSystem system;
    system.dimensions = draw(0, 3) == 0 ? 3 : 2;
    system.base = draw(2, 3);
    const auto n = static_cast<std::size_t>(system.dimensions);
    const auto count = static_cast<std::size_t>(draw(3, system.dimensions == 3 ? 8 : 5));
    const bool turns = draw(0, 2) > 0;
    std::set<WholeMap> maps;
    while (maps.size() < count) {
        WholeMap map;
        for (std::size_t i = 0; i < n; ++i) {
            map.offset[i] = draw(0, 3);
            if (turns && draw(0, 3) == 0) map.sign[i] = -1;
        }
        if (turns && draw(0, 1) == 0) std::swap(map.column[0], map.column[1]);
        maps.insert(map);
    }
    system.maps.assign(maps.begin(), maps.end());
    return system;
}

}  // namespace pxm::test
