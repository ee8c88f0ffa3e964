// OpenVDB as pxm sees it: a level set, samples of the distance to a surface, kept where they are
// near it. It lies in a module of its own (host/openvdb/), which not every build has and which is
// loaded when a file of that format is written. Samples are counted by whole numbers along x, y and
// z; a voxel is the cube around one.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

namespace pxm::host {

/// Samples further from the surface than so many voxels are only told to be inside or outside.
inline constexpr double level_set_band = 3;

/// Where samples lie: number i at first + voxel i.
struct SampleGrid {
    double voxel = 1;       // a length of the file
    glm::dvec3 first{0.0};  // the place of sample 0
};

class LevelSet {
  public:
    virtual ~LevelSet() = default;
    /// Distances in voxels, negative inside, of a box of samples, z fastest: each takes the place
    /// of what was there if it is lower. The box lies between two multiples of 8 along every axis.
    virtual void lower(const glm::ivec3& low, const glm::ivec3& size, const float* distances) = 0;
    /// All of a cube is inside, and deeper than the band. Its edge is a power of two, 8 or more, of
    /// which `low` is a multiple.
    virtual void fill(const glm::ivec3& low, int edge) = 0;
    /// How many samples are kept, or a little more.
    [[nodiscard]] virtual std::uint64_t samples() = 0;
    /// Makes distances inside reach from surface to surface, whatever cells meet there, and gives
    /// the bytes of a file with this grid alone. `title` becomes part of its metadata. Throws
    /// std::exception with OpenVDB's own words.
    [[nodiscard]] virtual std::string file(const std::string& title) = 0;
};

class VdbLibrary {
  public:
    /// A grid without an inside.
    [[nodiscard]] virtual std::unique_ptr<LevelSet> level_set(const SampleGrid& grid) const = 0;

  protected:
    ~VdbLibrary() = default;
};

inline constexpr char vdb_module[] = "pxm_openvdb.so";
inline constexpr char vdb_module_function[] = "pxm_vdb_library";

/// The one function of the module. What it returns lives as long as the process.
using VdbModuleFunction = const VdbLibrary*();

/// Loaded by the first call. Throws Error(ErrorKind::failed) if the module is not there.
[[nodiscard]] const VdbLibrary& vdb_library();

}  // namespace pxm::host
