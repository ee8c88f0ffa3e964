// A study that somebody waits for, who may want something else before it is done.
#pragma once

#include "host/engine/engine.hpp"
#include "host/study/study.hpp"

namespace pxm::host {

/// As run_study, until `control.stop` is set: false then. `control.progress` hears of all units
/// together.
[[nodiscard]] bool run_watched_study(const StudyRequest& request, const RunControl& control);

}  // namespace pxm::host
