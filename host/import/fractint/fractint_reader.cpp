#include "host/import/fractint/fractint_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v' || c == '\x1a';
}
bool ends_word(char c) { return is_blank(c) || c == ';' || c == '{' || c == '}'; }

}  // namespace

FractintReader::FractintReader(std::string_view text) : text_(text) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
}

char FractintReader::take() {
    const char c = peek();
    if (at_end()) return c;
    ++place_;
    ++position_.column;
    if (c == '\n') {
        ++position_.line;
        position_.column = 1;
    }
    return c;
}

void FractintReader::skip_blanks() {
    for (;;) {
        skip_blanks_in_line();
        if (peek() != '\n' || at_end()) return;
        take();
    }
}

void FractintReader::skip_blanks_in_line() {
    while (!at_end() && peek() != '\n' && is_blank(peek())) take();
    if (peek() != ';') return;
    while (!at_end() && peek() != '\n') take();
}

std::string_view FractintReader::word() const {
    std::size_t end = place_;
    while (end < text_.size() && !ends_word(text_[end])) ++end;
    return text_.substr(place_, end - place_);
}

std::string_view FractintReader::take_word() {
    const std::string_view taken = word();
    for (std::size_t i = 0; i < taken.size(); ++i) take();
    return taken;
}

bool FractintReader::at_head() const {
    FractintReader ahead = *this;
    if (ahead.take_word().empty()) return false;
    ahead.skip_blanks();
    if (ahead.peek() == '(') {
        ahead.take_word();
        ahead.skip_blanks();
    }
    return ahead.peek() == '{';
}

void FractintReader::skip_entry() {
    for (skip_blanks(); !at_end(); skip_blanks()) {
        const char c = peek();
        if (c == '}') {
            take();
            return;
        }
        if (c == '{') {
            take();
        } else {
            if (at_head()) return;
            take_word();
        }
    }
}

void FractintReader::skip_comment_entry() {
    while (!at_end() && take() != '}') {
    }
}

bool FractintReader::head(FractintEntry& entry, Diagnostics& diagnostics) {
    entry.position = position();
    std::string name(take_word());
    skip_blanks();
    if (peek() == '(') name += take_word();  // `name (3D) {`
    skip_blanks();
    if (peek() != '{' || name.empty() || name.front() == '(') {
        diagnostics.error(
            entry.position,
            name.empty() ? fmt::format("expected the name of an entry, found '{}'",
                                       printable(std::string(1, peek())))
                         : fmt::format("expected '{{' after the name \"{}\"", printable(name)));
        if (name.empty()) take();
        while (!at_end() && peek() != '}' && !at_head()) {
            peek() == '{' ? void(take()) : void(take_word());
            skip_blanks();
        }
        return false;
    }
    take();
    entry.has_quotes = std::erase(name, '"') > 0;
    const std::size_t open = std::min(name.find('('), name.size());
    entry.name = name.substr(0, open);
    if (open < name.size()) entry.option = name.substr(open + 1, name.find(')') - open - 1);
    return true;
}

bool is_comment_entry(const FractintEntry& entry) { return same_word(entry.name, "comment"); }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same_word(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

bool read_number(std::string_view text, double& value) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ptr != text.data() + text.size() || text.empty()) return false;
    if (result.ec == std::errc::result_out_of_range) {
        const std::size_t exponent = text.find_first_of("eE");
        if (exponent == std::string_view::npos || text[exponent + 1] != '-') return false;
        value = 0;  // too small for a double
        return true;
    }
    return result.ec == std::errc{} && std::isfinite(value);
}

}  // namespace pxm::host
