// Numbers of 77 decimal digits: the eye's place and the maps on the way to what is near it, where a
// double cannot tell one from the other any more. On the host, before a frame; the nodes never see
// them.
#pragma once

#include <array>
#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "host/math/affine.hpp"
#include "host/math/decimal.hpp"

namespace pxm::host {

/// One of them. Its arithmetic is Boost's, whose headers cost more to compile than all that
/// computes with them: only the .cpp knows them.
class Precise {
  public:
    struct Number;  // Boost's

    Precise() : Precise(0.0) {}
    explicit Precise(double value);
    /// Precondition: a decimal number.
    explicit Precise(const std::string& text);
    explicit Precise(const Number& number);
    Precise(const Precise& other);
    Precise& operator=(const Precise& other);
    ~Precise();

    [[nodiscard]] const Number& number() const;

  private:
    static constexpr std::size_t size_bytes = 64;
    alignas(16) std::array<std::byte, size_bytes> number_;
};

[[nodiscard]] Precise operator+(const Precise& a, const Precise& b);
[[nodiscard]] Precise operator-(const Precise& a, const Precise& b);
[[nodiscard]] Precise operator*(const Precise& a, const Precise& b);
[[nodiscard]] Precise operator/(const Precise& a, const Precise& b);

/// As decimal text with so many digits after the point, the last one rounded.
[[nodiscard]] std::string text_of(const Precise& x, int decimals);

using PreciseVec3 = std::array<Precise, 3>;

/// x' = x T + a, as Affine.
struct PreciseAffine {
    std::array<PreciseVec3, 3> linear;  // rows of T
    PreciseVec3 translation;
};

/// Whether a number was written with more digits than a double holds.
[[nodiscard]] bool is_long(const Decimal& decimal);

/// The number as written if it is long, else the double that it is everywhere.
[[nodiscard]] Precise precise(const Decimal& decimal);
[[nodiscard]] PreciseVec3 precise(const DecimalVec3& v);
[[nodiscard]] PreciseVec3 precise(const glm::dvec3& v);
[[nodiscard]] PreciseAffine precise(const Affine& map);

[[nodiscard]] double rounded(const Precise& x);
[[nodiscard]] glm::dvec3 rounded(const PreciseVec3& v);
[[nodiscard]] glm::dmat3 rounded_linear(const PreciseAffine& map);

[[nodiscard]] PreciseVec3 add(const PreciseVec3& a, const PreciseVec3& b);
[[nodiscard]] PreciseVec3 subtract(const PreciseVec3& a, const PreciseVec3& b);
[[nodiscard]] PreciseVec3 scaled(const PreciseVec3& v, const Precise& factor);
[[nodiscard]] Precise dot(const PreciseVec3& a, const PreciseVec3& b);

/// The image of a point.
[[nodiscard]] PreciseVec3 image(const PreciseAffine& map, const PreciseVec3& x);
/// The map that applies `first` and then `second`.
[[nodiscard]] PreciseAffine then(const PreciseAffine& first, const PreciseAffine& second);
/// The point that the map leaves where it is. Precondition: det (T - 1) is not zero.
[[nodiscard]] PreciseVec3 fixed_point(const PreciseAffine& map);
/// The point whose image is the origin. Precondition: det T is not zero.
[[nodiscard]] PreciseVec3 origin_of(const PreciseAffine& map);

}  // namespace pxm::host
