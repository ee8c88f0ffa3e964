#include "host/import/fractint/fractint_l.hpp"

#include <fmt/format.h>

#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::string_view turtle_commands = "+-|![]@\\/<>";
constexpr std::string_view space_commands = "+-|![]@\\/&^$%'\"";
constexpr std::size_t longest_word = 65'536;

/// Reads the statements of one entry. A statement is `Angle n`, `Axiom s` or `X=s`; a string goes
/// on to the end of the line or to the next statement.
class EntryReader {
  public:
    EntryReader(FractintReader& reader, FractintL& l) : reader_(reader), l_(l) {}

    void read() {
        for (;;) {
            reader_.skip_blanks();
            const bool bare = l_.entry.name.empty();
            if (reader_.at_end() || reader_.at_head()) return bare ? void() : unclosed();
            if (reader_.peek() == '}') {
                reader_.take();
                return;
            }
            if (!statement()) return reader_.skip_entry();
        }
    }

  private:
    void error(const Position& position, const std::string& message) {
        l_.entry.diagnostics.error(position, message);
    }
    void unclosed() {
        error(l_.entry.position,
              fmt::format("entry \"{}\" has no closing '}}'", printable(l_.entry.name)));
    }

    bool statement() {
        const Position place = reader_.position();
        if (starts("angle")) return angle(place);
        if (is_in_space(l_) && starts("degrees")) return degrees(place);
        if (starts("axiom")) {
            FractintWord word = string(place);
            if (l_.axiom) error(place, "a second axiom");
            if (word.text.empty()) error(place, "the axiom is empty");
            l_.axiom = std::move(word);
            return true;
        }
        return rule(place);
    }

    /// Takes the keyword, and '=' after it, if that is what stands here.
    bool starts(std::string_view keyword) {
        const std::string_view head = word_before_equals();
        if (!same_word(head, keyword)) return false;
        for (std::size_t i = 0; i < head.size(); ++i) reader_.take();
        equals();
        return true;
    }

    bool equals() {
        reader_.skip_blanks_in_line();
        if (reader_.peek() != '=') return false;
        reader_.take();
        reader_.skip_blanks_in_line();
        return true;
    }

    bool angle(const Position& place) {
        const Position number_place = reader_.position();
        const std::string_view word = reader_.word();
        double value = 0;
        if (!read_number(word, value) || !(value >= 1)) {
            error(number_place, fmt::format("'Angle' takes a number n of 1 or more (turns are "
                                            "360/n degrees), not '{}'",
                                            printable(word)));
        } else if (l_.angle) {
            error(place, "a second angle");
        }
        l_.angle = value;
        reader_.take_word();
        return true;
    }

    bool degrees(const Position& place) {
        const Position number_place = reader_.position();
        const std::string_view word = reader_.word();
        double value = 0;
        if (!read_number(word, value) || !(value > 0 && value <= 360)) {
            error(number_place,
                  fmt::format("'Degrees' takes a number above 0 and up to 360, not '{}'",
                              printable(word)));
        } else if (l_.angle) {
            error(place, "a second angle");
        }
        l_.degrees = word;
        l_.angle = value > 0 ? 360 / value : 1;
        reader_.take_word();
        return true;
    }

    /// A small letter, but for a turtle in space: there F draws, f moves, and D and M are letters
    /// like others.
    [[nodiscard]] char symbol_of(char c) const {
        if (!is_in_space(l_)) return lower(c);
        if (c == 'f') return 'g';
        const char small = lower(c);
        return small == 'd' ? 'D' : small == 'm' ? 'M' : small;
    }

