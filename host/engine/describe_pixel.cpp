// One ray's descent as text: the cells it meets, their intervals and sizes, and what ended the
// search.
#include <fmt/format.h>

#include <vector>

#include "host/engine/engine.hpp"
#include "host/engine/gather.hpp"
#include "host/node_program/crowded.hpp"
#include "host/node_program/instances.hpp"

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
        std::size_t ray;
    };
    struct WatchedRay {
        kernels::RayKind kind;
        kernels::Search<Real> search;
    };
    void watch(kernels::CellEvent event, const kernels::Cell<Real>& cell) {
        if (events_.size() == most_events) {
            ++left_out_;
            return;
        }
        events_.emplace_back();
        events_.back().event = event;
        kernels::copy_cell(events_.back().cell, cell);
        events_.back().ray = rays_.size() - 1;
    }
    void watch_ray(kernels::RayKind kind, const kernels::Search<Real>& search) {
        if (events_.size() < most_events) rays_.push_back({kind, search});
    }
    /// Events after the first most_events, which are not kept.
    [[nodiscard]] std::uint64_t left_out() const { return left_out_; }
    [[nodiscard]] const std::vector<Event>& events() const { return events_; }
    [[nodiscard]] const std::vector<WatchedRay>& rays() const { return rays_; }

  private:
    static constexpr std::size_t most_events = 100'000;

    std::uint64_t left_out_ = 0;
    std::vector<WatchedRay> rays_;
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
        case known:
            return "knows";
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
    for (const int symbol : object.prefix) {
        text += " " + shape.map_names[static_cast<std::size_t>(symbol)];
    }
    for (std::uint32_t i = 0; i < cell.level; ++i) {
        text += " " + shape.map_names[cell.word.get(i, cell.bits)];
    }
    return text;
}

/// A cell, and what happened to it, in a line.
template <class Real>
std::string event_text(const CompiledScene& scene, const std::vector<std::uint32_t>& block,
                       WatchedNode<Real>& node, const kernels::Search<Real>& search,
                       const typename WatchedNode<Real>::Event& event) {
    using enum kernels::CellEvent;
    const kernels::Cell<Real>& cell = event.cell;
    const std::size_t prefix = scene.objects[object_index<Real>(block, cell.object)].prefix.size();
    const auto world = [&](Real length) { return to_double(length) * scene.unit; };
    const bool interval = event.event != missed;
    const bool sized = event.event == expanded || event.event == known || event.event == terminal ||
                       event.event == capped;
    const auto number = [](bool known, double value, int digits) {
        return known ? fmt::format("{:.{}g}", value, digits) : std::string("-");
    };
    const double diameter = sized ? world(kernels::cell_diameter(node, cell)) : 0;
    const double p = sized ? world(kernels::pixel_at(node, search, cell.object, cell.key)) : 0;
    return fmt::format("{:<14} {:>5} {:>14} {:>14} {:>12} {:>12}  {}\n", name_of(event.event),
                       prefix + cell.level, number(interval, world(cell.key), 9),
                       number(interval, world(cell.exit), 9), number(sized, diameter, 6),
                       number(sized, p, 6), word_text(scene, block, cell));
}

const char* name_of(kernels::RayKind kind) {
    switch (kind) {
        case kernels::RayKind::eye:
            return "ray";
        case kernels::RayKind::mirror:
            return "mirror ray";
        case kernels::RayKind::light:
            return "light ray";
    }
    return "";
}

template <class Real>
std::string ray_text(kernels::RayKind kind, const kernels::Ray<Real>& ray) {
    return fmt::format("{} from ({:.9g} {:.9g} {:.9g}) along ({:.9g} {:.9g} {:.9g})", name_of(kind),
                       to_double(ray.origin.x), to_double(ray.origin.y), to_double(ray.origin.z),
                       to_double(ray.direction.x), to_double(ray.direction.y),
                       to_double(ray.direction.z));
}

/// "plane floor at 3.25"; without a name its number from 1.
template <class Real>
std::string plane_text(const CompiledScene& scene, const std::vector<std::uint32_t>& block,
                       const kernels::PlaneHit<Real>& hit) {
    const std::uint32_t plane = plane_index<Real>(block, hit.plane);
    const std::string& name = scene.planes[plane].name;
    return fmt::format("plane {} at {:.9g}", name.empty() ? fmt::format("{}", plane + 1) : name,
                       to_double(hit.t) * scene.unit);
}

template <class Real>
std::string end_text(const CompiledScene& scene, const std::vector<std::uint32_t>& block,
                     const kernels::PixelResult<Real>& result) {
    const std::string end = result.floor.plane != 0 ? plane_text(scene, block, result.floor)
                            : result.found.outcome == kernels::Outcome::miss ? "a miss"
                            : result.counts.capped > 0                       ? "the cap on cells"
                                                                             : "a terminal cell";
    return fmt::format(
        "ended by {}; {} volumes tested, at most {} cells in the heap; colour {:.6g} {:.6g} "
        "{:.6g}\n",
        end, result.counts.volumes_tested, result.counts.heap_peak, to_double(result.color.x),
        to_double(result.color.y), to_double(result.color.z));
}

template <class Real, kernels::Features features>
std::string describe(const CompiledScene& scene, long x, long y) {
    const std::vector<std::uint32_t> block = make_scene_block<Real>(scene);
    auto node = make_native_node<WatchedNode<Real>>(scene, block);
    kernels::Heap<WatchedNode<Real>> heap(node);
    auto frame = kernels::read_frame_constants(node);
    kernels::PixelResult<Real> result;
    kernels::render_pixel<features>(node, frame, heap, static_cast<std::uint32_t>(x),
                                    static_cast<std::uint32_t>(y), result);
    std::string text;
    auto event = node.events().begin();
    for (std::size_t i = 0; i < node.rays().size(); ++i) {
        const auto& [kind, search] = node.rays()[i];
        if (i == 0) {
            text += fmt::format(
                "pixel {},{}: {} in scene units with the eye at the origin; 1 scene unit = {:.9g}\n"
                "{:<14} {:>5} {:>14} {:>14} {:>12} {:>12}  cell\n",
                x, y, ray_text(kind, search.ray), scene.unit, "", "level", "key", "exit",
                "diameter", "p(key)");
        } else {
            text += ray_text(kind, search.ray) + "\n";
        }
        for (; event != node.events().end() && event->ray == i; ++event) {
            text += event_text(scene, block, node, search, *event);
        }
    }
    if (node.left_out() > 0) text += fmt::format("... and {} more\n", node.left_out());
    return text + end_text(scene, block, result);
}

}  // namespace

std::string describe_pixel(const CompiledScene& scene, Numeric numeric, long x, long y) {
    return with_instance(scene, numeric, [&]<class Real, kernels::Features features>() {
        return describe<Real, features>(scene, x, y);
    });
}

}  // namespace pxm::host
