// Where in a glTF's buffer everything lies: known before the first byte is written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/export/export_scene.hpp"
#include "host/export/tally.hpp"

namespace pxm::host {

/// The cells of one object that end with one set's shape. Instances have the shape once and numbers
/// a cell; geometry has every cell's vertices. What is absent has the place `none`.
struct GltfGroup {
    static constexpr std::uint64_t none = ~std::uint64_t{0};

    std::size_t system = 0;
    std::size_t set = 0;
    bool instanced = true;
    std::uint64_t cells = 0;
    std::uint64_t vertices = 0;  // of the positions
    std::uint64_t indices = 0;
    std::uint64_t positions_at = none;  // bytes from the buffer's beginning
    std::uint64_t indices_at = none;
    std::uint64_t translations_at = none;
    std::uint64_t rotations_at = none;
    std::uint64_t scales_at = none;
    std::uint64_t colors_at = none;  // of instances floats, of vertices bytes
};

struct GltfLayout {
    std::vector<GltfGroup> groups;
    std::uint64_t bytes = 0;
};

[[nodiscard]] GltfLayout gltf_layout(const ExportScene& scene, const CellTally& tally);

}  // namespace pxm::host
