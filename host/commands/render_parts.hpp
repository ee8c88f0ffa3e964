// What `pxm render` does where a picture is made in parts (docs/cluster.md).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/engine/aov.hpp"
#include "host/files/image_reader.hpp"
#include "host/process/exit_code.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

struct PartsRequest {
    RenderRequest render;
    std::vector<Aov> channels;
    std::function<Metadata(const RenderResult&)> metadata;  // of the picture
    std::string stats;                                      // empty: none were asked for
    bool quiet = false;
};

/// `--part I/N -o DIR`.
[[nodiscard]] ExitCode render_one_part(const PartsRequest& request, const std::string& part,
                                       const std::string& folder);

/// `--claim DIR`, perhaps with `--part any/N`; a worker that is silent for so many seconds is dead.
[[nodiscard]] ExitCode render_claimed(const PartsRequest& request, const std::string& folder,
                                      const std::string& parts, double expiry_seconds);

/// `--keep DIR -o OUT`.
[[nodiscard]] ExitCode render_keeping(const PartsRequest& request, const std::string& folder,
                                      const std::string& out);

}  // namespace pxm::host
