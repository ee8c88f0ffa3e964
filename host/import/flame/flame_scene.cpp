// A flame as a scene: its set of points, and its view of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host/import/chaos_order.hpp"
#include "host/import/entries.hpp"
#include "host/import/flame/flame.hpp"
#include "host/import/imported_scene.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t most_with_chaos = 2'000;  // their pairs are looked at one by one
constexpr double color_steps = 10'000;          // four digits of a colour are enough

/// y points down in a flame's picture and up in a scene.
PlaneNumbers upright(const PlaneNumbers& m) { return {m.a, -m.b, -m.c, m.d, m.e, -m.f}; }

std::string transform_name(std::size_t number) { return fmt::format("xform_{}", number + 1); }

MapReference reference(std::size_t number, const Position& place) {
    return {transform_name(number), place};
}

/// How much likelier `next` is to come after `transform`.
double chaos_of(const FlameTransform& transform, std::size_t next) {
    return next < transform.chaos.size() ? transform.chaos[next] : 1;
}

class FlameScene {
  public:
    FlameScene(const Flame& flame, const SourceFile& source, Diagnostics& diagnostics)
        : flame_(flame), source_(source), diagnostics_(diagnostics) {}

    Scene scene() {
        for (std::size_t i = 0; i < flame_.transforms.size(); ++i)
            if (flame_.transforms[i].weight > 0) live_.push_back(i);
        if (live_.empty()) error("the flame has no <xform> of weight above 0");
        const bool chaos = has_chaos();
        if (chaos && live_.size() > most_with_chaos)
            error(fmt::format("chaos of more than {} transforms", most_with_chaos));
        if (chaos && std::abs(flame_.symmetry) > 1)
            error("chaos and <symmetry> together are not taken");
        diagnostics_.throw_if_errors({source_});
        if (chaos) find_followers();
        diagnostics_.throw_if_errors({source_});
        write_maps();
        if (chaos) write_follow();
        write_start(chaos);
        diagnostics_.throw_if_errors({source_});
        Scene scene = imported_scene(std::move(block_), flame_.name, Space::plane, source_);
        write_view(scene);
        write_objects(scene);
        return scene;
    }

  private:
    void error(const std::string& message) { diagnostics_.error(flame_.position, message); }
    [[nodiscard]] const FlameTransform& transform(std::size_t i) const {
        return flame_.transforms[i];
    }

    [[nodiscard]] bool has_chaos() const {
        for (const std::size_t i : live_)
            for (const std::size_t next : live_)
                if (next < transform(i).chaos.size() && transform(i).chaos[next] != 1) return true;
        return false;
    }

    void find_followers() {
        const auto after = [&](std::size_t before, std::size_t next) {
            return chaos_of(transform(before), next) > 0;
        };
        for (const std::size_t i : live_)
            if (std::ranges::none_of(live_, [&](std::size_t next) { return after(i, next); }))
                diagnostics_.error(
                    transform(i).position,
                    fmt::format("xform {}: its chaos lets nothing come after it", i + 1));
        live_ = lasting_maps(live_, after);
        if (live_.empty()) error("its chaos lets no transform come again and again");
    }

    /// Turns and mirrors do not contract. What they do to the set, they do to the images of the
    /// other transforms: each is taken once for every turn.
    [[nodiscard]] std::vector<PlaneNumbers> symmetries() const {
        std::vector<PlaneNumbers> group;
        const int turns = std::abs(flame_.symmetry);
        for (const double side : {1.0, -1.0}) {
            if (side < 0 && flame_.symmetry > 0) break;
            for (int k = 0; k < turns; ++k) {
                const double angle = 2 * std::numbers::pi * k / turns;
                const double c = 4 * k == turns || 4 * k == 3 * turns ? 0 : std::cos(angle);
                const double s = 2 * k == turns || k == 0 ? 0 : std::sin(angle);
                group.push_back({side * c, -s, side * s, c, 0, 0});
            }
        }
        return group;
    }

    void write_maps() {
        const std::vector<PlaneNumbers> group = symmetries();
        if (group.size() * live_.size() > maps_an_ifs)
            error(fmt::format("more than {} maps", maps_an_ifs));
        for (std::size_t g = 0; g < group.size(); ++g) {
            for (const std::size_t i : live_) {
                MapBlock map = map_block(i);
                PlaneNumbers numbers = upright(transform(i).map);
                if (g > 0) {
                    numbers = then(numbers, upright(group[g]));
                    map.name += fmt::format("_turn_{}", g);
                }
                map.commands = {{MatrixCommand{plane_map(numbers)}, map.position}};
                block_.maps.push_back(std::move(map));
            }
        }
        block_.position = flame_.position;
    }

