// What a page is told, as JSON.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/render/render.hpp"
#include "host/studio/brought_file.hpp"
#include "host/studio/jobs.hpp"
#include "host/studio/scene_export.hpp"
#include "host/studio/scene_folder.hpp"
#include "host/studio/scene_view.hpp"
#include "host/studio/small_study.hpp"

namespace pxm::host {

/// What the page begins with.
struct StudioFacts {
    std::string folder;
    std::string scene;  // to be opened; empty: the gallery
    std::vector<std::string> scenes;
    int threads = 1;
    double grace_seconds = 0;
};
[[nodiscard]] std::string start_json(const StudioFacts& facts);

/// `{"error": {kind, message, mistakes: [{file, line, column, message}]}}`.
[[nodiscard]] std::string error_json(const Error& error);
/// What a request is told that a newer one has overtaken, or that was given up; and how long its
/// work went on after that, 0 if it was not begun.
[[nodiscard]] std::string superseded_json(double stopping_milliseconds);

/// `{"share": 0..1, "nodes": [[cycles, pixels], ...]}`; null where nothing is being computed.
[[nodiscard]] std::string progress_json(const Job* job);

[[nodiscard]] std::string imported_json(const MadeScene& made);
[[nodiscard]] std::string study_json(const StudyFindings& findings);
/// `{"exported": true, "messages": ...}`; false: there is a file of that name.
[[nodiscard]] std::string exported_json(const Exported& exported);

[[nodiscard]] std::string opened_json(const SceneFile& file);
[[nodiscard]] std::string saved_json(Saved saved, const std::string& digest);

/// A scene without mistakes: its camera, the numbers of its maps and objects, and warnings.
[[nodiscard]] std::string checked_json(const Scene& scene, const SceneView& view,
                                       const std::string& warnings);

/// The head of a picture's bytes.
[[nodiscard]] std::string picture_json(const RenderResult& result);

/// What stands at a pixel.
struct PickedPlace {
    std::string object;  // its name
    std::string ifs;
    std::vector<std::string> word;                    // maps by name, outermost first
    double distance = 0;                              // from the eye
    std::optional<std::array<std::string, 3>> point;  // absent for a volume that is an object
};
[[nodiscard]] std::string picked_json(const std::optional<PickedPlace>& place);

/// `{"text": ...}`.
[[nodiscard]] std::string text_json(const std::string& text);

}  // namespace pxm::host
