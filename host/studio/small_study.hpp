// A study that is short enough to wait for: of the scene as the page has it, in a folder of its own
// that is gone afterwards.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "host/studio/asks.hpp"
#include "host/study/study.hpp"

namespace pxm::host {

/// What a page may ask to be studied.
struct AskedStudy {
    AskedScene scene;
    StudyKind kind = StudyKind::balance;
    PixelSize size;
};

struct StudyFindings {
    std::vector<TextFile> tables;  // as the study's folder has them
    std::string report;            // report.html
    bool stopped = false;
};

/// Measures until `stop` is set; `progress` hears which share is done. Throws Error as a render.
[[nodiscard]] StudyFindings study_asked(const AskedStudy& asked, int threads,
                                        const std::atomic<bool>& stop,
                                        const std::function<void(double)>& progress);

}  // namespace pxm::host
