#define FMT_EXCEPTIONS 1  // OpenImageIO's headers would switch them off
#include "host/output/perceived.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <cmath>

namespace pxm::host {

namespace {

/// The colours as a picture; what is no number is black.
OIIO::ImageBuf picture_of(const Frame& frame) {
    const auto columns = static_cast<int>(frame.columns());
    const auto rows = static_cast<int>(frame.rows());
    OIIO::ImageBuf picture(OIIO::ImageSpec(columns, rows, 3, OIIO::TypeDesc::FLOAT));
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            float color[3];
            const PixelRecord& pixel =
                frame.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                             static_cast<std::size_t>(x)];
            for (int k = 0; k < 3; ++k)
                color[k] = std::isfinite(pixel.color[k]) ? pixel.color[k] : 0.0F;
            picture.setpixel(x, y, color);
        }
    }
    return picture;
}

}  // namespace

double perceived_difference(const Frame& a, const Frame& b) {
    OIIO::attribute("threads", 1);
    OIIO::ImageBufAlgo::CompareResults results;
    const int different =
        OIIO::ImageBufAlgo::compare_Yee(picture_of(a), picture_of(b), results, 100, 45, {}, 1);
    return static_cast<double>(different) / static_cast<double>(a.pixels.size());
}

}  // namespace pxm::host
