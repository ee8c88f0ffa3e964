// All that can be known of a scene before a ray is cast: what `pxm inspect` says. Facts only; how
// they are written stands in host/inspect/inspect_json and inspect_text.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/fractal/bounds/affine_hull.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/dimension/dimension.hpp"
#include "host/fractal/dimension/disconnected.hpp"
#include "host/fractal/dimension/open_set.hpp"
#include "host/fractal/measure/diameter.hpp"
#include "host/fractal/measure/moments.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/system/contraction.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/fractal/system/word_lipschitz.hpp"
#include "host/inspect/node_needs.hpp"
#include "host/math/lipschitz.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
/// What is known of one map.
struct MapFacts {
    MapKind kind = MapKind::affine;           // the narrowest that it is
    double determinant = 0;                   // of its linear part
    std::array<double, 3> singular_values{};  // largest first
    double lipschitz = 0;                     // the largest singular value, Sec. 16.2
    double determinant_bound = 0;             // Eq. 16.3
    std::optional<glm::dvec3> fixed_point;    // nothing if no single point stands still
};
/// What is known of one system.
struct IfsFacts {
    Rifs rifs;                             // its maps and its graph
    std::vector<MapFacts> maps;            // one of each map of `rifs`
    Contraction contraction;               // how it shrinks, and by what proof
    GraphFacts graph;                      // which maps lead to which
    std::vector<WordLipschitz> words;      // how far bounds of words are off
    std::vector<Bounds> bounds;            // per follow set of `rifs`
    Dimensions dimensions;                 // of its attractor
    OpenSetFinding open_set;               // whether it satisfies that condition
    DisconnectedFinding disconnected;      // whether its attractor is
    ExactFindings exact;                   // what is decided in the scene's very numbers
    std::vector<std::string> exact_names;  // of the maps that its numbers stand for
    std::optional<Moments> moments;        // of the measure by the maps' weights
    Diameter diameter;                     // of its attractor
    AffineHull subspace;                   // the smallest that its attractor lies in
};

/// The bounding volume of an object, as declared and as used.
struct ObjectFacts {
    std::string name;                        // of the object
    std::optional<std::string> ifs;          // nothing: the volume itself is the object
    std::string volume;                      // of the outermost cell: sphere, box, ...
    std::optional<DeclaredVolume> declared;  // as the scene says it
    double short_by = 0;                     // what the attractor sticks out of the declared volume
    double ball_slack = 0;  // the computed ball is at most so much larger than the smallest
};
/// What is known of a whole scene.
struct Inspection {
    std::string scene;                 // its path or name
    std::vector<IfsFacts> ifs;         // of all its systems
    std::vector<ObjectFacts> objects;  // of all that is shown
    NodeNeeds needs;                   // of a node of the machine
};

/// What is known of one system. Errors, as compile() would find, go to `diagnostics`; then nothing.
/// With the scene that the block is of, its text is read for exact numbers.
[[nodiscard]] std::optional<IfsFacts> inspect_ifs(const IfsBlock& block, Diagnostics& diagnostics,
                                                  const Scene* scene = nullptr,
                                                  const NeighbourLimits& limits = {});

/// Inspects a scene that check_scene found right; it may ask for what cannot be rendered yet. The
/// result is usable only if no error was added.
[[nodiscard]] Inspection inspect(const Scene& scene, const std::string& path,
                                 Diagnostics& diagnostics, const NeighbourLimits& limits = {});

}  // namespace pxm::host
