// One scene of the oracle's campaign: rendered by every engine and method that takes it, each
// picture judged. Where an independent engine shows the same, a random share of the pixels is
// judged by the definition itself; where any two differ, all are.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"
#include "host/scene/scene.hpp"

namespace pxm::test {

struct TrialSettings {
    std::vector<std::string> only;    // methods; empty: all
    std::uint64_t seed = 0;           // of the pixels that are judged
    long by_definition = 24;          // pixels of a scene that are judged whatever they show
    long disputed = 120;              // and at most so many of those in which engines differ
    std::uint32_t cell_cap = 20'000;  // cells of a ray of an engine
    long patience = 60'000;           // and of the oracle
    double machine_budget = 3e4;      // volumes that a picture of the machine may test
    const std::atomic<bool>* stop = nullptr;
    /// Faults that are planted: one changes a method's picture before it is judged, one the scene
    /// that the engines get and the oracle does not.
    std::function<void(const std::string& method, host::Frame& frame)> spoil;
    std::function<void(host::CompiledScene& scene)> spoil_scene;
};

/// What is wrong with one pixel, or with the scene (x < 0).
struct Find {
    std::string method;
    long x = -1, y = -1;
    std::string what;
};

/// What was judged. All but scenes are pixels of single pictures.
struct Score {
    std::map<std::string, long> counts;
    void add(const std::string& name, long n = 1) { counts[name] += n; }
    void add(const Score& other) {
        for (const auto& [name, n] : other.counts) counts[name] += n;
    }
    [[nodiscard]] long of(const std::string& name) const {
        const auto found = counts.find(name);
        return found == counts.end() ? 0 : found->second;
    }
};

struct Trial {
    Score score;
    std::vector<Find> finds;  // the first of each method
    std::string refused;      // why the scene was not rendered; empty if it was
};

/// The methods by name: print, double, float, dsp32, wide, heap, machine.
[[nodiscard]] const std::vector<std::string>& all_methods();

[[nodiscard]] Trial try_scene(const host::Scene& scene, const TrialSettings& settings);

}  // namespace pxm::test
