#include "host/import/lsystem/space_turn.hpp"

#include <algorithm>

namespace pxm::host {

namespace {

LongVec3 cross(const LongVec3& a, const LongVec3& b) {
    return {a.left * b.up - a.up * b.left, a.up * b.forward - a.forward * b.up,
            a.forward * b.left - a.left * b.forward};
}

LongReal dot(const LongVec3& a, const LongVec3& b) {
    return a.forward * b.forward + a.left * b.left + a.up * b.up;
}

}  // namespace

LongVec3 operator+(const LongVec3& a, const LongVec3& b) {
    return {a.forward + b.forward, a.left + b.left, a.up + b.up};
}

LongVec3 operator-(const LongVec3& a, const LongVec3& b) {
    return {a.forward - b.forward, a.left - b.left, a.up - b.up};
}

LongVec3 operator*(const LongReal& a, const LongVec3& b) {
    return {a * b.forward, a * b.left, a * b.up};
}

LongReal size(const LongVec3& v) {
    return std::max({LongReal(abs(v.forward)), LongReal(abs(v.left)), LongReal(abs(v.up))});
}

glm::dvec3 to_double(const LongVec3& v) {
    return {v.forward.convert_to<double>(), v.left.convert_to<double>(), v.up.convert_to<double>()};
}

SpaceTurn::SpaceTurn(int axis, const LongReal& degrees) {
    const LongReal half = degrees * atan(LongReal(1)) / 90;  // radians
    const LongReal sine = sin(half);
    real_ = cos(half);
    axis_ = {axis == 0 ? sine : LongReal(0), axis == 1 ? sine : LongReal(0),
             axis == 2 ? sine : LongReal(0)};
}

SpaceTurn SpaceTurn::then(const SpaceTurn& other) const {
    SpaceTurn both;
    both.real_ = real_ * other.real_ - dot(axis_, other.axis_);
    both.axis_ = real_ * other.axis_ + other.real_ * axis_ + cross(axis_, other.axis_);
    return both;
}

SpaceTurn SpaceTurn::inverse() const {
    SpaceTurn back;
    back.real_ = real_;
    back.axis_ = LongReal(-1) * axis_;
    return back;
}

LongVec3 SpaceTurn::of(const LongVec3& v) const {
    const LongVec3 twice = LongReal(2) * cross(axis_, v);
    return v + real_ * twice + cross(axis_, twice);
}

bool SpaceTurn::is_same(const SpaceTurn& other) const {
    const LongReal near("1e-60");
    const auto differs = [&](const LongReal& sign) {
        return size(axis_ - sign * other.axis_) > near ||
               abs(LongReal(real_ - sign * other.real_)) > near;
    };
    return !differs(1) || !differs(-1);  // a quaternion and its negative are one turn
}

glm::dmat3 SpaceTurn::matrix() const {
    return {to_double(of({1, 0, 0})), to_double(of({0, 1, 0})), to_double(of({0, 0, 1}))};
}

}  // namespace pxm::host
