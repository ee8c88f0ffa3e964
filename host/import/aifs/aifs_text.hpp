// IFStile's language AIFS as a syntax tree (docs/import.md): blocks `@ID:PARENT` of definitions
// `name = expression`. Ends of lines mean nothing inside an expression; `$n`, `$a` and the older
// form of `$subspace` are text up to the end of their line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/diagnostics.hpp"

namespace pxm::host {

enum class AifsOp {
    number,
    name,
    vector,    // [a, b]
    call,      // name(a, b)
    index,     // a[b]
    unite,     // a | b | c
    sum,       // a + b - c
    product,   // a * b / c % d
    power,     // a ^ b
    negative,  // -a
};

/// Chains of one operation are one node, however long, so that trees are as deep as the text nests.
struct AifsExpression {
    AifsOp op = AifsOp::number;
    double number = 0;
    std::string name;
    std::vector<AifsExpression> parts;
    std::string signs;  // of sum and product: what stands before each part
    Position position;
};

struct AifsDefinition {
    std::string name;  // with its $, without its &
    AifsExpression value;
    std::string text;  // of definitions that are text
    Position position;
};

struct AifsBlock {
    std::string id;
    std::string parent;
    std::vector<AifsDefinition> definitions;
    Position position;
    Diagnostics diagnostics;  // of the block: others can still be taken

    /// The text of `$n` or `$a`; empty if there is none.
    [[nodiscard]] std::string text_of(std::string_view name) const;
};

/// The blocks of a file. Mistakes inside a block are kept with it, others go to `diagnostics`.
[[nodiscard]] std::vector<AifsBlock> parse_aifs(std::string_view text, Diagnostics& diagnostics);

/// The same of a part of a file, which begins at that place. `left` is how many numbers and names
/// the file may still have, at first most_aifs_parts.
[[nodiscard]] std::vector<AifsBlock> parse_aifs_part(std::string_view text, const Position& begin,
                                                     std::size_t& left, Diagnostics& diagnostics);

inline constexpr std::size_t most_aifs_parts = 2'000'000;  // some 250 MB in memory

}  // namespace pxm::host
