// What FRACTINT's .ifs and .l files have in common (docs/import.md): entries `name { ... }`, blanks
// anywhere, `;` to the end of a line is a comment, and entries named "comment" say nothing.
// A broken entry keeps its own errors, so that the others of a collection can still be taken.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "host/scene/diagnostics.hpp"

namespace pxm::host {

/// The head of an entry, and what was wrong with the entry.
struct FractintEntry {
    std::string name;
    std::string option;  // what stands in parentheses after the name: "3D"
    Position position;
    Diagnostics diagnostics;
    bool has_quotes = false;  // that stand for nothing and were skipped
};

/// A place in the text of a FRACTINT file.
class FractintReader {
  public:
    /// `text` must outlive the reader. A byte order mark is skipped.
    explicit FractintReader(std::string_view text);

    [[nodiscard]] bool at_end() const { return place_ >= text_.size(); }
    /// The character here; 0 at the end.
    [[nodiscard]] char peek() const { return at_end() ? '\0' : text_[place_]; }
    [[nodiscard]] Position position() const { return position_; }
    char take();

    /// Goes past blanks and comments; with `stay_in_line` not past the end of the line.
    void skip_blanks();
    void skip_blanks_in_line();

    /// What stands here up to a blank, comment, brace or the end.
    [[nodiscard]] std::string_view word() const;
    /// Takes it.
    std::string_view take_word();
    /// True if what comes next is the head of an entry: `name {` or `name (option) {`.
    [[nodiscard]] bool at_head() const;
    /// Goes on to behind the next '}', or to the next head or the end.
    void skip_entry();
    /// Goes on to behind the next '}' whatever stands before it.
    void skip_comment_entry();

    /// Reads a head up to its '{'; false, with an error in `diagnostics`, if there is none here:
    /// then the words up to the next head or brace were skipped.
    bool head(FractintEntry& entry, Diagnostics& diagnostics);

  private:
    std::string_view text_;
    std::size_t place_ = 0;
    Position position_;
};

/// Entries with this name (in any case) are comments.
[[nodiscard]] bool is_comment_entry(const FractintEntry& entry);

/// Equal up to the case of ASCII letters.
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);
[[nodiscard]] char lower(char c);

/// A number as FRACTINT's files write it: sign, .16, 5., 1e-3. False if the text is none, or too
/// large.
[[nodiscard]] bool read_number(std::string_view text, double& value);

}  // namespace pxm::host
