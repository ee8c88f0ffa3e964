// Deep zooms: cells that are objects of their own show what the whole object shows, as long as
// double can tell; beyond, self-similarity says what the picture must be.
#include "host/compile/reroot.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host/render/alarms.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/wide/tables/eligible.hpp"
#include "host/wide/tile/wide_engine.hpp"
#include "tests/support/compile_text.hpp"
#include "tests/support/example_scenes.hpp"
#include "tests/support/referee.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

using namespace host;

std::string digits(const PreciseVec3& v) {
    return text_of(v[0], 70) + "," + text_of(v[1], 70) + "," + text_of(v[2], 70);
}

/// The point of the first ifs whose address repeats the word, numbers of maps from 0.
PreciseVec3 attractor_point(const std::string& text, const std::vector<int>& word) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("test.pxm", text, diagnostics);
    PreciseAffine map = precise(Affine{});
    for (const int symbol : word) {
        map = then(precise(compose(scene.ifs[0].maps[static_cast<std::size_t>(symbol)].commands)),
                   map);
    }
    return fixed_point(map);
}

/// A scene whose camera looks at that point from `from` beside it.
std::string looking_at(const std::string& text, const std::vector<int>& word,
                       const glm::dvec3& from) {
    const PreciseVec3 look = attractor_point(text, word);
    return text + fmt::format("camera {{ look: {} eye: {} fov: 40 }}\n", digits(look),
                              digits(add(look, precise(from))));
}

struct Views {
    std::string name;
    std::string text;
};

/// Systems of all kinds, looked at where they have something near the eye.
std::vector<Views> views(const std::string& render) {
    const std::string image = "size: 24,18";
    const auto system = [&](const char* name) { return scene_of(name, render, image); };
    const std::string two =
        "object a { ifs: tetra } object b { ifs: tetra scale: 0.8 rotate: y,40 "
        "translate: -1.5,0.3,1.5 color: 1,0,0,0.5 }";
    return {{"apex", looking_at(system("tetra"), {0}, {0.8, 1, -2})},
            {"inside", looking_at(system("tetra"), {0, 2, 1}, {0.3, 0.4, -1})},
            {"corner", looking_at(system("menger"), {0}, {-1, -1.1, -0.8})},
            {"side", looking_at(system("menger"), {3, 12}, {0.1, 0.2, -1})},
            {"elm", looking_at(system("elm"), {0, 1, 2, 3}, {0.5, 0.6, -1})},
            {"graph", looking_at(system("asymmetric"), {0, 1, 2}, {0.4, 0.5, -1})},
            {"two_levels", looking_at(system("hierarchical"), {0, 1}, {0.4, 0.5, -1})},
            {"squashed", looking_at(system("squashed"), {0, 2}, {0.4, 0.5, -1})},
            {"two_objects", looking_at(system("tetra") + two, {0}, {0.8, 1, -2})}};
}

struct Difference {
    double hits = 0;  // shares of the pixels
    double words = 0;
    double colors = 0;
};

/// `scale` is how much larger z is in `b`, `deeper` how many levels more it has.
Difference difference(const Frame& a, const Frame& b, double scale = 1, int deeper = 0) {
    Difference result;
    const double share = 1 / static_cast<double>(a.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const PixelRecord& p = a.pixels[i];
        const PixelRecord& q = b.pixels[i];
        double apart = 0;
        for (int k = 0; k < 3; ++k) {
            apart = std::max(apart, std::abs(double{p.color[k]} - double{q.color[k]}));
        }
        result.colors += apart > 1.0 / 255 ? share : 0;
        const bool both = p.level >= 0 && q.level >= 0;
        if (!both) {
            result.hits += p.level >= 0 || q.level >= 0 ? share : 0;
            continue;
        }
        const bool near = std::abs(double{q.z} / scale / double{p.z} - 1) < 1e-3;
        const bool same = p.object == q.object && p.level + deeper == q.level &&
                          (deeper != 0 || p.word == q.word);
        result.words += near && same ? 0 : share;
    }
    return result;
}

std::string text_of(const Difference& d) {
    return fmt::format("hits {} words {} colours {}", d.hits, d.words, d.colors);
}

