#include "host/import/aifs/aifs_text.hpp"

#include <fmt/format.h>

#include <utility>

#include "host/import/fractint/fractint_reader.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr int deepest = 200;  // parentheses and brackets inside one another

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

/// A place in the text; copies look ahead.
class Cursor {
  public:
    explicit Cursor(std::string_view text, const Position& begin = {})
        : text_(text), position_(begin) {
        if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    }
    [[nodiscard]] bool at_end() const { return place_ >= text_.size(); }
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return place_ + ahead < text_.size() ? text_[place_ + ahead] : '\0';
    }
    [[nodiscard]] const Position& position() const { return position_; }
    char take() {
        const char c = text_[place_++];
        ++position_.column;
        if (c == '\n') {
            ++position_.line;
            position_.column = 1;
        }
        return c;
    }
    /// Blanks, ends of lines and comments.
    void skip() {
        while (!at_end()) {
            if (peek() == '#') {
                while (!at_end() && peek() != '\n') take();
            } else if (is_blank(peek()) || peek() == '\n') {
                take();
            } else {
                return;
            }
        }
    }
    /// The rest of the line without its comment and the blanks around it.
    std::string line() {
        std::string rest;
        while (!at_end() && peek() != '\n' && peek() != '#') rest += take();
        while (!at_end() && peek() != '\n') take();
        while (!rest.empty() && is_blank(rest.back())) rest.pop_back();
        const std::size_t begin = rest.find_first_not_of(" \t\r");
        return begin == std::string::npos ? "" : rest.substr(begin);
    }
    /// A word: letters, digits and _, with a $ or & in front; empty if none is here.
    std::string word() {
        std::string name;
        if ((peek() == '$' || peek() == '&') && is_word(peek(1))) name += take();
        while (!at_end() && is_word(peek())) name += take();
        return name;
    }

  private:
    std::string_view text_;
    std::size_t place_ = 0;
    Position position_;
};

struct SyntaxMistake {
    Position position;
    std::string message;
};

/// Reads expressions; the first mistake is thrown as SyntaxMistake.
class ExpressionParser {
  public:
    /// `left` is how many numbers and names the file may still have.
    ExpressionParser(Cursor& cursor, std::size_t& left) : cursor_(cursor), left_(left) {}

    AifsExpression unite() {
        return chain(AifsOp::unite, "|", [this] { return sum(); });
    }

  private:
    [[noreturn]] void expected(const std::string& what) const {
        throw SyntaxMistake{cursor_.position(),
                            cursor_.at_end()
                                ? fmt::format("expected {}, found the end of the file", what)
                                : fmt::format("expected {}, found '{}'", what,
                                              printable(std::string(1, cursor_.peek())))};
    }

    template <class Part>
    AifsExpression chain(AifsOp op, std::string_view signs, const Part& part) {
        AifsExpression first = part();
        cursor_.skip();
        if (cursor_.at_end() || signs.find(cursor_.peek()) == std::string_view::npos) return first;
        AifsExpression whole;
        whole.op = op;
        whole.position = first.position;
        whole.parts.push_back(std::move(first));
        whole.signs += signs.front();
        while (!cursor_.at_end() && signs.find(cursor_.peek()) != std::string_view::npos) {
            whole.signs += cursor_.take();
            whole.parts.push_back(part());
            cursor_.skip();
        }
        return whole;
    }

    AifsExpression sum() {
        return chain(AifsOp::sum, "+-", [this] { return product(); });
    }
    AifsExpression product() {
        return chain(AifsOp::product, "*/%", [this] { return signed_power(); });
    }

    AifsExpression signed_power() {
        cursor_.skip();
        if (cursor_.peek() != '-' && cursor_.peek() != '+') return power();
        const Nested nested(*this);
        AifsExpression negative;
        negative.position = cursor_.position();
        if (cursor_.take() == '+') return signed_power();
        negative.op = AifsOp::negative;
        negative.parts.push_back(signed_power());
        return negative;
    }

    /// a^-1 binds stronger than the sign and the product; a^b^c is a^(b^c).
    AifsExpression power() {
        AifsExpression base = indexed();
        cursor_.skip();
        if (cursor_.peek() != '^') return base;
        const Nested nested(*this);
        AifsExpression whole;
        whole.op = AifsOp::power;
        whole.position = cursor_.position();
        cursor_.take();
        whole.parts.push_back(std::move(base));
        whole.parts.push_back(signed_power());
        return whole;
    }

