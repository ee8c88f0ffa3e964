// The stiff and extreme scenes of the stability study, as texts. One table: a case is a line.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace pxm::host {

struct StabilityCase {
    std::string name;
    std::string family;
    double value = 0;  // the family's parameter
    /// The scene with all lengths of the world multiplied by `unit`: the same picture in exact
    /// numbers, other roundings.
    std::function<std::string(double unit)> text;
};

[[nodiscard]] std::vector<StabilityCase> stability_cases();

}  // namespace pxm::host
