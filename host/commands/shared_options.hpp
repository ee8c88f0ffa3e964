// Options that several commands have.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/commands/options.hpp"
#include "host/process/limits.hpp"

namespace pxm::host {

/// `--threads N`; it stays 0 if it is not given (granted_threads.hpp).
void add_threads_option(CommandOptions& command, int& threads);

/// `--set KEY=VALUE`, as often as one likes (scene/settings.hpp).
void add_set_option(CommandOptions& command, std::vector<std::string>& texts);

/// `--allow DIR`, as often as one likes: further folders where files that a scene names may lie
/// (files/allowed_folders.hpp).
void add_allow_option(CommandOptions& command, std::vector<std::string>& folders);

/// What the limits' options are read into.
struct LimitArguments {
    std::optional<double> seconds;
    std::optional<long> memory_bytes;

    [[nodiscard]] Limits limits() const {
        Limits limits{seconds, {}};
        if (memory_bytes) limits.memory_bytes = static_cast<std::uint64_t>(*memory_bytes);
        return limits;
    }
};

/// `--limit-seconds S` and `--limit-memory BYTES` (host/process/limits.hpp).
void add_limit_options(CommandOptions& command, LimitArguments& limits);

/// Puts the path of the file in place of a scene's name, and allows what lies in the folder of the
/// scene path where it was found (scene/scene_path.hpp). What is not found stays as it is written.
void find_scene_by_name(std::string& scene, std::vector<std::string>& folders);

}  // namespace pxm::host
