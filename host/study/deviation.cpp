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

/// CIE L*a*b* of a linear colour with sRGB's primaries and white.
struct Lab {
    double l, a, b;
};
Lab lab_of(const PixelRecord& pixel) {
    const auto f = [](double t) {
        return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
    };
    const auto part = [&](int k) {
        return std::isfinite(pixel.color[k]) ? std::clamp(double{pixel.color[k]}, 0.0, 1.0) : 0.0;
    };
    const double r = part(0), g = part(1), b = part(2);
    const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
    const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
    const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

bool is_perceived(const PixelRecord& p, const PixelRecord& q) {
    constexpr double just_noticeable = 2.3;  // CIE delta E
    const Lab a = lab_of(p);
    const Lab b = lab_of(q);
    return std::hypot(a.l - b.l, a.a - b.a, a.b - b.b) > just_noticeable;
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
        result.perceived += is_perceived(a, b) ? 1 / count : 0;
        colors.push_back(color_apart(a, b, squares));
    }
    result.mean_depth = both > 0 ? depths / both : 0;
    result.rmse = std::sqrt(squares / (3 * count));
    result.color_99 = percentile_99(std::move(colors));
    return result;
}

}  // namespace pxm::host
