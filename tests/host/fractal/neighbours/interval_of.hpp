// From the text of a scene to what intervals decide.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/compile/proven_rifs.hpp"
#include "host/flint/exact_scene.hpp"
#include "host/fractal/neighbours/interval_findings.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::test {

enum class BallsOf { text, doubles };

/// Of the first system of the text, all of whose maps are reached.
inline host::ExactFindings intervals_of(const std::string& text, BallsOf which = BallsOf::text) {
    host::Diagnostics diagnostics;
    const host::Scene scene = host::parse_text("test.pxm", text, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files);
    if (diagnostics.has_errors()) return {};
    const auto proven = host::prove_rifs(scene.ifs.front(), diagnostics);
    EXPECT_TRUE(proven) << diagnostics.text(scene.files);
    if (!proven) return {};
    const auto bounds = host::bound(proven->rifs, proven->contraction);
    const host::exact::BallMaps balls = which == BallsOf::text
                                            ? host::balls_as_written(scene, scene.ifs.front())
                                            : host::exact::balls_around(proven->rifs);
    return host::find_by_intervals(balls, proven->rifs, bounds, "a test");
}

}  // namespace pxm::test
