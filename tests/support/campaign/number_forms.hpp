// A number of a scene, written in any of the forms that the language has for it.
#pragma once

#include <string>
#include <vector>

#include "tests/support/campaign/draw.hpp"

namespace pxm::test {

/// What may be named where a number is written.
struct KnownNames {
    std::vector<std::pair<std::string, double>> lets;
    bool animated = false;  // t and frame are there, and are 0
};

class NumberForms {
  public:
    NumberForms(Draw& draw, const KnownNames& names) : draw_(draw), names_(names) {}

    /// The value, but for rounding: digits, or an expression.
    std::string number(double value) { return expression(value, 3); }
    /// A value between the two.
    std::string between(double low, double high) { return number(draw_.between(low, high)); }
    /// A number without a fraction: exactly that.
    std::string whole(long value);
    /// The values between commas; in an animation they may be keys whose values are points.
    std::string list(const std::vector<double>& values);

    /// One of each form, by the words and signs that show it: the tests look for them.
    static const std::vector<std::string>& all_signs();

  private:
    std::string expression(double value, int depth);
    std::string keys(const std::string& value, bool positive);

    Draw& draw_;
    const KnownNames& names_;
};

}  // namespace pxm::test
