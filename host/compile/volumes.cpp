#include "host/compile/volumes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "host/compile/computed_volume.hpp"
#include "host/compile/filled_volume.hpp"
#include "host/compile/shape.hpp"
#include "host/compile/short_by.hpp"
#include "host/compile/trial.hpp"
#include "host/compiled/bounding_volume.hpp"
#include "host/math/lipschitz.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr double costly = 300;      // tests a ray: a reason to try more than spheres and boxes
constexpr double sheet = 1.0 / 20;  // of a map's widest: how much thinner is a sheet
constexpr std::size_t most_fitted = 300;  // follow sets: fitting hulls to more takes too long
constexpr double clearly_cheaper = 0.5;   // oriented boxes and hulls: else spheres and boxes stay
constexpr double hopeless = 3000;         // tests a ray, where ...
constexpr double much_dearer = 2;         // ... computed volumes need so many times fewer

using Volumes = std::vector<CompiledVolume>;

std::optional<kernels::Volume> kind_asked_for(VolumeKind kind) {
    switch (kind) {
        case VolumeKind::sphere:
            return kernels::Volume::sphere;
        case VolumeKind::box:
            return kernels::Volume::box;
        case VolumeKind::oriented:
            return kernels::Volume::oriented;
        case VolumeKind::hull:
            return kernels::Volume::hull;
        case VolumeKind::automatic:
            break;
    }
    return std::nullopt;
}

/// Volumes of all follow sets of a system, and what they cost.
class Choice {
  public:
    Choice(const Rifs& rifs, const std::vector<Bounds>& bounds, std::optional<long> levels)
        : rifs_(rifs), bounds_(bounds), computer_(rifs, bounds), start_(rifs.start) {
        if (levels) levels_ = static_cast<std::uint32_t>(std::min<long>(*levels, levels_ - 1));
    }

    Volumes of_kind(kernels::Volume kind) {
        Volumes volumes;
        for (std::size_t set = 0; set < bounds_.size(); ++set) {
            give_up_if_asked();
            volumes.push_back(computer_.make(kind, set));
        }
        return volumes;
    }

    /// What the attractor fills, if it does. Else spheres or boxes, as they cost less; oriented
    /// boxes or hulls where these cost far more.
    const Volumes& cheapest() {
        if (!cheapest_) cheapest_ = find_cheapest();
        return *cheapest_;
    }

    /// A declared volume, and in sets that stick out of it what suits it. `short_by` of each set.
    Volumes with_declared(const CompiledVolume& declared, const std::vector<double>& short_by) {
        Volumes volumes(bounds_.size(), declared);
        const auto sticks_out = [](double by) { return by > 0; };
        if (std::ranges::none_of(short_by, sticks_out)) return volumes;
        const bool simple =
            declared.kind == kernels::Volume::sphere || declared.kind == kernels::Volume::box;
        const Volumes computed = simple ? of_kind(declared.kind) : cheapest();
        for (std::size_t set = 0; set < bounds_.size(); ++set) {
            if (sticks_out(short_by[set])) volumes[set] = computed[set];
        }
        return volumes;
    }

    [[nodiscard]] Trial trial_of(const Volumes& volumes) const {
        const Ball& ball = bounds_[start_].ball;
        // The unit ball itself, unlike frame_around: costs must not depend on the scene's lengths.
        const ShapeFrame frame{ball.center, ball.radius > 0 ? ball.radius : 1};
        const auto method = choose_lipschitz(LipschitzMethod::automatic, rifs_);
        return {make_shape(rifs_, volumes, frame, method), levels_};
    }

  private:
    Volumes find_cheapest() {
        if (auto filled = filled_volumes(rifs_, bounds_, computer_)) return *std::move(filled);
        Volumes spheres = of_kind(kernels::Volume::sphere);
        // Spheres stay a pixel thick down to the last cell: curves and sheets edge on are not
        // missed.
        if (is_flat(bounds_[start_].box)) return spheres;
        Trial trial = trial_of(spheres);
        if (trial.cost(costly) < costly && has_sheets()) return spheres;
        Candidate best{std::move(spheres), std::move(trial)};
        take_if_cheaper(kernels::Volume::box, 1, best);
        if (best.trial.cost(costly) < costly || bounds_.size() > most_fitted) return best.volumes;
        const bool clearly = take_if_cheaper(kernels::Volume::oriented, clearly_cheaper, best);
        take_if_cheaper(kernels::Volume::hull, clearly ? 1 : clearly_cheaper, best);
        return best.volumes;
    }

    struct Candidate {
        Volumes volumes;
        Trial trial;
    };

