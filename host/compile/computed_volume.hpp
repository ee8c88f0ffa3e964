// Bounding volumes that are computed from what is known of the attractor
// (host/fractal/bounds/bounds, polytope). Each contains it, and is thick enough to be crossed where
// the attractor is flat.
#pragma once

#include <optional>

#include "host/compiled/compiled_scene.hpp"
#include "host/fractal/bounds/approximation.hpp"

namespace pxm::host {

/// Makes the volumes of one system's follow sets.
class VolumeComputer {
  public:
    VolumeComputer(const Rifs& rifs, const std::vector<Bounds>& bounds)
        : rifs_(rifs), bounds_(bounds) {}

    [[nodiscard]] CompiledVolume sphere(std::size_t set) const;
    [[nodiscard]] CompiledVolume box(std::size_t set) const;
    /// A sphere where the attractor is a point, as is hull().
    [[nodiscard]] CompiledVolume oriented(std::size_t set);
    [[nodiscard]] CompiledVolume hull(std::size_t set);
    [[nodiscard]] CompiledVolume make(kernels::Volume kind, std::size_t set);

  private:
    const Approximation& known();

    const Rifs& rifs_;
    const std::vector<Bounds>& bounds_;
    std::optional<Approximation> known_;  // made when first needed
};

/// Whether a box has no thickness to speak of along one of the axes.
[[nodiscard]] bool is_flat(const Box& bounds);

}  // namespace pxm::host
