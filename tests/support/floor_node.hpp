// A native node with a scene that has a floor, to ask the kernels of planes and textures directly.
#pragma once

#include <string>

#include "dsp_kernels/cell.hpp"
#include "dsp_kernels/plane.hpp"
#include "host/node_program/native_node.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/output/image.hpp"
#include "tests/support/compile_text.hpp"

namespace pxm::test {

/// A scene and its block, made before the node that reads them.
template <class Real>
struct FloorScene {
    explicit FloorScene(host::CompiledScene compiled)
        : scene(std::move(compiled)), block(host::make_scene_block<Real>(scene)) {}
    host::CompiledScene scene;
    std::vector<std::uint32_t> block;
};

template <class Real_>
class FloorNode : private FloorScene<Real_>, public host::NativeNode<Real_> {
  public:
    using Real = Real_;

    explicit FloorNode(const host::CompiledScene& compiled)
        : FloorScene<Real>(compiled),
          host::NativeNode<Real>(this->block, this->scene.texture_words, 1,
                                 sizeof(kernels::Cell<Real>)) {}
    FloorNode(const FloorNode&) = delete;
    FloorNode& operator=(const FloorNode&) = delete;

    [[nodiscard]] kernels::Vec3<Real> vector(const glm::dvec3& v) const {
        return {from_double<Real>(v.x), from_double<Real>(v.y), from_double<Real>(v.z)};
    }
    [[nodiscard]] std::uint32_t plane(std::uint32_t number) const {
        using Header = kernels::HeaderRecord<real_words<Real>>;
        return this->shape_word(Header::planes) +
               number * kernels::PlaneRecord<real_words<Real>>::words;
    }
    /// The first texture of the first plane.
    [[nodiscard]] std::uint32_t layer() const {
        return this->shape_word(plane(0) + kernels::PlaneRecord<real_words<Real>>::layers);
    }
    /// Its colour within a spot, in repeats.
    [[nodiscard]] glm::dvec3 color(const glm::dvec2& at, const glm::dvec2& minor,
                                   const glm::dvec2& major) {
        const auto pair = [](const glm::dvec2& v) {
            return kernels::Vec2<Real>{from_double<Real>(v.x), from_double<Real>(v.y)};
        };
        const auto color =
            kernels::texture_color(*this, layer(), {pair(at), pair(minor), pair(major)});
        return {to_double(color.x), to_double(color.y), to_double(color.z)};
    }
    /// Within a circle.
    [[nodiscard]] glm::dvec3 color(const glm::dvec2& at, double diameter) {
        return color(at, {diameter, 0}, {0, diameter});
    }
};

/// Writes a picture of linear colours, by rows from the top.
template <class ColorOf>
void write_picture(const std::string& path, long columns, long rows, const ColorOf& color_of) {
    host::Frame frame({columns, rows}, {0, 0, columns, rows});
    for (long y = 0; y < rows; ++y) {
        for (long x = 0; x < columns; ++x) {
            const glm::dvec3 color = color_of(x, y);
            for (int c = 0; c < 3; ++c) frame.at(x, y).color[c] = static_cast<float>(color[c]);
        }
    }
    host::write_image(path, frame, {}, {});
}

}  // namespace pxm::test