    /// Whether volumes of a kind cost less than `factor` times the best so far, and are that now.
    bool take_if_cheaper(kernels::Volume kind, double factor, Candidate& best) {
        Volumes volumes = of_kind(kind);
        Trial trial = trial_of(volumes);
        if (!is_cheaper(trial, factor, best.trial)) return false;
        best = {std::move(volumes), std::move(trial)};
        return true;
    }

    /// Whether a map makes a sheet or a curve of what is inside.
    [[nodiscard]] bool has_sheets() const {
        return std::ranges::any_of(rifs_.maps, [](const Affine& map) {
            return smallest_singular_value(map) < sheet * lipschitz_constant(map);
        });
    }

    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    VolumeComputer computer_;
    std::size_t start_;
    std::uint32_t levels_ = kernels::unlimited_levels;
    std::optional<Volumes> cheapest_;
};

const char* name_of(const DeclaredVolume& volume) {
    constexpr std::array names{"volume", "sphere", "box", "cone", "cylinder", "hull"};
    return names[volume.index()];
}

/// Says inside which map a declared volume does not hold, if inside any.
void warn_of_levels(const ObjectBlock& object, const Rifs& rifs,
                    const std::vector<double>& short_by, Diagnostics& diagnostics) {
    for (std::size_t map = 0; map < rifs.maps.size(); ++map) {
        const double by = short_by[static_cast<std::size_t>(rifs.follow_of[map])];
        if (!(by > 0)) continue;
        diagnostics.warning(
            object.volume_position,
            fmt::format("the {} of object \"{}\" does not contain what may stand inside {} (short "
                        "by {:.3g}): a computed volume is used there",
                        name_of(*object.volume), object.name,
                        spoken_name(rifs, static_cast<int>(map)), by));
        return;
    }
}

/// The volumes that a scene declares if they can be used; else nothing, with a warning that says
/// why.
std::optional<Volumes> declared_volumes(const ObjectBlock& object, const Rifs& rifs,
                                        const std::vector<Bounds>& bounds, Choice& choice,
                                        Diagnostics& diagnostics) {
    const DeclaredVolume& declared = *object.volume;
    const char* name = name_of(declared);
    const std::vector<double> short_by = host::short_by(rifs, bounds, declared);
    const double by = short_by[static_cast<std::size_t>(rifs.start)];
    if (by > 0) {
        diagnostics.warning(
            object.volume_position,
            fmt::format("the {} of object \"{}\" does not contain the attractor (short by "
                        "{:.3g}): a computed volume is used instead",
                        name, object.name, by));
        return std::nullopt;
    }
    Volumes volumes = choice.with_declared(primitive_volume(declared), short_by);
    Trial trial = choice.trial_of(volumes);
    const auto is_worth_it = [&] {
        Trial cheapest = choice.trial_of(choice.cheapest());
        return is_cheaper(trial, much_dearer, cheapest);
    };
    if (trial.cost(hopeless) < hopeless || is_worth_it()) {
        warn_of_levels(object, rifs, short_by, diagnostics);
        return volumes;
    }
    diagnostics.warning(
        object.volume_position,
        fmt::format("the {} of object \"{}\" is so loose that a ray would meet thousands of "
                    "cells: a computed volume is used instead; with fewer 'levels' it would do",
                    name, object.name));
    return std::nullopt;
}

}  // namespace

CompiledVolume primitive_volume(const DeclaredVolume& declared) {
    if (const auto* ball = std::get_if<SphereVolume>(&declared)) {
        return sphere_volume(ball->center, ball->radius);
    }
    if (const auto* corners = std::get_if<BoxVolume>(&declared)) {
        return box_volume(corners->low, corners->high);
    }
    return std::holds_alternative<ConeVolume>(declared) ? cone_volume() : cylinder_volume();
}

std::vector<CompiledVolume> choose_volumes(const ObjectBlock& object, VolumeKind kind,
                                           const Rifs& rifs, const std::vector<Bounds>& bounds,
                                           Diagnostics& diagnostics) {
    Choice choice(rifs, bounds, object.levels);
    if (const auto asked_for = kind_asked_for(kind)) return choice.of_kind(*asked_for);
    const DeclaredVolume declared = object.volume.value_or(AutoVolume{});
    if (std::holds_alternative<HullVolume>(declared)) {
        return choice.of_kind(kernels::Volume::hull);
    }
    if (!std::holds_alternative<AutoVolume>(declared)) {
        auto volumes = declared_volumes(object, rifs, bounds, choice, diagnostics);
        if (volumes) return *volumes;
    }
    return choice.cheapest();
}

}  // namespace pxm::host
