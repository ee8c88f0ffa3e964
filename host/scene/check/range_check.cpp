#include "host/scene/check/range_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

bool is_finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::string block_name(std::string_view kind, const std::string& name) {
    return name.empty() ? std::string(kind) : fmt::format("{} \"{}\"", kind, printable(name));
}

void RangeCheck::error(const std::string& message) { error_at(position_, message); }

void RangeCheck::error_at(const Position& position, const std::string& message) {
    diagnostics_.error(position, fmt::format("{}: {}", block_, message));
}

void RangeCheck::finite(std::string_view word, const glm::dvec3& value) {
    if (!is_finite(value)) error(fmt::format("'{}' must be finite", word));
}

void RangeCheck::not_negative(std::string_view word, const std::optional<double>& value) {
    if (value && !(*value >= 0 && std::isfinite(*value)))
        error(fmt::format("'{}' is {}: it must not be negative", word, *value));
}

void RangeCheck::positive(std::string_view word, const std::optional<double>& value) {
    if (value && !(*value > 0 && std::isfinite(*value)))
        error(fmt::format("'{}' is {}: it must be greater than 0", word, *value));
}

void RangeCheck::within(std::string_view word, const std::optional<double>& value, double low,
                        double high) {
    if (value && !(*value >= low && *value <= high))
        error(fmt::format("'{}' is {}: it must lie in {}..{}", word, *value, low, high));
}

void RangeCheck::within(std::string_view word, const std::optional<long>& value, long low,
                        long high) {
    if (value && (*value < low || *value > high))
        error(fmt::format("'{}' is {}: it must lie in {}..{}", word, *value, low, high));
}

void RangeCheck::at_least(std::string_view word, const std::optional<long>& value, long low) {
    if (value && *value < low)
        error(fmt::format("'{}' is {}: it must be at least {}", word, *value, low));
}

void RangeCheck::color(std::string_view word, const std::optional<glm::dvec3>& value) {
    if (value && !(is_finite(*value) && value->x >= 0 && value->y >= 0 && value->z >= 0))
        error(fmt::format("'{}' is {},{},{}: no component may be negative", word, value->x,
                          value->y, value->z));
}

void RangeCheck::color(std::string_view word, const std::optional<glm::dvec4>& value) {
    if (!value) return;
    color(word, std::optional(glm::dvec3(*value)));
    if (!(value->w >= 0 && value->w <= 1))
        error(fmt::format("'{}' has a = {}: it must lie in 0..1", word, value->w));
}

void RangeCheck::direction(std::string_view word, const std::optional<glm::dvec3>& value) {
    if (!value) return;
    finite(word, *value);
    if (*value == glm::dvec3{0.0}) error(fmt::format("'{}' is 0,0,0: it must not be zero", word));
}

}  // namespace pxm::host
