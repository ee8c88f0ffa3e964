#include "host/output/raw_frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pxm::host {

namespace {

class PpmStream : public FrameStream {
  public:
    PpmStream(CheckedFile& file, const FilmShape& shape)
        : file_(file), head_(fmt::format("P6\n{} {}\n255\n", shape.columns, shape.rows)) {}

    void frame(std::span<const unsigned char> rgb) override {
        file_.append(head_.data(), head_.size());
        file_.append(rgb.data(), rgb.size());
    }
    void finish() override { file_.sync(); }

  private:
    CheckedFile& file_;
    std::string head_;
};

/// The rate as a fraction with a denominator that players know.
std::string fraction(double rate) {
    for (const long denominator : {1L, 1001L, 1000L, 1'000'000L}) {
        const double numerator = rate * static_cast<double>(denominator);
        if (std::abs(numerator - std::round(numerator)) < 1e-9 * numerator ||
            denominator == 1'000'000L)
            return fmt::format("{}:{}", std::lround(numerator), denominator);
    }
    return {};
}

/// BT.709 in limited range, in 16 bits behind the point: 219 steps of luma from 16, 224 of chroma
/// about 128.
struct Yuv {
    explicit Yuv(const unsigned char* rgb) {
        const long r = rgb[0], g = rgb[1], b = rgb[2];
        y = byte(16 * one + weight(219 * 0.2126) * r + weight(219 * 0.7152) * g +
                 weight(219 * 0.0722) * b);
        u = byte(128 * one - weight(224 * 0.2126 / 1.8556) * r - weight(224 * 0.7152 / 1.8556) * g +
                 weight(224 * 0.5) * b);
        v = byte(128 * one + weight(224 * 0.5) * r - weight(224 * 0.7152 / 1.5748) * g -
                 weight(224 * 0.0722 / 1.5748) * b);
    }
    static constexpr long one = 1L << 16;
    static constexpr long weight(double of_full) {
        return static_cast<long>(of_full / 255 * one + 0.5);
    }
    static unsigned char byte(long value) {
        return static_cast<unsigned char>((value + one / 2) >> 16);
    }
    unsigned char y, u, v;
};

class Y4mStream : public FrameStream {
  public:
    Y4mStream(CheckedFile& file, const FilmShape& shape)
        : file_(file), pixels_(static_cast<std::size_t>(shape.columns * shape.rows)) {
        const std::string head =
            fmt::format("YUV4MPEG2 W{} H{} F{} Ip A1:1 C444 XCOLORRANGE=LIMITED\n", shape.columns,
                        shape.rows, fraction(shape.rate));
        file_.append(head.data(), head.size());
    }

    void frame(std::span<const unsigned char> rgb) override {
        std::vector<unsigned char> planes(3 * pixels_);
        for (std::size_t i = 0; i < pixels_; ++i) {
            const Yuv yuv(&rgb[3 * i]);
            planes[i] = yuv.y;
            planes[pixels_ + i] = yuv.u;
            planes[2 * pixels_ + i] = yuv.v;
        }
        constexpr std::string_view head = "FRAME\n";
        file_.append(head.data(), head.size());
        file_.append(planes.data(), planes.size());
    }
    void finish() override { file_.sync(); }

  private:
    CheckedFile& file_;
    std::size_t pixels_;
};

}  // namespace

std::unique_ptr<FrameStream> make_raw_stream(CheckedFile& file, RawFormat format,
                                             const FilmShape& shape) {
    if (format == RawFormat::ppm) return std::make_unique<PpmStream>(file, shape);
    return std::make_unique<Y4mStream>(file, shape);
}

}  // namespace pxm::host