    [[nodiscard]] MapBlock map_block(std::size_t i) const {
        MapBlock map;
        map.name = transform_name(i);
        map.position = transform(i).position;
        map.weight = transform(i).weight;
        if (flame_.palette.empty() || transform(i).color_speed == 0) return map;
        const auto short_ = [](double v) { return std::round(v * color_steps) / color_steps; };
        const PaletteColor color = palette_color(flame_.palette, transform(i).color);
        map.color = {short_(color[0]), short_(color[1]), short_(color[2]),
                     short_(transform(i).color_speed)};
        return map;
    }

    void write_follow() {
        for (const std::size_t j : live_) {
            FollowRule rule{reference(j, transform(j).position), {}};
            for (const std::size_t i : live_)
                if (chaos_of(transform(i), j) > 0)
                    rule.followers.push_back(reference(i, transform(j).position));
            block_.follow.push_back(std::move(rule));
        }
    }

    /// Points of a transform without opacity go on, but are not shown.
    void write_start(bool chaos) {
        if (std::abs(flame_.symmetry) > 1 || flame_.symmetry == -1) return;  // a turn shows them
        std::vector<MapReference> shown;
        for (const std::size_t i : live_)
            if (transform(i).opacity > 0) shown.push_back(reference(i, transform(i).position));
        if (shown.empty()) return error("no transform of the flame has opacity");
        if (chaos || shown.size() < live_.size()) block_.start = std::move(shown);
    }

    void write_view(Scene& scene) const {
        const double width = static_cast<double>(flame_.size.columns) /
                             (flame_.pixels_a_unit * std::exp2(flame_.zoom));
        const auto at = [](double value) { return Decimal{value + 0.0, {}}; };
        const Decimal x = at(flame_.center.x);
        const Decimal y = at(-flame_.center.y);
        CameraBlock& camera = *scene.camera;
        camera.eye = DecimalVec3{x, y, (*camera.eye)[2]};
        camera.look = DecimalVec3{x, y, at(0)};
        camera.orthographic = width;
        if (flame_.rotate_degrees != 0) {
            const double angle = flame_.rotate_degrees * std::numbers::pi / 180;
            camera.up = glm::dvec3{-std::sin(angle), std::cos(angle), 0};
        }
        ImageBlock image;
        image.size = flame_.size;
        scene.image = image;
    }

    /// The final transform places the whole; with an opacity below 1, some of it stays as it is.
    void write_objects(Scene& scene) const {
        if (!flame_.final_transform) return;
        const std::string name = scene.ifs[0].name;
        ObjectBlock placed;
        placed.name = name;
        placed.ifs = name;
        placed.commands = {{MatrixCommand{plane_map(upright(flame_.final_transform->map))},
                            flame_.final_transform->position}};
        scene.objects.push_back(placed);
        if (flame_.final_transform->opacity >= 1) return;
        ObjectBlock left;
        left.name = name + "_itself";
        left.ifs = name;
        scene.objects.push_back(left);
    }

    const Flame& flame_;
    const SourceFile& source_;
    Diagnostics& diagnostics_;
    std::vector<std::size_t> live_;  // transforms that points go through again and again
    IfsBlock block_;
};

}  // namespace

Imported import_flame(const SourceFile& source, const FlameRequest& request) {
    const XmlElement element = read_flame(source, request.entry);
    Diagnostics diagnostics;
    Flame flame = flame_of(element, request.variations, diagnostics);
    diagnostics.throw_if_errors({source});
    Scene scene = FlameScene(flame, source, diagnostics).scene();
    if (flame.palette.empty())
        flame.messages += "its palette is not in the file: the maps have no colours\n";
    Imported imported =
        finished(std::move(scene), fmt::format("{}: flame \"{}\" of {} (flam3; y is turned up)\n{}",
                                               scene_name(flame.name), printable(flame.name, 200),
                                               file_name(source.name), flame.messages));
    imported.messages = flame.messages;
    return imported;
}

}  // namespace pxm::host
