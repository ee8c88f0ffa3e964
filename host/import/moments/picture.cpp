#include "host/import/moments/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/error.hpp"
#include "host/import/fractint/fractint_reader.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

/// Luminance over black: colour times alpha.
std::vector<double> grey_of(const LoadedImage& image) {
    const int r = image.channel("R");
    const int g = image.channel("G");
    const int b = image.channel("B");
    const int alpha = image.channel("A");
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    std::vector<double> grey(pixels);
    for (std::size_t p = 0; p < pixels; ++p) {
        const double value =
            r >= 0 && g >= 0 && b >= 0
                ? 0.2126 * image.at(p, r) + 0.7152 * image.at(p, g) + 0.0722 * image.at(p, b)
                : image.at(p, 0);  // Rec. 709 luminance, or a grey channel
        grey[p] = value * (alpha >= 0 ? image.at(p, alpha) : 1.0F);
        if (!std::isfinite(grey[p])) grey[p] = 0;
    }
    return grey;
}

/// The median of the outermost pixels.
double border_of(const LoadedImage& image, const std::vector<double>& grey) {
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<double> border;
    for (std::size_t p = 0; p < grey.size(); ++p) {
        const std::size_t x = p % width;
        const std::size_t y = p / width;
        if (x == 0 || y == 0 || x + 1 == width || (y + 1) * width == grey.size())
            border.push_back(grey[p]);
    }
    const auto middle = border.begin() + static_cast<std::ptrdiff_t>(border.size() / 2);
    std::nth_element(border.begin(), middle, border.end());
    return *middle;
}

}  // namespace

PlaneMeasure picture_of(const LoadedImage& image) {
    constexpr double background = 0.25;  // of the largest ink: less is none
    if (image.width <= 0 || image.height <= 0 || image.channels.empty())
        throw Error(ErrorKind::scene, "nothing to import: the image is empty");
    std::vector<double> ink = grey_of(image);
    const double border = border_of(image, ink);
    double most = 0;
    for (double& value : ink) {
        value = std::abs(value - border);
        most = std::max(most, value);
    }
    if (!(most > 1.0 / 255)) throw Error(ErrorKind::scene, "nothing to import: the image is blank");
    const double unit = 2.0 / std::max(image.width, image.height);
    const auto width = static_cast<std::size_t>(image.width);
    PlaneMeasure picture;
    picture.finest = unit;
    const auto is_ink = [&](double value) { return value >= background * most; };
    picture.points.reserve(static_cast<std::size_t>(std::ranges::count_if(ink, is_ink)));
    for (std::size_t p = 0; p < ink.size(); ++p) {
        if (!is_ink(ink[p])) continue;
        picture.points.push_back(
            {(static_cast<double>(p % width) + 0.5 - image.width / 2.0) * unit,
             (image.height / 2.0 - static_cast<double>(p / width) - 0.5) * unit, ink[p] / most});
    }
    return picture;
}

PlaneMeasure read_points(const std::string& name, const std::string& text) {
    PlaneMeasure picture;
    Position place;
    Diagnostics diagnostics;
    for (std::size_t begin = 0; begin < text.size() && !diagnostics.full(); ++place.line) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string line = text.substr(begin, end - begin);
        begin = end + 1;
        line.resize(std::min(line.find_first_of("#;"), line.size()));
        std::ranges::replace(line, ',', ' ');
        std::vector<double> numbers;
        bool good = true;
        for (std::size_t at = line.find_first_not_of(" \t\r"); at < line.size();) {
            const std::size_t stop = std::min(line.find_first_of(" \t\r", at), line.size());
            double value = 0;
            good = good && read_number(std::string_view(line).substr(at, stop - at), value);
            numbers.push_back(value);
            at = line.find_first_not_of(" \t\r", stop);
        }
        if (numbers.empty()) continue;
        const double weight = numbers.size() > 2 ? numbers[2] : 1.0;
        if (!good || numbers.size() < 2 || numbers.size() > 3 || !(weight >= 0)) {
            diagnostics.error(place, "expected a point: x y, or x y weight");
            continue;
        }
        picture.points.push_back({numbers[0], numbers[1], weight});
    }
    diagnostics.throw_if_errors({{name, text}});
    double mass = 0;
    for (const WeightedPoint& p : picture.points) mass += p.weight;
    if (!(mass > 0)) throw Error(ErrorKind::scene, name + ": no points");
    return picture;
}

}  // namespace pxm::host
