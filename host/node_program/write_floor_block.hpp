// Planes and textures as words of the scene block (dsp_kernels/floor_block.hpp says where each
// lies).
#pragma once

#include "host/compiled/compiled_scene.hpp"
#include "host/node_program/block_writer.hpp"

namespace pxm::host {

/// Adds the planes of a scene with their textures, and tells the header where they are.
template <class Real>
void write_floor(BlockWriter<Real>& block, const CompiledScene& scene);

}  // namespace pxm::host
