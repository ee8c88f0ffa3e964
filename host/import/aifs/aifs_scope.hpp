// The definitions that a block of IFStile's language has, with those of its parents, and which of
// them are sets.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/import/aifs/aifs_text.hpp"
#include "host/import/aifs/aifs_value.hpp"

namespace pxm::host {

/// Names and what they stand for, once for every use of a block.
struct AifsScope {
    const AifsBlock* block = nullptr;
    std::vector<const AifsDefinition*> definitions;  // in order; a child's stand in the parent's
                                                     // place
    std::map<std::string, std::size_t, std::less<>> places;  // of names
    std::set<std::string, std::less<>> sets;                 // defined by themselves, or by what is
    std::map<std::string, AifsValue, std::less<>> values;    // known by now
};

/// Throws AifsMistake: a parent that is not there, or a block that is its own.
[[nodiscard]] AifsScope aifs_scope(const std::vector<AifsBlock>& blocks, std::size_t block);

/// The number of the block with that ID; -1 if there is none.
[[nodiscard]] int block_number(const std::vector<AifsBlock>& blocks, std::string_view id);

}  // namespace pxm::host
