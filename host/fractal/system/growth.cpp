#include "host/fractal/system/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/fractal/system/components.hpp"
#include "host/fractal/system/elimination.hpp"

namespace pxm::host {

namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double relative = 1e-13;  // of an exponent: how finely it is known
constexpr int most_sweeps = 400;    // of one comparison
constexpr double work_limit = 2e7;  // entries looked at in one comparison
constexpr int most_halvings = 60;   // of an interval of exponents
constexpr double largest_exponent = 1e12;
constexpr double tiny = 1e-280;

double row_times(const StepMatrix& matrix, int row, const std::vector<double>& x) {
    double sum = 0;
    for (std::size_t e = matrix.first[row]; e < matrix.first[row + 1]; ++e) {
        sum += matrix.weight[e] * x[matrix.to[e]];
    }
    return sum;
}

std::size_t entries_of(const StepMatrix& matrix, const std::vector<int>& sets) {
    std::size_t entries = 0;
    for (const int s : sets) entries += matrix.first[s + 1] - matrix.first[s];
    return entries;
}

int sweeps_for(const StepMatrix& matrix, const std::vector<int>& sets) {
    const double entries = 1 + static_cast<double>(entries_of(matrix, sets));
    return static_cast<int>(std::clamp(work_limit / (2 * entries), 2.0, double{most_sweeps}));
}

/// One row at a time, with what was just computed: down and up again, so that a wave runs along a
/// long cycle in one sweep. Part of the old value is kept, so that cycles do not make it swing.
void sweep(const StepMatrix& matrix, const std::vector<int>& sets, std::vector<double>& x) {
    constexpr double kept = 0.25;
    const auto relax = [&](int s) {
        x[s] = std::max(kept * x[s] + (1 - kept) * row_times(matrix, s, x), tiny);
    };
    for (auto s = sets.begin(); s != sets.end(); ++s) relax(*s);
    for (auto s = sets.rbegin(); s != sets.rend(); ++s) relax(*s);
}

/// For any positive x, the spectral radius lies between the least and the largest of (M x)_s / x_s
/// (Collatz and Wielandt). `error`: of the entries, relative; the sum of a row adds its own.
Growth growth_by(const StepMatrix& matrix, const std::vector<int>& sets,
                 const std::vector<double>& x, double error) {
    bool below = true;
    bool above = true;
    for (const int s : sets) {
        const double terms = static_cast<double>(matrix.first[s + 1] - matrix.first[s]);
        const double margin = error + (terms + 8) * unit;
        const double image = row_times(matrix, s, x);
        below = below && image < (1 - margin) * x[s];
        above = above && image > (1 + margin) * x[s];
    }
    return below ? Growth::below_one : above ? Growth::above_one : Growth::unclear;
}

/// `x` and `before` are scratch space, one number for each follow set; x is 1 on `sets`.
Growth growth_in(const StepMatrix& matrix, const std::vector<int>& sets, double error,
                 std::vector<double>& x, std::vector<double>& before) {
    Growth found = growth_by(matrix, sets, x, error);
    if (sets.size() == 1 || found != Growth::unclear) return found;
    constexpr double settled = 1e-14;
    for (int n = sweeps_for(matrix, sets); n > 0; --n) {
        for (const int s : sets) before[s] = x[s];
        sweep(matrix, sets, x);
        double least = std::numeric_limits<double>::infinity();
        double most = 0;
        double largest = 0;
        for (const int s : sets) {
            const double ratio = x[s] / before[s];
            least = std::min(least, ratio);
            most = std::max(most, ratio);
            largest = std::max(largest, x[s]);
        }
        if (!(largest < std::numeric_limits<double>::infinity())) break;
        for (const int s : sets) x[s] = std::max(x[s] / largest, tiny);
        if (most < 1 || least > 1 || most - least < settled) {
            found = growth_by(matrix, sets, x, error);
            if (found != Growth::unclear) return found;
        }
        if (most - least < settled) break;
    }
    return growth_by_elimination(matrix, sets, error);
}

double radius_in(const StepMatrix& matrix, const std::vector<int>& sets, std::vector<double>& x,
                 std::vector<double>& y) {
    if (sets.size() == 1) return row_times(matrix, sets[0], x);
    double radius = 0;
    for (int n = sweeps_for(matrix, sets); n > 0; --n) {
        double sum = 0;
        double image = 0;
        for (const int s : sets) {
            y[s] = row_times(matrix, s, x);
            sum += x[s];
            image += y[s];
        }
        const double last = radius;
        radius = image / sum;
        if (!(radius > 0)) return 0;
        if (std::abs(radius - last) <= relative * radius) break;
        // Half of the old value is kept: the matrix may be periodic.
        for (const int s : sets) x[s] = std::max((x[s] / sum + y[s] / image) / 2, tiny);
    }
    return radius;
}

/// The exponents nearest to `unclear` whose growth is known.
Interval around(const std::function<Growth(double)>& growth_at, Interval known, double unclear) {
    double inner = unclear;
    for (int n = 0; n < most_halvings / 2 && inner - known.low > relative * unclear; ++n) {
        const double d = (known.low + inner) / 2;
        (growth_at(d) == Growth::above_one ? known.low : inner) = d;
    }
    inner = unclear;
    for (int n = 0; n < most_halvings / 2 && known.high - inner > relative * unclear; ++n) {
        const double d = (known.high + inner) / 2;
        (growth_at(d) == Growth::below_one ? known.high : inner) = d;
    }
    return known;
}

}  // namespace

