// What a run reads it must not write over, by whatever name: links and hard links are seen through.
#pragma once

#include <string>
#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {

struct InputFile {
    std::string path;
    std::string what;  // as messages call it: "the scene"
};

/// The files that a scene was read from and the pictures that it names.
[[nodiscard]] std::vector<InputFile> inputs_of(const Scene& scene);

/// Whether both paths name one file: the same place, or one file that is there by two names.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// Throws Error(ErrorKind::setting) if an output is one of the inputs.
void require_spared(const std::vector<std::string>& outputs, const std::vector<InputFile>& inputs);

}  // namespace pxm::host
