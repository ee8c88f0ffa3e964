// Which part of how many a run makes: as it was told, or as the program that started it says in the
// environment (docs/cluster.md has the table).
#pragma once

#include <functional>
#include <string>

namespace pxm::host {

struct PartChoice {
    long part = 1;  // 1 <= part <= parts
    long parts = 1;
};

inline constexpr long most_parts = 1'000'000;

/// The value of a variable of the environment; null if there is none.
using Environment = std::function<const char*(const char* name)>;

/// Of "I/N" or "auto". Throws Error(ErrorKind::setting).
[[nodiscard]] PartChoice choose_part(const std::string& text, const Environment& environment);

/// N of "any/N": workers that claim parts take any of N. Throws Error(ErrorKind::setting).
[[nodiscard]] long choose_count(const std::string& text);

}  // namespace pxm::host
