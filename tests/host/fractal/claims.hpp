// What is claimed of a system, without what box counting measures.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "host/compile/build_rifs.hpp"
#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/dimension/dimension.hpp"
#include "host/fractal/dimension/disconnected.hpp"
#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::host::systems {

inline Rifs parsed(const std::string& text) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("test.pxm", text, diagnostics);
    Rifs rifs = build_rifs(scene.ifs.at(0), diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.text(scene.files);
    return rifs;
}

struct Claims {
    OpenSetFinding open_set;
    Dimensions dimensions;
    DisconnectedFinding disconnected;
};

/// As `pxm inspect` puts them together.
inline Claims claims_of(const Rifs& whole) {
    const Rifs part = reachable_part(whole);
    const std::vector<Bounds> bounds = bound(part, prove_contraction(part));
    const Rifs plain = as_similitudes(part, affine_hulls(part));
    Claims claims;
    const bool as_given = plain.maps == part.maps;
    claims.open_set =
        decide_open_set(plain, bounds, as_given ? MapNumbers::given : MapNumbers::computed);
    claims.dimensions = dimensions(plain, claims.open_set.condition);
    claims.disconnected = decide_disconnected(plain, bounds, claims.dimensions.upper);
    add_topology(claims.dimensions, claims.disconnected.totally_disconnected);
    return claims;
}

inline Claims claims_of(const std::string& text) { return claims_of(parsed(text)); }

}  // namespace pxm::host::systems