Frame render_wide(const CompiledScene& scene) {
    return wide::run_wide(scene, EngineChoice{}, {}).frame;
}

TEST(Reroot, leaves_usual_views_as_they_are) {
    for (const Example& example : example_scenes("40,30")) {
        const CompiledScene scene = compile_text(example.text);
        EXPECT_EQ(rerooted(scene).objects, 0U) << example.name;
        EXPECT_EQ(scene.enclosures.size(), 0U) << example.name;
    }
}

TEST(Reroot, shows_what_the_whole_object_shows) {
    for (const Views& view : views("")) {
        for (const double zoom : {1e4, 1e6}) {
            const CompiledScene kept = compile_text(view.text, zoom, NearCells::kept);
            const Frame whole = render_natively(kept, Numeric::double_).frame;
            const CompiledScene scene = compile_text(view.text, zoom);
            EXPECT_GT(rerooted(scene).objects, 0U) << view.name << zoom;
            const Difference d = difference(whole, render_natively(scene, Numeric::double_).frame);
            EXPECT_LT(d.hits, 0.003) << view.name << zoom << text_of(d);
            EXPECT_LT(d.words, 0.02) << view.name << zoom << text_of(d);
            EXPECT_LT(d.colors, 0.005) << view.name << zoom << text_of(d);
        }
    }
}

TEST(Reroot, shades_as_the_whole_object_does_in_every_mode) {
    for (const char* mode : {"low-pass", "high-pass", "facet"}) {
        for (const Views& view : views(fmt::format("shading: {}", mode))) {
            const CompiledScene kept = compile_text(view.text, 1e5, NearCells::kept);
            const Difference d =
                difference(render_natively(kept, Numeric::double_).frame,
                           render_natively(compile_text(view.text, 1e5), Numeric::double_).frame);
            EXPECT_LT(d.colors, 0.005) << view.name << mode << text_of(d);
        }
    }
}

TEST(Reroot, every_number_type_and_engine_shows_the_picture_of_double) {
    for (const Views& view : views("")) {
        // Cells of overlapping pieces lie in the same place: rounding decides which one shows.
        if (view.name == "squashed") continue;  // thousands of objects take their time
        const bool overlapping = view.name == "two_levels" || view.name == "graph";
        const bool small = view.name != "corner" && view.name != "side" && !overlapping;
        for (const double zoom : {1e10, 1e30}) {
            if (!small && zoom > 1e10) continue;
            const CompiledScene scene = compile_text(view.text, zoom);
            const Frame twice = render_natively(scene, Numeric::double_).frame;
            if (small) {
                const Verdict verdict = judge(scene, twice, Numeric::double_);
                EXPECT_GT(verdict.hits, 10) << view.name << zoom;
                EXPECT_EQ(verdict.same + verdict.tied, verdict.pixels)
                    << view.name << verdict.report;
                EXPECT_EQ(verdict.wrong_colors, 0) << view.name << zoom << verdict.report;
            }
            const auto check = [&](const char* what, const Frame& frame) {
                const Difference d = difference(twice, frame);
                EXPECT_LT(d.hits, 0.01) << view.name << zoom << what << text_of(d);
                EXPECT_LT(d.words, overlapping ? 0.15 : 0.04)
                    << view.name << zoom << what << text_of(d);
                EXPECT_LT(d.colors, overlapping ? 0.06 : 0.02)
                    << view.name << zoom << what << text_of(d);
            };
            check(" float", render_natively(scene, Numeric::single).frame);
            check(" dsp32", render_natively(scene, Numeric::dsp32).frame);
            if (wide::why_not_wide(scene, Numeric::single).empty()) {
                check(" wide", render_wide(scene));
            }
        }
    }
}

