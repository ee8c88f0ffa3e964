// Files of IFStile's language that are too long to be parsed as a whole: blocks are listed by their
// headings, and of a file of many thousand blocks those are parsed that the chosen one needs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host/import/aifs/aifs_text.hpp"
#include "host/scene/diagnostics.hpp"

namespace pxm::host {

/// A block of which nothing but its heading was read.
struct AifsSlice {
    std::string id;
    std::string parent;
    std::string name;       // of `$n`
    bool hidden = false;    // by `$a`
    std::string_view text;  // from its @ to before the next block's
    Position position;
};

/// The blocks of a text, in its order. They begin at lines whose first character is an @; what is
/// wrong outside of them goes to `diagnostics`, as parse_aifs has it.
[[nodiscard]] std::vector<AifsSlice> slice_aifs(std::string_view text, Diagnostics& diagnostics);

/// The blocks that the one of that number may need, parsed: its parents and what its text names,
/// and theirs. All but the chosen one are hidden. `chosen` becomes its number among them.
[[nodiscard]] std::vector<AifsBlock> parse_aifs_family(const std::vector<AifsSlice>& slices,
                                                       std::size_t& chosen,
                                                       Diagnostics& diagnostics);

}  // namespace pxm::host
