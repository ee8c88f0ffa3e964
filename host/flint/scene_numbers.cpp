#include "host/flint/scene_numbers.hpp"

namespace pxm::host {

FieldNumbers::Value FieldNumbers::decimal(const std::string& text) const {
    return {0, exact::Polynomial::decimal(text)};
}

FieldNumbers::Value FieldNumbers::pi() const { throw exact::NotExact{"pi is in no number field"}; }

FieldNumbers::Value FieldNumbers::divide(const Value& a, const Value& b) const {
    if (b.value.is_zero()) throw exact::NotExact{"a division by what is exactly 0"};
    return field_.divide(a, b);
}

BallNumbers::Value BallNumbers::divide(const Value& a, const Value& b) const {
    if (!b.is_positive() && !b.is_negative()) throw exact::NotExact{"a division by what may be 0"};
    return a / b;
}

BallNumbers::Value BallNumbers::square_root(const Value& a) const {
    if (!a.is_positive() && !a.is_zero()) throw exact::NotExact{"a root of what may be negative"};
    return exact::square_root(a);
}

BallNumbers::Value BallNumbers::sine(const Value& degrees) const { return exact::sine(degrees); }

BallNumbers::Value BallNumbers::cosine(const Value& degrees) const {
    return exact::cosine(degrees);
}

}  // namespace pxm::host
