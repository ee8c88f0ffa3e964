// Messages with their places. The line is shown without its leading blanks; a long line is shown as
// a window around the caret.
#include "host/scene/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t window_bytes = 120;  // of a long line, about half of it before the caret

struct ShownLine {
    std::string text;
    std::size_t caret;  // characters before it
};

std::string_view without_bom(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    return text;
}

/// Line `number` (from 1) without its line end; empty if there is none.
std::string_view source_line(std::string_view text, int number) {
    text = without_bom(text);
    for (int line = 1; line < number; ++line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
}

bool is_continuation(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

/// The first and one-past-last byte to show, never inside a UTF-8 sequence.
std::pair<std::size_t, std::size_t> window(std::string_view line, std::size_t caret) {
    std::size_t begin = std::min(line.find_first_not_of(" \t"), caret);
    if (line.size() - begin <= window_bytes) return {begin, line.size()};
    if (caret - begin > window_bytes / 2) begin = caret - window_bytes / 2;
    std::size_t end = std::min(line.size(), begin + window_bytes);
    while (begin < caret && is_continuation(line[begin])) ++begin;
    while (end < line.size() && end > caret && is_continuation(line[end])) --end;
    return {begin, end};
}

ShownLine shown_line(std::string_view line, int column) {
    const std::size_t caret =
        std::min(static_cast<std::size_t>(std::max(column, 1) - 1), line.size());
    const auto [begin, end] = window(line, caret);
    const bool cut_before = line.find_first_not_of(" \t") < begin;
    ShownLine shown{cut_before ? "..." : "", 0};
    std::size_t characters = shown.text.size();
    for (std::size_t at = begin; at < end;) {
        if (at <= caret) shown.caret = characters;
        const std::size_t length = printable_length(line, at);
        if (line[at] == '\t') {
            shown.text += ' ';
        } else if (length == 0) {
            shown.text += '?';
        } else {
            shown.text += line.substr(at, length);
        }
        at += std::max<std::size_t>(length, 1);
        ++characters;
    }
    if (caret >= end) shown.caret = characters;
    if (end < line.size()) shown.text += "...";
    return shown;
}

std::string place_and_line(const Position& position, const std::string& message,
                           const std::vector<SourceFile>& files) {
    if (position.file < 0 || static_cast<std::size_t>(position.file) >= files.size())
        return message;
    const SourceFile& file = files[static_cast<std::size_t>(position.file)];
    const std::string head = fmt::format("{}:{}:{}: {}", printable(file.name, 400), position.line,
                                         position.column, message);
    const std::string_view line = source_line(file.text, position.line);
    if (line.find_first_not_of(" \t") == std::string_view::npos) return head;
    const ShownLine shown = shown_line(line, position.column);
    return fmt::format("{}\n    {}\n    {}^", head, shown.text, std::string(shown.caret, ' '));
}

}  // namespace

void Diagnostics::error(const Position& position, const std::string& message) {
    if (full()) {
        more_errors_ = true;
        return;
    }
    entries_.push_back({position, message, true});
    ++errors_;
}

void Diagnostics::warning(const Position& position, const std::string& message) {
    if (warnings_ >= warning_limit) {
        more_warnings_ = true;
        return;
    }
    entries_.push_back({position, message, false});
    ++warnings_;
}

std::string Diagnostics::text(const std::vector<SourceFile>& files) const {
    return format(files, true);
}

std::string Diagnostics::warnings_text(const std::vector<SourceFile>& files) const {
    return format(files, false);
}

std::string Diagnostics::format(const std::vector<SourceFile>& files, bool errors_too) const {
    std::vector<std::string> parts;
    for (const Entry& entry : entries_) {
        if (entry.is_error && !errors_too) continue;
        const char* kind = entry.is_error ? "error: " : "warning: ";
        parts.push_back(place_and_line(entry.position, kind + entry.message, files));
    }
    if (more_warnings_)
        parts.push_back(fmt::format("... and more than {} warnings", warning_limit));
    if (more_errors_ && errors_too)
        parts.push_back(fmt::format("... and more: stopped after {} errors", error_limit));
    return fmt::format("{}", fmt::join(parts, "\n"));
}

void Diagnostics::append(const Diagnostics& other) {
    for (const Entry& entry : other.entries_) {
        if (entry.is_error) {
            error(entry.position, entry.message);
        } else {
            warning(entry.position, entry.message);
        }
    }
    more_errors_ = more_errors_ || other.more_errors_;
    more_warnings_ = more_warnings_ || other.more_warnings_;
}

void Diagnostics::throw_if_errors(const std::vector<SourceFile>& files) const {
    if (!has_errors()) return;
    std::vector<Mistake> mistakes;
    for (const Entry& entry : entries_) {
        if (!entry.is_error) continue;
        const Position& at = entry.position;
        const bool known = at.file >= 0 && static_cast<std::size_t>(at.file) < files.size();
        mistakes.push_back({known ? files[static_cast<std::size_t>(at.file)].name : "", at.line,
                            at.column, entry.message});
    }
    throw Error(ErrorKind::scene, text(files), std::move(mistakes));
}

}  // namespace pxm::host
