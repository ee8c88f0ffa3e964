// What `pxm render` was told.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/commands/option_checks.hpp"
#include "host/commands/shared_options.hpp"

namespace pxm::host {

/// The options as they were written; empty where they were not.
struct RenderArguments {
    std::string scene;
    std::vector<std::string> allowed;
    std::string out;
    std::string machine;
    std::string program;
    bool native = false;
    std::string cost_model;
    int threads = 0;  // 0: those granted
    std::string stats;
    std::string part, keep, claim;
    double claim_expiry = 60;  // seconds
    std::vector<std::string> set;
    std::string size, crop, numeric, covers, shading, intersect, lipschitz, volume, aov, pixel;
    std::optional<long> levels;
    std::optional<long> samples;
    std::optional<long> heap;
    std::optional<double> detail;
    std::optional<double> zoom;
    std::string half, cryptomatte;
    bool data_window = false;
    std::string frames, format;
    bool no_scene = false;
    bool quiet = false;
    LimitArguments limits;
};

// What their numbers may be.
[[nodiscard]] inline OptionCheck check_of_levels() { return whole_number(0, 1'000'000'000); }
[[nodiscard]] inline OptionCheck check_of_samples() { return whole_number(1, 65536); }
[[nodiscard]] inline OptionCheck check_of_heap() { return whole_number(1, 65536); }

}  // namespace pxm::host
