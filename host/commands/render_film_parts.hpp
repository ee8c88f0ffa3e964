// What `pxm render --frames` does where a film is made in parts (docs/cluster.md): each frame is a
// part, in a folder of its own.
#pragma once

#include <string>
#include <vector>

#include "host/commands/film_stream.hpp"
#include "host/commands/render_parts.hpp"

namespace pxm::host {

/// A film, as the command line asks for it.
struct FilmRequest {
    PartsRequest parts;
    std::string text;          // of --frames
    std::vector<long> frames;  // that it names
};

/// `--frames LIST --part I/N -o DIR`: every Nth frame.
[[nodiscard]] ExitCode render_part_of_film(const FilmRequest& request, const std::string& part,
                                           const std::string& folder);

/// `--frames LIST --claim DIR`.
[[nodiscard]] ExitCode render_claimed_film(const FilmRequest& request, const std::string& folder,
                                           double expiry_seconds);

/// `--frames LIST --keep DIR -o OUT`, where OUT is as `pxm join DIR -o OUT` has it.
[[nodiscard]] ExitCode render_film_keeping(const FilmRequest& request, const std::string& folder,
                                           const FilmPath& out);

}  // namespace pxm::host
