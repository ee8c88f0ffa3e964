// Where values lie along an axis, and which of them are written there.
#pragma once

#include <vector>

#include "host/study/page/plot.hpp"

namespace pxm::host {

/// Values to places along an axis.
class Mapping {
  public:
    /// From `low` to `high`, where the axis does not say otherwise, onto `from` to `to`.
    Mapping(const PlotAxis& axis, double low, double high, double from, double to);
    [[nodiscard]] double operator()(double value) const;
    [[nodiscard]] std::vector<double> ticks() const;

  private:
    [[nodiscard]] double place(double value) const;
    [[nodiscard]] std::vector<double> decades() const;
    [[nodiscard]] std::vector<double> round_numbers() const;

    AxisScale scale_;
    double low_;
    double high_;
    double from_;
    double to_;
};

}  // namespace pxm::host
