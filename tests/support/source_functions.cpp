#include "tests/support/source_functions.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <set>
#include <string_view>

namespace pxm::test {

namespace {

struct Token {
    std::string text;  // of a string or a character: its first quote
    int line;
};

bool is_word(const std::string& text) {
    return std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_';
}

bool continues_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// A source as tokens: words, numbers, `::`, `->`, and single characters.
class Lexer {
  public:
    explicit Lexer(std::string_view text) : text_(text) {}

    std::vector<Token> tokens() {
        while (at_ < text_.size()) step();
        return std::move(tokens_);
    }

  private:
    [[nodiscard]] bool starts_with(std::string_view with) const {
        return text_.substr(at_).starts_with(with);
    }
    void step() {
        const char c = text_[at_];
        if (c == '\n') line_has_token_ = false;
        if (std::isspace(static_cast<unsigned char>(c)) != 0) return skip(1);
        if (starts_with("//")) return skip_to("\n", 0);
        if (starts_with("/*")) return skip_to("*/", 2);
        if (c == '#' && !line_has_token_) return skip_directive();
        line_has_token_ = true;
        if (starts_with("R\"")) return take_raw_string();
        if (c == '"' || c == '\'') return take_quoted(c);
        if (continues_word(c)) return take_word(std::isdigit(static_cast<unsigned char>(c)) != 0);
        take(starts_with("::") || starts_with("->") ? 2 : 1);
    }
    void skip(std::size_t count) {
        const std::string_view skipped = text_.substr(at_, count);
        line_ += static_cast<int>(std::ranges::count(skipped, '\n'));
        at_ += skipped.size();
    }
    void skip_to(std::string_view end, std::size_t and_more) {
        const std::size_t found = text_.find(end, at_);
        skip(found == std::string_view::npos ? text_.size() - at_ : found - at_ + and_more);
    }
    void skip_directive() {
        while (at_ < text_.size() && text_[at_] != '\n') skip(starts_with("\\\n") ? 2 : 1);
    }
    void take(std::size_t count) {
        tokens_.push_back({std::string(text_.substr(at_, count)), line_});
        skip(count);
    }
    void take_raw_string() {
        const std::size_t open = text_.find('(', at_);
        std::string end(1, ')');
        end += text_.substr(at_ + 2, open - at_ - 2);
        end += '"';
        tokens_.push_back({"\"", line_});
        skip_to(end, end.size());
    }
    void take_quoted(char quote) {
        tokens_.push_back({std::string(1, quote), line_});
        skip(1);
        while (at_ < text_.size() && text_[at_] != quote) skip(text_[at_] == '\\' ? 2 : 1);
        skip(1);
    }
    void take_word(bool number) {
        std::size_t end = at_;
        const auto more = [&](char c) {
            return continues_word(c) || (number && (c == '\'' || c == '.'));
        };
        while (end < text_.size() && more(text_[end])) ++end;
        take(end - at_);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    bool line_has_token_ = false;
    std::vector<Token> tokens_;
};

using Tokens = std::vector<Token>;

/// Index of the bracket that closes the one at `open`; the number of tokens if none does.
std::size_t closing(const Tokens& tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const char c = tokens[i].text[0];
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        if (depth == 0) return i;
    }
    return tokens.size();
}

/// What commas part between two brackets. A `<` behind a word opens arguments of a template.
std::vector<Tokens> parts_between(const Tokens& tokens, std::size_t open, std::size_t close) {
    std::vector<Tokens> parts;
    if (open + 1 >= close) return parts;
    parts.emplace_back();
    int depth = 0, angles = 0;
    for (std::size_t i = open + 1; i < close; ++i) {
        const std::string& text = tokens[i].text;
        const char c = text[0];
        if (c == '(' || c == '[' || c == '{') ++depth;
        if (c == ')' || c == ']' || c == '}') --depth;
        if (depth == 0 && c == '<' && is_word(tokens[i - 1].text)) ++angles;
        if (depth == 0 && c == '>' && angles > 0) --angles;
        if (c == ',' && depth == 0 && angles == 0) {
            parts.emplace_back();
        } else {
            parts.back().push_back(tokens[i]);
        }
    }
    return parts;
}

/// A type and a name: words, and marks that expressions do not have between their words.
bool is_parameter(const Tokens& part) {
    static const std::set<std::string> of_types{"::", "<", ">", "&", "*", ",", "[", "]", "."};
    std::size_t end = 0;  // of what stands before a default
    while (end < part.size() && part[end].text != "=") ++end;
    if (end < 2 || !is_word(part[0].text)) return false;
    for (std::size_t i = 0; i < end; ++i) {
        const std::string& text = part[i].text;
        const bool number = std::isdigit(static_cast<unsigned char>(text[0])) != 0;
        const bool member = text == "." && (i == 0 || part[i - 1].text != ".") &&
                            (i + 1 == end || part[i + 1].text != ".");  // not an ellipsis
        if (member || !(is_word(text) || number || of_types.contains(text))) return false;
    }
    const std::string& last = part[end - 1].text;
    if (last == "&" || last == "*" || last == "]") return true;
    const std::string& before = part[end - 2].text;
    return is_word(last) &&
           (is_word(before) || before == ">" || before == "&" || before == "*" || before == ".");
}

bool takes_no_parameters(const std::string& word) {
    static const std::set<std::string> words{
        "if",       "for",     "while",     "switch",    "catch",    "return",
        "sizeof",   "throw",   "constexpr", "decltype",  "noexcept", "static_assert",
        "requires", "alignas", "new",       "co_return", "typeid",   "alignof"};
    return words.contains(word);
}

/// Index of the brace that opens the body of a function whose list ends at `close`; 0 if there is
/// none.
std::size_t body_behind(const Tokens& tokens, std::size_t close, bool of_parameters) {
    static const std::set<std::string> marks{"::", "<", ">", "&", "*", ",", "->"};
    bool result = false;  // behind an arrow
    for (std::size_t i = close + 1; i < tokens.size(); ++i) {
        const std::string& text = tokens[i].text;
        if (text == "{") return i;
        if (text == "->") result = true;
        if (text == ":" && of_parameters) {  // members are initialized
            while (++i < tokens.size() && tokens[i].text != ";") {
                const std::string& next = tokens[i].text;
                const std::string& before = tokens[i - 1].text;
                if (next == "{" && !is_word(before) && before != ">") return i;
                if (next == "(" || next == "{") i = closing(tokens, i);
            }
            return 0;
        }
        if (text == "(" && tokens[i - 1].text == "noexcept") {
            i = closing(tokens, i);
        } else if (!is_word(text) && !(result && marks.contains(text))) {
            return 0;
        }
    }
    return 0;
}

}  // namespace

std::vector<SourceFunction> functions_of(const std::string& text) {
    const Tokens tokens = Lexer(text).tokens();
    std::vector<SourceFunction> found;
    for (std::size_t open = 1; open < tokens.size(); ++open) {
        const Token& name = tokens[open - 1];
        const bool lambda = name.text == "]";
        if (tokens[open].text != "(" || (!lambda && !is_word(name.text))) continue;
        if (takes_no_parameters(name.text)) continue;
        const std::size_t close = closing(tokens, open);
        if (close == tokens.size()) break;
        const std::vector<Tokens> parts = parts_between(tokens, open, close);
        const bool of_parameters = std::ranges::all_of(parts, is_parameter);
        const std::size_t body = body_behind(tokens, close, of_parameters);
        if (body == 0 && (!of_parameters || parts.empty())) continue;
        const std::size_t end = body == 0 ? close : closing(tokens, body);
        const int last = end < tokens.size() ? tokens[end].line : name.line;
        found.push_back({lambda ? "lambda" : name.text, name.line, static_cast<int>(parts.size()),
                         body == 0 ? 0 : last - name.line + 1});
    }
    return found;
}

}  // namespace pxm::test
