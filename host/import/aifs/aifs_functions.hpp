// The functions that IFStile's language brings along.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "host/import/aifs/aifs_value.hpp"

namespace pxm::host {

/// The function's value; nothing if there is none of that name. Throws AifsMistake: wrong
/// arguments, or a function that is not taken, with the reason.
[[nodiscard]] std::optional<AifsValue> aifs_function(std::string_view name,
                                                     const std::vector<AifsValue>& arguments,
                                                     std::size_t dimension, const Position& place);

/// The value of `$pi`, `$i` or `$e`.
[[nodiscard]] std::optional<AifsValue> aifs_constant(std::string_view name, std::size_t dimension,
                                                     const Position& place);

}  // namespace pxm::host
