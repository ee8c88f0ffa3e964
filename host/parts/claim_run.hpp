// A worker that makes parts which nobody else makes, until all are there.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "host/parts/part_run.hpp"

namespace pxm::host {

struct ClaimedParts {
    std::string folder;
    long parts = 1;
    std::chrono::milliseconds expiry{60'000};  // after which a silent worker counts as dead
};

/// How many parts there are if nobody says: many, so that none keeps the others waiting at the end.
[[nodiscard]] long default_parts(std::size_t units);

/// Makes parts of the picture until all of them are there, its own and those of others; `made` is
/// told the name of each that it made. False if it was stopped. Throws Error as write_part() does.
[[nodiscard]] bool make_claimed_parts(const UnitRender& render, const ClaimedParts& claimed,
                                      const std::function<void(const std::string&)>& made);

}  // namespace pxm::host
