// ifs and object: maps finite, colors and weights in range, an instance that can be inverted.
#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "host/scene/check/check_blocks.hpp"
#include "host/scene/check/range_check.hpp"

namespace pxm::host {
namespace {

bool is_finite(const Affine& map) {
    double sum = 0;  // NaN or infinite if any entry is
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) sum += 0 * map.linear[row][column];
    for (int column = 0; column < 3; ++column) sum += 0 * map.translation[column];
    return sum == 0;
}

/// No inverse, or none that a double can hold: the volume of the image is nothing beside its edges.
bool is_singular(const Affine& map) {
    constexpr double flat = 1e-14;
    const double edges =
        glm::length(map.linear[0]) * glm::length(map.linear[1]) * glm::length(map.linear[2]);
    return !(std::abs(determinant(map)) > flat * edges);
}

/// The composed map, unless a command of it is wrong, which is reported.
std::optional<Affine> composed(const std::vector<Command>& commands, RangeCheck& check) {
    for (const Command& command : commands) {
        try {
            if (is_finite(compose({command}))) continue;
            check.error_at(command.position, "the command is not finite");
        } catch (const std::domain_error& error) {
            check.error_at(command.position, error.what());
        }
        return std::nullopt;
    }
    const Affine map = compose(commands);
    if (is_finite(map)) return map;
    check.error("the map is not finite");
    return std::nullopt;
}

void check_volume(const DeclaredVolume& volume, const Position& position, RangeCheck& check) {
    if (const auto* sphere = std::get_if<SphereVolume>(&volume)) {
        check.finite("sphere", sphere->center);
        if (!(sphere->radius > 0 && std::isfinite(sphere->radius)))
            check.error_at(position,
                           fmt::format("the sphere's radius is {}: it must be greater than 0",
                                       sphere->radius));
    }
    if (const auto* box = std::get_if<BoxVolume>(&volume)) {
        check.finite("box", box->low);
        check.finite("box", box->high);
        for (int axis = 0; axis < 3; ++axis)
            if (!(box->low[axis] < box->high[axis]))
                check.error_at(position,
                               fmt::format("the box is empty: its {} runs from {} to {}",
                                           "xyz"[axis], box -> low[axis], box -> high[axis]));
    }
}

}  // namespace

void check_ifs(const IfsBlock& ifs, Diagnostics& diagnostics) {
    const std::string block = block_name("ifs", ifs.name);
    for (std::size_t i = 0; i < ifs.maps.size() && !diagnostics.overflowed(); ++i) {
        const MapBlock& map = ifs.maps[i];
        const std::string name =
            map.name.empty() ? fmt::format("map {}", i + 1) : block_name("map", map.name);
        RangeCheck check(diagnostics, map.position, fmt::format("{}: {}", block, name));
        (void)composed(map.commands, check);
        check.color("color", map.color);
        check.not_negative("weight", map.weight);
    }
}

void check_object(const ObjectBlock& object, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, object.position, block_name("object", object.name));
    const bool is_hull = object.volume && std::holds_alternative<HullVolume>(*object.volume);
    const bool has_body =
        object.volume && !is_hull && !std::holds_alternative<AutoVolume>(*object.volume);
    if (!object.ifs && !has_body) {
        check.error(is_hull ? "a hull is computed: it needs an 'ifs'"
                            : "it needs an 'ifs' or a volume");
    }
    const std::optional<Affine> map = composed(object.commands, check);
    if (map && is_singular(*map)) check.error("its matrix is singular: it squashes space flat");
    if (object.volume) check_volume(*object.volume, object.volume_position, check);
    check.color("color", object.color);
    check.within("opacity", object.opacity, 0.0, 1.0);
    check.within("diffuse", object.diffuse, 0.0, 1.0);
    check.within("reflect", object.reflect, 0.0, 1.0);
    check.at_least("levels", object.levels, 0);
}

}  // namespace pxm::host
