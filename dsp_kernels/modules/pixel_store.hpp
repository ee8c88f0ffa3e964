// What the node program does with a finished pixel, as the machine engine does it for the nodes
// (host/engine/machine_engine.cpp): four bytes into the front frame buffer.
#pragma once

#include "dsp_kernels/modules/measured_node.hpp"
#include "dsp_kernels/pixel_program.hpp"

namespace pxm::kernels {

/// Stores the node's own pixels, one after the other.
struct PixelStore {
    Node& node;            // that does the work
    std::uint32_t& pixel;  // counts the node's own pixels

    /// 0 to 255 of a value that is clamped to 0 to 1.
    [[nodiscard]] static std::uint32_t byte(float v) noexcept {
        const float clamped = v < 0 ? 0 : 1 < v ? 1 : v;
        return static_cast<std::uint32_t>(clamped * 255.0F + 0.5F);
    }
    /// Stores the next pixel; always true.
    bool operator()(std::uint32_t, std::uint32_t, const PixelResult<float>& result) const noexcept {
        const Vec3<float>& color = result.color;
        const std::uint32_t alpha =
            result.found.outcome == Outcome::miss && result.floor.plane == 0 ? 0 : 255;
        node.write_pixel(pixel++,
                         byte(color.x) << 24 | byte(color.y) << 16 | byte(color.z) << 8 | alpha);
        return true;
    }
};

}  // namespace pxm::kernels
