// Which objects the wide engine can do, and why not the others: decided once, before anything is
// tabulated.
#pragma once

#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host::wide {

inline constexpr double thinnest = 1e-7;  // half width of a box, of its diameter

/// Of each object why the wide engine cannot do it, as the rest of a sentence that begins with its
/// name; empty if it can.
[[nodiscard]] std::vector<std::string> why_not_objects(const CompiledScene& scene);

/// Why nothing of this scene can be rendered by the wide engine; empty if it can, or if at least
/// one of its objects can: the others are left to the reference kernels then.
[[nodiscard]] std::string why_not_wide(const CompiledScene& scene, Numeric numeric);

/// How the first cells of one object are found in native renders in float.
struct ObjectMethod {
    std::string object;   // its name
    std::string method;   // which engine finds them
    std::string because;  // why that one
};
/// Of each object, in the order of the scene.
[[nodiscard]] std::vector<ObjectMethod> object_methods(const CompiledScene& scene);

}  // namespace pxm::host::wide
