#include "host/scene/print/formatted_lines.hpp"

#include <algorithm>

namespace pxm::host {

std::size_t columns_in(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

void FormattedLines::begin(std::size_t indent) {
    lines_.push_back({std::string(indent, ' '), {}});
    in_line_ = true;
    first_ = false;
}

void FormattedLines::end_with(const std::string& comment) {
    lines_.back().comment = comment;
    in_line_ = false;
}

void FormattedLines::blank() {
    if (!first_ && !lines_.empty()) lines_.emplace_back();
    in_line_ = false;
}

std::string FormattedLines::text() const {
    constexpr std::size_t before_comment = 4;
    std::string text;
    for (std::size_t i = 0; i < lines_.size();) {
        std::size_t end = i;  // of a run of lines with comments behind them
        std::size_t column = 0;
        for (; end < lines_.size() && !lines_[end].comment.empty(); ++end)
            column = std::max(column, columns_in(lines_[end].code) + before_comment);
        for (end = std::max(end, i + 1); i < end; ++i) {
            const Line& line = lines_[i];
            text += line.code;
            if (!line.comment.empty())
                text += std::string(column - columns_in(line.code), ' ') + line.comment;
            text += '\n';
        }
    }
    return text;
}

}  // namespace pxm::host
