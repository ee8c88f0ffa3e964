#include "host/render/alarms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
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

/// What a number type can hold.
struct Precision {
    const char* name;
    double step;            // relative error of one operation
    double smallest_share;  // p never falls below this share of an object's diameter
    double steepest;        // condition of a map that half of the digits cannot bear
    double largest;         // whose square is still in range
};

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

/// An object's outermost volume, seen from the eye, in scene units.
struct Place {
    int origin = 0;       // number of the object in the scene
    double distance = 0;  // of its middle
    double diameter = 0;
    double begin = 0;  // what is nearer than that, or farther than the end, is not of the object
    double end = 0;
};

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

/// How near anything is that the frame shows, in scene units; infinite if it shows nothing.
double nearest_hit(const CompiledScene& scene, const Frame& frame) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const PixelRecord& pixel : frame.pixels)
        if (pixel.level >= 0) nearest = std::min(nearest, double{pixel.z} / scene.unit);
    return nearest;
}

/// What is true of every pixel that misses: it might have met an object as near as any pixel does,
/// or as near as the object's volume begins if none does.
std::uint8_t alarms_of_misses(const CompiledScene& scene, const Precision& precision,
                              const std::vector<Place>& places, const Frame& frame) {
    const double hit = nearest_hit(scene, frame);
    std::uint8_t alarms = 0;
    for (const Place& place : places) {
        const double from = std::isfinite(hit) ? std::max(place.begin, hit) : place.begin;
        if (from <= place.end) alarms |= look(scene, precision, from, place);
    }
    return alarms;
}

/// Alarms of a pixel that shows one of the objects that a scene's object became, whichever it is.
std::uint8_t alarms_of_hit(const CompiledScene& scene, const Precision& precision,
                           const std::vector<Place>& places, const PixelRecord& pixel) {
    const double distance = double{pixel.z} / scene.unit;
    std::uint8_t alarms = 0;
    for (const Place& place : places) {
        const bool there = std::isinf(place.end) || (place.begin * (1 - rounding) <= distance &&
                                                     distance <= place.end * (1 + rounding));
        if (place.origin == pixel.object && there)
            alarms |= look(scene, precision, distance, place);
    }
    return alarms;
}

bool is_finite(const PixelRecord& pixel) {
    const auto all = [](const float(&v)[3]) {
        return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
    };
    return all(pixel.color) && all(pixel.normal) && (pixel.level < 0 || std::isfinite(pixel.z));
}

/// How many pixels have each alarm, by its bit.
class AlarmCounts {
  public:
    void add(std::uint8_t alarms) {
        for (unsigned rest = alarms; rest != 0; rest &= rest - 1)
            ++counts_[static_cast<std::size_t>(std::countr_zero(rest))];
    }
    [[nodiscard]] std::uint64_t of(PixelAlarm alarm) const {
        return counts_[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(alarm)))];
    }

  private:
    std::array<std::uint64_t, 8> counts_{};
};

AlarmCounts mark_pixels(const CompiledScene& scene, const Precision& precision, Frame& frame) {
    const std::vector<Place> places = places_of(scene);
    const auto objects = static_cast<int>(object_count(scene));
    const std::uint8_t missed = alarms_of_misses(scene, precision, places, frame);
    AlarmCounts counts;
    for (PixelRecord& pixel : frame.pixels) {
        const bool hit = pixel.level >= 0 && pixel.object < objects;
        pixel.alarms |= hit ? alarms_of_hit(scene, precision, places, pixel) : missed;
        if (!is_finite(pixel)) pixel.alarms |= alarm_not_finite;
        counts.add(pixel.alarms);
    }
    return counts;
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

std::vector<Alarm> raise_alarms(const CompiledScene& scene, Numeric numeric, Frame& frame) {
    const Precision precision = precision_of(numeric);
    const AlarmCounts counts = mark_pixels(scene, precision, frame);
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
    return {{"precision", counts.of(alarm_precision),
             fmt::format("pixels are less than {} units of the last place of {} wide where they "
                         "look: cells may be missed or misplaced",
                         least_ulps, name)},
            {"floored", counts.of(alarm_floored),
             fmt::format("pixels are finer than {} can tell apart: they show larger cells", name)},
            {"capped", counts.of(alarm_capped),
             "pixels show the nearest cell known when their ray was given up"},
            {"not_finite", counts.of(alarm_not_finite),
             "pixels have a depth, colour or normal that is no number"},
            {"overflow", counts.of(alarm_overflow),
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

void add_pixels(std::vector<Alarm>& sum, const std::vector<Alarm>& part) {
    if (sum.empty()) {
        sum = part;
        return;
    }
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (sum[i].of_pixels) sum[i].count += part[i].count;
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
