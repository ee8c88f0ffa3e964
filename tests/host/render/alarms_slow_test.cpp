// Laws of the alarms (docs/alarms.md).
#include "host/render/alarms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <span>

#include "host/study/deviation.hpp"
#include "host/study/stability_cases.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;
using testing::Not;

std::uint64_t count_of(const RenderResult& result, const std::string& name) {
    const auto found = std::ranges::find(result.statistics.alarms, name, &Alarm::name);
    EXPECT_NE(found, result.statistics.alarms.end()) << name;
    return found->count;
}

RenderResult tetra_at(double zoom, Numeric numeric,
                      IntersectMethod intersect = IntersectMethod::heap) {
    RenderRequest request;
    request.overrides.size = PixelSize{16, 12};
    request.overrides.numeric = numeric;
    request.overrides.zoom = zoom;
    request.overrides.intersect = intersect;
    return test::render_text(std::string(test::tetra_text) + "camera { eye: 0,1,-3 look: 0,1,0 }",
                             request);
}

/// A parallel view that is a millionth of the object wide, and less: it is never re-rooted.
RenderResult parallel(double zoom, Numeric numeric) {
    RenderRequest request;
    request.overrides.size = PixelSize{16, 12};
    request.overrides.numeric = numeric;
    request.overrides.zoom = zoom;
    request.overrides.intersect = IntersectMethod::heap;
    return test::render_text(
        std::string(test::tetra_text) + "camera { eye: 0,1,-3 look: 0,1,0 orthographic: 1 }",
        request);
}

/// The picture in two parts, above and below a row.
std::pair<Frame, Frame> cut(const Frame& whole, long row) {
    const CropWindow& w = whole.crop;
    std::pair<Frame, Frame> parts{Frame(whole.size, {w.x0, w.y0, w.x1, row}),
                                  Frame(whole.size, {w.x0, row, w.x1, w.y1})};
    for (long y = w.y0; y < w.y1; ++y)
        for (long x = w.x0; x < w.x1; ++x)
            (y < row ? parts.first : parts.second).at(x, y) = whole.at(x, y);
    return parts;
}

TEST(AlarmSums, do_not_depend_on_the_parts_that_a_picture_comes_in) {
    RenderRequest request;
    request.scene_text =
        std::string(test::tetra_text) + "camera { eye: 0,1,-3 look: 0,1,0 orthographic: 1 }";
    request.overrides.size = PixelSize{16, 12};
    request.overrides.zoom = 1e5;
    request.overrides.numeric = Numeric::single;
    request.overrides.intersect = IntersectMethod::heap;
    const CompiledScene scene = compiled_scene_of(request);
    Frame frame({16, 12}, {0, 0, 16, 12});
    // Half of the pixels see a far cell, one of the last row a near one.
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
        if (i % 2 == 0) continue;
        frame.pixels[i].level = 3;
        frame.pixels[i].object = 0;
        frame.pixels[i].z = i == frame.pixels.size() - 1 ? 0.5F : 3.0F;
        frame.pixels[i].alarms = i % 3 == 0 ? alarm_capped : 0;
    }
    for (const Numeric numeric : {Numeric::single, Numeric::double_}) {
        const AlarmBasis basis = alarm_basis(scene, numeric);
        Frame marked = frame;
        const AlarmSums whole = mark_alarms(basis, marked.pixels);
        mark_misses(basis, whole, marked.pixels);
        const std::vector<Alarm> expected = alarms_of(basis, whole);
        for (const long row : {1, 6, 11}) {
            auto [above, below] = cut(frame, row);
            AlarmSums sums = mark_alarms(basis, below.pixels);
            sums.add(mark_alarms(basis, above.pixels));
            const std::vector<Alarm> found = alarms_of(basis, sums);
            for (std::size_t i = 0; i < expected.size(); ++i)
                EXPECT_EQ(found[i].count, expected[i].count) << expected[i].name << " " << row;
        }
        std::uint64_t capped = 0, precision = 0;
        for (const PixelRecord& pixel : marked.pixels) {
            capped += (pixel.alarms & alarm_capped) != 0 ? 1 : 0;
            precision += (pixel.alarms & alarm_precision) != 0 ? 1 : 0;
        }
        for (const Alarm& alarm : expected) {
            if (alarm.name == "capped") {
                EXPECT_EQ(alarm.count, capped);
            } else if (alarm.name == "precision") {
                EXPECT_EQ(alarm.count, precision);
            }
        }
        EXPECT_EQ(capped, 32U);
    }
}

