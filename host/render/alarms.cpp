#include "host/render/alarms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "dsp_kernels/scene_block.hpp"
#include "host/compile/extent.hpp"
#include "host/math/lipschitz.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "pxm/dsp32/float.hpp"

namespace pxm::host {

namespace {

constexpr double rounding = 1e-4;  // of a depth
constexpr double least_ulps = 32;  // where float begins to show wrong pixels (docs/studies.md)

using Precision = AlarmTally::Precision;
using Place = AlarmTally::Place;

Precision precision_of(Numeric numeric) {
    switch (numeric) {
        case Numeric::dsp32:
            return {"dsp32", 0x1p-23, smallest_pixel_share<dsp32::Float>(), 0x1p9, 1e18};
        case Numeric::single:
            return {"float", 0x1p-24, smallest_pixel_share<float>(), 0x1p9, 1e18};
        case Numeric::double_:
            break;
    }
    return {"double", 0x1p-53, smallest_pixel_share<double>(), 0x1p26, 1e150};
}

Place place_of(const CompiledScene& scene, const CompiledObject& object) {
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    const CompiledVolume& volume = shape.sets[static_cast<std::size_t>(object.start)].volume;
    const double distance = glm::length(object.instance.point(volume.center));
    const double begin = std::max(0.0, distance - object.diameter / 2);
    if (object.prefix.empty()) {
        return {object.origin, distance, object.diameter, begin,
                std::numeric_limits<double>::infinity()};
    }
    const Extent reach =
        extent(volume, object.instance.linear, object.instance.point(middle(volume)));
    return {object.origin, distance, object.diameter, std::max(begin, reach.distance()),
            glm::length(reach.center) + reach.radius()};
}

std::vector<Place> places_of(const CompiledScene& scene) {
    std::vector<Place> places;
    for (const CompiledObject& object : scene.objects) places.push_back(place_of(scene, object));
    return places;
}

double pixel_at(const CompiledScene& scene, double distance) {
    return scene.camera.pixel_at_eye + scene.camera.pixel_growth * distance;
}

/// Alarms of a pixel that looks at an object from this distance on.
std::uint8_t look(const CompiledScene& scene, const Precision& precision, double distance,
                  const Place& place) {
    const double p = pixel_at(scene, distance) * std::min(1.0, scene.detail);
    const double coordinates = std::max({distance, place.distance, place.diameter});
    std::uint8_t alarms = 0;
    if (p < least_ulps * precision.step * coordinates) alarms |= alarm_precision;
    if (p < precision.smallest_share * place.diameter) alarms |= alarm_floored;
    return alarms;
}

bool is_finite(const PixelRecord& pixel) {
    const auto all = [](const float(&v)[3]) {
        return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
    };
    return all(pixel.color) && all(pixel.normal) && (pixel.level < 0 || std::isfinite(pixel.z));
}

std::uint64_t count_of(const std::array<std::uint64_t, 256>& counts, PixelAlarm alarm,
                       std::uint8_t of_all) {
    std::uint64_t count = 0;
    for (std::size_t bits = 0; bits < counts.size(); ++bits)
        if (((bits | of_all) & alarm) != 0) count += counts[bits];
    return count;
}

template <class Wrong>
std::uint64_t count_maps(const CompiledScene& scene, const Wrong& wrong) {
    std::uint64_t count = 0;
    for (const CompiledShape& shape : scene.shapes)
        for (const CompiledMap& map : shape.maps) count += wrong(map) ? 1 : 0;
    return count;
}

bool is_out_of_range(const CompiledMap& map, double largest) {
    const Affine back = inverse(map.map);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(back.linear[i][j]) <= largest)) return true;
        if (!(std::abs(back.translation[i]) <= largest)) return true;
    }
    return false;
}

}  // namespace

AlarmTally::AlarmTally(const CompiledScene& scene, Numeric numeric)
    : scene_(scene),
      precision_(precision_of(numeric)),
      places_(places_of(scene)),
      objects_(static_cast<int>(object_count(scene))) {}

/// Of a pixel that shows one of the objects that a scene's object became, whichever it is.
std::uint8_t AlarmTally::alarms_of(const PixelRecord& hit) const {
    const double distance = double{hit.z} / scene_.unit;
    std::uint8_t alarms = 0;
    for (const Place& place : places_) {
        const bool there = std::isinf(place.end) || (place.begin * (1 - rounding) <= distance &&
                                                     distance <= place.end * (1 + rounding));
        if (place.origin == hit.object && there)
            alarms |= look(scene_, precision_, distance, place);
    }
    return alarms;
}