TEST(Reroot, a_zoom_about_a_fixed_point_shows_the_same_again) {
    const std::string text =
        looking_at(scene_of("tetra", "", "size: 24,18"), {0, 2, 1}, {0.3, 0.4, -1});
    const Frame at_40 = render_natively(compile_text(text, 0x1p42), Numeric::double_).frame;
    for (const double zoom : {0x1p72, 0x1p99}) {
        const int deeper = static_cast<int>(std::log2(zoom)) - 42;
        const Frame frame = render_natively(compile_text(text, zoom), Numeric::double_).frame;
        const Difference d = difference(at_40, frame, std::ldexp(1, -deeper), deeper);
        EXPECT_EQ(d.hits, 0) << zoom << text_of(d);
        EXPECT_LT(d.words, 0.003) << zoom << text_of(d);
        EXPECT_EQ(d.colors, 0) << zoom << text_of(d);
    }
}

TEST(Reroot, numbers_with_many_digits_say_what_a_zoom_says) {
    const std::string system = scene_of("tetra", "", "size: 24,18");
    const PreciseVec3 look = attractor_point(system, {0, 2, 1});
    const PreciseVec3 eye = add(look, scaled(precise(glm::dvec3{0.3, 0.4, -1}), Precise(0x1p-70)));
    const CompiledScene written = compile_text(
        system + fmt::format("camera {{ look: {} eye: {} fov: 40 }}", digits(look), digits(eye)));
    const CompiledScene zoomed =
        compile_text(looking_at(system, {0, 2, 1}, {0.3, 0.4, -1}), 0x1p70);
    EXPECT_EQ(rerooted(written).levels, rerooted(zoomed).levels);
    const Difference d = difference(render_natively(written, Numeric::double_).frame,
                                    render_natively(zoomed, Numeric::double_).frame);
    EXPECT_EQ(d.hits, 0) << text_of(d);
    EXPECT_EQ(d.words, 0) << text_of(d);
    EXPECT_EQ(d.colors, 0) << text_of(d);
}

TEST(Reroot, an_object_stops_at_its_last_level_all_the_same) {
    const std::string text = looking_at(scene_of("tetra", "", "size: 24,18"), {0}, {0.8, 1, -2}) +
                             "object a { ifs: tetra levels: 12 }";
    const CompiledScene scene = compile_text(text, 1e4);
    EXPECT_GT(rerooted(scene).objects, 0U);
    const Frame frame = render_natively(scene, Numeric::double_).frame;
    const CompiledScene kept = compile_text(text, 1e4, NearCells::kept);
    const Difference d = difference(render_natively(kept, Numeric::double_).frame, frame);
    EXPECT_LT(d.hits + d.words + d.colors, 0.01) << text_of(d);
    for (const PixelRecord& pixel : frame.pixels) EXPECT_LE(pixel.level, 12);
    EXPECT_LE(rerooted(compile_text(text, 1e12)).levels, 12U);
}

TEST(Reroot, costs_few_objects) {
    for (const Views& view : views("")) {
        const CompiledScene scene = compile_text(view.text, 1e30);
        const bool squashed = view.name == "squashed";  // needles lie along the view
        EXPECT_LT(scene.objects.size(), squashed ? 4000U : 1000U) << view.name;
        EXPECT_LT(scene.enclosures.size(), squashed ? 4000U : 500U) << view.name;
    }
}

TEST(Reroot, alarms_are_silent_where_it_helps_and_are_not_where_it_does_not) {
    const auto raised = [](const CompiledScene& scene) {
        Frame frame = render_natively(scene, Numeric::single).frame;
        std::uint64_t count = 0;
        for (const Alarm& alarm : raise_alarms(scene, Numeric::single, frame)) {
            if (alarm.name == "precision" || alarm.name == "floored") count += alarm.count;
        }
        return count;
    };
    const std::string system = scene_of("tetra", "", "size: 24,18");
    const std::string text = looking_at(system, {0, 2, 1}, {0.3, 0.4, -1});
    EXPECT_EQ(raised(compile_text(text, 1e20)), 0U);
    EXPECT_GT(raised(compile_text(text, 1e20, NearCells::kept)), 0U);
    const std::string parallel =
        system + fmt::format("camera {{ look: {} eye: 0,1,-3 orthographic: 2 }}",
                             digits(attractor_point(system, {0})));
    EXPECT_GT(raised(compile_text(parallel, 1e9)), 0U);
}

}  // namespace
}  // namespace pxm::test
