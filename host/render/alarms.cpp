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
#include "host/node_program/crowded.hpp"
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

AlarmPlace place_of(const CompiledScene& scene, const CompiledObject& object) {
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

/// Alarms of a pixel that looks at an object from this distance on.
std::uint8_t look(const AlarmBasis& basis, const Precision& precision, double distance,
                  const AlarmPlace& place) {
    const double at = basis.pixel_at_eye + basis.pixel_growth * distance;
    const double p = at * std::min(1.0, basis.detail);
    const double coordinates = std::max({distance, place.distance, place.diameter});
    std::uint8_t alarms = 0;
    if (p < least_ulps * precision.step * coordinates) alarms |= alarm_precision;
    if (p < precision.smallest_share * place.diameter) alarms |= alarm_floored;
    return alarms;
}

/// What is true of every pixel that misses: it might have met an object as near as any pixel does,
/// or as near as the object's volume begins if none does.
std::uint8_t alarms_of_misses(const AlarmBasis& basis, double nearest) {
    const Precision precision = precision_of(basis.numeric);
    std::uint8_t alarms = 0;
    for (const AlarmPlace& place : basis.places) {
        const double from = std::isfinite(nearest) ? std::max(place.begin, nearest) : place.begin;
        if (from <= place.end) alarms |= look(basis, precision, from, place);
    }
    return alarms;
}

/// Alarms of a pixel that shows one of the objects that a scene's object became, whichever it is.
std::uint8_t alarms_of_hit(const AlarmBasis& basis, const Precision& precision,
                           const PixelRecord& pixel) {
    const double distance = double{pixel.z} / basis.unit;
    std::uint8_t alarms = 0;
    for (const AlarmPlace& place : basis.places) {
        const bool there = std::isinf(place.end) || (place.begin * (1 - rounding) <= distance &&
                                                     distance <= place.end * (1 + rounding));
        if (place.origin == pixel.object && there)
            alarms |= look(basis, precision, distance, place);
    }
    return alarms;
}

bool is_hit(const AlarmBasis& basis, const PixelRecord& pixel) {
    return pixel.level >= 0 && pixel.object < basis.objects;
}

/// 0 times a number is 0, and no number otherwise: one comparison for all, as every pixel is asked.
bool is_finite(const PixelRecord& pixel) {
    const auto nothing = [](const float(&v)[3]) { return 0 * v[0] + 0 * v[1] + 0 * v[2]; };
    const float depth = pixel.level < 0 ? 0 : pixel.z;
    return nothing(pixel.color) + nothing(pixel.normal) + 0 * depth == 0;
}

void count(std::array<std::uint64_t, 8>& counts, std::uint8_t alarms) {
    for (unsigned rest = alarms; rest != 0; rest &= rest - 1)
        ++counts[static_cast<std::size_t>(std::countr_zero(rest))];
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

AlarmBasis alarm_basis(const CompiledScene& scene, Numeric numeric) {
    const Precision precision = precision_of(numeric);
    AlarmBasis basis{numeric,
                     scene.camera.pixel_at_eye,
                     scene.camera.pixel_growth,
                     scene.detail,
                     scene.unit,
                     static_cast<int>(object_count(scene)),
                     {},
                     0,
                     0,
                     0};
    for (const CompiledObject& object : scene.objects)
        basis.places.push_back(place_of(scene, object));
    const auto steep = [&](const CompiledMap& map) {
        const auto values = singular_values(map.map.linear).values;
        return map.lost.empty() && !(values[0] <= precision.steepest * values[2]);
    };
    const auto flat = [](const CompiledMap& map) { return !map.lost.empty(); };
    const auto outside = [&](const CompiledMap& map) {
        return is_out_of_range(map, precision.largest);
    };
    basis.steep_maps = count_maps(scene, steep);
    basis.flat_maps = count_maps(scene, flat);
    basis.maps_out_of_range = count_maps(scene, outside);
    return basis;
}

void AlarmSums::add(const AlarmSums& other) {
    for (std::size_t i = 0; i < of_hits.size(); ++i) {
        of_hits[i] += other.of_hits[i];
        of_misses[i] += other.of_misses[i];
    }
    misses += other.misses;
    nearest = std::min(nearest, other.nearest);
}

AlarmSums mark_alarms(const AlarmBasis& basis, std::span<PixelRecord> pixels) {
    const Precision precision = precision_of(basis.numeric);
    AlarmSums sums;
    float nearest = std::numeric_limits<float>::infinity();
    for (PixelRecord& pixel : pixels) {
        const bool hit = is_hit(basis, pixel);
        if (hit) pixel.alarms |= alarms_of_hit(basis, precision, pixel);
        if (!is_finite(pixel)) pixel.alarms |= alarm_not_finite;
        count(hit ? sums.of_hits : sums.of_misses, pixel.alarms);
        sums.misses += hit ? 0 : 1;
        if (pixel.level >= 0) nearest = std::min(nearest, pixel.z);
    }
    sums.nearest = double{nearest} / basis.unit;
    return sums;
}

void mark_misses(const AlarmBasis& basis, const AlarmSums& sums, std::span<PixelRecord> pixels) {
    const std::uint8_t missed = alarms_of_misses(basis, sums.nearest);
    if (missed == 0) return;
    for (PixelRecord& pixel : pixels)
        if (!is_hit(basis, pixel)) pixel.alarms |= missed;
}

std::vector<Alarm> raise_alarms(const CompiledScene& scene, Numeric numeric, Frame& frame) {
    const AlarmBasis basis = alarm_basis(scene, numeric);
    const AlarmSums sums = mark_alarms(basis, frame.pixels);
    mark_misses(basis, sums, frame.pixels);
    return alarms_of(basis, sums);
}

std::vector<Alarm> alarms_of(const AlarmBasis& basis, const AlarmSums& sums) {
    const unsigned missed = alarms_of_misses(basis, sums.nearest);
    const auto counted = [&](PixelAlarm alarm) {
        const auto bit = static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(alarm)));
        const bool all = (missed & alarm) != 0;
        return sums.of_hits[bit] + (all ? sums.misses : sums.of_misses[bit]);
    };
    const char* name = precision_of(basis.numeric).name;
    const auto of_maps = [&](const char* alarm, std::uint64_t count, const std::string& text) {
        return Alarm{alarm, count, text, false};
    };
    return {{"precision", counted(alarm_precision),
             fmt::format("pixels are less than {} units of the last place of {} wide where they "
                         "look: cells may be missed or misplaced",
                         least_ulps, name)},
            {"floored", counted(alarm_floored),
             fmt::format("pixels are finer than {} can tell apart: they show larger cells", name)},
            {"capped", counted(alarm_capped),
             "pixels show the nearest cell known when their ray was given up"},
            {"not_finite", counted(alarm_not_finite),
             "pixels have a depth, colour or normal that is no number"},
            {"overflow", counted(alarm_overflow),
             fmt::format("pixels met a cell whose numbers are beyond the range of {}: it may be "
                         "missed",
                         name)},
            of_maps("steep_maps", basis.steep_maps,
                    fmt::format("maps squash so much that {} misplaces some of their cells", name)),
            of_maps("flat_maps", basis.flat_maps,
                    "singular maps are shown a pixel thick, and where several meet, not exactly"),
            of_maps("range", basis.maps_out_of_range,
                    fmt::format("maps have inverses that leave the range of {}", name))};
}

