// EisenScript, the language of Structure Synth: rules whose actions place other rules, or shapes
// (docs/import.md).
//   rule NAME weight w maxdepth n > OTHER { 3 * { x 1 } 2 * { ry 90 } NAME  box }
#pragma once

#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/math/affine.hpp"
#include "host/scene/diagnostics.hpp"

namespace pxm::host {

/// A colour as the program keeps it: hue in degrees, saturation and value from 0 to 1.
struct EisenColor {
    double hue = 0;
    double saturation = 1;
    double value = 1;
    bool operator==(const EisenColor&) const = default;
};

/// What a list { ... } does to what stands behind it. Lengths are those of the unit cube [0,1],
/// about whose centre is turned, scaled and mirrored.
struct EisenTransform {
    Affine map;
    EisenColor change;              // hue is added, the others are factors
    std::optional<EisenColor> set;  // instead
    EisenColor blend;               // with this one, in hue, saturation and value
    double blend_strength = 0;
};

struct EisenLoop {
    long count = 1;
    EisenTransform step;
};

/// count * { step } ... of a rule or a shape; the first loop's steps come first.
struct EisenAction {
    std::vector<EisenLoop> loops;
    std::string target;
    Position position;
};

struct EisenRule {
    double weight = 1;
    std::optional<long> max_depth;
    std::string retirement;  // what comes instead at that depth
    std::vector<EisenAction> actions;
    Position position;
};

struct EisenScript {
    std::vector<EisenAction> start;
    std::map<std::string, std::vector<EisenRule>> rules;  // several of a name are drawn from
    long max_depth = 1000;
    long max_objects = 100'000;
    std::string messages;  // what was left out, a line each
};

/// Mistakes go to `diagnostics`; then the result cannot be used.
[[nodiscard]] EisenScript parse_eisenscript(std::string_view text, Diagnostics& diagnostics);

}  // namespace pxm::host
