#include "host/fractal/system/cycle_mean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/fractal/system/components.hpp"
#include "host/math/bracket_matrix.hpp"
#include "host/math/lipschitz.hpp"

namespace pxm::host {

namespace {

constexpr double lowest_lip = 1e-300;  // stands for the zero map, whose logarithm does not exist
constexpr double improvement = 1e-13;  // in log Lip: smaller gains are rounding
constexpr long work_limit = 2'000'000'000;  // edges looked at; the certificate holds at any time
constexpr double least_potential = -690;    // a weight below would have no inverse
constexpr double none = -std::numeric_limits<double>::infinity();

/// The worst map that leads from one follow set to another of the same component.
struct Edge {
    int to;
    int map;
    double log_lip;
};

/// Per follow set, one edge for each follow set of its component that its maps lead to.
std::vector<std::vector<Edge>> inner_edges(const Rifs& rifs, const std::vector<int>& component) {
    std::vector<double> log_lip;
    for (const Affine& map : rifs.maps) {
        log_lip.push_back(std::log(std::max(lipschitz_constant(map), lowest_lip)));
    }
    std::vector<std::vector<Edge>> edges(rifs.follow_sets.size());
    std::vector<int> place(rifs.follow_sets.size(),
                           -1);  // of the edge to a set, in the current list
    for (std::size_t s = 0; s < edges.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            const int to = rifs.follow_of[m];
            if (component[to] != component[s]) continue;
            if (place[to] < 0) {
                place[to] = static_cast<int>(edges[s].size());
                edges[s].push_back({to, m, log_lip[m]});
            } else if (log_lip[m] > edges[s][place[to]].log_lip) {
                edges[s][place[to]] = {to, m, log_lip[m]};
            }
        }
        for (const Edge& edge : edges[s]) place[edge.to] = -1;
    }
    return edges;
}

/// Howard's algorithm in one component. A policy is one edge for each set; it runs into cycles.
class Howard {
  public:
    Howard(const std::vector<std::vector<Edge>>& edges, std::vector<double>& potential)
        : edges_(edges),
          potential_(potential),
          policy_(edges.size()),
          state_(edges.size(), State::unseen) {}

    /// Leaves the worst cycle of the component and potentials that prove it the worst.
    void solve(const std::vector<int>& members) {
        start(members);
        long work = 0;
        do {
            evaluate(members);
            for (const int s : members) work += static_cast<long>(edges_[s].size());
        } while (improve(members) && work < work_limit);
    }

    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] const std::vector<int>& cycle() const { return cycle_; }

  private:
    enum class State : char { unseen, on_path, leads_to_best, leads_elsewhere };

    void start(const std::vector<int>& members) {
        for (const int s : members) {
            policy_[s] = *std::max_element(
                edges_[s].begin(), edges_[s].end(),
                [](const Edge& a, const Edge& b) { return a.log_lip < b.log_lip; });
            potential_[s] = 0;
        }
    }

    /// Finds the policy's worst cycle, and the potentials of all sets whose policy leads to it.
    void evaluate(const std::vector<int>& members) {
        int best = find_worst_cycle(members);
        for (const int s : members) state_[s] = State::unseen;
        for (int s = best; state_[s] == State::unseen;) {
            state_[s] = State::leads_to_best;
            s = policy_[s].to;
        }
        // Round the cycle backwards from `best`, whose potential stays.
        std::vector<int> round;
        for (int s = policy_[best].to; s != best; s = policy_[s].to) round.push_back(s);
        for (auto s = round.rbegin(); s != round.rend(); ++s) set_potential(*s);
        for (const int s : members) follow_policy(s);
    }

    int find_worst_cycle(const std::vector<int>& members) {
        for (const int s : members) state_[s] = State::unseen;
        int best = members.front();
        mean_ = none;
        std::vector<int> path;
        for (const int root : members) {
            path.clear();
            int s = root;
            for (; state_[s] == State::unseen; s = policy_[s].to) {
                state_[s] = State::on_path;
                path.push_back(s);
            }
            if (state_[s] == State::on_path && cycle_is_worse(s)) best = s;
            for (const int seen : path) state_[seen] = State::leads_elsewhere;
        }
        return best;
    }

