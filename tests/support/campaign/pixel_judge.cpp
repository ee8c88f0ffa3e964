#include "tests/support/campaign/pixel_judge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "host/compiled/compiled_scene.hpp"
#include "tests/support/referee.hpp"

namespace pxm::test {

using namespace host;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int details = 3;       // as it is, a hair finer, a hair coarser
constexpr int double_index = 1;  // of truths_; 0: single precision

/// What rounding does at most, of the numbers that cells are placed with.
struct Rounding {
    double least_move;  // pixels that a ray is moved by at least
    double step;        // relative error of one operation
    double hair;        // relative error of a cell's diameter
};

Rounding rounding_of(Numeric numeric) {
    switch (numeric) {
        case Numeric::dsp32:
            return {1.0 / 128, 0x1p-23, 1e-4};
        case Numeric::single:
            return {1.0 / 256, 0x1p-24, 1e-4};
        case Numeric::double_:
            break;
    }
    return {1.0 / 65536, 0x1p-53, 1e-9};
}

int objects_of(const CompiledScene& scene) { return static_cast<int>(object_count(scene)); }

bool same_plane(const CompiledScene& scene, const PixelRecord& pixel, double t, int number) {
    const double z = t * scene.unit;
    return pixel.object == objects_of(scene) + number &&
           std::abs(static_cast<double>(pixel.z) - z) <= 1e-3 * std::abs(z);
}

/// Whether the pixel shows that cell, seen by a ray not quite its own: as deep within p.
bool shows_nearly(const CompiledScene& scene, const PixelRecord& pixel, const TerminalCell& cell,
                  double p) {
    PixelRecord as_deep = pixel;
    as_deep.z = static_cast<float>(cell.key * scene.unit);
    const double apart = std::abs(static_cast<double>(pixel.z) / scene.unit - cell.key);
    return apart <= p + 1e-5 * cell.key && shows(scene, as_deep, cell);
}

std::string text_of(const PixelRecord& pixel) {
    if (is_miss(pixel)) return "shows a miss";
    return fmt::format("shows object {} level {} hash {:06x} z {:.9g}", pixel.object, pixel.level,
                       pixel.word, pixel.z);
}

std::string text_of(const CompiledScene& scene, const std::vector<TerminalCell>& cells) {
    if (cells.empty()) return "a miss";
    const TerminalCell& cell = cells.front();
    return fmt::format("object {} level {} z {:.9g} word [{}]", cell.object, cell.word.size(),
                       cell.key * scene.unit, fmt::join(cell.word, " "));
}

const char* alarm_name(unsigned alarms) {
    if (alarms & alarm_capped) return "capped";
    if (alarms & alarm_floored) return "floored";
    if (alarms & alarm_precision) return "precision";
    if (alarms & alarm_overflow) return "overflow";
    return alarms & alarm_not_finite ? "not_finite" : "";
}

/// The alarm that is true of a pixel, or of maps of the whole picture; empty if there is none.
std::string excuse(const JudgedPicture& picture, const PixelRecord& pixel) {
    if (pixel.alarms != 0) return alarm_name(pixel.alarms);
    for (const Alarm& alarm : picture.alarms)
        if (!alarm.of_pixels && alarm.count > 0) return alarm.name;
    return "";
}

}  // namespace

PixelJudge::PixelJudge(const CompiledScene& scene, long patience)
    : scene_(scene), patience_(patience), definitions_(2 * details) {
    floors_ = std::ranges::any_of(scene.objects, [&](const CompiledObject& object) {
        const double away = glm::length(object.instance.translation) - object.diameter;
        const double p =
            scene.camera.pixel_at_eye + scene.camera.pixel_growth * std::max(0.0, away);
        return p < 4 * smallest_share(Numeric::single) * object.diameter;
    });
}

Oracle& PixelJudge::oracle_with(Numeric numeric, int finer) {
    const bool twice = numeric == Numeric::double_;
    const auto index = static_cast<std::size_t>((twice ? details : 0) + finer);
    Definition& definition = definitions_[index];
    if (!definition.oracle) {
        const double hair = rounding_of(numeric).hair;
        definition.scene = scene_;
        definition.scene.detail *= finer == 0 ? 1 : finer == 1 ? 1 - hair : 1 + hair;
        definition.oracle.emplace(definition.scene, smallest_share(numeric), patience_);
    }
    return *definition.oracle;
}

PixelJudge::Truth PixelJudge::truth_of(Oracle& oracle, const Sight& ray) const {
    Truth truth;
    truth.plane = infinity;
    for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
        const CompiledPlane& plane = scene_.planes[i];
        const double height = plane.offset - glm::dot(plane.normal, ray.origin);
        const double t = height / glm::dot(plane.normal, ray.direction);
        if (!(0 < t && t < truth.plane)) continue;
        truth.plane = t;
        truth.plane_number = static_cast<int>(i);
    }
    try {
        truth.cells = oracle.look_near(ray);
        truth.known = true;
    } catch (const std::runtime_error&) {  // too many cells
    }
    return truth;
}

const PixelJudge::Truth& PixelJudge::truth(Numeric numeric, long x, long y) {
    Truth& kept = truths_[numeric == Numeric::double_ || !floors_ ? double_index : 0];
    if (kept.x == x && kept.y == y) return kept;
    Oracle& oracle = oracle_with(numeric, 0);
    kept = truth_of(oracle, oracle.sight(x, y));
    kept.x = x;
    kept.y = y;
    return kept;
}

