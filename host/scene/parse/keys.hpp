// key(x: x1 -> v1, x2 -> v2, ..., KIND): values between given ones, as x moves.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "host/scene/parse/expression.hpp"
#include "host/scene/parse/token_reader.hpp"

namespace pxm::host {

/// How values go from one key to the next. Smooth: by cubics whose slopes are 0 at the first key,
/// the last one, and where the values turn round, and nowhere so steep that they would overshoot.
/// Exponential: the logarithms go smoothly, as magnifications do.
enum class Interpolation { smooth, linear, stepped, exponential };

struct Key {
    double at = 0;
    double value = 0;
};

/// The value at `x`; before the first key and after the last one, theirs. Precondition: there are
/// keys, their places rise, and of exponential ones all values are greater than 0.
[[nodiscard]] double value_between(const std::vector<Key>& keys, double x, Interpolation kind);

/// The word at the end, or `usual` if there is none. Throws SyntaxError after reporting a mistake.
[[nodiscard]] Interpolation read_interpolation(TokenReader& tokens, Interpolation usual);

/// Reads what follows the word `key`: values of `count` numbers each by `read_value()`, places by
/// `read_place(behind)`. Throws SyntaxError after reporting a mistake.
template <std::size_t count, class ReadValue, class ReadPlace>
std::array<double, count> read_keys(TokenReader& tokens, Interpolation usual,
                                    const ReadValue& read_value, const ReadPlace& read_place) {
    constexpr std::string_view form = "key(t: 0 -> value, 1 -> value)";
    tokens.expect('(', form);
    const double x = read_place(Behind::colon);
    tokens.expect(':', form);
    std::array<std::vector<Key>, count> keys;
    Interpolation kind = usual;
    std::vector<Position> places;
    do {
        const bool alone = tokens.peek().kind == TokenKind::word && tokens.peek_second().is(')');
        if (alone && !keys[0].empty()) {
            kind = read_interpolation(tokens, usual);
            break;
        }
        const Position place = tokens.peek().position;
        const double at = read_place(Behind::anything);
        if (!keys[0].empty() && !(at > keys[0].back().at))
            tokens.fail(place, fmt::format("the keys are out of order: {} comes after {}", at,
                                           keys[0].back().at));
        if (tokens.peek().kind != TokenKind::arrow) tokens.fail_expected("'->'", form);
        tokens.take();
        places.push_back(tokens.peek().position);
        const std::array<double, count> value = read_value();
        for (std::size_t i = 0; i < count; ++i) keys[i].push_back({at, value[i]});
    } while (tokens.accept(','));
    tokens.expect(')', form);
    std::array<double, count> result{};
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < keys[i].size() && kind == Interpolation::exponential; ++k) {
            if (!(keys[i][k].value > 0))
                tokens.fail(places[k], "a value that goes exponentially is greater than 0");
        }
        result[i] = value_between(keys[i], x, kind);
    }
    return result;
}

}  // namespace pxm::host
