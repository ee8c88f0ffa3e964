// What stands in a part file beside its units: what the part belongs to, and all that the picture
// and its statistics need when the parts are joined, where the scene may not be at hand.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/engine/aov.hpp"
#include "host/engine/units.hpp"
#include "host/files/image_reader.hpp"
#include "host/render/start.hpp"

namespace pxm::host {

/// Something that all parts of a picture have in common, as text or as the digest of it.
struct CommonThing {
    std::string name;
    std::string value;
    bool operator==(const CommonThing&) const = default;
};

/// Where a frame stands in its film.
struct FilmPlace {
    long frame = 0;
    std::string frames;  // that are made, as --frames says it
    long count = 0;      // of the animation
    double rate = 0;     // frames a second
    std::string source;  // digest of all that the film is made from
    bool operator==(const FilmPlace&) const = default;
};

/// Nothing in it depends on how or where the part was made, but for the names in `statistics` and
/// `metadata`, which are as they were written for that run.
struct PartHeading {
    std::vector<CommonThing> common;
    UnitGrid grid;
    std::vector<Aov> channels;  // that are kept beside the colour
    AlarmBasis alarms;
    std::uint32_t cell_cap = 0;
    Statistics statistics;  // what is known without a ray
    Metadata metadata;
    std::optional<FilmPlace> film;  // of a frame that is a part of a film
    long part = 0, parts = 0;       // of how many this is the how manieth; 0: of no fixed number
};

/// The heading of a render's parts. `metadata` is what a picture of it gets.
[[nodiscard]] PartHeading heading_of(const StartedRender& started, const RenderRequest& request,
                                     const std::vector<Aov>& channels, const Metadata& metadata);

/// Why parts with these headings are not of one picture, for a sentence about the first: "its
/// samples are 4, not 1". Empty if they are.
[[nodiscard]] std::string why_apart(const PartHeading& one, const PartHeading& other);

}  // namespace pxm::host
