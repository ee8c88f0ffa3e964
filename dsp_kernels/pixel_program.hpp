// The program of a pixel node: for each of its pixels a ray, or several, what is seen along it, and
// the colour.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/camera.hpp"
#include "dsp_kernels/trace.hpp"

namespace pxm::kernels {

/// Reads them from the scene block's header.
template <NodeLike Node, class Real = typename Node::Real>
[[nodiscard]] FrameConstants<Real> read_frame_constants(Node& node) noexcept {
    using Header = HeaderRecord<real_words<Real>>;
    FrameConstants<Real> frame{};
    frame.search.pixel = {node.shape_real(Header::pixel_at_eye),
                          node.shape_real(Header::pixel_growth)};
    frame.search.detail = node.shape_real(Header::detail);
    frame.search.fade = node.shape_real(Header::fade);
    frame.search.cell_cap = node.shape_word(Header::cell_cap);
    frame.search.method = static_cast<Method>(node.shape_word(Header::method));
    frame.shading = static_cast<ShadingMode>(node.shape_word(Header::shading));
    frame.background = read_vector(node, Header::background);
    frame.planes = node.shape_word(Header::plane_count);
    frame.bounces = node.shape_word(Header::bounces);
    frame.samples = node.shape_word(Header::sample_count);
    frame.sample_share = node.shape_real(Header::sample_share);
    return frame;
}

/// Renders one pixel: its colour is the mean over its samples, and what else is known of it is of
/// the first one, which is nearest to the centre.
template <Features features, NodeLike Node, class Real = typename Node::Real>
void render_pixel(Node& node, FrameConstants<Real>& frame, Heap<Node>& heap, std::uint32_t x,
                  std::uint32_t y, PixelResult<Real>& result) noexcept {
    result.color = {};
    result.opacity = Real(0);
    result.found.outcome = Outcome::miss;
    result.floor = {};
    result.normal = {};
    result.counts = {};
    result.rays = {};
    Tracer<features, Node> tracer(node, frame, heap, result);
    for (std::uint32_t sample = 0; sample < frame.samples; ++sample) {
        node.tally(Operation::loop_turn, 1);
        frame.search.ray = eye_ray(node, x, y, sample);
        tracer.trace(frame.search, frame.sample_share, sample == 0 ? Sample::first : Sample::other);
    }
}

/// The pixels a program renders: every step_x-th and step_y-th of a window, half open.
struct PixelShare {
    std::uint32_t x0;      // the first column
    std::uint32_t y0;      // the first row
    std::uint32_t x1;      // beyond the last column
    std::uint32_t y1;      // beyond the last row
    std::uint32_t step_x;  // columns
    std::uint32_t step_y;  // rows
};

/// The node's program. `store(x, y, result)` takes a finished pixel and says whether to go on.
template <Features features, NodeLike Node, class Store>
void pixel_program(Node& node, const PixelShare& share, const Store& store) noexcept {
    using Real = typename Node::Real;
    Heap<Node> heap(node);
    FrameConstants<Real> frame = read_frame_constants(node);
    PixelResult<Real> result;
    for (std::uint32_t y = share.y0; y < share.y1; y += share.step_y) {
        for (std::uint32_t x = share.x0; x < share.x1; x += share.step_x) {
            node.tally(Operation::loop_turn, 1);
            render_pixel<features>(node, frame, heap, x, y, result);
            if (!store(x, y, result)) return;
        }
    }
}

}  // namespace pxm::kernels
