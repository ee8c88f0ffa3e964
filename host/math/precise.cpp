#include "host/math/precise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <ios>
#include <limits>
#include <memory>
#include <new>

namespace pxm::host {

using BoostNumber = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

struct Precise::Number {
    BoostNumber value;
};

Precise::Precise(double value) : Precise(Number{BoostNumber(value)}) {}
Precise::Precise(const std::string& text) : Precise(Number{BoostNumber(text)}) {}
Precise::Precise(const Number& number) {
    static_assert(sizeof(Number) <= size_bytes);
    ::new (static_cast<void*>(number_.data())) Number(number);
}
Precise::Precise(const Precise& other) : Precise(other.number()) {}
Precise& Precise::operator=(const Precise& other) {
    std::launder(reinterpret_cast<Number*>(number_.data()))->value = other.number().value;
    return *this;
}
Precise::~Precise() { std::destroy_at(std::launder(reinterpret_cast<Number*>(number_.data()))); }

const Precise::Number& Precise::number() const {
    return *std::launder(reinterpret_cast<const Number*>(number_.data()));
}

namespace {

const BoostNumber& value_of(const Precise& x) { return x.number().value; }

Precise precise(const BoostNumber& value) { return Precise(Precise::Number{value}); }

PreciseVec3 cross(const PreciseVec3& a, const PreciseVec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// x T
PreciseVec3 direction(const PreciseAffine& map, const PreciseVec3& x) {
    return add(add(scaled(map.linear[0], x[0]), scaled(map.linear[1], x[1])),
               scaled(map.linear[2], x[2]));
}

}  // namespace

Precise operator+(const Precise& a, const Precise& b) { return precise(value_of(a) + value_of(b)); }
Precise operator-(const Precise& a, const Precise& b) { return precise(value_of(a) - value_of(b)); }
Precise operator*(const Precise& a, const Precise& b) { return precise(value_of(a) * value_of(b)); }
Precise operator/(const Precise& a, const Precise& b) { return precise(value_of(a) / value_of(b)); }

std::string text_of(const Precise& x, int decimals) {
    const BoostNumber& value = value_of(x);
    BoostNumber rest = abs(value) + pow(BoostNumber(10), -decimals) / 2;
    const BoostNumber whole = floor(rest);
    // As text, up to the point: no whole number of the language is wide enough for all of them.
    const std::string digits = whole.str(0, std::ios::fixed);
    std::string text =
        fmt::format("{}{}.", value < 0 ? "-" : "", digits.substr(0, digits.find('.')));
    rest -= whole;
    for (int i = 0; i < decimals; ++i) {
        rest *= 10;
        const int digit = rest.convert_to<int>();
        text.push_back(static_cast<char>('0' + digit));
        rest -= digit;
    }
    return text;
}

bool is_long(const Decimal& decimal) {
    const std::string mantissa = decimal.text.substr(0, decimal.text.find_first_of("eE"));
    const auto digits =
        std::ranges::count_if(mantissa, [](char c) { return '0' <= c && c <= '9'; });
    return digits > std::numeric_limits<double>::max_digits10;
}

Precise precise(const Decimal& decimal) {
    return is_long(decimal) ? Precise(decimal.text) : Precise(decimal.value);
}

PreciseVec3 precise(const DecimalVec3& v) { return {precise(v[0]), precise(v[1]), precise(v[2])}; }

PreciseVec3 precise(const glm::dvec3& v) { return {Precise(v.x), Precise(v.y), Precise(v.z)}; }

PreciseAffine precise(const Affine& map) {
    return {{precise(map.linear[0]), precise(map.linear[1]), precise(map.linear[2])},
            precise(map.translation)};
}

double rounded(const Precise& x) { return value_of(x).convert_to<double>(); }

glm::dvec3 rounded(const PreciseVec3& v) { return {rounded(v[0]), rounded(v[1]), rounded(v[2])}; }

glm::dmat3 rounded_linear(const PreciseAffine& map) {
    return {rounded(map.linear[0]), rounded(map.linear[1]), rounded(map.linear[2])};
}

PreciseVec3 add(const PreciseVec3& a, const PreciseVec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

PreciseVec3 subtract(const PreciseVec3& a, const PreciseVec3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

PreciseVec3 scaled(const PreciseVec3& v, const Precise& factor) {
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

Precise dot(const PreciseVec3& a, const PreciseVec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PreciseVec3 image(const PreciseAffine& map, const PreciseVec3& x) {
    return add(direction(map, x), map.translation);
}

PreciseAffine then(const PreciseAffine& first, const PreciseAffine& second) {
    return {{direction(second, first.linear[0]), direction(second, first.linear[1]),
             direction(second, first.linear[2])},
            image(second, first.translation)};
}

PreciseVec3 origin_of(const PreciseAffine& map) {
    // x T = -a by Cramer's rule: the rows of T are the columns of the equations.
    const PreciseVec3 b = scaled(map.translation, Precise(-1));
    const auto& [u, v, w] = map.linear;
    const Precise determinant = dot(u, cross(v, w));
    return {dot(b, cross(v, w)) / determinant, dot(u, cross(b, w)) / determinant,
            dot(u, cross(v, b)) / determinant};
}

PreciseVec3 fixed_point(const PreciseAffine& map) {
    PreciseAffine away = map;  // from where a point was to where it goes
    for (std::size_t i = 0; i < 3; ++i) away.linear[i][i] = away.linear[i][i] - Precise(1);
    return origin_of(away);
}

}  // namespace pxm::host
