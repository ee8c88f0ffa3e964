// Renders units of a picture into part files: one part of N, or those that a folder lacks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/parts/part_set.hpp"

namespace pxm::host {

/// A render of units: the scene in its engine, and what their parts say of it.
struct UnitRender {
    StartedRender& started;
    const PartHeading& heading;
    const RunControl& control;
};

/// The part of `parts`, from 1, that renders a unit of `units`: stretches of the picture are dealt
/// out one by one, so that a place that takes long is shared by many.
[[nodiscard]] long part_of_unit(std::size_t unit, std::size_t units, long parts);
/// The units of a part. Empty where there are more parts than units.
[[nodiscard]] std::vector<std::size_t> units_of_part(std::size_t units, long part, long parts);

/// The name of that part's file.
[[nodiscard]] std::string part_name(long part, long parts);

/// Renders the units, in their order, into one file at `path`. False if it was stopped: then there
/// is no file. Throws Error as a render does, or if the file cannot be written.
[[nodiscard]] bool write_part(const UnitRender& render, const std::vector<std::size_t>& wanted,
                              const std::string& path);

/// Writes a whole picture that was rendered otherwise, its alarms marked, as one file at `path`.
/// Throws Error(ErrorKind::file).
void write_whole(const RenderResult& picture, const PartHeading& heading, const std::string& path);

/// Makes the folder if it is not there. Throws Error(ErrorKind::file) unless files can be written
/// in it.
void make_part_folder(const std::string& folder);

}  // namespace pxm::host
