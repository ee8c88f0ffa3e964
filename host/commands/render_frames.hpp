// `pxm render --frames`: several frames of an animation, to pictures, a film or a pipe.
#pragma once

#include <functional>
#include <string>

#include "host/process/exit_code.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

/// The command, as it was written.
struct FilmJob {
    RenderRequest request;  // its frame is left open
    std::string frames;     // empty: all
    std::string out;        // a path with %04d, a film, or "-"
    std::string format;     // of "-": y4m or ppm
    std::string stats;      // empty, or a path with %04d
    bool quiet = false;
    /// Throws Error unless a picture can be written there.
    std::function<void(const std::string& out)> require_picture;
    std::function<RenderResult(const RenderRequest& request, const std::string& out,
                               const RunControl& control)>
        write_picture;
};

/// Renders the frames in the order in which they are named. A mistake of a frame names it. Throws
/// Error: a setting is wrong (2), the scene is (3), a file cannot be written (4).
[[nodiscard]] ExitCode render_frames(const FilmJob& job);

}  // namespace pxm::host
