// What studies do with scenes: name them, know them again, render them, picture them.
#pragma once

#include <string>
#include <vector>

#include "host/engine/frame.hpp"
#include "host/study/study.hpp"

namespace pxm::host {

/// A scene's file name without folder and extension.
[[nodiscard]] std::string stem_of(const std::string& scene);

/// Names for the files of several scenes: their stems, numbered where two are the same.
[[nodiscard]] std::vector<std::string> file_names_of(const std::vector<std::string>& scenes);

/// A hash of what the scene says with what is set of it, includes too, as 16 hex digits. Throws
/// Error(ErrorKind::file, scene).
[[nodiscard]] std::string fingerprint_of(const std::string& scene, const Settings& settings,
                                         const std::vector<std::string>& allowed);

/// Renders, or throws StudyStopped.
[[nodiscard]] RenderResult render_unit(const RenderRequest& request, const UnitControl& control);

/// Values per pixel as a picture in the colours of plot.hpp, from `low` to `high`.
void write_value_picture(const std::string& path, const Frame& shape,
                         const std::vector<double>& values, double low, double high);

/// A grid of means over tiles of equal size, at most `most` a side, for the page's pointer.
struct CoarseGrid {
    long columns = 0;
    long rows = 0;
    std::vector<double> values;
};
[[nodiscard]] CoarseGrid coarse_grid(const Frame& shape, const std::vector<double>& values,
                                     long most);

/// The grid in data.json, and back.
[[nodiscard]] Json json_of(const CoarseGrid& grid);
[[nodiscard]] CoarseGrid grid_of(const Json& json);

}  // namespace pxm::host
