#include "host/import/fractint_l.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/scene/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::string_view turtle_commands = "+-|![]@\\/<>";
constexpr std::size_t longest_word = 65'536;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads the statements of one entry. A statement is `Angle n`, `Axiom s` or `X=s`; a string goes
/// on to the end of the line or to the next statement.
class EntryReader {
  public:
    EntryReader(FractintReader& reader, FractintL& l) : reader_(reader), l_(l) {}

    void read() {
        for (;;) {
            reader_.skip_blanks();
            if (reader_.at_end() || reader_.at_head()) return unclosed();
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
        const std::string_view word = reader_.word();
        const std::string_view head = word.substr(0, word.find('='));
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

    bool rule(const Position& place) {
        const char symbol = reader_.peek();
        const std::string_view word = reader_.word();
        if (word.find('=') != std::string_view::npos && word.find('=') > 1) {
            error(place, fmt::format("'{}' is replaced only in a context: rules X=string alone "
                                     "have an exact system",
                                     printable(word.substr(0, word.find('=')))));
            return false;
        }
        if (!word.empty()) reader_.take();
        if (word.empty() || !equals()) {
            error(place, fmt::format("expected 'Angle', 'Axiom', a rule X=string or '}}', found "
                                     "'{}'",
                                     word.empty() ? "{" : printable(word)));
            return false;
        }
        if (turtle_commands.find(symbol) != std::string_view::npos) {
            error(place, fmt::format("'{}' moves the turtle: a rule cannot replace it", symbol));
        }
        add_rule(lower(symbol), string(place));
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
        const std::string_view word = reader_.word();
        const std::string_view head = word.substr(0, word.find('='));
        return head.size() < word.size() || same_word(head, "angle") || same_word(head, "axiom");
    }

    FractintWord string(const Position& position) {
        FractintWord word;
        word.position = position;
        for (reader_.skip_blanks_in_line(); !reader_.word().empty() && !at_statement();
             reader_.skip_blanks_in_line()) {
            for (std::size_t rest = reader_.word().size(); rest > 0; --rest) {
                word.places.push_back(reader_.position());
                word.text += lower(reader_.take());
            }
        }
        if (word.text.size() > longest_word)
            error(position, fmt::format("a string of more than {} characters", longest_word));
        return word;
    }

    FractintReader& reader_;
    FractintL& l_;
};

/// Turns a string into turtle commands.
class WordCompiler {
  public:
    WordCompiler(FractintL& l, const FractintWord& word) : l_(l), word_(word) {}

    std::vector<TurtleCommand> compile() {
        while (place_ < word_.text.size()) command(word_.text[place_]);
        if (!open_.empty()) error(open_.back(), "'[' without its ']'");
        return std::move(commands_);
    }

  private:
    void error(std::size_t place, const std::string& message) {
        l_.entry.diagnostics.error(word_.places[place], message);
    }
    void add(TurtleOp op, double value = 0, char symbol = 0) {
        commands_.push_back({op, symbol, value});
    }

    void command(char c) {
        const std::size_t start = place_++;
        if (c == '+' || c == '-') return add(TurtleOp::turn, (c == '+' ? 1 : -1) * step(start));
        if (c == '\\' || c == '/')
            return add(TurtleOp::turn, (c == '\\' ? 1 : -1) * number(start, "degrees"));
        if (c == '|') return round(start);
        if (c == '!') return add(TurtleOp::flip);
        if (c == '@') return step_factor(start);
        if (c == '[' || c == ']') return bracket(c, start);
        if (c == '<' || c == '>' || (c == 'c' && !l_.rules.contains('c'))) return skip_digits();
        if (c <= ' ' || c > '~') return error(start, "a character that is not printable ASCII");
        add(TurtleOp::symbol, 0, c);
    }

    double step(std::size_t start) {
        if (!l_.angle) error(start, "a turn, but the entry has no 'Angle'");
        return 360 / l_.angle.value_or(1);
    }

    /// With an odd angle number the largest turn below 180 degrees, to the right.
    void round(std::size_t start) {
        const double n = l_.angle.value_or(2);
        const double steps = std::floor(n / 2);
        if (2 * steps == n) return add(TurtleOp::round, 180);
        (void)start;
        uneven_round_ = true;
        add(TurtleOp::round, -steps * 360 / n);
    }

    void bracket(char c, std::size_t start) {
        if (c == '[') {
            open_.push_back(start);
        } else if (open_.empty()) {
            return error(start, "']' without its '['");
        } else {
            open_.pop_back();
        }
        add(c == '[' ? TurtleOp::push : TurtleOp::pop);
    }

    void skip_digits() {
        while (place_ < word_.text.size() && is_digit(word_.text[place_])) ++place_;
    }

    double number(std::size_t start, std::string_view what) {
        const std::size_t begin = place_;
        skip_digits();
        if (place_ < word_.text.size() && word_.text[place_] == '.') {
            ++place_;
            skip_digits();
        }
        double value = 0;
        if (!read_number(std::string_view(word_.text).substr(begin, place_ - begin), value))
            error(start, fmt::format("'{}' needs a number: {}", word_.text[start], what));
        return value;
    }

    /// @n, @In, @Qn, @IQn: inverse, square root.
    void step_factor(std::size_t start) {
        bool inverse = false;
        bool root = false;
        for (; place_ < word_.text.size(); ++place_) {
            if (word_.text[place_] == 'i') {
                inverse = !inverse;
            } else if (word_.text[place_] == 'q') {
                root = true;
            } else {
                break;
            }
        }
        double factor = number(start, "the factor of the step");
        if (!(factor > 0)) {
            error(start, "the factor of the step must be greater than 0");
            factor = 1;
        }
        if (root) factor = std::sqrt(factor);
        add(TurtleOp::step, inverse ? 1 / factor : factor);
    }

  public:
    [[nodiscard]] bool uneven_round() const { return uneven_round_; }

  private:
    FractintL& l_;
    const FractintWord& word_;
    std::vector<TurtleCommand> commands_;
    std::vector<std::size_t> open_;
    std::size_t place_ = 0;
    bool uneven_round_ = false;
};

}  // namespace

std::vector<FractintL> parse_fractint_l(std::string_view text, Diagnostics& diagnostics) {
    std::vector<FractintL> list;
    FractintReader reader(text);
    for (reader.skip_blanks(); !reader.at_end() && !diagnostics.full(); reader.skip_blanks()) {
        FractintL l;
        if (!reader.head(l.entry, diagnostics)) {
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

Lsystem lsystem_of(FractintL& l) {
    Lsystem lsystem;
    lsystem.name = l.entry.name;
    lsystem.step_degrees = l.angle ? 360 / *l.angle : 0;
    bool uneven_round = false;
    bool flips = false;
    const auto compiled = [&](const FractintWord& word) {
        WordCompiler compiler(l, word);
        auto commands = compiler.compile();
        uneven_round = uneven_round || compiler.uneven_round();
        flips = flips || word.text.find('!') != std::string::npos;
        return commands;
    };
    if (l.axiom) lsystem.axiom = compiled(*l.axiom);
    for (const auto& [symbol, word] : l.rules) lsystem.rules[symbol] = compiled(word);
    if (uneven_round && flips)
        l.entry.diagnostics.error(l.entry.position,
                                  "'|' of an odd angle is not mirrored by '!': such an L-system "
                                  "has no exact linear fractal");
    return lsystem;
}

}  // namespace pxm::host
