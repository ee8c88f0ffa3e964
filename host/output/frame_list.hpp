// Which frames of an animation, and what their files are called.
#pragma once

#include <string>
#include <vector>

namespace pxm::host {

/// The frames of "0-599", "0-599:10", "3,7,20-30": ranges, whose last frame belongs to them, with
/// or without a step. At most 1,000,000, all of them below `frames`; none twice. Throws
/// Error(ErrorKind::setting).
[[nodiscard]] std::vector<long> frames_of(const std::string& text, long frames);

/// Whether a path has a place for the frame's number, %d or %04d. Throws Error(ErrorKind::setting)
/// if it has several, or another sign after a %; %% stands for one.
[[nodiscard]] bool has_frame_number(const std::string& path);

/// The path with the number in its place. Precondition: has_frame_number() has read it.
[[nodiscard]] std::string path_of_frame(const std::string& path, long frame);

}  // namespace pxm::host
