// What needs exact numbers, asked through a module: FLINT and Arb, which have them, cost a start as
// much as all the rest of the program, and one command asks.
#pragma once

#include <cstddef>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/neighbours/neighbour_limits.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// A system whose numbers are to be read exactly.
struct WrittenSystem {
    const Scene& scene;  // that the block is of; without files, doubles are numbers
    const IfsBlock& block;
    const Rifs& part;                   // what is reached of it from its start
    std::vector<std::size_t> maps;      // per map of the part: its place in the block
    const std::vector<Bounds>& bounds;  // of the follow sets of `part`, as from bound()
};

class ExactLibrary {
  public:
    /// Nothing decided, with the reason, where exact numbers are out of reach. Precondition: the
    /// part contracts, and every follow set is reached from its start.
    [[nodiscard]] virtual ExactFindings find(const WrittenSystem& system,
                                             const NeighbourLimits& limits) const = 0;

  protected:
    ~ExactLibrary() = default;
};

inline constexpr char exact_module[] = "pxm_flint.so";
inline constexpr char exact_module_function[] = "pxm_exact_library";

/// The one function of the module. What it returns lives as long as the process.
using ExactModuleFunction = const ExactLibrary*();

/// Loaded by the first call. Throws Error of kind `failed` if the module, or what it is linked to,
/// is not there.
[[nodiscard]] const ExactLibrary& exact_library();

}  // namespace pxm::host
