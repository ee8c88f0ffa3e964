// The picture of parts: what one run would have written, to the last byte.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/parts/part_set.hpp"

namespace pxm::host {

struct JoinedPicture {
    Statistics statistics;
    std::string warnings;              // for the user, as a render has them
    std::vector<std::size_t> missing;  // units; their pixels are black and see nothing
};

/// Takes a part of the picture; parts come in any order.
using TakeBlock = std::function<void(const Frame&)>;

/// Gives the picture to `take`, and of it what was counted; empty if it was stopped. Throws
/// Error(ErrorKind::file): a part is not as it was written.
[[nodiscard]] std::optional<JoinedPicture> join(PartSet& parts, const RunControl& control,
                                                const TakeBlock& take);

/// Writes the parts' picture to `path`; empty if it was stopped. Throws Error: the picture cannot
/// be written, or a part is not as it was written (4), the picture's format has no room for the
/// channels (2).
[[nodiscard]] std::optional<JoinedPicture> join(PartSet& parts, const std::string& path,
                                                const RunControl& control);

/// Which parts are missing, as a sentence for the user; empty if none is.
[[nodiscard]] std::string missing_text(const PartSet& parts);

}  // namespace pxm::host
