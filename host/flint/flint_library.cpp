// The module that is linked to FLINT and Arb.
#include <cstddef>
#include <utility>
#include <vector>

#include "host/exact/exact_library.hpp"
#include "host/flint/exact_scene.hpp"
#include "host/fractal/exact/exact_system.hpp"

namespace pxm::host {

namespace {

/// The maps of the part, in its order.
exact::WrittenMaps written_part(const WrittenSystem& system) {
    exact::WrittenMaps all = written_maps(system.scene, system.block);
    std::vector<exact::Entries> maps;
    for (const std::size_t place : system.maps) maps.push_back(all.maps[place]);
    all.maps = std::move(maps);
    return all;
}

class FlintLibrary : public ExactLibrary {
  public:
    [[nodiscard]] ExactFindings find(const WrittenSystem& system,
                                     const NeighbourLimits& limits) const override {
        try {
            return find_exactly(written_part(system), system.part, system.bounds, limits);
        } catch (const exact::NotExact& reason) {
            return nothing_exact(reason.why);
        }
    }
};

}  // namespace

}  // namespace pxm::host

extern "C" __attribute__((visibility("default"))) const pxm::host::ExactLibrary*
pxm_exact_library() {
    static const pxm::host::FlintLibrary library;
    return &library;
}
