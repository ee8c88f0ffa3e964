#include "tests/support/referee.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace pxm::test {

using namespace host;

namespace {

constexpr int reported = 5;
constexpr double rounding = 1e-9;  // of p
constexpr double color_tolerance = 1.0 / 255;
constexpr double share_single = 0x1p-20;  // of an object's diameter: p never falls below
constexpr double share_twice = 0x1p-48;

/// z is a float in world units.
bool same_depth(const CompiledScene& scene, const PixelRecord& pixel, double key) {
    const double z = key * scene.unit;
    const double reach = scene.camera.pixel_at_eye + scene.camera.pixel_growth * key;
    return std::abs(static_cast<double>(pixel.z) - z) <= 1e-3 * reach * scene.unit + 1e-6 * z;
}

std::string text_of(const CompiledScene& scene, const TerminalCell& cell) {
    return fmt::format("object {} word [{}] z {:.9g}", cell.object, fmt::join(cell.word, " "),
                       cell.key * scene.unit);
}

/// Judges one pixel after the other and keeps the score.
class Referee {
  public:
    Referee(const CompiledScene& scene, Numeric numeric)
        : scene_(scene), oracle_(scene, smallest_share(numeric)) {}

    void look_at(long x, long y, const PixelRecord& pixel) {
        const Sight ray = oracle_.sight(x, y);
        const std::vector<TerminalCell> cells = oracle_.look(ray);
        ++verdict_.pixels;
        if (cells.empty()) {
            look_at_miss(x, y, pixel);
            return;
        }
        ++verdict_.hits;
        const TerminalCell& first = cells.front();
        const auto shown = std::ranges::find_if(
            cells, [&](const TerminalCell& cell) { return shows(scene_, pixel, cell); });
        const double p = oracle_.pixel_size(first.object, first.key);
        const double behind = shown == cells.end() ? INFINITY : (shown->key - first.key) / p;
        if (behind <= 1) {
            ++verdict_.admissible;
            check_color(x, y, pixel, oracle_.appearance(ray, *shown).color);
        }
        if (shown == cells.begin()) {
            ++verdict_.same;
            return;
        }
        verdict_.tied += behind <= rounding ? 1 : 0;
        report(x, y, pixel, text_of(scene_, first), behind);
    }

    Verdict take() { return std::move(verdict_); }

  private:
    void look_at_miss(long x, long y, const PixelRecord& pixel) {
        if (!is_miss(pixel)) {
            report(x, y, pixel, "a miss", INFINITY);
            return;
        }
        ++verdict_.same;
        ++verdict_.admissible;
        check_color(x, y, pixel, scene_.background);
    }
    void check_color(long x, long y, const PixelRecord& pixel, const glm::dvec3& color) {
        if (same_color(pixel, color)) return;
        if (++verdict_.wrong_colors > reported) return;
        verdict_.report += fmt::format(
            "pixel {},{}: colour {:.6g} {:.6g} {:.6g}, by the oracle {:.6g} {:.6g} {:.6g}\n", x, y,
            pixel.color[0], pixel.color[1], pixel.color[2], color.x, color.y, color.z);
    }
    void report(long x, long y, const PixelRecord& pixel, const std::string& expected,
                double behind) {
        if (++reports_ > reported) return;
        verdict_.report += fmt::format(
            "pixel {},{}: object {} level {} hash {:06x} z {:.9g}, {:.3g} p behind; by the oracle "
            "{}\n",
            x, y, pixel.object, pixel.level, pixel.word, pixel.z, behind, expected);
    }

    const CompiledScene& scene_;
    Oracle oracle_;
    Verdict verdict_;
    int reports_ = 0;
};

}  // namespace

bool shows(const CompiledScene& scene, const PixelRecord& pixel, const TerminalCell& cell) {
    const CompiledObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    std::vector<int> word = object.prefix;
    word.insert(word.end(), cell.word.begin(), cell.word.end());
    return pixel.object == object.origin && pixel.level == static_cast<int>(word.size()) &&
           pixel.word == hash_of(word) && same_depth(scene, pixel, cell.key);
}

bool is_miss(const PixelRecord& pixel) {
    return pixel.object == -1 && pixel.level == -1 && pixel.word == 0 && pixel.alpha == 0 &&
           std::isinf(pixel.z);
}

bool same_color(const PixelRecord& pixel, const glm::dvec3& color) {
    for (int i = 0; i < 3; ++i) {
        if (!(std::abs(static_cast<double>(pixel.color[i]) - color[i]) <= color_tolerance)) {
            return false;
        }
    }
    return true;
}

double smallest_share(Numeric numeric) {
    return numeric == Numeric::double_ ? share_twice : share_single;
}

std::uint32_t hash_of(const std::vector<int>& word) {
    std::uint32_t hash = 2166136261U;  // FNV-1a: the bytes of each symbol + 1, then 255
    const auto take = [&](std::uint32_t byte) { hash = (hash ^ byte) * 16777619U; };
    for (const int symbol : word) {
        for (auto rest = static_cast<std::uint32_t>(symbol) + 1; rest != 0; rest /= 256) {
            take(rest % 256);
        }
        take(255);
    }
    const std::uint32_t folded = (hash / (1U << 24U) ^ hash) % (1U << 24U);
    return std::max(folded, 1U);
}

Verdict judge(const CompiledScene& scene, const Frame& frame, Numeric numeric) {
    Referee referee(scene, numeric);
    for (long y = frame.crop.y0; y < frame.crop.y1; ++y) {
        for (long x = frame.crop.x0; x < frame.crop.x1; ++x) {
            referee.look_at(x, y, frame.at(x, y));
        }
    }
    return referee.take();
}

}  // namespace pxm::test
