#include "host/compile/reroot.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host/compile/extent.hpp"
#include "host/math/lipschitz.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

// p where a cell is nearest to the eye, as shares of its diameter: that of an object as a whole,
// and what is kept of one that is replaced. Float tells 2^-23 of coordinates apart.
constexpr double whole_share = 0x1p-17;
constexpr double kept_share = 0x1p-15;
constexpr double nearest_share = 0.125;  // a cell that keeps that distance is never replaced
constexpr double eye_share = 0x1p-20;    // of the look distance: nothing smaller is replaced
constexpr double touching = 1e-6;
constexpr std::size_t most_replaced = 4000;
constexpr std::size_t most_objects = 100'000;  // of a scene: then nothing more is replaced
constexpr int most_looked_at = 4000;           // cells, to find out whether an object is near

/// What is near: where a pixel is too small for a cell of some size.
struct Nearness {
    // Something is near at less than these shares of a diameter: an object's, a cell's.
    double whole;
    double kept;
    double bulge;     // how much larger than a volume is what rays beside it may meet
    double smallest;  // diameter of cells that stay as they are, world units
    Rays rays;
    Frustum frustum;

    [[nodiscard]] bool can_meet(const Extent& extent) const {
        return rays == Rays::from_everywhere || !frustum.misses(extent, bulge);
    }
};

Nearness nearness(const CompiledScene& scene, const View& view, Rays rays) {
    const double growth = scene.camera.pixel_growth * std::min(1.0, scene.detail);
    const double bulge = needs_covers(scene) ? 1.5 : 1 + 1e-6;  // dsp_kernels/descend.hpp
    const auto share = [&](double least) { return std::min(nearest_share, least / growth); };
    return {
        share(whole_share),       share(kept_share), bulge, eye_share * view.look_distance, rays,
        Frustum(view, scene.size)};
}

/// Whether any of an object's attractor that rays may meet is near, for the object as a whole.
class NearSearch {
  public:
    NearSearch(const CompiledShape& shape, const Nearness& nearness, const Affine& place)
        : shape_(shape), nearness_(nearness) {
        limit_ = nearness.whole * 2 * extent_at(place, shape.start).radius();
        found_ = look(place, shape.start);
    }
    [[nodiscard]] bool found() const { return found_; }

  private:
    [[nodiscard]] Extent extent_at(const Affine& place, int set) const {
        const CompiledVolume& volume = shape_.sets[static_cast<std::size_t>(set)].volume;
        return extent(volume, place.linear, place.point(middle(volume)));
    }
    bool look(const Affine& place, int set_index) {
        const Extent cell = extent_at(place, set_index);
        const double radius = cell.radius();
        const double distance = cell.distance();
        if (distance >= limit_) return false;
        // Where the eye all but touches a cell, a double does not say on which side of it it is.
        if (distance > touching * limit_ && !nearness_.can_meet(cell)) return false;
        if (glm::length(cell.center) + radius < limit_ || radius < limit_ / 16) return true;
        if (++looked_at_ > most_looked_at) return false;
        const std::vector<int>& maps = shape_.sets[static_cast<std::size_t>(set_index)].maps;
        return std::ranges::any_of(maps, [&](int index) {
            const CompiledMap& map = shape_.maps[static_cast<std::size_t>(index)];
            return look(then(map.map, place), map.follow_set);
        });
    }

    const CompiledShape& shape_;
    const Nearness& nearness_;
    double limit_ = 0;
    int looked_at_ = 0;
    bool found_ = false;
};

/// The maps of a system in its shape's coordinates, exactly.
std::vector<PreciseAffine> precise_maps(const Root& root) {
    const PreciseVec3 center = precise(root.frame.center);
    std::vector<PreciseAffine> maps;
    for (const Affine& map : root.rifs->maps) {
        PreciseAffine exact = precise(map);
        exact.translation =
            scaled(subtract(image(exact, center), center), Precise(1) / Precise(root.frame.scale));
        maps.push_back(exact);
    }
    return maps;
}

/// From a shape's coordinates to the world about the eye.
PreciseAffine place_of(const Root& root, const PreciseVec3& eye) {
    const Affine frame{glm::dmat3{root.frame.scale}, root.frame.center};
    PreciseAffine place = then(precise(frame), precise(root.instance));
    place.translation = subtract(place.translation, eye);
    return place;
}

/// Replaces one object by its cells.
class Rerooting {
  public:
    Rerooting(const CompiledObject& object, const Root& root, const Nearness& nearness,
              CompiledScene& scene)
        : object_(object),
          shape_(scene.shapes[static_cast<std::size_t>(object.shape)]),
          maps_(precise_maps(root)),
          nearness_(nearness),
          scene_(scene) {}

    /// The distance of the nearest of them.
    double run(const PreciseVec3& eye, const Root& root) {
        visit({place_of(root, eye), object_.start, object_.constant, object_.color, {}, -1});
        return nearest_;
    }

  private:
    struct Cell {
        PreciseAffine place;
        int set;
        double constant;  // scene units
        glm::dvec3 color;
        std::vector<int> word;
        int around;  // the cell that was replaced by this one and others
    };
    struct Replaced {
        PreciseAffine place;
        int set;
        int around;
        double constant;
        std::optional<int> enclosure;  // once it was asked for
    };

    const CompiledSet& set_of(int index) const {
        return shape_.sets[static_cast<std::size_t>(index)];
    }

