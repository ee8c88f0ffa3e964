#include "host/flint/shadow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/neighbours/exact_findings.hpp"
#include "host/fractal/system/contraction.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t most_types = 2'000;

using Kept = std::array<bool, 3>;  // coordinates of the projection

/// Whether these coordinates of an image do not depend on the others.
bool is_projected(const exact::WrittenMaps& written, const Kept& kept) {
    return std::ranges::all_of(written.maps, [&](const exact::Entries& map) {
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                if (kept[r] && !kept[c] && !map[r][c].value.is_zero()) return false;
        return true;
    });
}

/// The other coordinates halved instead, so that they are 0 on the attractor.
void project(exact::WrittenMaps& written, Rifs& rifs, const Kept& kept) {
    constexpr double half = 0.5;
    for (std::size_t m = 0; m < written.maps.size(); ++m)
        for (std::size_t r = 0; r < 3; ++r) {
            if (kept[r]) continue;
            const int row = static_cast<int>(r);
            for (std::size_t c = 0; c < 4; ++c) written.maps[m][r][c] = exact::whole(0);
            written.maps[m][r][r] = {0, exact::Polynomial::of_double(half)};
            for (int c = 0; c < 3; ++c) rifs.maps[m].linear[c][row] = c == row ? half : 0;
            rifs.maps[m].translation[row] = 0;
        }
}

/// Whether these coordinates' lengths or areas, under all maps, add up to more than the whole's:
/// the affinity dimension is more than how many they are then. A word's singular value function is
/// at least what the word does to them, and these multiply. Of an IFS.
bool overfills(const Rifs& rifs, const Kept& kept) {
    constexpr double clearly = 1 + 1e-9;
    if (rifs.follow_sets.size() > 1) return false;
    double sum = 0;
    for (const Affine& map : rifs.maps) {
        glm::dmat3 linear = map.linear;
        for (int i = 0; i < 3; ++i)
            if (!kept[static_cast<std::size_t>(i)]) linear[i] = glm::dmat3{1}[i];
        sum += std::abs(glm::determinant(linear));
    }
    return sum > clearly;
}

}  // namespace

Decided<double> shadow_dimension(const std::function<exact::WrittenMaps()>& written,
                                 const Rifs& rifs, const NeighbourLimits& limits) {
    constexpr std::array<Kept, 6> all{Kept{true, true, false}, {true, false, true},
                                      {false, true, true},     {true, false, false},
                                      {false, true, false},    {false, false, true}};
    constexpr std::array names{"x and y", "x and z", "y and z", "x", "y", "z"};
    Decided<double> largest{std::nullopt, "no projection along axes is known"};
    NeighbourLimits few = limits;
    few.types = std::min(few.types, most_types);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double most = i < 3 ? 2 : 1;  // there are three planes, and then lines
        if (largest.value && *largest.value >= most) continue;
        exact::WrittenMaps maps = written();
        if (!is_projected(maps, all[i])) continue;
        if (overfills(rifs, all[i])) break;  // no projection has the affinity dimension
        Rifs flat = rifs;
        project(maps, flat, all[i]);
        const Contraction contraction = prove_contraction(flat);
        if (contraction.proof == ContractionProof::none) continue;
        const ExactFindings found =
            find_exactly(std::move(maps), flat, bound(flat, contraction), few);
        const auto& value = found.hausdorff.value;
        if (!value || (largest.value && *largest.value >= *value)) continue;
        largest = {value,
                   fmt::format("that of its projection to {}: {}", names[i], found.hausdorff.why)};
    }
    return largest;
}

}  // namespace pxm::host
