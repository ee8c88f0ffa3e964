#include "host/fractal/system/elimination.hpp"

#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

namespace pxm::host {

namespace {

constexpr long work_limit = 2'000'000;  // entries changed

/// All that is computed is rounded by at most a unit, three roundings an entry.
constexpr double step_error = 4 * std::numeric_limits<double>::epsilon();

/// I - M has only positive pivots, in any order, exactly if the spectral radius is below 1. What
/// remains of M after a pivot stays nonnegative, so bounds of entries stay bounds.
class Elimination {
  public:
    /// `bias` multiplies every entry and every result: above 1 for upper bounds, below for lower.
    Elimination(const StepMatrix& matrix, const std::vector<int>& sets, double error, double bias)
        : bias_(bias), out_(sets.size()), in_(sets.size()) {
        std::unordered_map<int, int> place;
        for (std::size_t i = 0; i < sets.size(); ++i) place[sets[i]] = static_cast<int>(i);
        for (std::size_t i = 0; i < sets.size(); ++i) {
            const int s = sets[i];
            for (std::size_t e = matrix.first[s]; e < matrix.first[s + 1]; ++e) {
                add(static_cast<int>(i), place.at(matrix.to[e]), matrix.weight[e] * error);
            }
        }
    }

    enum class Result { all_below_one, one_above, gave_up };

    Result run() {
        using Entry = std::pair<std::size_t, int>;  // in times out, and the set
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> order;
        const auto cost = [&](int s) { return in_[s].size() * out_[s].size(); };
        for (int s = 0; s < static_cast<int>(out_.size()); ++s) order.emplace(cost(s), s);
        while (!order.empty()) {
            const auto [expected, s] = order.top();
            order.pop();
            if (gone_.contains(s)) continue;
            if (cost(s) != expected) {
                order.emplace(cost(s), s);
                continue;
            }
            const auto own = out_[s].find(s);
            const double pivot = 1 - (own == out_[s].end() ? 0 : own->second);
            if (!(pivot > 0)) return Result::one_above;
            work_ += static_cast<long>(cost(s));
            if (work_ > work_limit) return Result::gave_up;
            eliminate(s, pivot);
        }
        return Result::all_below_one;
    }

  private:
    void add(int from, int to, double weight) {
        double& entry = out_[from][to];
        entry = (entry + weight) * bias_;
        in_[to][from] = 1;
    }

    void eliminate(int s, double pivot) {
        for (const auto& [from, unused] : in_[s]) {
            if (from == s) continue;
            const double share = out_[from].at(s) / pivot;
            for (const auto& [to, weight] : out_[s]) {
                if (to != s) add(from, to, share * weight);
            }
            out_[from].erase(s);
        }
        for (const auto& [to, weight] : out_[s]) in_[to].erase(s);
        out_[s].clear();
        in_[s].clear();
        gone_.emplace(s, 1);
    }

    double bias_;
    std::vector<std::unordered_map<int, double>> out_;
    std::vector<std::unordered_map<int, char>> in_;
    std::unordered_map<int, char> gone_;
    long work_ = 0;
};

}  // namespace

Growth growth_by_elimination(const StepMatrix& matrix, const std::vector<int>& sets, double error) {
    using Result = Elimination::Result;
    const Result upper = Elimination(matrix, sets, 1 + error, 1 + step_error).run();
    if (upper == Result::all_below_one) return Growth::below_one;
    if (upper == Result::gave_up) return Growth::unclear;
    const Result lower = Elimination(matrix, sets, 1 - error, 1 - step_error).run();
    return lower == Result::one_above ? Growth::above_one : Growth::unclear;
}

}  // namespace pxm::host
