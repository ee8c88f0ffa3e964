// A worker that makes parts which nobody else makes, until all are there.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "host/engine/engine.hpp"

namespace pxm::host {

struct ClaimedParts {
    std::string folder;                        // of the parts, and of what is claimed
    std::vector<std::string> names;            // of their files, below the folder
    std::chrono::milliseconds expiry{60'000};  // after which a silent worker counts as dead
    /// Makes the part of that number; false if it was stopped.
    std::function<bool(std::size_t)> make;
};

/// How many parts there are if nobody says: many, so that none keeps the others waiting at the end.
[[nodiscard]] long default_parts(std::size_t units);

/// Makes parts until all of them are there, its own and those of others; how many it made. Fewer
/// are there if it was stopped. Throws Error as `make` does, or if the folder cannot be written.
std::size_t make_claimed_parts(const ClaimedParts& parts, const RunControl& control);

}  // namespace pxm::host
