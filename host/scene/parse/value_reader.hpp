// The values of directives: numbers, points, words, references. Each reader takes what it names or
// reports what it found instead and throws SyntaxError.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

#include "host/scene/parse/expression.hpp"
#include "host/scene/parse/grammar.hpp"
#include "host/scene/parse/keys.hpp"
#include "host/scene/parse/token_reader.hpp"
#include "host/scene/scene.hpp"
#include "host/scene/words.hpp"

namespace pxm::host {

class ValueReader {
  public:
    ValueReader(TokenReader& tokens, const Constants& constants)
        : tokens_(tokens), constants_(constants) {}

    double number() { return parse_expression(tokens_, constants_); }
    /// A number without a fraction.
    long whole_number();
    /// A number greater than 0 whose keys go exponentially.
    double magnification();
    /// A number with its text, if it is written plainly: digits with or without a sign.
    Decimal decimal();

    /// Numbers separated by commas; `note` says what they are, as in "r,g,b,a".
    template <std::size_t count>
    std::array<double, count> numbers(std::string_view note) {
        std::array<double, count> values{};
        if (keys_are_points()) {
            tokens_.take();
            values = read_keys<count>(
                tokens_, Interpolation::smooth, [&] { return in_parentheses<count>(note); },
                [&](Behind behind) { return parse_expression(tokens_, constants_, behind); });
            end_of_list(note);
            return values;
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) tokens_.expect(',', note);
            values[i] = number();
        }
        end_of_list(note);
        return values;
    }
    template <std::size_t count>
    std::array<long, count> whole_numbers(std::string_view note) {
        std::array<long, count> values{};
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) tokens_.expect(',', note);
            values[i] = whole_number();
        }
        end_of_list(note);
        return values;
    }
    glm::dvec2 vec2(std::string_view note);
    glm::dvec3 vec3(std::string_view note);
    glm::dvec4 rgba();
    glm::dvec3 rgb() { return vec3("a color is r,g,b"); }
    DecimalVec3 decimals(std::string_view note);
    /// One factor for all axes or three.
    glm::dvec3 scale_factors();
    /// (x,y,z)
    glm::dvec3 point();
    /// A comma that may be left out beside a parenthesised point.
    void optional_comma() { tokens_.accept(','); }

    /// A name that is no keyword; `what` is what it names.
    std::string name(std::string_view what);
    MapReference map_reference();
    std::vector<MapReference> map_references();
    /// The text of a string.
    std::string file_name();

    /// One of the words of a table in words.hpp.
    template <class Words>
    auto word(const Words& words) {
        const Token first = tokens_.peek();
        const std::string text = hyphenated();
        const auto value = value_of(words, text);
        if (!value)
            tokens_.fail(first.position, "expected " + one_of(words) + ", found " +
                                             (text.empty() ? describe(first) : quoted(text)));
        return *value;
    }

  private:
    /// Words joined by hyphens, as low-pass; empty if no word is next.
    std::string hyphenated();
    static std::string quoted(const std::string& text);
    void end_of_list(std::string_view note);
    /// Whether key(...) is next, and its values are points.
    [[nodiscard]] bool keys_are_points() const;
    template <std::size_t count>
    std::array<double, count> in_parentheses(std::string_view note) {
        std::array<double, count> values{};
        tokens_.expect('(', note);
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) tokens_.expect(',', note);
            values[i] = number();
        }
        tokens_.expect(')', note);
        return values;
    }

    TokenReader& tokens_;
    const Constants& constants_;
};

}  // namespace pxm::host
