// How a sum over words grows with their length. The sums of one letter more are a nonnegative
// matrix over the follow sets; dimensions are the exponents at which its spectral radius is 1
// (Sec. 5.4 and 6.4, for graphs).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

/// A nonnegative matrix over the follow sets, by rows. Entries never lead from one strongly
/// connected component to another: those play no part in the growth.
struct StepMatrix {
    std::vector<std::size_t> first{0};  // entries of row s: first[s] .. first[s + 1] - 1
    std::vector<int> to;                // the follow set that an entry leads to
    std::vector<double> weight;         // the entry itself, not negative

    /// Appends a row.
    void add_row(const std::vector<int>& columns, const std::vector<double>& weights);
};

/// Follow sets by strongly connected component, without those that no cycle passes.
[[nodiscard]] std::vector<std::vector<int>> cyclic_components(const Rifs& rifs);

/// Whether a component of the graph has a set with two maps that stay in it. If none has, words
/// stay as few as they are, and every dimension is 0.
[[nodiscard]] bool branches(const Rifs& rifs);

enum class Growth { below_one, above_one, unclear };  // what is proven of the spectral radius

/// The numbers of a scene are rounded, and so is what single maps' constants are computed from.
inline constexpr double scene_error = 1e-12;

/// Is the spectral radius below or above 1? Both are proven for all matrices whose entries differ
/// from those given by a factor of at most 1 + error or 1 - error.
[[nodiscard]] Growth growth(const StepMatrix& matrix,
                            const std::vector<std::vector<int>>& components,
                            double error = scene_error);

/// The spectral radius, estimated.
[[nodiscard]] double spectral_radius(const StepMatrix& matrix,
                                     const std::vector<std::vector<int>>& components);

/// Where a number lies.
struct Interval {
    double low = 0;   // the least that it may be
    double high = 0;  // the most
    [[nodiscard]] double middle() const { return low + (high - low) / 2; }  // between both ends
    /// How far it may be from the middle.
    [[nodiscard]] double error() const { return (high - low) / 2; }
};

/// The d >= 0 at which the growth falls below 1, as near as it can be told. `growth_at` falls with
/// d. Preconditions: it is below 1 for some d, and the system branches.
[[nodiscard]] Interval critical_exponent(const std::function<Growth(double)>& growth_at);

}  // namespace pxm::host
