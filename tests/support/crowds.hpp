// Systems whose cells overlap so much that many words lead to (nearly) the same cell.
#pragma once

#include <string>
#include <vector>

#include "dsp_kernels/search_result.hpp"
#include "host/compiled/compiled_scene.hpp"
#include "host/node_program/native_node.hpp"

namespace pxm::test {

/// A filled square by four maps of 0.8, seen from the front; an image of side x side pixels.
[[nodiscard]] std::string fat_square(int side);
/// A filled cube by eight maps of 0.7, seen from a corner.
[[nodiscard]] std::string fat_cube(int side);
/// A filled square by 25 maps of 1/2 whose words coincide exactly, with `detail: 2`.
[[nodiscard]] std::string square_of_coinciding_cells(int side);

/// What the first cell along a pixel's eye ray is.
struct SeenPixel {
    kernels::Outcome outcome;
    double key;
    std::vector<std::uint32_t> word;
    std::uint64_t tested;  // volumes
};

/// All pixels, in double, with a heap that crowds do not fill, by nodes that tell opened cells
/// apart at that share of a pixel; 0: every word is opened.
[[nodiscard]] std::vector<SeenPixel> look_at(const host::CompiledScene& scene, double known_share);

}  // namespace pxm::test
