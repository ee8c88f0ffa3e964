#include "host/parts/film_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "host/error.hpp"
#include "host/files/folder_names.hpp"
#include "host/output/frame_list.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace fs = std::filesystem;

namespace {

constexpr const char* frame_beginning = "frame-";

/// The folders of frames, sorted by their names.
std::vector<std::string> frame_folders(const std::string& folder) {
    std::error_code error;
    std::vector<std::string> folders;
    for (const std::string& name : names_in(folder, error)) {
        const fs::path path = fs::path(folder) / name;
        if (name.starts_with(frame_beginning) && fs::is_directory(path, error))
            folders.push_back(path.string());
    }
    std::ranges::sort(folders);
    return folders;
}

/// The heading of the first part in there; empty if there is none.
std::optional<PartHeading> heading_in(const std::string& folder) {
    const std::vector<std::string> paths = part_paths(folder);
    if (paths.empty()) return std::nullopt;
    const PartHeading heading = PartReader(paths.front()).heading();
    if (!heading.film)
        throw Error(ErrorKind::file,
                    fmt::format("{}: is no frame of a film", printable_path(paths.front())));
    return heading;
}

[[noreturn]] void refuse_other(const std::string& folder, const std::string& than,
                               const std::string& why) {
    throw Error(ErrorKind::file, fmt::format("{}: is of another film than {} ({})",
                                             printable_path(folder), than, why));
}

/// Why two frames are not of one film; empty if they are.
std::string why_apart(const FilmPlace& one, const FilmPlace& other) {
    if (one.count != other.count)
        return fmt::format("it has {} frames, not {}", one.count, other.count);
    if (one.rate != other.rate)
        return fmt::format("it has {} frames a second, not {}", one.rate, other.rate);
    return one.source == other.source ? "" : "its scene or its options are others";
}

FilmShape shape_of(const PartHeading& heading) {
    const CropWindow& window = heading.grid.window;
    return {window.x1 - window.x0, window.y1 - window.y0, heading.film->rate};
}

void add_frames(FilmSet& film, const FilmPlace& place) {
    std::set<long> known(film.frames.begin(), film.frames.end());
    for (const long frame : frames_of(place.frames, place.count))
        if (known.insert(frame).second) film.frames.push_back(frame);
}

}  // namespace

std::string frame_folder(const std::string& folder, long frame) {
    return (fs::path(folder) / fmt::format("{}{:04}", frame_beginning, frame)).string();
}

std::vector<long> frames_of_part(const std::vector<long>& frames, long part, long parts) {
    std::vector<long> own;
    for (auto i = static_cast<std::size_t>(part - 1); i < frames.size();
         i += static_cast<std::size_t>(parts))
        own.push_back(frames[i]);
    return own;
}

std::set<long> FilmSet::missing() const {
    std::set<long> missing;
    for (const long frame : frames)
        if (!there.contains(frame)) missing.insert(frame);
    return missing;
}

bool is_film_folder(const std::string& folder) { return !frame_folders(folder).empty(); }

FilmSet read_film(const std::string& folder) {
    FilmSet film;
    std::optional<PartHeading> first;
    std::string first_folder;
    std::set<std::string> lists;  // of frames, each looked at once
    for (const std::string& of_frame : frame_folders(folder)) {
        const std::optional<PartHeading> heading = heading_in(of_frame);
        if (!heading) continue;
        if (!first) {
            first = heading;
            first_folder = of_frame;
            film.shape = shape_of(*first);
            film.channels = first->channels;
        }
        const std::string why = why_apart(*heading->film, *first->film);
        if (!why.empty()) refuse_other(of_frame, printable_path(first_folder), why);
        if (lists.insert(heading->film->frames).second) add_frames(film, *heading->film);
        film.there.emplace(heading->film->frame, of_frame);
    }
    if (!first)
        throw Error(ErrorKind::file,
                    fmt::format("{}: holds no frames with parts", printable_path(folder)));
    return film;
}

void require_same_film(const std::string& folder, const FilmPlace& place) {
    for (const std::string& of_frame : frame_folders(folder)) {
        std::string why;
        const std::vector<std::string> paths = part_paths(of_frame);
        if (paths.empty()) continue;
        const std::optional<PartReader> part = find_part(paths.front(), why);
        if (!part) continue;  // what is damaged is made again
        if (part->heading().film) why = why_apart(*part->heading().film, place);
        if (!why.empty()) refuse_other(of_frame, "this", why);
        return;
    }
}

}  // namespace pxm::host
