// What `pxm render` does where a picture is made in parts (docs/cluster.md).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/engine/aov.hpp"
#include "host/files/image_reader.hpp"
#include "host/parts/part_choice.hpp"
#include "host/parts/part_heading.hpp"
#include "host/process/exit_code.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/progress.hpp"
#include "host/render/render.hpp"
#include "host/render/start.hpp"

namespace pxm::host {

struct PartsRequest {
    RenderRequest render;
    std::vector<Aov> channels;
    std::function<Metadata(const RenderResult&, double frame)> metadata;  // of the picture
    std::string stats;  // empty: none were asked for
    bool quiet = false;
};

// What these have in common with a film's parts.

/// A picture's statistics are the sums over its parts. Throws Error(ErrorKind::setting).
void require_no_stats(const PartsRequest& request, const char* option);
/// The value of --part. Throws Error(ErrorKind::setting).
[[nodiscard]] PartChoice part_choice_of(const std::string& part);
/// Whether that part is there already; one that is damaged is not. Throws Error(ErrorKind::file)
/// if it is of another picture.
[[nodiscard]] bool is_part_there(const std::string& path, const PartHeading& heading);
/// As start_render(), of what can be made in parts.
[[nodiscard]] std::unique_ptr<StartedRender> start_parts(const RenderRequest& request);

/// What becomes of a run that a limit ends.
inline constexpr const char* goes_on =
    "what is done is in the folder; the same command goes on from there";

/// Runs `work(control)` with a bar of its progress; stopped by signals.
template <class Work>
auto with_progress(bool quiet, const Work& work) {
    Progress progress(quiet);
    RunControl control;
    control.stop = &stop_requested();
    if (progress.enabled()) control.progress = [&](double share) { progress.update(share); };
    return work(control);
}

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
