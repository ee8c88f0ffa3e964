// Lines of a formatted text: indentation, blank lines, comments at the ends of neighbouring lines
// in one column.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pxm::host {

/// Characters of UTF-8.
[[nodiscard]] std::size_t columns_in(std::string_view text);

class FormattedLines {
  public:
    /// Whether something more can be added to the line.
    [[nodiscard]] bool in_line() const { return in_line_; }
    [[nodiscard]] std::size_t columns() const { return columns_in(lines_.back().code); }

    /// A new line with that many blanks.
    void begin(std::size_t indent);
    void add(std::string_view text) { lines_.back().code += text; }
    void end() { in_line_ = false; }
    void end_with(const std::string& comment);
    /// A blank line before the next one, unless that is the first of the text or of a block.
    void blank();
    /// The line opened a block.
    void opened() { first_ = true; }

    [[nodiscard]] std::string text() const;

  private:
    struct Line {
        std::string code;
        std::string comment;  // behind the code
    };
    std::vector<Line> lines_;
    bool in_line_ = false;
    bool first_ = true;
};

}  // namespace pxm::host
