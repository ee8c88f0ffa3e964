#include "host/import/eisenscript/eisen_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/import/eisenscript/eisen_color.hpp"
#include "host/import/eisenscript/eisen_tokens.hpp"
#include "host/import/fractint/fractint_reader.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr long most_repeats = 100'000'000;

std::string lower_word(std::string_view text) {
    std::string word;
    for (const char c : text) word += lower(c);
    return word;
}

/// The long name of an operator; empty if the word is none.
std::string operator_name(std::string_view text) {
    static const std::map<std::string, std::string, std::less<>> short_names{
        {"md", "maxdepth"},  {"w", "weight"}, {"h", "hue"},  {"b", "brightness"},
        {"v", "brightness"}, {"a", "alpha"},  {"c", "color"}};
    static const std::set<std::string, std::less<>> names{
        "x",     "y",     "z",     "rx",      "ry",       "rz",    "s",
        "fx",    "fy",    "fz",    "matrix",  "hue",      "sat",   "brightness",
        "alpha", "color", "blend", "reflect", "maxdepth", "weight"};
    const std::string word = lower_word(text);
    if (const auto found = short_names.find(word); found != short_names.end()) return found->second;
    return names.contains(word) ? word : "";
}

bool begins_number(std::string_view text) {
    return !text.empty() && std::string_view("+-0123456789.").find(text[0]) != std::string::npos;
}

/// The map about the middle of the unit cube, on the axes that say so.
Affine about_middle(const Affine& map, const glm::dvec3& axes) {
    return then(then(translation(-0.5 * axes), map), translation(0.5 * axes));
}

class EisenParser {
  public:
    EisenParser(std::vector<EisenToken> tokens, Diagnostics& diagnostics)
        : tokens_(std::move(tokens)), diagnostics_(diagnostics) {}

    EisenScript read() {
        while (!at_end() && !diagnostics_.has_errors()) {
            if (lower_word(peek()) == "rule") {
                rule();
            } else if (lower_word(peek()) == "set") {
                setting();
            } else {
                script_.start.push_back(action());
            }
        }
        if (script_.start.empty() && !diagnostics_.has_errors())
            diagnostics_.error({}, "the script places nothing");
        return std::move(script_);
    }

  private:
    [[nodiscard]] bool at_end() const { return place_ >= tokens_.size(); }
    [[nodiscard]] std::string_view peek() const {
        return at_end() ? std::string_view() : std::string_view(tokens_[place_].text);
    }
    [[nodiscard]] Position position() const {
        if (tokens_.empty()) return {};
        return tokens_[std::min(place_, tokens_.size() - 1)].position;
    }
    std::string take() { return at_end() ? std::string() : tokens_[place_++].text; }
    void expected(const std::string& what) {
        if (diagnostics_.has_errors()) return;
        diagnostics_.error(
            position(), at_end() ? fmt::format("expected {}, found the end of the file", what)
                                 : fmt::format("expected {}, found '{}'", what, printable(peek())));
        place_ = tokens_.size();
    }

    double number(const std::string& what) {
        const std::string_view text = peek();
        const std::size_t slash = text.find('/');
        double value = 0;
        double divisor = 1;
        const bool fits = slash == std::string_view::npos
                              ? read_number(text, value)
                              : read_number(text.substr(0, slash), value) &&
                                    read_number(text.substr(slash + 1), divisor) && divisor != 0;
        if (!fits) {
            expected("a number for " + what);
            return 0;
        }
        ++place_;
        return value / divisor;
    }
    long whole(const std::string& what, long most) {
        const Position place = position();
        const double value = number(what);
        if (diagnostics_.has_errors()) return 1;
        if (value != std::round(value) || value < 0 || value > static_cast<double>(most)) {
            diagnostics_.error(place,
                               fmt::format("{}: expected a whole number from 0 to {}", what, most));
            return 1;
        }
        return static_cast<long>(value);
    }

    void rule() {
        take();
        EisenRule rule;
        rule.position = position();
        const std::string name = take();
        if (name.empty() || name == "{") return expected("the name of a rule");
        while (!at_end() && peek() != "{" && !diagnostics_.has_errors()) {
            const std::string modifier = operator_name(peek());
            if (modifier == "weight") {
                take();
                rule.weight = number("the weight");
                if (!(rule.weight >= 0)) diagnostics_.error(rule.position, "a negative weight");
            } else if (modifier == "maxdepth") {
                take();
                rule.max_depth = whole("maxdepth", most_repeats);
                if (peek() == ">") {
                    take();
                    rule.retirement = take();
                }
            } else {
                expected("'weight', 'maxdepth' or '{'");
            }
        }
        if (peek() != "{") return expected("'{'");
        take();
        while (!at_end() && peek() != "}" && !diagnostics_.has_errors()) {
            if (lower_word(peek()) == "set") {
                setting();
            } else {
                rule.actions.push_back(action());
            }
        }
        if (peek() != "}") return expected("'}'");
        take();
        script_.rules[name].push_back(std::move(rule));
    }