    void visit(const Cell& cell) {
        const CompiledSet& set = set_of(cell.set);
        const Extent reach = extent(set.volume, rounded_linear(cell.place),
                                    rounded(image(cell.place, precise(middle(set.volume)))));
        if (!nearness_.can_meet(reach)) return;
        const double distance = reach.distance();
        const double radius = reach.radius();
        const bool last = cell.word.size() == object_.levels;
        if (last || distance >= nearness_.kept * 2 * radius || 2 * radius < nearness_.smallest ||
            replaced_.size() >= most_replaced ||
            scene_.objects.size() + set.maps.size() > most_objects) {
            keep(cell);
            nearest_ = std::min(nearest_, std::max(distance, nearness_.kept * 2 * radius));
            return;
        }
        const int around = static_cast<int>(replaced_.size());
        replaced_.push_back({cell.place, cell.set, cell.around, cell.constant, {}});
        give_up_if_asked();
        for (const int index : set.maps) visit(child(cell, index, around));
    }

    Cell child(const Cell& cell, int index, int around) const {
        const auto at = static_cast<std::size_t>(index);
        const CompiledMap& map = shape_.maps[at];
        Cell child{then(maps_[at], cell.place),
                   map.follow_set,
                   cell.constant * map.constant,
                   cell.color * (1 - map.color.a) + glm::dvec3{map.color} * map.color.a,
                   cell.word,
                   around};
        child.word.push_back(index);
        return child;
    }

    void keep(const Cell& cell) {
        CompiledObject object = object_;
        object.start = cell.set;
        object.prefix = cell.word;
        object.enclosing = enclosing(cell.around);
        object.instance = {rounded_linear(cell.place) / scene_.unit,
                           rounded(cell.place.translation) / scene_.unit};
        object.constant = constant_of(object.instance, cell.constant);
        object.diameter = lipschitz_constant(object.instance) * set_of(cell.set).volume.diameter;
        object.color = cell.color;
        if (object.levels != kernels::unlimited_levels) {
            object.levels -= static_cast<std::uint32_t>(cell.word.size());
        }
        scene_.objects.push_back(std::move(object));
    }

    /// The Lipschitz constant by the shape's method; `product` is that of the maps.
    [[nodiscard]] double constant_of(const Affine& instance, double product) const {
        return shape_.lipschitz == kernels::Lipschitz::product
                   ? product
                   : constant_by(shape_.lipschitz, instance);
    }

    /// The innermost enclosure that stands for a replaced cell or one around it.
    int enclosing(int index) {
        if (index < 0 || scene_.shading == kernels::ShadingMode::facet) return -1;
        Replaced& cell = replaced_[static_cast<std::size_t>(index)];
        if (cell.enclosure) return *cell.enclosure;
        const int outer = enclosing(cell.around);
        const CompiledVolume& volume = set_of(cell.set).volume;
        const Affine instance{rounded_linear(cell.place) / scene_.unit, glm::dvec3{0}};
        const double diameter = constant_of(instance, cell.constant) * volume.diameter;
        auto made =
            enclosure(cell.place, volume, diameter * scene_.unit, scene_.unit, nearness_.rays);
        if (!made && cell.around < 0) made = silent_enclosure(diameter * scene_.unit, scene_.unit);
        cell.enclosure = outer;
        if (made) {
            made->enclosing = outer;
            cell.enclosure = static_cast<int>(scene_.enclosures.size());
            scene_.enclosures.push_back(std::move(*made));
        }
        return *cell.enclosure;
    }

    const CompiledObject& object_;
    const CompiledShape& shape_;
    std::vector<PreciseAffine> maps_;
    const Nearness& nearness_;
    CompiledScene& scene_;
    std::vector<Replaced> replaced_;
    double nearest_ = std::numeric_limits<double>::infinity();
};

/// Another unit; a power of two, as units are, so that nothing is rounded.
void change_unit(CompiledScene& scene, double unit) {
    const double factor = scene.unit / unit;
    for (CompiledObject& object : scene.objects) {
        object.instance.linear *= factor;
        object.instance.translation *= factor;
        object.constant *= factor;
        object.diameter *= factor;
    }
    for (CompiledEnclosure& cell : scene.enclosures) {
        cell.inverse.linear /= factor;
        cell.volume.diameter *= factor;
    }
    scene.unit = unit;
}

}  // namespace

void reroot(const std::vector<Root>& roots, const View& view, Rays rays, CompiledScene& scene) {
    // Where a cell as wide as the view may be terminal, none may be replaced.
    const double widest = scene.camera.pixel_growth * std::max(scene.detail, scene.fade);
    if (view.orthographic || !(widest < 0.5)) return;
    const Nearness near = nearness(scene, view, rays);
    const std::vector<CompiledObject> whole = std::move(scene.objects);
    scene.objects.clear();
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(whole[i].shape)];
        const Affine place{whole[i].instance.linear * scene.unit,
                           whole[i].instance.translation * scene.unit};
        if (roots[i].rifs == nullptr || !NearSearch(shape, near, place).found()) {
            scene.objects.push_back(whole[i]);
            continue;
        }
        nearest = std::min(
            nearest, Rerooting(whole[i], roots[i], near, scene).run(view.exact_eye, roots[i]));
        farthest = std::max(farthest, whole[i].diameter * scene.unit);
    }
    if (!std::isfinite(nearest)) return;
    // Lengths from the smallest pixel to the largest cell, as far above 1 as below it.
    const double pixel = scene.camera.pixel_growth * nearest;
    change_unit(scene, power_of_two_near(std::sqrt(pixel * farthest)));
}

}  // namespace pxm::host
