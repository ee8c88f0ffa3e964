// The instances of the node program: a number type, and what a scene needs of the tracer (design
// decisions 1 and 8). Chosen once per render.
#pragma once

#include "dsp_kernels/trace.hpp"
#include "host/compiled/compiled_scene.hpp"
#include "pxm/real.hpp"

namespace pxm::host {

/// Calls `run.operator()<features>()` with the least that the scene needs.
template <class Run>
auto with_needed_features(const CompiledScene& scene, const Run& run) {
    if (scene.area) return run.template operator()<kernels::area_features>();
    if (needs_covers(scene)) return run.template operator()<kernels::all_features>();
    if (needs_plain_features(scene)) return run.template operator()<kernels::plain_features>();
    return run.template operator()<kernels::ray_features>();
}

/// Calls `run.operator()<Real, features>()` for that number type and with the least that the scene
/// needs.
template <class Run>
auto with_instance(const CompiledScene& scene, Numeric numeric, const Run& run) {
    const auto with = [&]<class Real>() {
        return with_needed_features(scene, [&]<kernels::Features features>() {
            return run.template operator()<Real, features>();
        });
    };
    switch (numeric) {
        case Numeric::double_:
            return with.template operator()<double>();
        case Numeric::dsp32:
            return with.template operator()<dsp32::Float>();
        case Numeric::single:
            break;
    }
    return with.template operator()<float>();
}

}  // namespace pxm::host
