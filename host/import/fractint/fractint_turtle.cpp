// The strings of a FRACTINT L-system as turtle commands.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/import/fractint/fractint_l.hpp"

namespace pxm::host {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Turns a string into turtle commands.
class WordCompiler {
  public:
    WordCompiler(FractintL& l, const FractintWord& word) : l_(l), word_(word) {}

    std::vector<TurtleCommand> compile() {
        while (place_ < word_.text.size()) command(word_.text[place_]);
        if (!open_.empty()) error(open_.back(), "'[' without its ']'");
        return std::move(commands_);
    }
    [[nodiscard]] bool uneven_round() const { return uneven_round_; }

  private:
    void error(std::size_t place, const std::string& message) {
        l_.entry.diagnostics.error(word_.places[place], message);
    }
    void add(TurtleOp op, double value = 0, char symbol = 0) {
        commands_.push_back({op, symbol, value, {}});
    }

    void command(char c) {
        const std::size_t start = place_++;
        if (is_in_space(l_)) return space_command(c, start);
        if (c == '+' || c == '-') return turn(c == '+' ? 1 : -1, start);
        if (c == '\\' || c == '/')
            return add(TurtleOp::turn_degrees,
                       (c == '\\' ? 1 : -1) * number(start, "degrees").value);
        if (c == '|') return round();
        if (c == '!') return add(TurtleOp::flip);
        if (c == '@') return step_factor(start);
        if (c == '[' || c == ']') return bracket(c, start);
        if (c == '<' || c == '>' || (c == 'c' && !l_.rules.contains('c'))) return skip_digits();
        if (c <= ' ' || c > '~') return error(start, "a character that is not printable ASCII");
        add(TurtleOp::symbol, 0, c);
    }

    /// [ABOP]'s. Widths and colours (! ' ") say nothing of a place.
    void space_command(char c, std::size_t start) {
        switch (c) {
            case '+':
            case '-':
                return space_turn(TurtleOp::turn, c == '+' ? 1 : -1, start);
            case '&':
            case '^':
                return space_turn(TurtleOp::pitch, c == '&' ? 1 : -1, start);
            case '\\':
            case '/':
                return space_turn(TurtleOp::roll, c == '\\' ? 1 : -1, start);
            case '|':
                return add(TurtleOp::round);
            case '[':
            case ']':
                return bracket(c, start);
            case '@':
                return step_factor(start);
            case '!':
            case '\'':
            case '"':
                return;
            case '$':
                return error(start,
                             "'$' turns the turtle to the horizon, wherever it is: such an "
                             "L-system has no exact linear fractal");
            case '%':
                return error(start,
                             "'%' cuts off what comes after it: such an L-system has no "
                             "exact linear fractal");
            case '(':
                return error(start, "parameters: only turns take a number in parentheses");
            default:
                if (c <= ' ' || c > '~')
                    return error(start, "a character that is not printable ASCII");
                return add(TurtleOp::symbol, 0, c);
        }
    }

    /// By the entry's angle, or by the degrees in parentheses.
    void space_turn(TurtleOp op, int sign, std::size_t start) {
        TurtleCommand command{op, 0, static_cast<double>(sign), {}};
        if (place_ < word_.text.size() && word_.text[place_] == '(') {
            const std::size_t close = std::min(word_.text.find(')', place_), word_.text.size());
            std::string degrees = word_.text.substr(place_ + 1, close - place_ - 1);
            double value = 0;
            if (close == word_.text.size() || !read_number(degrees, value) || std::abs(value) > 360)
                error(start,
                      fmt::format("'{}(' needs a number of degrees and ')'", word_.text[start]));
            if (degrees.starts_with('+')) degrees.erase(0, 1);
            if (degrees.starts_with('-')) {
                degrees.erase(0, 1);
                command.value = -command.value;
            }
            command.factor.decimal = degrees.empty() ? "0" : degrees;
            place_ = std::min(close + 1, word_.text.size());
        } else if (!l_.angle) {
            error(start, "a turn, but the entry has neither 'Degrees' nor 'Angle'");
        }
        commands_.push_back(std::move(command));
    }

    void turn(int steps, std::size_t start) {
        if (!l_.angle) error(start, "a turn, but the entry has no 'Angle'");
        add(TurtleOp::turn, steps);
    }

    /// With an odd angle number the largest turn below 180 degrees, to the right.
    void round() {
        const double n = l_.angle.value_or(2);
        const double steps = std::floor(n / 2);
        if (2 * steps == n) return add(TurtleOp::round, steps);
        uneven_round_ = true;
        add(TurtleOp::round, -steps);
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

    struct Number {
        double value = 0;
        std::string decimal;  // as it is written
    };

    Number number(std::size_t start, std::string_view what) {
        const std::size_t begin = place_;
        skip_digits();
        if (place_ < word_.text.size() && word_.text[place_] == '.') {
            ++place_;
            skip_digits();
        }
        Number number;
        number.decimal = word_.text.substr(begin, place_ - begin);
        if (!read_number(number.decimal, number.value))
            error(start, fmt::format("'{}' needs a number: {}", word_.text[start], what));
        return number;
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
        const Number factor = number(start, "the factor of the step");
        if (!(factor.value > 0)) error(start, "the factor of the step must be greater than 0");
        commands_.push_back({TurtleOp::step, 0, 0, {factor.decimal, inverse, root}});
    }

    FractintL& l_;
    const FractintWord& word_;
    std::vector<TurtleCommand> commands_;
    std::vector<std::size_t> open_;
    std::size_t place_ = 0;
    bool uneven_round_ = false;
};

}  // namespace

Lsystem lsystem_of(FractintL& l) {
    Lsystem lsystem;
    lsystem.name = l.entry.name;
    lsystem.steps_a_turn = l.angle.value_or(2);
    lsystem.in_space = is_in_space(l);
    lsystem.degrees = l.degrees;
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
