// From the text of a scene to what exact numbers decide, without measuring anything else.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/compile/proven_rifs.hpp"
#include "host/flint/exact_scene.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::test {

/// Of the first system of the text, all of whose maps are reached.
inline host::ExactFindings exact_of(const std::string& text,
                                    const host::NeighbourLimits& limits = {}) {
    host::Diagnostics diagnostics;
    const host::Scene scene = host::parse_text("test.pxm", text, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files);
    if (diagnostics.has_errors()) return {};
    const auto proven = host::prove_rifs(scene.ifs.front(), diagnostics);
    EXPECT_TRUE(proven) << diagnostics.text(scene.files);
    if (!proven) return {};
    const host::Rifs part = host::reachable_part(proven->rifs);
    EXPECT_EQ(part.map_names, proven->rifs.map_names);
    const auto bounds = host::bound(part, host::prove_contraction(part));
    try {
        return host::find_exactly(host::written_maps(scene, scene.ifs.front()), part, bounds,
                                  limits);
    } catch (const host::exact::NotExact& reason) {
        return host::nothing_exact(reason.why);
    }
}

/// A system of maps, each given by its commands.
inline std::string system_of(const std::vector<std::string>& maps, const std::string& more = "") {
    std::string text = "ifs a {\n";
    for (const std::string& map : maps) text += "newmap " + map + "\n";
    return text + more + "}\n";
}

}  // namespace pxm::test