void recount(std::vector<Alarm>& alarms, const Frame& marked) {
    constexpr std::array bits{alarm_precision, alarm_floored, alarm_capped, alarm_not_finite,
                              alarm_overflow};  // in the order of alarms_of()
    for (std::size_t i = 0; i < bits.size(); ++i) {
        alarms[i].count = static_cast<std::uint64_t>(std::ranges::count_if(
            marked.pixels,
            [&](const PixelRecord& pixel) { return (pixel.alarms & bits[i]) != 0; }));
    }
}

std::string crowd_text(const CompiledScene& scene, Numeric numeric) {
    const bool covers = needs_covers(scene);
    if (!has_crowded_objects(scene) || (numeric != Numeric::dsp32 && !covers)) return "";
    return fmt::format(
        "warning: cells overlap so much that a ray may open up to {} of them before it is given "
        "up, once for every word that leads there: {}. That may take minutes; 'levels' or a "
        "smaller picture take less, and native renders in float or double without covers remember "
        "them\n",
        scene.cell_cap, covers ? "with covers every word shows" : "dsp32 remembers no cells");
}

std::string cap_text(const RayStatistics& rays, std::uint32_t cell_cap) {
    if (rays.capped_rays == 0) return "";
    return fmt::format(
        "warning: {} of {} rays were given up after {} cells; their pixels show the nearest cell "
        "known by then\n",
        rays.capped_rays, rays.eye_rays + rays.light_rays + rays.reflect_rays, cell_cap);
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
