// What the expressions of scenes are computed in: elements of a number field, or balls of certified
// radius.
#pragma once

#include <string>

#include "host/fractal/exact/number_field.hpp"
#include "host/fractal/exact/real_ball.hpp"

namespace pxm::host {

/// Elements of a field that grows with what is asked for. All throw NotExact.
class FieldNumbers {
  public:
    using Value = exact::Algebraic;

    [[nodiscard]] Value whole(long value) const { return exact::whole(value); }
    [[nodiscard]] Value decimal(const std::string& text) const;
    [[nodiscard]] Value pi() const;
    [[nodiscard]] Value add(const Value& a, const Value& b) const { return field_.add(a, b); }
    [[nodiscard]] Value subtract(const Value& a, const Value& b) const {
        return field_.subtract(a, b);
    }
    [[nodiscard]] Value multiply(const Value& a, const Value& b) const {
        return field_.multiply(a, b);
    }
    [[nodiscard]] Value divide(const Value& a, const Value& b) const;
    [[nodiscard]] Value square_root(const Value& a) { return field_.square_root(a); }
    [[nodiscard]] Value sine(const Value& degrees) { return field_.sine(degrees); }
    [[nodiscard]] Value cosine(const Value& degrees) { return field_.cosine(degrees); }

    [[nodiscard]] exact::NumberField& field() { return field_; }

  private:
    exact::NumberField field_;
};

/// Balls. What needs to know that a number is not 0, or not negative, throws NotExact where the
/// ball does not tell.
class BallNumbers {
  public:
    using Value = exact::RealBall;

    [[nodiscard]] Value whole(long value) const { return Value(value); }
    [[nodiscard]] Value decimal(const std::string& text) const { return Value::decimal(text); }
    [[nodiscard]] Value pi() const { return Value::pi(); }
    [[nodiscard]] Value add(const Value& a, const Value& b) const { return a + b; }
    [[nodiscard]] Value subtract(const Value& a, const Value& b) const { return a - b; }
    [[nodiscard]] Value multiply(const Value& a, const Value& b) const { return a * b; }
    [[nodiscard]] Value divide(const Value& a, const Value& b) const;
    [[nodiscard]] Value square_root(const Value& a) const;
    [[nodiscard]] Value sine(const Value& degrees) const;
    [[nodiscard]] Value cosine(const Value& degrees) const;
};

}  // namespace pxm::host
