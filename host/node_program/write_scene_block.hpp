// The compiled scene as words in a node's format: what is broadcast into the back frame buffers.
// Every number is rounded once, here (dsp_kernels/scene_block.hpp says where each lies).
#pragma once

#include <cstdint>
#include <vector>

#include "host/compiled/compiled_scene.hpp"

namespace pxm::host {

/// The block for nodes that compute with Real.
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> make_scene_block(const CompiledScene& scene);

/// Addresses of the object records in that block, in scene order: hits name objects by address.
template <class Real>
[[nodiscard]] std::uint32_t object_index(const std::vector<std::uint32_t>& block,
                                         std::uint32_t address);

/// The same for the plane records.
template <class Real>
[[nodiscard]] std::uint32_t plane_index(const std::vector<std::uint32_t>& block,
                                        std::uint32_t address);

/// p never falls below this share of an object's diameter (design decision 4).
template <class Real>
[[nodiscard]] double smallest_pixel_share();

/// A hash of the words (FNV-1a, 64 bits), to compare what two hosts broadcast.
[[nodiscard]] std::uint64_t block_hash(const std::vector<std::uint32_t>& block);

}  // namespace pxm::host
