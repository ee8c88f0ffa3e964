#include "host/output/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "host/error.hpp"

namespace pxm::host {

namespace {

constexpr double color_step = 1.0 / 255;

/// a - b; 0 where they are equal though infinite.
double difference(float a, float b) { return a == b ? 0 : double{a} - double{b}; }

/// p at a depth, from the first file's metadata; 0 if it is not told.
class PixelMeasure {
  public:
    explicit PixelMeasure(const LoadedImage& image)
        : at_eye_(number(image, "pixel_at_eye")), growth_(number(image, "pixel_growth")) {}
    [[nodiscard]] double at(double depth) const { return at_eye_ + growth_ * depth; }
    [[nodiscard]] bool known() const { return at_eye_ > 0 || growth_ > 0; }

  private:
    static double number(const LoadedImage& image, const char* name) {
        const std::string* text = image.find(name);
        return text ? std::atof(text->c_str()) : 0;
    }
    double at_eye_;
    double growth_;
};

/// The same channel of both images, or nothing.
struct ChannelPair {
    int a = -1;
    int b = -1;
    [[nodiscard]] bool present() const { return a >= 0 && b >= 0; }
};

ChannelPair pair_of(const LoadedImage& a, const LoadedImage& b, const char* name) {
    return {a.channel(name), b.channel(name)};
}

}  // namespace

Comparison compare_images(const LoadedImage& a, const LoadedImage& b) {
    if (a.width != b.width || a.height != b.height) {
        throw Error(ExitCode::file, fmt::format("the images differ in size: {}x{} and {}x{}",
                                                a.width, a.height, b.width, b.height));
    }
    const ChannelPair rgb[3] = {pair_of(a, b, "R"), pair_of(a, b, "G"), pair_of(a, b, "B")};
    for (const ChannelPair& channel : rgb) {
        if (!channel.present()) throw Error(ExitCode::file, "an image has no R, G, B channels");
    }
    const ChannelPair z = pair_of(a, b, "Z");
    const ChannelPair word = pair_of(a, b, "word");
    const ChannelPair object = pair_of(a, b, "object");
    const PixelMeasure p(a);
    const bool depths_known = z.present() && p.known();

    const std::size_t pixels =
        static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
    std::size_t hits = 0, words = 0, depths = 0, colors = 0, different = 0;
    double squares = 0;
    double worst_depth = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const bool hit_a = !z.present() || std::isfinite(a.at(i, z.a));
        const bool hit_b = !z.present() || std::isfinite(b.at(i, z.b));
        const bool both = hit_a && hit_b;
        const bool other_hit = hit_a != hit_b;
        const bool other_word =
            both && ((word.present() && a.at(i, word.a) != b.at(i, word.b)) ||
                     (object.present() && a.at(i, object.a) != b.at(i, object.b)));
        bool other_depth = false;
        if (both && depths_known) {
            const double depth = a.at(i, z.a);
            const double apart = std::abs(depth - b.at(i, z.b)) / p.at(depth);
            worst_depth = std::max(worst_depth, apart);
            other_depth = apart > 1;
        }
        bool other_color = false;
        for (const ChannelPair& channel : rgb) {
            const double d = difference(a.at(i, channel.a), b.at(i, channel.b));
            squares += d * d;
            other_color = other_color || !(std::abs(d) <= color_step);  // NaN differs
        }
        other_color = other_color && !other_word && !other_hit;
        hits += other_hit;
        words += other_word;
        depths += other_depth;
        colors += other_color;
        different += other_hit || other_depth || other_color;
    }
    const auto share = [&](std::size_t n) {
        return static_cast<double>(n) / static_cast<double>(pixels);
    };
    Comparison result;
    if (z.present()) result.hits = share(hits);
    if (word.present() || object.present()) result.words = share(words);
    if (depths_known) {
        result.depths = share(depths);
        result.worst_depth = worst_depth;
    }
    result.colors = share(colors);
    result.rmse = std::sqrt(squares / static_cast<double>(3 * pixels));
    result.different = share(different);
    return result;
}

}  // namespace pxm::host
