// The scene that a picture of pxm carries: its text and all that it includes, what the command line
// said over it, and which pictures its textures show (docs/pictures.md, "Pictures are scenes").
// Files go by names that start at the folder of the scene, so that nothing tells where it lay, and
// none of them is looked for on the disk: what a picture does not carry cannot be included.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/scene/diagnostics.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// What a texture shows. It is not carried: it has to be found again, and to be the same.
struct CarriedPicture {
    std::string name;
    std::string digest;
    bool operator==(const CarriedPicture&) const = default;
};

struct CarriedScene {
    std::string version;            // of pxm
    std::vector<SourceFile> files;  // the scene first; empty if it was left out
    std::vector<CarriedPicture> pictures;
    std::vector<std::pair<std::string, std::string>> options;  // "--size", "640x480"
    bool has_frames = false;                                   // it has an animation
    std::string left_out;                                      // why

    /// The values of an option, in their order.
    [[nodiscard]] std::vector<std::string> values_of(const std::string& option) const;
};

/// The scene at `path` as its pictures carry it, without options; that of a picture is its own. It
/// is left out where that would not be the same scene, or where the text says where on a disk a
/// file is. Precondition: it can be parsed. Throws Error as parse_scene().
[[nodiscard]] CarriedScene carry(const std::string& path, const std::vector<std::string>& allowed);

/// What a picture carries; nothing if there is no picture at `path`. Throws Error(ErrorKind::scene)
/// if it carries no scene, or one that is broken.
[[nodiscard]] std::optional<CarriedScene> carried_scene_at(const std::string& path);

/// As parse_scene(), of what the picture at `path` carries. What the textures show is looked for
/// beside the picture.
[[nodiscard]] Scene parse_carried(const CarriedScene& carried, const std::string& path,
                                  Diagnostics& diagnostics, const LetNumber& let_number = nullptr,
                                  double frame = 0);

/// Adds an error for each texture whose file is there and is not what the picture was rendered
/// with. Precondition: the files may be read.
void refuse_other_pictures(const CarriedScene& carried, const std::string& path, const Scene& scene,
                           Diagnostics& diagnostics);

}  // namespace pxm::host
