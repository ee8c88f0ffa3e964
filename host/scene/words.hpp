// The words of the scene language that name a value, each beside it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/scene.hpp"

namespace pxm::host {

template <class Value>
struct Word {
    std::string_view text;
    Value value;
};

inline constexpr std::array<Word<Axis>, 3> axis_words{
    {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}}};
inline constexpr std::array<Word<bool>, 2> switch_words{{{"on", true}, {"off", false}}};
inline constexpr std::array<Word<Shading>, 4> shading_words{{{"constant", Shading::constant},
                                                             {"low-pass", Shading::low_pass},
                                                             {"high-pass", Shading::high_pass},
                                                             {"facet", Shading::facet}}};
inline constexpr std::array<Word<IntersectMethod>, 4> intersect_words{
    {{"auto", IntersectMethod::automatic},
     {"heap", IntersectMethod::heap},
     {"fast", IntersectMethod::fast},
     {"wide", IntersectMethod::wide}}};
inline constexpr std::array<Word<Numeric>, 3> numeric_words{
    {{"dsp32", Numeric::dsp32}, {"float", Numeric::single}, {"double", Numeric::double_}}};
inline constexpr std::array<Word<LipschitzMethod>, 4> lipschitz_words{
    {{"auto", LipschitzMethod::automatic},
     {"product", LipschitzMethod::product},
     {"determinant", LipschitzMethod::determinant},
     {"polar", LipschitzMethod::polar}}};
inline constexpr std::array<Word<VolumeKind>, 5> volume_words{{{"auto", VolumeKind::automatic},
                                                               {"sphere", VolumeKind::sphere},
                                                               {"box", VolumeKind::box},
                                                               {"oriented", VolumeKind::oriented},
                                                               {"hull", VolumeKind::hull}}};

/// The value that the word names; empty if none.
template <class Words>
[[nodiscard]] constexpr auto value_of(const Words& words, std::string_view text)
    -> std::optional<decltype(words.front().value)> {
    for (const auto& word : words)
        if (word.text == text) return word.value;
    return std::nullopt;
}

/// The word that names the value.
template <class Words, class Value>
[[nodiscard]] constexpr std::string_view word_of(const Words& words, Value value) {
    for (const auto& word : words)
        if (word.value == value) return word.text;
    return {};
}

/// "constant, low-pass, high-pass or facet"
template <class Words>
[[nodiscard]] std::string one_of(const Words& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) list += i + 1 == words.size() ? " or " : ", ";
        list += words[i].text;
    }
    return list;
}

}  // namespace pxm::host
