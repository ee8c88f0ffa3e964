#include "host/render/native_numeric.hpp"

#include <algorithm>

#include "host/wide/tables/eligible.hpp"

namespace pxm::host {

Numeric native_numeric(const CompiledScene& scene) {
    const bool hulls = std::ranges::any_of(scene.shapes, [](const CompiledShape& shape) {
        return std::ranges::any_of(shape.sets, [](const CompiledSet& set) {
            return set.volume.kind == kernels::Volume::hull;
        });
    });
    if (!hulls || wide::why_not_wide(scene, Numeric::single).empty()) return Numeric::single;
    return Numeric::double_;
}

}  // namespace pxm::host