void StepMatrix::add_row(const std::vector<int>& columns, const std::vector<double>& weights) {
    to.insert(to.end(), columns.begin(), columns.end());
    weight.insert(weight.end(), weights.begin(), weights.end());
    first.push_back(to.size());
}

std::vector<std::vector<int>> cyclic_components(const Rifs& rifs) {
    const std::vector<int> component = set_components(rifs);
    std::vector<std::vector<int>> members(rifs.maps.size() + rifs.follow_sets.size());
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        const auto stays = [&](int m) { return component[rifs.follow_of[m]] == component[s]; };
        if (std::ranges::any_of(rifs.follow_sets[s].maps, stays)) {
            members[component[s]].push_back(static_cast<int>(s));
        }
    }
    std::erase_if(members, [](const std::vector<int>& sets) { return sets.empty(); });
    return members;
}

bool branches(const Rifs& rifs) {
    const std::vector<int> component = set_components(rifs);
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        const auto stays = [&](int m) { return component[rifs.follow_of[m]] == component[s]; };
        if (std::ranges::count_if(rifs.follow_sets[s].maps, stays) > 1) return true;
    }
    return false;
}

Growth growth(const StepMatrix& matrix, const std::vector<std::vector<int>>& components,
              double error) {
    Growth result = Growth::below_one;
    std::vector<double> x(matrix.first.size(), 1);
    std::vector<double> scratch(x.size(), 0);
    for (const std::vector<int>& sets : components) {
        const Growth here = growth_in(matrix, sets, error, x, scratch);
        if (here == Growth::above_one) return here;
        if (here == Growth::unclear) result = here;
    }
    return result;
}

double spectral_radius(const StepMatrix& matrix, const std::vector<std::vector<int>>& components) {
    double radius = 0;
    std::vector<double> x(matrix.first.size(), 1);
    std::vector<double> scratch(x.size(), 0);
    for (const std::vector<int>& sets : components) {
        radius = std::max(radius, radius_in(matrix, sets, x, scratch));
    }
    return radius;
}

Interval critical_exponent(const std::function<Growth(double)>& growth_at) {
    Interval known{0, 1};
    while (growth_at(known.high) != Growth::below_one) {
        if (known.high > largest_exponent) {
            return {known.low, std::numeric_limits<double>::infinity()};
        }
        known.high *= 2;
    }
    for (int n = 0; n < most_halvings && known.high - known.low > relative * known.high; ++n) {
        const double d = known.middle();
        const Growth found = growth_at(d);
        if (found == Growth::unclear) return around(growth_at, known, d);
        (found == Growth::above_one ? known.low : known.high) = d;
    }
    return known;
}

}  // namespace pxm::host
