#include "host/import/aifs/aifs_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace pxm::host {
namespace {

using Function = double (*)(double);

const std::array<std::pair<std::string_view, Function>, 11> functions{{
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
    {"abs", [](double x) { return std::abs(x); }},
}};

constexpr std::array<std::string_view, 5> templates{"$number", "$real", "$integer", "$semigroup",
                                                    "$vector"};

/// x -> the companion matrix of a0 + a1 x + ... + x^n: it takes each base vector to the next, so
/// that the vector [c0, c1, ...] is c0 + c1 M + c2 M^2 ... applied to the first.
AifsValue companion(const std::vector<AifsValue>& arguments, std::size_t n, const Position& place) {
    const AifsVector* vector =
        arguments.size() == 1 ? std::get_if<AifsVector>(&arguments[0].value) : nullptr;
    if (vector == nullptr || (*vector)->size() != n)
        throw AifsMistake{place, fmt::format("$companion: expected a vector of {} numbers, as many "
                                             "as $dim says",
                                             n)};
    AffineN map = scaling_n(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        if (i + 1 < n) map.linear[(i + 1) * n + i] = 1;
        map.linear[i * n + n - 1] = -number_of((**vector)[i], place);
    }
    return {map};
}

AifsValue exchange(std::size_t n) {
    AffineN map = scaling_n(n, 0);
    for (std::size_t i = 0; i < n; ++i) map.linear[i * n + n - 1 - i] = 1;
    return {map};
}

}  // namespace

std::optional<AifsValue> aifs_constant(std::string_view name, std::size_t dimension,
                                       const Position& place) {
    if (name == "$pi") return AifsValue{std::numbers::pi};
    if (name == "$i") return AifsValue{scaling_n(dimension, 1)};
    if (name == "$e") throw AifsMistake{place, "the empty set ($e) is not taken"};
    return std::nullopt;
}

std::optional<AifsValue> aifs_function(std::string_view name,
                                       const std::vector<AifsValue>& arguments,
                                       std::size_t dimension, const Position& place) {
    if (std::ranges::find(templates, name) != templates.end())
        throw AifsMistake{place, fmt::format("{} leaves the value to a search: a block that "
                                             "inherits from this one has to say it",
                                             name)};
    if (name == "$companion") return companion(arguments, dimension, place);
    if (name == "$exchange") return exchange(dimension);
    if (name == "$style") return AifsValue{scaling_n(dimension, 1)};  // a colour
    for (const auto& [known, function] : functions) {
        if (name != known) continue;
        if (arguments.size() != 1)
            throw AifsMistake{place, fmt::format("{}: expected one argument", name)};
        const double result = function(number_of(arguments[0], place));
        if (!std::isfinite(result))
            throw AifsMistake{place, fmt::format("{}: a value that is not finite", name)};
        return AifsValue{result};
    }
    return std::nullopt;
}

}  // namespace pxm::host