    /// Settings of the picture mean nothing here; those that decide what is built are minded.
    void setting() {
        take();
        const Position place = position();
        const std::string key = lower_word(take());
        if (key == "maxdepth") {
            script_.max_depth = whole("maxdepth", most_repeats);
        } else if (key == "maxobjects") {
            script_.max_objects = whole("maxobjects", most_repeats * 100);
        } else if (key == "minsize" || key == "maxsize") {
            diagnostics_.error(place, fmt::format("'set {}' is not taken: use maxdepth", key));
        } else {
            take();
        }
    }

    EisenAction action() {
        EisenAction action;
        action.position = position();
        if (peek() == "{") {
            action.loops.push_back({1, list()});
        } else {
            while (begins_number(peek()) && !diagnostics_.has_errors()) {
                EisenLoop loop;
                loop.count = std::max(whole("a count", most_repeats), 1L);  // it takes 0 for 1
                if (peek() != "*") return expected("'*'"), action;
                take();
                if (peek() != "{") return expected("'{'"), action;
                loop.step = list();
                action.loops.push_back(std::move(loop));
            }
        }
        action.target = take();
        if (action.target.empty() || action.target == "{" || action.target == "}") {
            --place_;
            expected("the name of a rule or of a shape");
        }
        return action;
    }

    EisenTransform list() {
        take();
        EisenTransform all;
        while (!at_end() && peek() != "}" && !diagnostics_.has_errors()) {
            const std::string name = operator_name(peek());
            if (name.empty()) {
                expected("a transformation or '}'");
                break;
            }
            take();
            step(name, all);
        }
        if (peek() != "}") {
            expected("'}'");
        } else {
            take();
        }
        return all;
    }

    /// A point goes through the last one first: { x 1 s 2 } scales, then moves.
    static void inside(const Affine& map, EisenTransform& all) { all.map = then(map, all.map); }

    void step(const std::string& name, EisenTransform& all) {
        if (name == "x") return inside(translation({number(name), 0, 0}), all);
        if (name == "y") return inside(translation({0, number(name), 0}), all);
        if (name == "z") return inside(translation({0, 0, number(name)}), all);
        if (name == "rx")
            return inside(about_middle(rotation(Axis::x, number(name)), {0, 1, 1}), all);
        if (name == "ry")
            return inside(about_middle(rotation(Axis::y, number(name)), {1, 0, 1}), all);
        if (name == "rz")
            return inside(about_middle(rotation(Axis::z, number(name)), {1, 1, 0}), all);
        if (name == "fx") return scale({-1, 1, 1}, all);
        if (name == "fy") return scale({1, -1, 1}, all);
        if (name == "fz") return scale({1, 1, -1}, all);
        if (name == "s") return size(all);
        if (name == "matrix") return matrix(all);
        if (name == "reflect") return reflect(all);
        if (name == "alpha") {
            (void)number(name);
            return tell("alpha is left out: shapes are opaque");
        }
        color_step(name, all);
    }

    static void scale(const glm::dvec3& factors, EisenTransform& all) {
        inside(about_middle(scaling(factors), {1, 1, 1}), all);
    }
    void size(EisenTransform& all) {
        glm::dvec3 factors(number("s"));
        if (begins_number(peek())) {
            factors.y = number("s");
            factors.z = number("s");
        }
        scale(factors, all);
    }
    void matrix(EisenTransform& all) {
        Affine map;
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column) map.linear[column][row] = number("matrix");
        inside(about_middle(map, {1, 1, 1}), all);
    }
    /// In the plane through the origin across a direction.
    void reflect(EisenTransform& all) {
        glm::dvec3 n;
        for (int i = 0; i < 3; ++i) n[i] = number("reflect");
        const double length = glm::length(n);
        if (!(length > 0)) return expected("a direction that is not 0 before this");
        Affine map;
        for (int column = 0; column < 3; ++column)
            map.linear[column] -= 2 * (n[column] / length) * (n / length);
        inside(map, all);
    }

    void color_step(const std::string& name, EisenTransform& all) {
        if (name == "hue") all.change.hue += number(name);
        if (name == "sat") all.change.saturation *= number(name);
        if (name == "brightness") all.change.value *= number(name);
        if (name != "color" && name != "blend") return;
        const std::string word = lower_word(peek());
        const std::optional<EisenColor> color = eisen_color(word);
        if (!color && word != "random") return expected("a colour");
        take();
        if (name == "blend") {
            if (color) all.blend = *color;
            all.blend_strength = number(name);
        } else if (color) {
            all.set = color;
        } else {
            tell("color random is left out");
        }
    }

    void tell(const std::string& message) {
        if (script_.messages.find(message) == std::string::npos) script_.messages += message + '\n';
    }

    std::vector<EisenToken> tokens_;
    Diagnostics& diagnostics_;
    std::size_t place_ = 0;
    EisenScript script_;
};

}  // namespace

EisenScript parse_eisenscript(std::string_view text, Diagnostics& diagnostics) {
    std::vector<EisenToken> tokens = eisen_tokens(text, diagnostics);
    if (diagnostics.has_errors()) return {};
    return EisenParser(std::move(tokens), diagnostics).read();
}

}  // namespace pxm::host
