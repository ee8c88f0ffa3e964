// Numbers as they were written: what a double cannot hold of them is not lost before it is needed.
#pragma once

#include <array>
#include <string>

namespace pxm::host {

/// A number with its exact text: deep zooms need more digits than a double holds.
struct Decimal {
    double value = 0;  // the nearest double
    std::string text;  // as written; empty if it was computed by an expression
    bool operator==(const Decimal& other) const { return value == other.value; }
};
using DecimalVec3 = std::array<Decimal, 3>;  // x, y and z

}  // namespace pxm::host
