#include "host/fractal/system/components.hpp"

#include <algorithm>

namespace pxm::host {

Graph descent_graph(const Rifs& rifs) {
    const int maps = static_cast<int>(rifs.maps.size());
    Graph graph;
    graph.first.push_back(0);
    for (int m = 0; m < maps; ++m) {
        graph.targets.push_back(maps + rifs.follow_of[m]);
        graph.first.push_back(static_cast<int>(graph.targets.size()));
    }
    for (const FollowSet& set : rifs.follow_sets) {
        graph.targets.insert(graph.targets.end(), set.maps.begin(), set.maps.end());
        graph.first.push_back(static_cast<int>(graph.targets.size()));
    }
    return graph;
}

namespace {

/// Tarjan's algorithm with a stack of its own: a chain of 65,536 maps must not recurse.
class Tarjan {
  public:
    explicit Tarjan(const Graph& graph)
        : graph_(graph),
          order_(graph.size(), unseen),
          low_(graph.size()),
          component_(graph.size(), unseen),
          next_edge_(graph.first.begin(), graph.first.end() - 1) {}

    std::vector<int> components() {
        for (int v = 0; v < graph_.size(); ++v) {
            if (order_[v] == unseen) visit(v);
        }
        // Components were closed sinks first.
        for (int& component : component_) component = closed_ - 1 - component;
        return component_;
    }

  private:
    static constexpr int unseen = -1;

    void visit(int root) {
        enter(root);
        while (!path_.empty()) {
            const int v = path_.back();
            if (next_edge_[v] == graph_.first[v + 1]) {
                leave(v);
                continue;
            }
            const int w = graph_.targets[next_edge_[v]++];
            if (order_[w] == unseen) {
                enter(w);
            } else if (component_[w] == unseen) {
                low_[v] = std::min(low_[v], order_[w]);
            }
        }
    }

    void enter(int v) {
        order_[v] = low_[v] = seen_++;
        path_.push_back(v);
        open_.push_back(v);
    }

    void leave(int v) {
        path_.pop_back();
        if (!path_.empty()) low_[path_.back()] = std::min(low_[path_.back()], low_[v]);
        if (low_[v] != order_[v]) return;
        int w = unseen;
        do {
            w = open_.back();
            open_.pop_back();
            component_[w] = closed_;
        } while (w != v);
        ++closed_;
    }

    const Graph& graph_;
    std::vector<int> order_;
    std::vector<int> low_;
    std::vector<int> component_;
    std::vector<int> next_edge_;
    std::vector<int> path_;  // from the root to the vertex being visited
    std::vector<int> open_;  // seen, but in no component yet
    int seen_ = 0;
    int closed_ = 0;
};

}  // namespace

std::vector<int> component_numbers(const Graph& graph) { return Tarjan(graph).components(); }

std::vector<int> set_components(const Rifs& rifs) {
    const std::vector<int> all = component_numbers(descent_graph(rifs));
    return {all.begin() + static_cast<std::ptrdiff_t>(rifs.maps.size()), all.end()};
}

}  // namespace pxm::host
