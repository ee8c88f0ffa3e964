// A film as a file: frames go through a pipe to ffmpeg's program, which writes mp4, webm or gif.
#pragma once

#include <memory>
#include <string>

#include "host/output/raw_frames.hpp"

namespace pxm::host {

/// Whether the path's extension is that of a film: mp4, webm, or gif, which is one with several
/// frames.
[[nodiscard]] bool is_film(const std::string& path);

/// Throws Error(ErrorKind::setting) with what to do unless ffmpeg is there.
void require_ffmpeg(const std::string& path);

/// Starts ffmpeg. The film is put into its place by finish(), whole or not at all. A picture with
/// an odd number of columns or rows gets one more of black, which mp4 and webm want. Throws
/// Error(ErrorKind::file), as all of it.
[[nodiscard]] std::unique_ptr<FrameStream> make_film(const std::string& path,
                                                     const FilmShape& shape);

}  // namespace pxm::host