    bool rule(const Position& place) {
        const char symbol = reader_.peek();
        const std::string_view word = reader_.word();
        if (const auto head = word_before_equals(); head != word && head.size() > 1) {
            error(place, fmt::format("'{}' is replaced only in a context: rules X=string alone "
                                     "have an exact system",
                                     printable(head)));
            return false;
        }
        if (!word.empty()) reader_.take();
        if (word.empty() || !equals()) {
            error(place, fmt::format("expected 'Angle', 'Axiom', a rule X=string or '}}', found "
                                     "'{}'",
                                     word.empty() ? "{" : printable(word)));
            return false;
        }
        const std::string_view commands = is_in_space(l_) ? space_commands : turtle_commands;
        if (commands.find(symbol) != std::string_view::npos) {
            error(place, fmt::format("'{}' moves the turtle: a rule cannot replace it", symbol));
        }
        add_rule(symbol_of(symbol), string(place));
        return true;
    }

    /// A symbol's strings are joined, as FRACTINT does.
    void add_rule(char symbol, FractintWord word) {
        const auto [rule, added] = l_.rules.emplace(symbol, word);
        if (added) return;
        rule->second.text += word.text;
        rule->second.places.insert(rule->second.places.end(), word.places.begin(),
                                   word.places.end());
    }

    /// True if the word here begins another statement of the same line.
    [[nodiscard]] bool at_statement() const {
        const std::string_view head = word_before_equals();
        return head != reader_.word() || same_word(head, "angle") || same_word(head, "axiom") ||
               (is_in_space(l_) && same_word(head, "degrees"));
    }
    [[nodiscard]] std::string_view word_before_equals() const {
        const std::string_view word = reader_.word();
        return word.substr(0, word.find('='));
    }

    FractintWord string(const Position& position) {
        FractintWord word;
        word.position = position;
        for (reader_.skip_blanks_in_line(); !reader_.word().empty() && !at_statement();
             reader_.skip_blanks_in_line()) {
            for (std::size_t rest = reader_.word().size(); rest > 0; --rest) {
                if (reader_.peek() == '"') {
                    reader_.take();
                    l_.entry.has_quotes = true;
                    continue;
                }
                word.places.push_back(reader_.position());
                word.text += symbol_of(reader_.take());
            }
        }
        if (word.text.size() > longest_word)
            error(position, fmt::format("a string of more than {} characters", longest_word));
        return word;
    }

    FractintReader& reader_;
    FractintL& l_;
};

}  // namespace

namespace {

/// True if an entry begins here that has no name: no text but an L-system begins with these words.
bool at_bare_statement(const FractintReader& reader) {
    const std::string_view word = reader.word();
    const std::string_view head = word.substr(0, word.find('='));
    return (same_word(head, "angle") || same_word(head, "axiom")) && !reader.at_head();
}

}  // namespace

bool is_in_space(const FractintL& l) { return same_word(l.entry.option, "3D"); }

std::vector<FractintL> parse_fractint_l(std::string_view text, Diagnostics& diagnostics) {
    std::vector<FractintL> list;
    FractintReader reader(text);
    for (reader.skip_blanks(); !reader.at_end() && !diagnostics.full(); reader.skip_blanks()) {
        FractintL l;
        l.entry.position = reader.position();
        FractintReader inside = reader;  // of a block without a name
        if (reader.peek() == '{') {
            inside.take();
            inside.skip_blanks();
            if (!at_bare_statement(inside)) {
                reader.skip_comment_entry();
                continue;
            }
        }
        if (at_bare_statement(inside)) {
            reader = inside;
        } else if (!reader.head(l.entry, diagnostics)) {
            if (reader.peek() == '}') reader.take();
            continue;
        }
        if (is_comment_entry(l.entry)) {
            reader.skip_comment_entry();
            continue;
        }
        EntryReader(reader, l).read();
        if (!l.axiom && !l.entry.diagnostics.has_errors())
            l.entry.diagnostics.error(l.entry.position, fmt::format("entry \"{}\" has no 'Axiom'",
                                                                    printable(l.entry.name)));
        list.push_back(std::move(l));
    }
    return list;
}

}  // namespace pxm::host
