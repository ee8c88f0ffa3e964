#include "host/study/deviation.hpp"

#include <algorithm>
#include <cmath>

namespace pxm::host {

namespace {

/// How far apart two hits are, in pixels. Depths that are no numbers are as wrong as can be.
double pixels_apart(const RenderResult& picture, double a, double b) {
    const double p = picture.pixel_at_eye + picture.pixel_growth * b;
    const double apart = std::abs(a - b) / p;
    return std::isfinite(apart) ? apart : 1e9;
}

/// The largest difference of a pixel's colour; its squares are added to a sum.
double color_apart(const PixelRecord& a, const PixelRecord& b, double& squares) {
    double largest = 0;
    for (int k = 0; k < 3; ++k) {
        double d = double{a.color[k]} - double{b.color[k]};
        if (!std::isfinite(d)) d = 1;
        squares += d * d;
        largest = std::max(largest, std::abs(d));
    }
    return largest;
}

double percentile_99(std::vector<double> values) {
    const auto at = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

}  // namespace

Deviation deviation_of(const RenderResult& picture, const RenderResult& reference, double scale) {
    Deviation result;
    const std::vector<PixelRecord>& pixels = picture.frame.pixels;
    const auto count = static_cast<double>(pixels.size());
    std::vector<double> colors;
    double squares = 0, depths = 0, both = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PixelRecord& a = pixels[i];
        const PixelRecord& b = reference.frame.pixels[i];
        const bool other_hit = (a.level < 0) != (b.level < 0);
        double apart = 0;
        if (a.level >= 0 && b.level >= 0) {
            apart = pixels_apart(picture, double{a.z}, double{b.z} / scale);
            depths += apart;
            ++both;
        }
        result.worst_depth = std::max(result.worst_depth, apart);
        result.wrong.push_back(other_hit || apart > 1);
        result.wrong_hits += other_hit ? 1 / count : 0;
        result.wrong_share += result.wrong.back() ? 1 / count : 0;
        colors.push_back(color_apart(a, b, squares));
    }
    result.mean_depth = both > 0 ? depths / both : 0;
    result.rmse = std::sqrt(squares / (3 * count));
    result.color_99 = percentile_99(std::move(colors));
    return result;
}

}  // namespace pxm::host
