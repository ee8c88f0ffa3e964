// The program of a pixel node: for each of its pixels a ray, the first cell along it, its colour.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/camera.hpp"
#include "dsp_kernels/first_cell.hpp"
#include "dsp_kernels/shade.hpp"

namespace pxm::kernels {

/// What a node knows of a pixel once it is done.
template <class Real>
struct PixelResult {
    Vec3<Real> color{};
    SearchResult<Real> found;
    Vec3<Real> normal{};  // the total normal, unless the ray missed
    SearchCounts counts;
};

/// The part of the scene block that is the same for every pixel, read once.
template <class Real>
struct FrameConstants {
    Search<Real> search;
    ShadingMode shading;
    Vec3<Real> background;
};

template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] FrameConstants<Real> read_frame_constants(Node& node) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    FrameConstants<Real> frame{};
    frame.search.pixel = {node.shape_real(Header::pixel_at_eye),
                          node.shape_real(Header::pixel_growth)};
    frame.search.detail = node.shape_real(Header::detail);
    frame.search.cell_cap = node.shape_word(Header::cell_cap);
    frame.search.method = static_cast<Method>(node.shape_word(Header::method));
    frame.shading = static_cast<ShadingMode>(node.shape_word(Header::shading));
    frame.background = read_vector(node, Header::background);
    return frame;
}

/// Renders one pixel.
template <NodeLike Node, class Real = typename Node::Real>
void render_pixel(Node& node, FrameConstants<Real>& frame, Heap<Node>& heap, std::uint32_t x,
                  std::uint32_t y, PixelResult<Real>& result) noexcept {
    frame.search.ray = eye_ray(node, x, y);
    result.counts = {};
    result.found = first_cell(node, frame.search, heap, result.counts);
    result.normal = {};
    result.color = frame.background;
    if (result.found.outcome == Outcome::miss) return;
    const Surface<Real> surface = surface_at(node, frame.search, result.found.cell, frame.shading);
    const Ray<Real>& ray = frame.search.ray;
    const Vec3<Real> point = add_scaled(node, ray.origin, result.found.cell.key, ray.direction);
    result.normal = surface.normal;
    result.color = illuminate(node, surface, point);
}

/// The pixels a program renders: every step_x-th and step_y-th of a window, half open.
struct PixelShare {
    std::uint32_t x0;
    std::uint32_t y0;
    std::uint32_t x1;
    std::uint32_t y1;
    std::uint32_t step_x;
    std::uint32_t step_y;
};

/// The node's program. `store(x, y, result)` takes a finished pixel and says whether to go on.
template <NodeLike Node, class Store>
void pixel_program(Node& node, const PixelShare& share, const Store& store) noexcept {
    using Real = typename Node::Real;
    Heap<Node> heap(node);
    FrameConstants<Real> frame = read_frame_constants(node);
    PixelResult<Real> result;
    for (std::uint32_t y = share.y0; y < share.y1; y += share.step_y) {
        for (std::uint32_t x = share.x0; x < share.x1; x += share.step_x) {
            node.tally(Operation::loop_turn, 1);
            render_pixel(node, frame, heap, x, y, result);
            if (!store(x, y, result)) return;
        }
    }
}

}  // namespace pxm::kernels
