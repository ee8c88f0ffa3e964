// The smallest scene that still shows what was found: the picture cut down to the pixel, maps,
// objects, lights and directives left out, numbers made simple, as long as the same method is
// wrong.
#pragma once

#include "host/scene/scene.hpp"
#include "tests/support/campaign/trial.hpp"

namespace pxm::test {

struct Shrunk {
    host::Scene scene;
    Find find;      // in that scene
    int tried = 0;  // scenes on the way
};

/// Takes about `seconds` at most. What cannot be shown again comes back as it was.
[[nodiscard]] Shrunk shrink(const host::Scene& scene, const Find& find,
                            const TrialSettings& settings, double seconds);

}  // namespace pxm::test