TEST(AlarmSums, a_pixel_is_finite_if_each_of_its_numbers_is) {
    const AlarmBasis basis;
    for (const float value :
         {-std::numeric_limits<float>::max(), 0.0F, -0.0F, std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        for (int where = 0; where < 7; ++where) {
            for (const int level : {-1, 2}) {
                PixelRecord pixel;
                pixel.level = level;
                if (level >= 0) pixel.z = 1;
                (where < 3   ? pixel.color[where]
                 : where < 6 ? pixel.normal[where - 3]
                             : pixel.z) = value;
                const bool wrong = !std::isfinite(value) && (where < 6 || level >= 0);
                (void)mark_alarms(basis, std::span(&pixel, 1));
                EXPECT_EQ(pixel.alarms, wrong ? alarm_not_finite : 0)
                    << value << " at " << where << ", level " << level;
            }
        }
    }
}

TEST(Alarms, an_ordinary_view_raises_none) {
    for (const Numeric numeric : {Numeric::dsp32, Numeric::single, Numeric::double_}) {
        const RenderResult result = tetra_at(1, numeric);
        for (const Alarm& alarm : result.statistics.alarms)
            EXPECT_EQ(alarm.count, 0U) << alarm.name;
        EXPECT_EQ(result.warnings, "");
    }
}

TEST(Alarms, a_view_beyond_the_numbers_raises_precision_and_double_has_more_of_it) {
    EXPECT_EQ(count_of(parallel(1e6, Numeric::single), "precision"), 16U * 12);
    EXPECT_EQ(count_of(parallel(1e6, Numeric::double_), "precision"), 0U);
    EXPECT_THAT(parallel(1e6, Numeric::single).warnings,
                HasSubstr("warning: 192 pixels are less than 32 units of the last place of float"));
}

TEST(Alarms, the_wide_engine_is_judged_by_the_double_that_it_places_cells_in) {
    const RenderResult wide = tetra_at(1e6, Numeric::single, IntersectMethod::wide);
    EXPECT_EQ(count_of(wide, "precision"), 0U);
    EXPECT_EQ(wide.warnings, "");
}

TEST(Alarms, pixels_finer_than_the_floor_are_told) {
    EXPECT_GT(count_of(parallel(1e7, Numeric::dsp32), "floored"), 0U);
    EXPECT_EQ(count_of(parallel(1e7, Numeric::double_), "floored"), 0U);
}

RenderResult squash_in(const std::string& scene, Numeric numeric) {
    RenderRequest request;
    request.overrides.volume = VolumeKind::sphere;
    request.overrides.intersect = IntersectMethod::heap;
    request.overrides.numeric = numeric;
    return test::render_text(scene, request);
}

TEST(Alarms, results_beyond_the_range_are_told_and_double_has_more_of_it) {
    const std::string squashed =
        "ifs a { newmap rotate: x,20 scale: 1e-25 rotate: z,30 "
        "newmap scale: 0.5 translate: 1,0,0 } ";
    for (const Numeric numeric : {Numeric::dsp32, Numeric::single}) {
        EXPECT_GT(count_of(squash_in(squashed, numeric), "overflow"), 0U);
    }
    EXPECT_EQ(count_of(squash_in(squashed, Numeric::double_), "overflow"), 0U);
}

TEST(Alarms, directions_too_long_to_be_squared_raise_none_and_lose_no_cell) {
    int found = 0;
    for (const StabilityCase& one : stability_cases()) {
        if (one.family != "squash") continue;
        ++found;
        const RenderResult reference = squash_in(one.text(1), Numeric::double_);
        for (const Numeric numeric : {Numeric::dsp32, Numeric::single}) {
            const RenderResult picture = squash_in(one.text(1), numeric);
            EXPECT_EQ(count_of(picture, "overflow"), 0U) << one.name;
            EXPECT_EQ(count_of(picture, "not_finite"), 0U) << one.name;
            EXPECT_LE(deviation_of(picture, reference).wrong_share, 0.001) << one.name;
        }
    }
    EXPECT_EQ(found, 6);
}

/// The trough z = x^2: the matrices of its cells become nearly diagonal, and the rotation that
/// makes them so turns by an angle whose cotangent has no square in float.
const char* const trough =
    "ifs trough { newmap matrix: 1/2,0,0, 0,1/2,0, 0,0,1/4, 0,0,0 "
    "newmap matrix: 1/2,0,1/2, 0,1/2,0, 0,0,1/4, 1/2,0,1/4 "
    "newmap matrix: 1/2,0,0, 0,1/2,0, 0,0,1/4, 0,1/2,0 "
    "newmap matrix: 1/2,0,1/2, 0,1/2,0, 0,0,1/4, 1/2,1/2,1/4 } "
    "camera { eye: 0.5,0.5,-5 look: 0.5,0.5,0 orthographic: 1.2 } ";

/// A pine's branches: rotations and squashes, in whose cells such entries come up as rounding.
const char* const branches =
    "ifs b { newmap scale: 0.2,0.6,0.2 newmap rotate: x,40 scale: 0.5 translate: 0,0.4,0 "
    "newmap rotate: x,40 rotate: y,120 scale: 0.5 translate: 0,0.4,0 "
    "newmap rotate: x,40 rotate: y,-120 scale: 0.5 translate: 0,0.4,0 } ";

TEST(Alarms, what_cannot_reach_the_picture_raises_none) {
    for (const char* scene : {trough, branches}) {
        for (const Numeric numeric : {Numeric::dsp32, Numeric::single}) {
            RenderRequest request;
            request.overrides.size = PixelSize{20, 16};
            request.overrides.numeric = numeric;
            request.overrides.intersect = IntersectMethod::heap;
            request.overrides.volume = VolumeKind::box;
            EXPECT_EQ(count_of(test::render_text(scene, request), "overflow"), 0U) << scene;
        }
    }
}

TEST(Alarms, what_a_thread_computed_before_is_no_alarm_of_its_first_pixel) {
#pragma omp parallel num_threads(2)
    std::feraiseexcept(FE_OVERFLOW | FE_DIVBYZERO);
    RenderRequest request;
    request.overrides.size = PixelSize{16, 16};
    request.overrides.numeric = Numeric::double_;
    request.threads = 2;
    EXPECT_EQ(count_of(test::render_text(test::tetra_text, request), "overflow"), 0U);
}

TEST(Alarms, steep_maps_are_told_in_single_precision) {
    const std::string steep =
        "ifs a { newmap scale: 0.5,0.00001,0.5 newmap scale: 0.5 translate: 1,0,0 }";
    RenderRequest request;
    request.overrides.size = PixelSize{8, 8};
    EXPECT_EQ(count_of(test::render_text(steep, request), "steep_maps"), 1U);
    request.overrides.numeric = Numeric::double_;
    EXPECT_EQ(count_of(test::render_text(steep, request), "steep_maps"), 0U);
}

}  // namespace
}  // namespace pxm::host
