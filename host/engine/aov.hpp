// Channels that --aov can add to an EXR, and what they are called in the file.
#pragma once

#include <string>
#include <vector>

namespace pxm::host {

/// What can be written of a pixel beside its colour.
enum class Aov { z, node, cycles, volumes, level, heap, alpha, object, word, normal, neighbours };

/// The name on the command line.
[[nodiscard]] const char* aov_name(Aov aov);
/// All of them, in the order of the documentation.
[[nodiscard]] const std::vector<Aov>& all_aovs();

/// A channel of the file. Blender drops a channel whose name is a bare word, and knows a vector by
/// its capitals; other programs take any name (docs/pictures.md).
struct AovChannel {
    std::string name;      // in files of today
    std::string old_name;  // in files of pxm 0.1.0; the same where it did not change
};

/// One, or three of a vector.
[[nodiscard]] std::vector<AovChannel> channels_of(Aov aov);

}  // namespace pxm::host
