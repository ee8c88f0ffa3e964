// One ray's descent as text: the cells it meets, their intervals and sizes, and what ended the
// search.
#include <fmt/format.h>

#include <vector>

#include "host/render/engine.hpp"
#include "host/render/gather.hpp"
#include "host/render/native_node.hpp"

namespace pxm::host {

namespace {

/// A native node that remembers what the search did.
template <class Real_>
class WatchedNode : public NativeNode<Real_> {
  public:
    using Real = Real_;
    static constexpr bool watched = true;
    using NativeNode<Real_>::NativeNode;

    struct Event {
        kernels::CellEvent event;
        kernels::Cell<Real> cell;
    };
    void watch(kernels::CellEvent event, const kernels::Cell<Real>& cell) {
        events_.emplace_back();
        events_.back().event = event;
        kernels::copy_cell(events_.back().cell, cell);
    }
    [[nodiscard]] const std::vector<Event>& events() const { return events_; }

  private:
    std::vector<Event> events_;
};

const char* name_of(kernels::CellEvent event) {
    using enum kernels::CellEvent;
    switch (event) {
        case met:
            return "meets";
        case missed:
            return "misses";
        case expanded:
            return "opens";
        case terminal:
            return "shows";
        case capped:
            return "gives up at";
        case dropped:
            return "drops";
        case restarted:
            return "restarts after";
    }
    return "";
}

template <class Real>
std::string word_text(const CompiledScene& scene, const std::vector<std::uint32_t>& block,
                      const kernels::Cell<Real>& cell) {
    const CompiledObject& object = scene.objects[object_index<Real>(block, cell.object)];
    const CompiledShape& shape = scene.shapes[static_cast<std::size_t>(object.shape)];
    std::string text = object.name + ":";
    for (std::uint32_t i = 0; i < cell.level; ++i) {
        text += " " + shape.map_names[cell.word.get(i, cell.bits)];
    }
    return text;
}

/// Its name, or its number from 1.
std::string plane_name(const CompiledScene& scene, std::uint32_t plane) {
    const std::string& name = scene.planes[plane].name;
    return name.empty() ? fmt::format("{}", plane + 1) : name;
}

template <class Real>
std::string describe(const CompiledScene& scene, long x, long y) {
    const std::vector<std::uint32_t> block = make_scene_block<Real>(scene);
    WatchedNode<Real> node(block, scene.texture_words, scene.heap, sizeof(kernels::Cell<Real>));
    kernels::Heap<WatchedNode<Real>> heap(node);
    auto frame = kernels::read_frame_constants(node);
    kernels::PixelResult<Real> result;
    kernels::render_pixel(node, frame, heap, static_cast<std::uint32_t>(x),
                          static_cast<std::uint32_t>(y), result);
    const auto world = [&](Real length) { return to_double(length) * scene.unit; };
    std::string text = fmt::format(
        "pixel {},{}: ray from ({:.9g} {:.9g} {:.9g}) along ({:.9g} {:.9g} {:.9g}) in scene units "
        "with the eye at the origin; 1 scene unit = {:.9g}\n"
        "{:<14} {:>5} {:>14} {:>14} {:>12} {:>12}  cell\n",
        x, y, to_double(frame.search.ray.origin.x), to_double(frame.search.ray.origin.y),
        to_double(frame.search.ray.origin.z), to_double(frame.search.ray.direction.x),
        to_double(frame.search.ray.direction.y), to_double(frame.search.ray.direction.z),
        scene.unit, "", "level", "key", "exit", "diameter", "p(key)");
    for (const auto& [event, cell] : node.events()) {
        const bool interval = event != kernels::CellEvent::missed;
        const bool sized = event == kernels::CellEvent::expanded ||
                           event == kernels::CellEvent::terminal ||
                           event == kernels::CellEvent::capped;
        const auto number = [](bool known, double value, int digits) {
            return known ? fmt::format("{:.{}g}", value, digits) : std::string("-");
        };
        text += fmt::format(
            "{:<14} {:>5} {:>14} {:>14} {:>12} {:>12}  {}\n", name_of(event), cell.level,
            number(interval, world(cell.key), 9), number(interval, world(cell.exit), 9),
            number(sized, sized ? world(kernels::cell_diameter(node, cell)) : 0, 6),
            number(sized,
                   sized ? world(kernels::pixel_at(node, frame.search, cell.object, cell.key)) : 0,
                   6),
            word_text(scene, block, cell));
    }
    if (result.floor.plane != 0) {
        const std::uint32_t plane = plane_index<Real>(block, result.floor.plane);
        text += fmt::format("plane {} at {:.9g} is in front\n", plane_name(scene, plane),
                            world(result.floor.t));
    }
    const char* end = result.found.outcome == kernels::Outcome::miss  ? "a miss"
                      : result.found.outcome == kernels::Outcome::hit ? "a terminal cell"
                                                                      : "the cap on cells";
    text += fmt::format(
        "ended by {}; {} volumes tested, at most {} cells in the heap; colour {:.6g} {:.6g} "
        "{:.6g}\n",
        end, result.counts.volumes_tested, result.counts.heap_peak, to_double(result.color.x),
        to_double(result.color.y), to_double(result.color.z));
    return text;
}

}  // namespace

std::string describe_pixel(const CompiledScene& scene, Numeric numeric, long x, long y) {
    if (numeric == Numeric::twice) return describe<double>(scene, x, y);
    if (numeric == Numeric::dsp32) return describe<dsp32::Float>(scene, x, y);
    return describe<float>(scene, x, y);
}

}  // namespace pxm::host
