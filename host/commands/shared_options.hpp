// Options that several commands have.
#pragma once

#include <string>
#include <vector>

#include "host/commands/options.hpp"

namespace pxm::host {

/// `--threads N`; it stays 0 if it is not given (granted_threads.hpp).
void add_threads_option(CommandOptions& command, int& threads);

/// `--set KEY=VALUE`, as often as one likes (scene/settings.hpp).
void add_set_option(CommandOptions& command, std::vector<std::string>& texts);

/// `--allow DIR`, as often as one likes: further folders where files that a scene names may lie
/// (files/allowed_folders.hpp).
void add_allow_option(CommandOptions& command, std::vector<std::string>& folders);

/// Puts the path of the file in place of a scene's name, and allows what lies in the folder of the
/// scene path where it was found (scene/scene_path.hpp). What is not found stays as it is written.
void find_scene_by_name(std::string& scene, std::vector<std::string>& folders);

}  // namespace pxm::host
