// A render that has come to its first ray: what render() does with a whole window, host/parts does
// with units of it.
#pragma once

#include <memory>

#include "host/render/alarms.hpp"
#include "host/render/prepare.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

struct StartedRender {
    Prepared prepared;
    AlarmBasis alarms;
    RenderResult result;                  // what is known without a ray
    std::unique_ptr<LoadedScene> loaded;  // of prepared.compiled
};

/// Throws Error as render() does.
[[nodiscard]] std::unique_ptr<StartedRender> start_render(const RenderRequest& request);

}  // namespace pxm::host
