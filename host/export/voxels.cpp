#include "host/export/voxels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

namespace pxm::host {
namespace {

constexpr int block = 8;  // samples a side: what OpenVDB keeps as one piece

/// The largest multiple of a power of two that is no larger.
int multiple(int sample, int edge) { return sample & ~(edge - 1); }

}  // namespace

Voxels::Voxels(const ExportSystem& system, const SampleGrid& grid, LevelSet& level_set,
               const std::function<void()>& look)
    : system_(system), level_set_(level_set), look_(look) {
    to_samples_.linear = glm::dmat3{1 / grid.voxel};
    to_samples_.translation = -grid.first / grid.voxel;
    for (const SystemSet& set : system.sets) solids_.emplace_back(set.volume, set.shape);
}

void Voxels::add(const Cell& cell) {
    const auto set = static_cast<std::size_t>(cell.set);
    const Affine place = then(cell.place, to_samples_);
    const Box3 extent = solids_[set].extent(place);
    const double room = level_set_band + cell_growth;
    low_ = glm::ivec3{glm::floor(extent.low - room)};
    high_ = glm::ivec3{glm::ceil(extent.high + room)};
    const glm::ivec3 size = high_ - low_ + 1;
    int edge = block;
    while (edge < std::max({size.x, size.y, size.z})) edge *= 2;
    const auto divide_all = [&](const Placed& placed) {
        for (int x = multiple(low_.x, edge); x <= high_.x; x += edge)
            for (int y = multiple(low_.y, edge); y <= high_.y; y += edge)
                for (int z = multiple(low_.z, edge); z <= high_.z; z += edge)
                    divide(placed, {x, y, z}, edge);
    };
    if (system_.similar) {
        divide_all({solids_[set], inverse(place), lipschitz_constant(place)});
    } else {
        const Solid sheared(system_.sets[set].volume, system_.sets[set].shape, place);
        divide_all({sheared, {}, 1});
    }
}

void Voxels::divide(const Placed& placed, const glm::ivec3& low, int edge) {
    const glm::dvec3 middle = glm::dvec3{low} + (edge - 1) / 2.0;
    const double half_diagonal = std::sqrt(3.0) * (edge - 1) / 2;
    const double reach = level_set_band + half_diagonal + 1;
    const double distance =
        placed.scale * placed.solid.at_least(placed.back.point(middle), reach / placed.scale) -
        cell_growth;
    if (distance - half_diagonal >= level_set_band) return;
    if (distance + half_diagonal <= -level_set_band) return level_set_.fill(low, edge);
    if (edge == block) return sample(placed, low);
    for (int child = 0; child < 8; ++child)
        divide(placed, low + edge / 2 * glm::ivec3{child & 1, child >> 1 & 1, child >> 2},
               edge / 2);
}

void Voxels::sample(const Placed& placed, const glm::ivec3& corner) {
    look_();
    const glm::ivec3 low = glm::max(corner, low_);
    const glm::ivec3 size = glm::min(corner + block - 1, high_) - low + 1;
    if (std::min({size.x, size.y, size.z}) <= 0) return;
    std::array<float, block * block * block> distances;
    std::size_t count = 0;
    double nearest = level_set_band;
    for (int x = 0; x < size.x; ++x)
        for (int y = 0; y < size.y; ++y)
            for (int z = 0; z < size.z; ++z) {
                const glm::dvec3 at = placed.back.point(glm::dvec3{low + glm::ivec3{x, y, z}});
                const double distance =
                    placed.scale * placed.solid.distance(at, level_set_band / placed.scale) -
                    cell_growth;
                nearest = std::min(nearest, distance);
                distances[count++] = static_cast<float>(distance);
            }
    if (nearest < level_set_band) level_set_.lower(low, size, distances.data());
}

}  // namespace pxm::host
