// The part of a render before its first ray: text -> scene -> check -> compile, and the method of
// intersection. `pxm check` goes no further.
#pragma once

#include <string>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/neighbour_walk.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

/// A scene that was parsed, checked and compiled without an error.
struct Prepared {
    Scene scene;
    CompiledScene compiled;
    NeighbourWalks walks;  // if a channel wants them
    std::string warnings;
    double parse_seconds = 0;
    double compile_seconds = 0;
};

/// Throws Error: the scene is wrong (3), a file cannot be read (4), a setting is wrong (2).
[[nodiscard]] Prepared prepare(const RenderRequest& request);

/// The machine's own numbers on the machine, those of native renders else, unless the scene says.
[[nodiscard]] Numeric numeric_of(const Prepared& prepared, const RenderRequest& request);

struct IntersectChoice {
    IntersectMethod method = IntersectMethod::heap;
    std::string because;
};

/// How the first cells are found. To demand the wide engine where it does not apply is an error
/// of the scene or the command line, whichever demands it.
[[nodiscard]] IntersectChoice intersect_of(const Prepared& prepared, const RenderRequest& request);

}  // namespace pxm::host