    AifsExpression indexed() {
        AifsExpression value = primary();
        for (int depth = depth_;; cursor_.skip()) {
            cursor_.skip();
            if (cursor_.peek() == '.' && !is_digit(cursor_.peek(1)))
                throw SyntaxMistake{cursor_.position(), "a field of a block ('.') is not taken"};
            if (cursor_.peek() != '[' || ++depth > deepest) break;
            AifsExpression whole;
            whole.op = AifsOp::index;
            whole.position = cursor_.position();
            cursor_.take();
            whole.parts.push_back(std::move(value));
            const Nested nested(*this);
            whole.parts.push_back(unite());
            close(']');
            value = std::move(whole);
        }
        return value;
    }

    AifsExpression primary() {
        cursor_.skip();
        if (left_ == 0)
            throw SyntaxMistake{
                cursor_.position(),
                fmt::format("more than {} numbers and names in a file", most_aifs_parts)};
        --left_;
        AifsExpression value;
        value.position = cursor_.position();
        if (cursor_.peek() == '(') {
            const Nested nested(*this);
            cursor_.take();
            value = unite();
            close(')');
            return value;
        }
        if (cursor_.peek() == '[') {
            value.op = AifsOp::vector;
            cursor_.take();
            value.parts = list(']');
            return value;
        }
        if (is_digit(cursor_.peek()) || cursor_.peek() == '.') return number();
        value.op = AifsOp::name;
        value.name = cursor_.word();
        if (value.name.empty()) expected("a number, a name, '[' or '('");
        cursor_.skip();
        if (cursor_.peek() != '(') return value;
        value.op = AifsOp::call;
        cursor_.take();
        value.parts = list(')');
        return value;
    }

    std::vector<AifsExpression> list(char end) {
        const Nested nested(*this);
        std::vector<AifsExpression> parts;
        cursor_.skip();
        while (cursor_.peek() != end) {
            parts.push_back(unite());
            cursor_.skip();
            if (cursor_.peek() != ',') break;
            cursor_.take();
            cursor_.skip();
        }
        close(end);
        return parts;
    }

    void close(char end) {
        cursor_.skip();
        if (cursor_.peek() != end) expected(fmt::format("'{}'", end));
        cursor_.take();
    }

    AifsExpression number() {
        AifsExpression value;
        value.position = cursor_.position();
        std::string text;
        while (is_digit(cursor_.peek()) || cursor_.peek() == '.') text += cursor_.take();
        const char sign = cursor_.peek(1);
        const bool exponent =
            (cursor_.peek() == 'e' || cursor_.peek() == 'E') &&
            (is_digit(sign) || ((sign == '-' || sign == '+') && is_digit(cursor_.peek(2))));
        if (exponent) {
            text += cursor_.take();
            if (!is_digit(sign)) text += cursor_.take();
            while (is_digit(cursor_.peek())) text += cursor_.take();
        }
        if (!read_number(text, value.number))
            throw SyntaxMistake{value.position, fmt::format("'{}' is no number that can be taken",
                                                            printable(text))};
        return value;
    }

    /// One level deeper while it lives.
    struct Nested {
        explicit Nested(ExpressionParser& p) : parser(p) {
            if (++parser.depth_ > deepest)
                throw SyntaxMistake{
                    parser.cursor_.position(),
                    fmt::format("more than {} parentheses inside one another", deepest)};
        }
        ~Nested() { --parser.depth_; }
        Nested(const Nested&) = delete;
        Nested& operator=(const Nested&) = delete;
        ExpressionParser& parser;
    };

    Cursor& cursor_;
    std::size_t& left_;
    int depth_ = 0;
};

bool is_text(std::string_view name) { return name == "$n" || name == "$a"; }

/// `$subspace=s 0 1`, as older files have it, is `$subspace=[s,0,1]`.
std::string with_commas(std::string text) {
    if (text.empty() || text.front() == '[') return text;
    std::string list = "[";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool gap = is_blank(text[i]);
        if (gap && list.back() != ',') list += ',';
        if (!gap) list += text[i];
    }
    return list + "]";
}

