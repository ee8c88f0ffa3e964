// Cells as a level set of OpenVDB: samples of the distance to the union of all of them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <new>
#include <string>

#include "host/error.hpp"
#include "host/export/vdb_library.hpp"
#include "host/export/voxels.hpp"
#include "host/export/writers.hpp"

namespace pxm::host {
namespace {

constexpr double most_voxels_a_side = 4096;
constexpr std::uint64_t most_samples = 100'000'000;  // some 28 bytes each at the end
constexpr double voxels_a_side = 256;

double longest_side(const CellTally& tally) {
    const glm::dvec3 size = tally.high - tally.low;
    return std::max({size.x, size.y, size.z});
}

/// Half of the length at which cells end: a cube of that diameter has a sample inside.
double voxel_of_detail(const ExportScene& scene) {
    double voxel = std::numeric_limits<double>::infinity();
    for (const ExportSystem& system : scene.systems)
        if (system.detail > 0) voxel = std::min(voxel, system.detail / 2);
    return voxel;
}

double voxel_of(const ExportScene& scene, const CellTally& tally) {
    const double side = longest_side(tally);
    if (scene.voxels) return side / static_cast<double>(*scene.voxels);
    const double voxel = voxel_of_detail(scene);
    return std::isfinite(voxel) ? voxel : side / voxels_a_side;
}

}  // namespace

void require_vdb(const ExportScene& scene, const CellTally& tally) {
    const double side = longest_side(tally) / voxel_of(scene, tally);
    if (side <= most_voxels_a_side * (1 + 1e-9)) return;
    throw Error(ErrorKind::setting,
                fmt::format("a level set of {:.0f} voxels along its longest side: at most {:.0f}; "
                            "--voxels N says how many, or take a larger --detail",
                            side, most_voxels_a_side));
}

std::string told_of_voxels(const ExportScene& scene, const CellTally& tally) {
    const double voxel = voxel_of(scene, tally);
    std::string told = fmt::format("voxels of {:.6g}", voxel);
    if (tally.smallest < voxel)
        told += fmt::format(", and cells of {:.3g} that may lie between their samples and be lost",
                            tally.smallest);
    return told + '\n';
}

void write_vdb(const ExportJob& job, CheckedFile& file) {
    const double voxel = voxel_of(job.scene, job.tally);
    // Samples lie in the middles of voxels that divide the box.
    const SampleGrid grid{voxel, job.tally.low + voxel / 2};
    const std::unique_ptr<LevelSet> level_set = vdb_library().level_set(grid);
    const std::function<void()> look = [&] {
        job.watch.stop_if_asked();
        if (level_set->samples() > most_samples)
            throw Error(ErrorKind::setting,
                        fmt::format("a level set of more than {} samples near its surface: fewer "
                                    "--voxels or fewer --levels",
                                    most_samples));
    };
    for (const ExportSystem& system : job.scene.systems) {
        Voxels voxels(system, grid, *level_set, look);
        (void)for_each_cell(system, [&](const Cell& cell) {
            job.watch.visit();
            voxels.add(cell);
        });
    }
    std::string bytes;
    try {
        bytes = level_set->file(job.title);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw Error(ErrorKind::failed, fmt::format("OpenVDB: {}", error.what()));
    }
    file.append(bytes.data(), bytes.size());
}

}  // namespace pxm::host
