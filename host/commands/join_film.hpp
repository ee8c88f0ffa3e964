// The frames of a film's parts as pictures, a film, or a stream.
#pragma once

#include <string>
#include <vector>

#include "host/commands/film_stream.hpp"
#include "host/engine/aov.hpp"
#include "host/process/exit_code.hpp"

namespace pxm::host {

struct FilmJoin {
    std::string folder;
    FilmPath out;       // a path with %04d, a film, or "-"
    std::string stats;  // empty, or a path with %04d
    bool quiet = false;
    std::vector<long> frames = {};  // empty: all that the film's parts know of
};

/// Throws Error unless the frames can be written (2, 4). Nothing is written.
void require_film_output(const FilmJoin& join, const std::vector<long>& frames,
                         const FilmShape& shape, const std::vector<Aov>& channels);

/// Joins the frames in the order in which they were asked for. One that is missing is black in a
/// film and has no picture. Throws Error(ErrorKind::file).
[[nodiscard]] ExitCode join_film(const FilmJoin& join);

}  // namespace pxm::host
