// bench_compare_depths A.exr DEPTHS: whether pxm (channel Z) and a program of bench/ (raw floats,
// row by row) see the same: shares of pixels that only one of them hits, and where both hit those
// with depths more than a pixel apart.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "host/error.hpp"
#include "host/files/image_reader.hpp"

namespace {

using namespace pxm::host;

std::vector<float> read_depths(const std::string& path, std::size_t pixels) {
    std::vector<float> depths(pixels);
    std::ifstream in(path, std::ios::binary);
    in.read(reinterpret_cast<char*>(depths.data()),
            static_cast<std::streamsize>(pixels * sizeof(float)));
    if (!in) throw Error(ErrorKind::file, fmt::format("{}: fewer than {} depths", path, pixels));
    return depths;
}

double number(const LoadedImage& image, const char* name) {
    const std::string* text = image.find(name);
    return text ? std::atof(text->c_str()) : 0;
}

void compare(const std::string& picture, const std::string& dump) {
    const LoadedImage image = read_image(picture, {"Z"});
    const int z = image.channel("Z");
    if (z < 0) throw Error(ErrorKind::file, picture + ": no channel Z");
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const std::vector<float> depths = read_depths(dump, pixels);
    const double at_eye = number(image, "pixel_at_eye");
    const double growth = number(image, "pixel_growth");
    double hits = 0;
    double one_only = 0;
    double apart = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const double a = double{image.at(i, z)};
        const double b = double{depths[i]};
        hits += std::isfinite(a) ? 1 : 0;
        if (std::isfinite(a) != std::isfinite(b)) ++one_only;
        if (std::isfinite(a) && std::isfinite(b)) {
            apart += std::abs(a - b) > at_eye + growth * a ? 1 : 0;
        }
    }
    const auto all = static_cast<double>(pixels);
    fmt::print("{:.2f} % hit, {:.4f} % by one only, {:.4f} % over a pixel apart\n",
               100 * hits / all, 100 * one_only / all, 100 * apart / all);
}

}  // namespace

int main(int count, char** values) {
    if (count != 3) {
        fmt::print(stderr, "usage: bench_compare_depths A.exr DEPTHS\n");
        return 2;
    }
    try {
        compare(values[1], values[2]);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 4;
    }
}
