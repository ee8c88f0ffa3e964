#include "host/study/stability_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/study/study_scene.hpp"

namespace pxm::host {

namespace {

/// A map: its commands before its place, and its place in units.
std::string map_text(const std::string& commands, double x, double y, double z, double unit) {
    return fmt::format("    newmap {} translate: {},{},{}\n", commands, x * unit, y * unit,
                       z * unit);
}

std::string corners(const std::string& commands, double unit) {
    return map_text(commands, 0, 0.5, 0, unit) + map_text(commands, 0, -0.166, -0.472, unit) +
           map_text(commands, 0.409, -0.166, 0.236, unit) +
           map_text(commands, -0.409, -0.166, 0.236, unit);
}

struct Eye {
    double x = 1.2, y = 1.5, z = -3;
    double look_x = 0, look_y = 0, look_z = 0;
    std::string lens = "fov: 40";
};

std::string camera(const Eye& eye, double unit) {
    return fmt::format("camera {{ eye: {},{},{} look: {},{},{} {} }}\n", eye.x * unit, eye.y * unit,
                       eye.z * unit, eye.look_x * unit, eye.look_y * unit, eye.look_z * unit,
                       eye.lens);
}

std::string scene(const std::string& maps, const std::string& view, const std::string& more = "") {
    return fmt::format("ifs case {{\n{}}}\n{}image {{ size: 64,48 }}\n{}", maps, view, more);
}

std::string simple(const std::string& maps, double unit, const Eye& eye = {},
                   const std::string& more = "") {
    return scene(maps, camera(eye, unit), more);
}

/// The eye comes near to a vertex of the tetra, a point of its attractor: (0,1,0).
std::string zoomed(double zoom, double unit) {
    const double d = 3 / zoom;
    const double far = std::sqrt(0.4 * 0.4 + 0.5 * 0.5 + 1);
    const auto place = [&](double middle, double step) {
        return fmt::format("{:.20f}", (middle + step * d / far) * unit);
    };
    return scene(corners("scale: 0.5", unit),
                 fmt::format("camera {{ eye: {},{},{} look: 0,{},0 fov: 40 }}\n", place(0, 0.4),
                             place(1, 0.5), place(0, -1), unit));
}

std::string spiral(double ratio, double unit) {
    return simple(map_text(fmt::format("scale: {} rotate: y,40", ratio), 0, 0.1, 0, unit) +
                      map_text("scale: 0.3", 0.6, 0.2, 0, unit),
                  unit, {1.5, 1.5, -4, 0, 0.5, 0, "fov: 50"});
}

std::string squashed(double ratio, double unit) {
    return simple(
        corners(fmt::format("rotate: x,20 scale: 0.5,{},0.5 rotate: z,30", 0.5 * ratio), unit),
        unit);
}

std::string sheared(double amount, double unit) {
    const auto one = [&](double x, double y, double z) {
        return fmt::format("    newmap matrix: 0.5,{},0, 0,0.5,0, 0,{},0.5, {},{},{}\n", amount,
                           amount, x * unit, y * unit, z * unit);
    };
    const double away = 1 + 3 * amount;
    return simple(one(0, 0.5, 0) + one(0, -0.166, -0.472) + one(0.409, -0.166, 0.236) +
                      one(-0.409, -0.166, 0.236),
                  unit, {1.2 * away, 1.5 * away, -3 * away, 0, 0, 0, "fov: 40"});
}

std::string placed(double scale, double offset, double unit) {
    const double s = scale * unit;
    const double o = offset * unit;
    return fmt::format(
        "ifs case {{\n{}}}\nobject o {{ ifs: case scale: {} translate: {},0,0 }}\n"
        "camera {{ eye: {},{},{} look: {},0,0 fov: 40 }}\nimage {{ size: 64,48 }}\n",
        corners("scale: 0.5", 1), s, o, o + 1.2 * s, 1.5 * s, -3 * s, o);
}

std::string ratios(double ratio, double unit) {
    return simple(corners("scale: 0.5", unit) +
                      map_text(fmt::format("scale: {}", 0.5 / ratio), 0.3, 0.9, 0, unit),
                  unit);
}

std::string many(int maps, double unit) {
    std::string text;
    for (int i = 0; i < maps; ++i) {
        const double angle = 2.399963 * i;  // the golden angle: points of a sphere
        const double z = 1 - 2.0 * (i + 0.5) / maps;
        const double r = std::sqrt(1 - z * z);
        text += map_text(fmt::format("scale: {}", 0.8 / std::sqrt(maps)), r * std::cos(angle),
                         r * std::sin(angle), z, unit);
    }
    return simple(text, unit, {1, 1.5, -3.5, 0, 0, 0, "fov: 45"});
}

/// A chain of maps, each followed by the next alone, that ends in a gasket: so small that the eye
/// is near, and no smaller however long the chain.
std::string chained(int length, double unit) {
    const double ratio = std::max(0.9, std::pow(1e-3, 1.0 / length));
    const std::string link = fmt::format("scale: {} rotate: y,10", ratio);
    std::string maps;
    std::string rules;
    for (int i = 1; i <= length; ++i) {
        maps += map_text(link, 0, 0.5 * (1 - ratio), 0, unit);
        rules += fmt::format("    follow: {} -> {}\n", i,
                             i < length ? fmt::format("{}", i + 1)
                                        : fmt::format("{},{},{},{}", length + 1, length + 2,
                                                      length + 3, length + 4));
    }
    maps += corners("scale: 0.5", unit);
    for (int k = 1; k <= 4; ++k)
        rules += fmt::format("    follow: {} -> {},{},{},{}\n", length + k, length + 1, length + 2,
                             length + 3, length + 4);
    const double small = std::pow(ratio, length);
    const double height = 0.5 * (1 - small);  // of what the chain leads to
    return simple(maps + rules + "    start: 1\n", unit,
                  {1.2 * small, height + 1.5 * small, -3 * small, 0, height, 0, "fov: 60"});
}

/// Norms of 1.5 in turn with 0.2: only products contract.
std::string expanding(double norm, double unit) {
    return simple(map_text(fmt::format("scale: {},0.2,0.2 rotate: z,90", norm), 0, 0.4, 0, unit) +
                      map_text("scale: 0.4", 0.6, 0, 0, unit) +
                      map_text("scale: 0.4", -0.6, 0, 0.3, unit),
                  unit, {2, 3, -7, 0, 0, 0, "fov: 50"});
}

/// Map 1 leads to map 2, which leads to map 3, which nothing may follow.
constexpr const char* dead_end =
    "ifs case { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 newmap scale: 0.5 "
    "translate: 0,1,0 follow: 1 -> 2 follow: 2 -> 3 follow: 3 -> }\n";
/// A rule that leads to a map that is not there.
constexpr const char* no_such_map =
    "ifs case { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 follow: 2 -> 3 }\n";

class Table {
  public:
    template <class Make>
    void add(const char* family, std::initializer_list<double> values, Make make) {
        for (const double value : values) {
            cases.push_back({fmt::format("{} {:g}", family, value), family, value, volume, size,
                             cell_cap, "", [=](double unit) { return make(value, unit); }});
        }
    }
    std::vector<StabilityCase> cases;
    VolumeKind volume = VolumeKind::sphere;  // of the cases that are added next
    std::optional<PixelSize> size;
    std::optional<std::uint32_t> cell_cap;
};

}  // namespace

std::vector<StabilityCase> stability_cases() {
    Table t;
    t.add("zoom", {1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e8, 1e10, 1e12}, zoomed);
    t.add("contraction", {0.9, 0.96, 0.98, 0.99}, spiral);
    t.size = {16, 12};
    t.cell_cap = 20'000;
    t.add("contraction", {0.999, 0.9999}, spiral);
    t.size.reset();
    t.cell_cap.reset();
    t.add("squash", {0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, squashed);
    t.add("shear", {0.1, 0.5, 2}, sheared);
    t.add("reflection", {1},
          [](double, double u) { return simple(corners("scale: -0.5,0.5,0.5", u), u); });
    t.add("singular map", {0}, [](double, double u) {
        return simple(
            corners("scale: 0.5", u) + map_text("scale: 0.3,0,0.3 rotate: x,30", 0, 0.2, 0, u), u);
    });
    t.add("object scale", {1e-20, 1e20}, [](double s, double u) { return placed(s, 0, u); });
    t.add("offset in diameters", {1e3, 1e6},
          [](double o, double u) { return placed(1, 2 * o, u); });
    t.add("ratio of maps", {1e2, 1e4}, ratios);
    t.add("eye inside the volume", {1}, [](double, double u) {
        return simple(corners("scale: 0.5", u), u, {0.15, 0.2, 0.05, 0, 0.5, 0, "fov: 80"});
    });
    t.add("eye on the attractor", {1}, [](double, double u) {
        return simple(corners("scale: 0.5", u), u, {0, 1, 0, 0.3, 0, 0.2, "fov: 80"});
    });
    t.volume = VolumeKind::box;
    t.add("rays along faces", {1}, [](double, double u) {
        return simple(corners("scale: 0.5", u), u,
                      {0, 0, -5, 0, 0, 0, fmt::format("orthographic: {}", 2.5 * u)});
    });
    t.volume = VolumeKind::sphere;
    t.add("norm above 1", {1.5, 1.9}, expanding);
    t.add("maps", {1, 100, 10'000},
          [](double n, double u) { return many(static_cast<int>(n), u); });
    t.add("chain", {10, 60, 120, 300},
          [](double n, double u) { return chained(static_cast<int>(n), u); });
    t.add("dead end", {1}, [](double, double) { return std::string(dead_end); });
    t.add("no such map", {1}, [](double, double) { return std::string(no_such_map); });
    t.add("heap", {1, 4, 16, 256}, [](double heap, double u) {
        return simple(corners("scale: 0.5", u), u, {},
                      fmt::format("render {{ heap: {} }}\n", static_cast<int>(heap)));
    });
    return t.cases;
}

StabilityCase case_of(const std::string& scene, const std::vector<std::string>& allowed,
                      const std::optional<PixelSize>& size) {
    StabilityCase one;
    one.name = stem_of(scene);
    one.family = "scene";
    one.volume.reset();
    one.size = size.value_or(PixelSize{64, 48});
    one.path = scene;
    one.allowed = allowed;
    return one;
}

}  // namespace pxm::host
