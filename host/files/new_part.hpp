// Files that are being written, beside the place where they will be: `.pxm-part-` and twelve random
// letters. Whoever writes one holds a lock on it, which the system takes away with the process,
// however that ends: a part without a lock belongs to nobody. Process ids would not do, as those of
// two containers may be equal.
#pragma once

#include <sys/types.h>

#include <string>

namespace pxm::host {

struct NewPart {
    std::string path;
    int descriptor = -1;  // for reading and writing, locked, closed on exec; the caller's
    std::string error;    // why there is none; else empty
};

/// Makes an empty part in the folder. `extension` with its dot is kept unless it is long.
[[nodiscard]] NewPart make_part(const std::string& folder, const std::string& extension,
                                mode_t mode);

/// Removes the parts in the folder that were left by runs which are over. What cannot be removed
/// stays.
void remove_left_parts(const std::string& folder);

}  // namespace pxm::host
