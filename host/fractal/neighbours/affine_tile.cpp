#include "host/fractal/neighbours/affine_tile.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "host/fractal/exact/lattice.hpp"

namespace pxm::host {

namespace {

using exact::ExactMap;
using exact::ExactSystem;
using exact::Polynomial;
using Vector = exact::Lattice::Vector;

bool have_one_linear_part(const ExactSystem& system) {
    const int n = system.field.dimensions;
    for (const ExactMap& map : system.maps)
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c)
                if (!(map.entry(system.field, r, c) == system.maps[0].entry(system.field, r, c)))
                    return false;
    return true;
}

/// Whether the maps' volumes add up to the whole's.
bool fill_the_whole(const ExactSystem& system) {
    const auto count = static_cast<long>(system.maps.size());
    const Polynomial volumes = Polynomial(count) * system.volume_ratio[0];
    return volumes == Polynomial(1) || volumes == Polynomial(-1);
}

/// By the linear part of a map.
Vector image(const ExactSystem& system, const ExactMap& map, const Vector& v) {
    const int n = system.field.dimensions;
    const exact::NumberField& numbers = system.numbers;
    Vector result;
    for (int r = 0; r < n; ++r) {
        exact::Algebraic sum = numbers.lifted(exact::whole(0));
        for (int c = 0; c < n; ++c) {
            exact::Algebraic entry = numbers.lifted(exact::whole(0)), of_v = entry;
            entry.value = map.entry(system.field, r, c);
            of_v.value = v[static_cast<std::size_t>(c)];
            sum = numbers.add(sum, numbers.multiply(entry, of_v));
        }
        result.push_back(sum.value);
    }
    return result;
}

/// f_0^-1 f_m is a translation: by the difference of the two digits.
Vector digit(const ExactSystem& system, std::size_t m) {
    const int n = system.field.dimensions;
    const ExactMap relative = ExactMap::composed(system.field, system.inverses[0], system.maps[m]);
    Vector v;
    for (int r = 0; r < n; ++r) v.push_back(relative.entry(system.field, r, n));
    return v;
}

}  // namespace

bool has_lattice_digits(const ExactSystem& system) {
    constexpr std::size_t most_digits = 200;
    if (system.maps.size() > most_digits || system.inverses.empty()) return false;
    if (!have_one_linear_part(system) || !fill_the_whole(system)) return false;
    // By Cayley and Hamilton's theorem the lattice of n powers is all, if A keeps it.
    std::vector<Vector> generators, last;
    for (std::size_t m = 1; m < system.maps.size(); ++m) {
        Vector v = digit(system, m);
        for (int power = 0; power < system.field.dimensions; ++power) {
            generators.push_back(v);
            v = image(system, system.inverses[0], v);
        }
        last.push_back(v);
    }
    const auto lattice = exact::Lattice::generated(system, generators);
    return lattice &&
           std::ranges::all_of(last, [&](const Vector& v) { return lattice->contains(v); });
}

}  // namespace pxm::host
