// The scene language as a table: which blocks there are and which directives each may hold.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pxm::host {

enum class Values { none, needed, optional };
enum class Times { once, once_a_map, many };
enum class Naming { needed, allowed, none };

struct Directive {
    std::string_view word;
    Values values = Values::needed;
    Times times = Times::once;
};

struct BlockGrammar {
    std::string_view kind;
    Naming naming;
    std::span<const Directive> directives;

    /// The directive's index, or -1.
    [[nodiscard]] int find(std::string_view word) const;
};

/// Every block, in the order of docs/scene-language.md.
[[nodiscard]] std::span<const BlockGrammar> all_blocks();

/// The block of that kind (`rifs` is an `ifs`), or nullptr.
[[nodiscard]] const BlockGrammar* find_block(std::string_view kind);

/// A word of the language that cannot be a name: blocks, directives, functions, pi and phi. Words
/// of animations (animation, frames, rate, shutter, zoom, blend, key, t, frame) can: scenes had
/// such names before there were any.
[[nodiscard]] bool is_keyword(std::string_view word);

/// A keyword that stands for a number or a function: pi, phi, sqrt, sin, cos, tan.
[[nodiscard]] bool is_number_word(std::string_view word);

/// " (did you mean 'scale'?)" for the directive nearest to a misspelt word; empty if none is near.
[[nodiscard]] std::string suggest_directive(std::string_view word, const BlockGrammar& block);
/// The same for what may stand at the top of a file.
[[nodiscard]] std::string suggest_block(std::string_view word);

/// "newmap, scale, rotate, ...": what the block may hold.
[[nodiscard]] std::string directive_list(const BlockGrammar& block);

}  // namespace pxm::host
