#include "host/commands/points_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "host/error.hpp"
#include "host/text/nearest.hpp"
#include "host/text/number_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

glm::dvec3 parse_offset(const std::string& text) {
    glm::dvec3 offset{0.0};
    std::size_t begin = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t end =
            axis < 2 ? std::min(text.find(',', begin), text.size()) : text.size();
        const auto value =
            number_of_text<double>(std::string_view(text).substr(begin, end - begin));
        if (!value)
            throw Error(
                ErrorKind::setting,
                fmt::format("--offset: found \"{}\", expected x,y,z or auto", printable(text)));
        offset[axis] = *value;
        begin = std::min(end + 1, text.size());
    }
    return offset;
}

}  // namespace

void require_coordinates(const std::string& precision, const std::string& offset) {
    const std::vector<std::string_view> known{"auto", "float", "double"};
    if (std::ranges::count(known, precision) == 0)
        throw Error(ErrorKind::setting,
                    fmt::format("--precision: found \"{}\", expected auto, float or double{}",
                                printable(precision), suggestion(precision, known)));
    if (!offset.empty() && offset != "auto") (void)parse_offset(offset);
}

Coordinates coordinates_of(std::vector<CloudExtent> extents, const std::string& precision,
                           const std::string& offset) {
    Coordinates coordinates;
    CloudExtent all;
    for (const CloudExtent& extent : extents) all.add(extent);
    if (offset == "auto") coordinates.offset = all.offset();
    if (!offset.empty() && offset != "auto") coordinates.offset = parse_offset(offset);
    for (CloudExtent& extent : extents) extent = extent.without(coordinates.offset);
    if (precision == "auto") coordinates.number = number_for(extents);
    if (precision == "double") coordinates.number = CoordinateNumber::double_;
    return coordinates;
}

}  // namespace pxm::host
