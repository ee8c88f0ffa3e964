// Ranges of a block's values: each check adds one error that names the block and the directive.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/diagnostics.hpp"

namespace pxm::host {

/// `object "fern"`, or `object` if it has no name.
[[nodiscard]] std::string block_name(std::string_view kind, const std::string& name);

class RangeCheck {
  public:
    RangeCheck(Diagnostics& diagnostics, const Position& position, std::string block)
        : diagnostics_(diagnostics), position_(position), block_(std::move(block)) {}

    /// Adds "BLOCK: MESSAGE".
    void error(const std::string& message);
    void error_at(const Position& position, const std::string& message);

    void finite(std::string_view word, const glm::dvec3& value);
    void not_negative(std::string_view word, const std::optional<double>& value);
    void positive(std::string_view word, const std::optional<double>& value);
    /// low <= value <= high
    void within(std::string_view word, const std::optional<double>& value, double low, double high);
    void within(std::string_view word, const std::optional<long>& value, long low, long high);
    void at_least(std::string_view word, const std::optional<long>& value, long low);
    /// Finite, no component negative.
    void color(std::string_view word, const std::optional<glm::dvec3>& value);
    /// The same, and a in 0..1.
    void color(std::string_view word, const std::optional<glm::dvec4>& value);
    /// Finite and not the zero vector.
    void direction(std::string_view word, const std::optional<glm::dvec3>& value);

  private:
    Diagnostics& diagnostics_;
    Position position_;
    std::string block_;
};

}  // namespace pxm::host