/// What is true of every pixel that misses: it might have met an object as near as any pixel does,
/// or as near as the object's volume begins if none does.
std::uint8_t AlarmTally::alarms_of_misses() const {
    std::uint8_t alarms = 0;
    for (const Place& place : places_) {
        const double from = std::isfinite(nearest_) ? std::max(place.begin, nearest_) : place.begin;
        if (from <= place.end) alarms |= look(scene_, precision_, from, place);
    }
    return alarms;
}

void AlarmTally::add(const Frame& part) {
    Counts hits{}, misses{};
    double nearest = std::numeric_limits<double>::infinity();
    for (const PixelRecord& pixel : part.pixels) {
        const unsigned own = pixel.alarms | (is_finite(pixel) ? 0U : unsigned{alarm_not_finite});
        if (pixel.level >= 0) nearest = std::min(nearest, double{pixel.z} / scene_.unit);
        if (is_hit(pixel)) {
            ++hits[own | alarms_of(pixel)];
        } else {
            ++misses[own];
        }
    }
    const std::lock_guard lock(mutex_);
    for (std::size_t bits = 0; bits < hits.size(); ++bits) {
        hits_[bits] += hits[bits];
        misses_[bits] += misses[bits];
    }
    nearest_ = std::min(nearest_, nearest);
}

void AlarmTally::mark(Frame& whole) const {
    const std::uint8_t missed = alarms_of_misses();
    for (PixelRecord& pixel : whole.pixels) {
        pixel.alarms |= is_hit(pixel) ? alarms_of(pixel) : missed;
        if (!is_finite(pixel)) pixel.alarms |= alarm_not_finite;
    }
}

std::vector<Alarm> AlarmTally::alarms() const {
    const CompiledScene& scene = scene_;
    const Precision& precision = precision_;
    const std::uint8_t missed = alarms_of_misses();
    const auto pixels = [&](PixelAlarm alarm) {
        return count_of(hits_, alarm, 0) + count_of(misses_, alarm, missed);
    };
    const auto steep = [&](const CompiledMap& map) {
        const auto values = singular_values(map.map.linear).values;
        return map.lost.empty() && !(values[0] <= precision.steepest * values[2]);
    };
    const auto flat = [](const CompiledMap& map) { return !map.lost.empty(); };
    const auto outside = [&](const CompiledMap& map) {
        return is_out_of_range(map, precision.largest);
    };
    const char* name = precision.name;
    const auto of_maps = [&](const char* alarm, const auto& wrong, const std::string& text) {
        return Alarm{alarm, count_maps(scene, wrong), text, false};
    };
    return {{"precision", pixels(alarm_precision),
             fmt::format("pixels are less than {} units of the last place of {} wide where they "
                         "look: cells may be missed or misplaced",
                         least_ulps, name)},
            {"floored", pixels(alarm_floored),
             fmt::format("pixels are finer than {} can tell apart: they show larger cells", name)},
            {"capped", pixels(alarm_capped),
             "pixels show the nearest cell known when their ray was given up"},
            {"not_finite", pixels(alarm_not_finite),
             "pixels have a depth, colour or normal that is no number"},
            {"overflow", pixels(alarm_overflow),
             fmt::format("pixels met a cell whose numbers are beyond the range of {}: it may be "
                         "missed",
                         name)},
            of_maps("steep_maps", steep,
                    fmt::format("maps squash so much that {} misplaces some of their cells", name)),
            of_maps("flat_maps", flat,
                    "singular maps are shown a pixel thick, and where several meet, not exactly"),
            of_maps("range", outside,
                    fmt::format("maps have inverses that leave the range of {}", name))};
}

std::vector<Alarm> raise_alarms(const CompiledScene& scene, Numeric numeric, Frame& frame) {
    AlarmTally tally(scene, numeric);
    tally.add(frame);
    tally.mark(frame);
    return tally.alarms();
}

void recount(std::vector<Alarm>& alarms, const Frame& marked) {
    constexpr std::array bits{alarm_precision, alarm_floored, alarm_capped, alarm_not_finite,
                              alarm_overflow};  // in the order of AlarmTally::alarms()
    for (std::size_t i = 0; i < bits.size(); ++i) {
        alarms[i].count = static_cast<std::uint64_t>(std::ranges::count_if(
            marked.pixels,
            [&](const PixelRecord& pixel) { return (pixel.alarms & bits[i]) != 0; }));
    }
}

std::string alarm_text(const std::vector<Alarm>& alarms) {
    std::string text;
    for (const Alarm& alarm : alarms) {
        // Rays that were given up are reported with their cap.
        if (alarm.count == 0 || alarm.name == "capped") continue;
        text += fmt::format("warning: {} {}\n", alarm.count, alarm.text);
    }
    return text;
}

}  // namespace pxm::host
