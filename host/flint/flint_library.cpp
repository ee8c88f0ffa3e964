// The module that is linked to FLINT and Arb.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "host/exact/exact_library.hpp"
#include "host/flint/exact_scene.hpp"
#include "host/flint/shadow.hpp"
#include "host/fractal/exact/ball_system.hpp"
#include "host/fractal/exact/exact_system.hpp"
#include "host/fractal/neighbours/interval_findings.hpp"

namespace pxm::host {

namespace {

template <class List>
List of_part(const List& all, const std::vector<std::size_t>& places) {
    List list;
    for (const std::size_t place : places) list.push_back(all[place]);
    return list;
}

/// The maps of the part, in its order.
exact::WrittenMaps written_part(const WrittenSystem& system) {
    exact::WrittenMaps all = written_maps(system.scene, system.block);
    all.maps = of_part(all.maps, system.maps);
    return all;
}

/// The scene's numbers in balls, or all that are near the doubles that pictures are made of.
ExactFindings found_by_intervals(const WrittenSystem& system, const std::string& why,
                                 bool as_written) {
    constexpr std::size_t most_maps = 5'000;  // no pairs of more are told apart in moderate time
    if (system.block.maps.size() > most_maps) return nothing_exact(why);
    try {
        if (as_written) {
            exact::BallMaps all = balls_as_written(system.scene, system.block);
            all.maps = of_part(all.maps, system.maps);
            all.ratio = of_part(all.ratio, system.maps);
            return find_by_intervals(all, system.part, system.bounds, why);
        }
    } catch (const exact::NotExact&) {
        // Then the numbers near the doubles are left.
    }
    try {
        return find_by_intervals(exact::balls_around(system.part), system.part, system.bounds,
                                 why + ", so all numbers near the rounded ones");
    } catch (const exact::NotExact& reason) {
        return nothing_exact(why + "; " + reason.why);
    }
}

/// What exact numbers decide, or the reason why there are none.
ExactFindings found_exactly(const WrittenSystem& system, const NeighbourLimits& limits) {
    if (!limits.as_written) return nothing_exact("numbers were set from outside");
    try {
        ExactFindings found =
            find_exactly(written_part(system), system.part, system.bounds, limits);
        if (found.degree > 0 && found.dimensions > 1 && !found.hausdorff.value)
            found.shadow =
                shadow_dimension([&] { return written_part(system); }, system.part, limits);
        return found;
    } catch (const exact::NotExact& reason) {
        return nothing_exact(reason.why);
    }
}

class FlintLibrary : public ExactLibrary {
  public:
    [[nodiscard]] ExactFindings find(const WrittenSystem& system,
                                     const NeighbourLimits& limits) const override {
        ExactFindings found = found_exactly(system, limits);
        if (found.degree > 0) return found;
        return found_by_intervals(system, found.numbers, limits.as_written);
    }
};

}  // namespace

}  // namespace pxm::host

extern "C" __attribute__((visibility("default"))) const pxm::host::ExactLibrary*
pxm_exact_library() {
    static const pxm::host::FlintLibrary library;
    return &library;
}
