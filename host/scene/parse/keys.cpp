#include "host/scene/parse/keys.hpp"

#include <algorithm>

#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

struct InterpolationWord {
    std::string_view text;
    Interpolation kind;
};
constexpr std::array<InterpolationWord, 4> interpolation_words{
    {{"smooth", Interpolation::smooth},
     {"linear", Interpolation::linear},
     {"stepped", Interpolation::stepped},
     {"exponential", Interpolation::exponential}}};

double slope(const Key& a, const Key& b) { return (b.value - a.value) / (b.at - a.at); }

/// Of the curve at a key: the harmonic mean of the slopes beside it (Fritsch and Butland), with
/// which a cubic stays between its ends.
double tangent(const std::vector<Key>& keys, std::size_t i) {
    if (i == 0 || i + 1 == keys.size()) return 0;
    const double before = slope(keys[i - 1], keys[i]), after = slope(keys[i], keys[i + 1]);
    return before * after > 0 ? 2 / (1 / before + 1 / after) : 0;
}

double smooth(const std::vector<Key>& keys, std::size_t i, double share) {
    const Key &a = keys[i], &b = keys[i + 1];
    const double width = b.at - a.at, s = share;
    const double rest = (1 - s) * (1 - s) * (1 + 2 * s);  // 1 at the first, 0 at the second
    return rest * a.value + (1 - rest) * b.value +
           width * s * (1 - s) * ((1 - s) * tangent(keys, i) - s * tangent(keys, i + 1));
}

}  // namespace

double value_between(const std::vector<Key>& keys, double x, Interpolation kind) {
    if (x <= keys.front().at) return keys.front().value;
    if (x >= keys.back().at) return keys.back().value;
    if (kind == Interpolation::exponential) {
        std::vector<Key> logarithms = keys;
        for (Key& key : logarithms) key.value = std::log(key.value);
        return std::exp(value_between(logarithms, x, Interpolation::smooth));
    }
    const auto after = std::ranges::upper_bound(keys, x, {}, &Key::at);
    const auto i = static_cast<std::size_t>(after - keys.begin()) - 1;
    const double share = (x - keys[i].at) / (keys[i + 1].at - keys[i].at);
    if (kind == Interpolation::stepped) return keys[i].value;
    if (kind == Interpolation::linear)
        return (1 - share) * keys[i].value + share * keys[i + 1].value;
    return smooth(keys, i, share);
}

Interpolation read_interpolation(TokenReader& tokens, Interpolation usual) {
    const Token word = tokens.take();
    for (const InterpolationWord& one : interpolation_words)
        if (word.text == one.text) return one.kind;
    tokens.fail(word.position,
                fmt::format("expected smooth, linear, stepped or exponential, found '{}'",
                            printable(word.text)));
    return usual;
}

}  // namespace pxm::host