Opinion PixelJudge::judge(const JudgedPicture& picture, long x, long y) {
    const PixelRecord& pixel = picture.frame.at(x, y);
    const Truth& known = truth(picture.numeric, x, y);
    if (!known.known) return {Standing::unjudged, ""};
    Oracle& oracle = oracle_with(picture.numeric, 0);
    Opinion opinion = by_truth(picture, oracle, known);
    if (opinion.standing != Standing::find) return opinion;
    const std::string alarm = excuse(picture, pixel);
    if (!alarm.empty()) return {Standing::excused, alarm};
    if (shown_by_a_near_ray(picture, x, y)) return {Standing::rounded, ""};
    return opinion;
}

Opinion PixelJudge::by_truth(const JudgedPicture& picture, Oracle& oracle,
                             const Truth& truth) const {
    const PixelRecord& pixel = picture.frame.at(truth.x, truth.y);
    const auto wrong = [&](const std::string& what) {
        return Opinion{Standing::find,
                       fmt::format("{}; by the definition {}", what, text_of(scene_, truth.cells))};
    };
    const double first = truth.cells.empty() ? infinity : truth.cells.front().key;
    const double p = truth.cells.empty() ? 0 : oracle.pixel_size(truth.cells.front().object, first);
    if (pixel.object >= objects_of(scene_) || std::min(first, truth.plane) == infinity) {
        const bool right = std::isfinite(truth.plane)
                               ? truth.plane <= first + p &&
                                     same_plane(scene_, pixel, truth.plane, truth.plane_number)
                               : is_miss(pixel);
        return right ? Opinion{} : wrong(text_of(pixel));
    }
    const auto shown = std::ranges::find_if(
        truth.cells, [&](const TerminalCell& cell) { return shows(scene_, pixel, cell); });
    if (shown == truth.cells.end() || shown->key > std::min(first, truth.plane) + p)
        return wrong(text_of(pixel));
    if (needs_plain_features(scene_) && scene_.planes.empty()) {
        const glm::dvec3 color = oracle.appearance(oracle.sight(truth.x, truth.y), *shown).color;
        if (!same_color(pixel, color)) {
            return wrong(fmt::format("colour {:.4f} {:.4f} {:.4f} instead of {:.4f} {:.4f} {:.4f}",
                                     pixel.color[0], pixel.color[1], pixel.color[2], color.x,
                                     color.y, color.z));
        }
    }
    return {shown == truth.cells.begin() ? Standing::same : Standing::admitted, ""};
}

/// How far rounding moves a ray at most, in pixels: the sum of many steps in the last place of the
/// coordinates there. Where that is more than a quarter pixel, the alarm `precision` is near.
double PixelJudge::ray_error(const JudgedPicture& picture, const PixelRecord& pixel) const {
    constexpr double steps = 16;
    const Rounding rounding = rounding_of(picture.numeric);
    double coordinates = 0, nearest = infinity;
    for (const CompiledObject& object : scene_.objects) {
        const double distance = glm::length(object.instance.translation);
        coordinates = std::max({coordinates, distance, object.diameter});
        nearest = std::min(nearest, std::max(0.0, distance - object.diameter));
    }
    const double z = is_miss(pixel) ? nearest : static_cast<double>(pixel.z) / scene_.unit;
    const double p = scene_.camera.pixel_at_eye + scene_.camera.pixel_growth * z;
    return std::clamp(steps * rounding.step * coordinates / p, rounding.least_move, 0.25);
}

bool PixelJudge::shown_by_a_near_ray(const JudgedPicture& picture, long x, long y) {
    constexpr int side = 5;  // places around the pixel's own, in a square
    const PixelRecord& pixel = picture.frame.at(x, y);
    const double step = ray_error(picture, pixel) / (side / 2);
    for (int finer = 0; finer < details; ++finer) {
        Oracle& oracle = oracle_with(picture.numeric, finer);
        for (int i = 0; i < side * side; ++i) {
            const glm::dvec2 moved = step * glm::dvec2{i % side - side / 2, i / side - side / 2};
            if (is_shown_by(oracle, oracle.sight(x, y, moved), pixel)) return true;
        }
    }
    return false;
}

bool PixelJudge::is_shown_by(Oracle& oracle, const Sight& ray, const PixelRecord& pixel) const {
    const Truth truth = truth_of(oracle, ray);
    if (!truth.known) return false;
    const double first = truth.cells.empty() ? infinity : truth.cells.front().key;
    const double p = truth.cells.empty() ? 0 : oracle.pixel_size(truth.cells.front().object, first);
    if (pixel.object >= objects_of(scene_)) {
        return truth.plane <= first + p &&
               same_plane(scene_, pixel, truth.plane, truth.plane_number);
    }
    if (std::min(first, truth.plane) == infinity) return is_miss(pixel);
    const bool colored = needs_plain_features(scene_) && scene_.planes.empty();
    return std::ranges::any_of(truth.cells, [&](const TerminalCell& cell) {
        return cell.key <= std::min(first, truth.plane) + p &&
               shows_nearly(scene_, pixel, cell, p) &&
               (!colored || same_color(pixel, oracle.appearance(ray, cell).color));
    });
}

}  // namespace pxm::test
