// Sets and maps of a block of IFStile's language, computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/import/aifs/aifs_text.hpp"
#include "host/import/aifs/aifs_value.hpp"

namespace pxm::host {

/// Each set is the union of what its node's edges lead to. The first one is the one to show.
struct AifsSystem {
    struct Set {
        std::string name;
        AifsUnion value;
    };
    std::size_t dimension = 2;
    std::vector<Set> sets;
    std::optional<AffineN> subspace_of;  // the matrix whose eigenspaces are shown
    std::vector<int> cells;              // which of them
    std::vector<double> camera;          // its numbers, without the inner brackets
};

/// A block as a user sees it: not hidden, with a set in it.
struct AifsEntry {
    std::string name;  // $n, else the ID, else "block 3"
    std::size_t block = 0;
    std::vector<std::string> sets;  // in the order of the text, the parents' first
};
[[nodiscard]] std::vector<AifsEntry> aifs_entries(const std::vector<AifsBlock>& blocks);

/// The system of a block; the set of that name is the first, else the one of `$root`, else the
/// first that is defined. Throws AifsMistake.
[[nodiscard]] AifsSystem evaluate_aifs(const std::vector<AifsBlock>& blocks, std::size_t block,
                                       const std::optional<std::string>& set);

}  // namespace pxm::host
