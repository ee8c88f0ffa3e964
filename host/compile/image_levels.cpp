#include "host/compile/image_levels.hpp"

#include <algorithm>
#include <cmath>

namespace pxm::host {

namespace {

constexpr double largest_root = 1023;  // 10 bits

/// Source texels that lie in one texel of a shorter row, with their shares.
struct Part {
    int texel;
    double share;
};

/// For each of `to` texels the ones of `from` in it: whole ones, and the cut ones at its ends.
std::vector<std::vector<Part>> parts_of(int from, int to) {
    std::vector<std::vector<Part>> parts(static_cast<std::size_t>(to));
    const double width = static_cast<double>(from) / to;
    for (int i = 0; i < to; ++i) {
        const double begin = i * width;
        const double end = (i + 1) * width;
        for (int texel = static_cast<int>(begin); texel < from && texel < end; ++texel) {
            const double share = std::min(texel + 1.0, end) - std::max<double>(texel, begin);
            if (share > 0) parts[static_cast<std::size_t>(i)].push_back({texel, share / width});
        }
    }
    return parts;
}

LinearPicture halve(const LinearPicture& picture) {
    LinearPicture half{std::max(1, picture.width / 2), std::max(1, picture.height / 2), {}};
    const auto columns = parts_of(picture.width, half.width);
    const auto rows = parts_of(picture.height, half.height);
    for (const auto& row : rows) {
        for (const auto& column : columns) {
            std::array<double, 3> sum{};
            for (const Part& y : row) {
                for (const Part& x : column) {
                    const auto& texel = picture.pixels[static_cast<std::size_t>(y.texel) *
                                                           static_cast<std::size_t>(picture.width) +
                                                       static_cast<std::size_t>(x.texel)];
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += x.share * y.share * texel[c];
                }
            }
            half.pixels.push_back({static_cast<float>(sum[0]), static_cast<float>(sum[1]),
                                   static_cast<float>(sum[2])});
        }
    }
    return half;
}

/// Ten bits each of the square roots of red, green and blue.
std::uint32_t pack(const std::array<float, 3>& texel, double unit) {
    const auto bits = [unit](double value) {
        return static_cast<std::uint32_t>(std::lround(std::sqrt(value / unit)));
    };
    return bits(texel[0]) << 20 | bits(texel[1]) << 10 | bits(texel[2]);
}

}  // namespace

std::vector<LinearPicture> make_levels(LinearPicture picture) {
    for (auto& texel : picture.pixels) {
        // Files of floats may hold what is no brightness.
        for (float& value : texel) value = value > 0 ? std::min(value, 1e6F) : 0.0F;
    }
    std::vector<LinearPicture> levels{std::move(picture)};
    while (levels.back().width > 1 || levels.back().height > 1) {
        levels.push_back(halve(levels.back()));
    }
    return levels;
}

void store_levels(const std::vector<LinearPicture>& levels, CompiledTexture& texture,
                  std::vector<std::uint32_t>& texture_words) {
    float brightest = 1;
    for (const auto& texel : levels.front().pixels) {
        brightest = std::max({brightest, texel[0], texel[1], texel[2]});
    }
    texture.unit = brightest / (largest_root * largest_root);
    for (const LinearPicture& level : levels) {
        texture.levels.push_back({static_cast<std::uint32_t>(level.width),
                                  static_cast<std::uint32_t>(level.height),
                                  static_cast<std::uint32_t>(texture_words.size())});
        for (const auto& texel : level.pixels) {
            texture_words.push_back(pack(texel, texture.unit));
        }
    }
    const auto& mean = levels.back().pixels.front();
    texture.mean = {mean[0], mean[1], mean[2]};
}

}  // namespace pxm::host
