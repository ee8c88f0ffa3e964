// The measured dimension and its error, against systems whose dimension is known.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "host/fractal/dimension/box_counting.hpp"
#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/in_threads.hpp"
#include "tests/support/known_systems.hpp"

namespace pxm::host::known_dimensions {

struct Tried {
    int systems = 0;
    int measured = 0;
    int beyond = 0;      // its error
    double too_low = 0;  // in all
    double errors = 0;   // their sum

    [[nodiscard]] int not_held() const { return systems - measured + beyond; }
};

/// Of each kind; "" is all.
using TriedKinds = std::map<std::string, Tried>;

/// "carpet" of "carpet of 5 by 3, 17": what was drawn has its seed at the end.
inline std::string kind_of(const std::string& name) {
    const std::size_t comma = name.rfind(", ");
    if (comma == std::string::npos || std::isdigit(name.back()) == 0 ||
        name.find_first_not_of("0123456789", comma + 2) != std::string::npos)
        return "figures and products";
    return name.substr(0, std::min(comma, name.find(" of ")));
}

inline BoxCounting boxes_of(const systems::KnownSystem& known) {
    const Rifs rifs = reachable_part(known.rifs);
    return count_boxes(rifs, bound(rifs, prove_contraction(rifs)));
}

/// By as many threads as are granted: what is found does not depend on them.
inline TriedKinds try_kinds(const std::vector<systems::KnownSystem>& list) {
    std::vector<BoxCounting> found(list.size());
    const std::atomic<bool> never = false;
    in_threads(granted_threads().threads, list.size(), never,
               [&](std::size_t i) { found[i] = boxes_of(list[i]); });
    TriedKinds kinds;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string& name = list[i].name;
        for (Tried* tried : {&kinds[""], &kinds[kind_of(name)]}) {
            ++tried->systems;
            if (!found[i].dimension) continue;
            ++tried->measured;
            const double off = *found[i].dimension - list[i].dimension;
            tried->too_low -= off;
            tried->errors += found[i].error;
            tried->beyond += std::abs(off) > found[i].error ? 1 : 0;
        }
        if (!found[i].dimension) {
            std::cout << name << ": " << found[i].method << '\n';
        } else if (std::abs(*found[i].dimension - list[i].dimension) > found[i].error) {
            std::cout << fmt::format("{}: {:.5f} +- {:.5f}, not {:.5f}\n", name,
                                     *found[i].dimension, found[i].error, list[i].dimension);
        }
    }
    return kinds;
}

inline Tried try_all(const std::vector<systems::KnownSystem>& list) { return try_kinds(list)[""]; }

/// Law: the errors of 19 systems of 20 hold the dimension, those without one not counted as held;
/// and on average none is too low or too high.
inline void errors_are_right(const Tried& tried) {
    EXPECT_LE(20 * tried.not_held(), tried.systems) << tried.measured << " measured";
    EXPECT_LT(std::abs(tried.too_low), 0.015 * tried.measured);
}

}  // namespace pxm::host::known_dimensions
