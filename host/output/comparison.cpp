#include "host/output/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "host/engine/aov.hpp"
#include "host/error.hpp"

namespace pxm::host {

namespace {

constexpr double color_step = 1.0 / 255;

/// a - b; 0 where they are equal though infinite.
double difference(float a, float b) { return a == b ? 0 : double{a} - double{b}; }

double number(const ImageHeader& image, const char* name) {
    const std::string* text = image.find(name);
    return text ? std::atof(text->c_str()) : 0;
}

/// The channel by its name or the one that it had before.
int channel_of(const ImageHeader& image, Aov aov) {
    const AovChannel channel = channels_of(aov).front();
    const int found = image.channel(channel.name);
    return found >= 0 ? found : image.channel(channel.old_name);
}

}  // namespace

ImageComparison::ImageComparison(const ImageHeader& a, const ImageHeader& b)
    : width_(static_cast<std::size_t>(a.width)),
      channels_a_(a.channels.size()),
      channels_b_(b.channels.size()),
      rgb_{{a.channel("R"), b.channel("R")},
           {a.channel("G"), b.channel("G")},
           {a.channel("B"), b.channel("B")}},
      z_{channel_of(a, Aov::z), channel_of(b, Aov::z)},
      word_{channel_of(a, Aov::word), channel_of(b, Aov::word)},
      object_{channel_of(a, Aov::object), channel_of(b, Aov::object)},
      pixel_at_eye_(number(a, "pixel_at_eye")),
      pixel_growth_(number(a, "pixel_growth")) {
    if (a.width != b.width || a.height != b.height) {
        throw Error(ErrorKind::file, fmt::format("the images differ in size: {}x{} and {}x{}",
                                                 a.width, a.height, b.width, b.height));
    }
    for (const ChannelPair& channel : rgb_) {
        if (!channel.present()) throw Error(ErrorKind::file, "an image has no R, G, B channels");
    }
}

void ImageComparison::add_row(const float* a, const float* b) {
    for (std::size_t x = 0; x < width_; ++x) add_pixel(a + x * channels_a_, b + x * channels_b_);
}

void ImageComparison::add_pixel(const float* a, const float* b) {
    const bool hit_a = !z_.present() || std::isfinite(a[z_.a]);
    const bool hit_b = !z_.present() || std::isfinite(b[z_.b]);
    const bool both = hit_a && hit_b;
    const bool hit = hit_a != hit_b;
    const bool word = both && other_word(a, b);
    const bool depth = both && other_depth(a, b);
    // A hit beside a miss is one difference, not two.
    const bool color = other_color(a, b) && !hit;
    ++pixels_;
    hits_ += hit;
    words_ += word;
    depths_ += depth;
    colors_ += color;
    other_cell_colors_ += color && word;
    different_ += hit || depth || color;
}

bool ImageComparison::other_word(const float* a, const float* b) const {
    return (word_.present() && a[word_.a] != b[word_.b]) ||
           (object_.present() && a[object_.a] != b[object_.b]);
}

bool ImageComparison::other_depth(const float* a, const float* b) {
    if (!z_.present()) return false;
    const double depth = a[z_.a];
    const double p = pixel_at_eye_ + pixel_growth_ * depth;
    if (!(p > 0)) return false;
    const double apart = std::abs(depth - b[z_.b]) / p;
    worst_depth_ = std::max(worst_depth_, apart);
    return apart > 1;
}

bool ImageComparison::other_color(const float* a, const float* b) {
    bool other = false;
    for (const ChannelPair& channel : rgb_) {
        const double d = difference(a[channel.a], b[channel.b]);
        squares_ += d * d;
        other = other || !(std::abs(d) <= color_step);  // NaN differs
    }
    return other;
}

Comparison ImageComparison::result() const {
    const auto share = [&](std::size_t n) {
        return static_cast<double>(n) / static_cast<double>(pixels_);
    };
    Comparison result;
    if (z_.present()) result.hits = share(hits_);
    if (word_.present() || object_.present()) result.words = share(words_);
    if (z_.present() && (pixel_at_eye_ > 0 || pixel_growth_ > 0)) {
        result.depths = share(depths_);
        result.worst_depth = worst_depth_;
    }
    result.colors = share(colors_);
    result.other_cell_colors = share(other_cell_colors_);
    result.rmse = std::sqrt(squares_ / static_cast<double>(3 * pixels_));
    result.different = share(different_);
    return result;
}

}  // namespace pxm::host