class BlockParser {
  public:
    BlockParser(Cursor& cursor, AifsBlock& block, std::size_t& left)
        : cursor_(cursor), block_(block), left_(left) {}

    void read() {
        for (skip_gap(); !cursor_.at_end() && cursor_.peek() != '@'; skip_gap()) {
            try {
                definition();
            } catch (const SyntaxMistake& mistake) {
                block_.diagnostics.error(mistake.position, mistake.message);
                skip_block();
            }
        }
    }

  private:
    /// Between definitions a semicolon is one more blank.
    void skip_gap() {
        for (cursor_.skip(); cursor_.peek() == ';'; cursor_.skip()) cursor_.take();
    }

    void definition() {
        AifsDefinition definition;
        definition.position = cursor_.position();
        definition.name = cursor_.word();
        cursor_.skip();
        if (definition.name.empty() || cursor_.peek() != '=')
            throw SyntaxMistake{definition.name.empty() ? cursor_.position() : definition.position,
                                "expected a definition, name = value"};
        cursor_.take();
        if (definition.name.front() == '&') definition.name.erase(0, 1);  // computed at every use
        if (is_text(definition.name)) {
            definition.text = cursor_.line();
        } else if (definition.name == "$subspace") {
            const Position place = cursor_.position();
            const std::string list = with_commas(cursor_.line());
            Cursor inside(list);
            definition.value = ExpressionParser(inside, left_).unite();
            move_to(definition.value, place);
        } else {
            definition.value = ExpressionParser(cursor_, left_).unite();
        }
        block_.definitions.push_back(std::move(definition));
    }

    static void move_to(AifsExpression& value, const Position& place) {
        value.position = place;
        for (AifsExpression& part : value.parts) move_to(part, place);
    }

    /// To the next line that begins a block.
    void skip_block() {
        while (!cursor_.at_end() && cursor_.peek() != '@') {
            while (!cursor_.at_end() && cursor_.peek() != '\n') cursor_.take();
            cursor_.skip();
        }
    }

    Cursor& cursor_;
    AifsBlock& block_;
    std::size_t& left_;
};

/// What begins with @@: lines for the program that reads the file.
void read_directive(Cursor& cursor, Diagnostics& diagnostics) {
    const Position place = cursor.position();
    const std::string line = cursor.line();
    if (line == "@@" || line.starts_with("@@version")) return;
    diagnostics.error(place, fmt::format("'{}': only the file itself is read; put what it names "
                                         "into it",
                                         printable(line)));
}

}  // namespace

std::string AifsBlock::text_of(std::string_view name) const {
    std::string text;
    for (const AifsDefinition& definition : definitions)
        if (definition.name == name) text = definition.text;
    return text;
}

std::vector<AifsBlock> parse_aifs(std::string_view text, Diagnostics& diagnostics) {
    std::size_t left = most_aifs_parts;
    return parse_aifs_part(text, {}, left, diagnostics);
}

std::vector<AifsBlock> parse_aifs_part(std::string_view text, const Position& begin,
                                       std::size_t& left, Diagnostics& diagnostics) {
    std::vector<AifsBlock> blocks;
    Cursor cursor(text, begin);
    cursor.skip();
    if (!cursor.at_end() && cursor.peek() != '@') {
        diagnostics.error(cursor.position(),
                          "expected '@', the begin of a block (programs in JavaScript before the "
                          "first block are not run)");
        return blocks;
    }
    for (; !cursor.at_end() && !diagnostics.full(); cursor.skip()) {
        if (cursor.peek(1) == '@') {
            read_directive(cursor, diagnostics);
            continue;
        }
        AifsBlock block;
        block.position = cursor.position();
        cursor.take();
        const std::string head = cursor.line();
        const std::size_t colon = std::min(head.find(':'), head.size());
        block.id = head.substr(0, colon);
        if (colon < head.size()) block.parent = head.substr(colon + 1);
        BlockParser(cursor, block, left).read();
        if (left == 0 && block.diagnostics.has_errors()) {
            diagnostics.append(block.diagnostics);
            return blocks;
        }
        blocks.push_back(std::move(block));
    }
    return blocks;
}

}  // namespace pxm::host
