// From the text of a scene to what exact numbers decide, or intervals, without measuring anything
// else.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "host/compile/proven_rifs.hpp"
#include "host/flint/exact_scene.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/neighbours/interval_findings.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::test {

/// What is asked about: the first system of a text, all of whose maps are reached.
struct AskedSystem {
    host::Scene scene;
    host::Rifs rifs;
    std::vector<host::Bounds> bounds;
};

inline std::optional<AskedSystem> asked_system(const std::string& text) {
    host::Diagnostics diagnostics;
    AskedSystem asked{host::parse_text("test.pxm", text, diagnostics), {}, {}};
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(asked.scene.files);
    if (diagnostics.has_errors()) return std::nullopt;
    const auto proven = host::prove_rifs(asked.scene.ifs.front(), diagnostics);
    EXPECT_TRUE(proven) << diagnostics.text(asked.scene.files);
    if (!proven) return std::nullopt;
    asked.rifs = host::reachable_part(proven->rifs);
    EXPECT_EQ(asked.rifs.map_names, proven->rifs.map_names);
    asked.bounds = host::bound(asked.rifs, host::prove_contraction(asked.rifs));
    return asked;
}

inline host::ExactFindings exact_of(const std::string& text,
                                    const host::NeighbourLimits& limits = {}) {
    const auto asked = asked_system(text);
    if (!asked) return {};
    try {
        return host::find_exactly(host::written_maps(asked->scene, asked->scene.ifs.front()),
                                  asked->rifs, asked->bounds, limits);
    } catch (const host::exact::NotExact& reason) {
        return host::nothing_exact(reason.why);
    }
}

enum class BallsOf { text, doubles };

inline host::ExactFindings intervals_of(const std::string& text, BallsOf which = BallsOf::text) {
    const auto asked = asked_system(text);
    if (!asked) return {};
    const host::exact::BallMaps balls =
        which == BallsOf::text ? host::balls_as_written(asked->scene, asked->scene.ifs.front())
                               : host::exact::balls_around(asked->rifs);
    return host::find_by_intervals(balls, asked->rifs, asked->bounds, "a test");
}

/// A system of maps, each given by its commands.
inline std::string system_of(const std::vector<std::string>& maps, const std::string& more = "") {
    std::string text = "ifs a {\n";
    for (const std::string& map : maps) text += "newmap " + map + "\n";
    return text + more + "}\n";
}

}  // namespace pxm::test
