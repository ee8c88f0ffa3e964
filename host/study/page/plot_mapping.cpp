#include "host/study/page/plot_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pxm::host {

Mapping::Mapping(const PlotAxis& axis, double low, double high, double from, double to)
    : scale_(axis.scale), from_(from), to_(to) {
    low_ = place(axis.low.value_or(low));
    high_ = place(axis.high.value_or(high));
    if (!(high_ > low_)) {
        low_ -= 0.5;
        high_ += 0.5;
    }
}

double Mapping::operator()(double value) const {
    const double share = (place(value) - low_) / (high_ - low_);
    return from_ + std::clamp(share, 0.0, 1.0) * (to_ - from_);
}

std::vector<double> Mapping::ticks() const {
    return scale_ == AxisScale::logarithmic ? decades() : round_numbers();
}

double Mapping::place(double value) const {
    if (scale_ == AxisScale::linear) return value;
    return std::log10(std::max(value, std::numeric_limits<double>::min()));
}

std::vector<double> Mapping::decades() const {
    std::vector<double> values;
    const double step = std::max(1.0, std::ceil((high_ - low_) / 8));
    const bool few = high_ - low_ < 2;
    for (double e = std::floor(low_); e <= high_ + 1e-9; e += step) {
        for (const double lead : {1.0, 2.0, 5.0}) {
            const double at = e + std::log10(lead);
            const bool inside = at >= low_ - 1e-9 && at <= high_ + 1e-9;
            if (inside && (few || lead == 1)) values.push_back(lead * std::pow(10, e));
        }
    }
    return values;
}

std::vector<double> Mapping::round_numbers() const {
    const double raw = (high_ - low_) / 5;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    const double lead = raw / power;
    const double step = power * (lead > 5 ? 10 : lead > 2 ? 5 : lead > 1 ? 2 : 1);
    std::vector<double> values;
    for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + step * 1e-9; ++k)
        values.push_back(k * step);
    return values;
}

}  // namespace pxm::host
