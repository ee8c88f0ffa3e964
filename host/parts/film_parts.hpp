// A film in parts: each frame has a folder of its own below the film's, with the parts of its
// picture, usually one. So frames are made in any order by anybody, and a frame is nothing but a
// picture whose heading says where it stands.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "host/output/raw_frames.hpp"
#include "host/parts/part_set.hpp"

namespace pxm::host {

/// The folder of a frame.
[[nodiscard]] std::string frame_folder(const std::string& folder, long frame);

/// Of `count` frames those that a part of `parts`, from 1, makes: every `parts`th, as what takes
/// long is often beside what takes long.
[[nodiscard]] std::vector<long> frames_of_part(const std::vector<long>& frames, long part,
                                               long parts);

/// What the folder of a film holds.
struct FilmSet {
    FilmShape shape;
    std::vector<long> frames;                      // that were asked for, in their order
    std::map<long, std::string> there;             // the folders of those that have a part
    std::vector<Aov> channels;                     // of all frames
    [[nodiscard]] std::set<long> missing() const;  // that have none
};

/// Whether the folder holds frames.
[[nodiscard]] bool is_film_folder(const std::string& folder);

/// Throws Error(ErrorKind::file): there is no frame, a part is damaged, or frames are of different
/// films.
[[nodiscard]] FilmSet read_film(const std::string& folder);

/// Throws Error(ErrorKind::file) if the folder holds a frame of another film than this.
void require_same_film(const std::string& folder, const FilmPlace& place);

}  // namespace pxm::host
