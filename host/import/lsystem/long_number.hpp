// Numbers of 300 digits. The lengths that an L-system's edges really have can grow slower than
// other solutions of the same recurrence, which rounding brings in: in doubles those have taken
// over after some tens of levels. With 300 digits, and a bound on what rounding has done, they have
// not.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <complex>

namespace pxm::host {

using LongReal = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300>,
                                               boost::multiprecision::et_off>;

struct LongComplex {
    LongReal real{0};
    LongReal imag{0};
};

inline LongComplex operator+(const LongComplex& a, const LongComplex& b) {
    return {a.real + b.real, a.imag + b.imag};
}
inline LongComplex operator-(const LongComplex& a, const LongComplex& b) {
    return {a.real - b.real, a.imag - b.imag};
}
inline LongComplex operator*(const LongReal& a, const LongComplex& b) {
    return {a * b.real, a * b.imag};
}
inline LongComplex operator*(const LongComplex& a, const LongComplex& b) {
    return {a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real};
}
inline LongComplex conj(const LongComplex& a) { return {a.real, -a.imag}; }
inline LongReal norm(const LongComplex& a) { return a.real * a.real + a.imag * a.imag; }
/// Between |a| / sqrt 2 and |a|; a root of so many digits would cost as much as 100 products.
inline LongReal size(const LongComplex& a) {
    return std::max(LongReal(abs(a.real)), LongReal(abs(a.imag)));
}
/// b must not be zero.
inline LongComplex operator/(const LongComplex& a, const LongComplex& b) {
    return LongReal(1 / norm(b)) * (a * conj(b));
}
inline LongComplex long_complex(const std::complex<double>& a) { return {a.real(), a.imag()}; }
inline std::complex<double> to_double(const LongComplex& a) {
    return {a.real.convert_to<double>(), a.imag.convert_to<double>()};
}

}  // namespace pxm::host