    bool cycle_is_worse(int first) {
        double sum = 0;
        std::vector<int> maps;
        int s = first;
        do {
            sum += policy_[s].log_lip;
            maps.push_back(policy_[s].map);
            s = policy_[s].to;
        } while (s != first);
        const double mean = sum / static_cast<double>(maps.size());
        if (mean <= mean_) return false;
        mean_ = mean;
        cycle_ = std::move(maps);
        return true;
    }

    void follow_policy(int root) {
        std::vector<int> path;
        int s = root;
        for (; state_[s] == State::unseen; s = policy_[s].to) {
            state_[s] = State::on_path;
            path.push_back(s);
        }
        const bool to_best = state_[s] == State::leads_to_best;
        for (auto on_path = path.rbegin(); on_path != path.rend(); ++on_path) {
            state_[*on_path] = to_best ? State::leads_to_best : State::leads_elsewhere;
            if (to_best) set_potential(*on_path);
        }
    }

    void set_potential(int s) {
        potential_[s] = policy_[s].log_lip - mean_ + potential_[policy_[s].to];
    }

    bool improve(const std::vector<int>& members) {
        bool better = false;
        for (const int s : members) {
            for (const Edge& edge : edges_[s]) {
                const double value = edge.log_lip - mean_ + potential_[edge.to];
                if (value <= potential_[s]) continue;
                // Round a long cycle the potential of the same edge can creep: that is rounding.
                const bool other = edge.map != policy_[s].map;
                better = better ||
                         (other && value > potential_[s] + improvement * (1 + std::abs(value)));
                potential_[s] = value;
                policy_[s] = edge;
            }
        }
        return better;
    }

    const std::vector<std::vector<Edge>>& edges_;
    std::vector<double>& potential_;
    std::vector<Edge> policy_;
    std::vector<State> state_;
    std::vector<int> cycle_;
    double mean_ = none;
};

void normalise(const std::vector<int>& members, std::vector<double>& potential) {
    double largest = none;
    for (const int s : members) largest = std::max(largest, potential[s]);
    for (const int s : members) potential[s] -= largest;
}

double certified_bound(const std::vector<std::vector<Edge>>& edges,
                       const std::vector<double>& potential) {
    double bound = std::log(lowest_lip);
    for (std::size_t s = 0; s < edges.size(); ++s) {
        for (const Edge& edge : edges[s]) {
            bound = std::max(bound, edge.log_lip + potential[edge.to] - potential[s]);
        }
    }
    return bound;
}

}  // namespace

CycleMean largest_cycle_mean(const Rifs& rifs) {
    const std::vector<int> component = set_components(rifs);
    const std::vector<std::vector<Edge>> edges = inner_edges(rifs, component);
    std::vector<std::vector<int>> members(rifs.maps.size() + rifs.follow_sets.size());
    for (std::size_t s = 0; s < edges.size(); ++s) {
        if (!edges[s].empty()) members[component[s]].push_back(static_cast<int>(s));
    }
    CycleMean result;
    result.mean = none;
    result.potential.resize(edges.size(), 0.0);
    Howard howard(edges, result.potential);
    for (const std::vector<int>& sets : members) {
        if (sets.empty()) continue;
        howard.solve(sets);
        normalise(sets, result.potential);
        if (howard.mean() <= result.mean) continue;
        result.mean = howard.mean();
        result.cycle = howard.cycle();
    }
    result.bound = certified_bound(edges, result.potential);
    return result;
}

std::vector<double> weights_of(const CycleMean& mean) {
    std::vector<double> weight;
    for (const double potential : mean.potential) {
        weight.push_back(std::exp(std::max(potential, least_potential)));
    }
    return weight;
}

double proven_rate(const Rifs& rifs, const std::vector<double>& weight) {
    const std::vector<int> component = set_components(rifs);
    std::vector<double> lip;
    for (const Affine& map : rifs.maps) lip.push_back(norm_at_most(map.linear));
    double rate = lowest_lip;
    for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s) {
        for (const int m : rifs.follow_sets[s].maps) {
            const int to = rifs.follow_of[m];
            if (component[to] != component[s]) continue;
            rate = std::max(rate, (Bracket{lip[m]} * weight[to] / weight[s]).high);
        }
    }
    return rate;
}

}  // namespace pxm::host
