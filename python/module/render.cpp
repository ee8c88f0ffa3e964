#include "python/module/render.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "host/engine/aov.hpp"
#include "host/error.hpp"
#include "host/output/cost_model_json.hpp"
#include "host/output/image.hpp"
#include "host/output/pixel_values.hpp"
#include "host/output/statistics_json.hpp"
#include "host/process/granted_threads.hpp"
#include "host/render/render.hpp"
#include "host/render/render_options.hpp"
#include "pxm/model.hpp"
#include "python/module/scene.hpp"
#include "python/module/work.hpp"

namespace pxm::python {

namespace py = pybind11;
using namespace host;

namespace {

/// What Python says over the scene, in the words of the command line; empty where it says nothing.
struct Options {
    std::string size, crop, shading, covers, intersect, numeric, lipschitz, volume, machine,
        cost_model;
    std::optional<long> levels, samples, heap;
    std::optional<double> detail;
    double zoom = 1;
    double frame = 0;
    int threads = 0;
};

/// The same limits as those of the command line.
template <class Number>
void require_within(const char* name, const std::optional<Number>& number, Number low,
                    Number high) {
    if (!number || (*number >= low && *number <= high)) return;
    throw Error(ErrorKind::setting,
                fmt::format("{}: found {}, expected {} to {}", name, *number, low, high));
}

void require_positive(const char* name, double number) {
    if (std::isfinite(number) && number > 0) return;
    throw Error(ErrorKind::setting,
                fmt::format("{}: found {}, expected a number greater than 0", name, number));
}

void require_sound(const Options& options) {
    require_within<long>("levels", options.levels, 0, 1'000'000'000);
    require_within<long>("samples", options.samples, 1, 65536);
    require_within<long>("heap", options.heap, 1, 65536);
    require_within<int>("threads", std::optional(options.threads), 0, most_threads);
    require_positive("zoom", options.zoom);
    if (options.detail) require_positive("detail", *options.detail);
    if (!options.cost_model.empty() && options.machine.empty())
        throw Error(ErrorKind::setting, "cost_model: cycles are counted on the machine only");
    if (!std::isfinite(options.frame) || options.frame < 0) {
        throw Error(ErrorKind::setting,
                    fmt::format("frame: found {}, expected 0 or more", options.frame));
    }
}

SceneOverrides overrides_of(const Options& options) {
    SceneOverrides overrides;
    if (!options.size.empty()) overrides.size = parse_size(options.size);
    if (!options.crop.empty()) overrides.crop = parse_crop(options.crop);
    overrides.levels = options.levels;
    overrides.zoom = options.zoom;
    overrides.samples = options.samples;
    overrides.detail = options.detail;
    overrides.heap = options.heap;
    if (!options.numeric.empty()) overrides.numeric = parse_numeric(options.numeric);
    if (!options.covers.empty()) overrides.covers = parse_covers(options.covers);
    if (!options.shading.empty()) overrides.shading = parse_shading(options.shading);
    if (!options.intersect.empty()) overrides.intersect = parse_intersect(options.intersect);
    if (!options.lipschitz.empty()) overrides.lipschitz = parse_lipschitz(options.lipschitz);
    if (!options.volume.empty()) overrides.volume = parse_volume(options.volume);
    return overrides;
}

RenderRequest request_of(const ReadScene& scene, const Options& options) {
    require_sound(options);
    RenderRequest request = scene.request(options.frame);
    request.overrides = overrides_of(options);
    if (!options.machine.empty()) request.machine = &parse_model("machine", options.machine);
    if (!options.cost_model.empty()) request.costs = read_cost_model(options.cost_model);
    const ThreadChoice choice = choose_threads(options.threads);
    request.threads = choice.threads;
    request.threads_because = choice.because;
    return request;
}

/// Puts the picture together of what threads have just rendered and still have in their caches: to
/// render into the memory of the whole takes longer.
class WholeFrame : public PictureTaker {
  public:
    void begin(const RenderResult& known) override {
        frame_ = Frame(known.statistics.size, known.window);
    }
    void take(const Frame& part) override {
        const long left = part.crop.x0;
        for (long y = part.crop.y0; y < part.crop.y1; ++y)
            std::copy_n(&part.at(left, y), part.columns(), &frame_.at(left, y));
    }
    [[nodiscard]] Frame frame() && { return std::move(frame_); }

  private:
    Frame frame_;
};

RenderResult rendered(const ReadScene& scene, const Options& options, const py::object& progress) {
    RenderResult result;
    watch(progress, [&](const RunControl& control) {
        WholeFrame whole;
        result = render(request_of(scene, options), control, &whole);
        result.frame = std::move(whole).frame();
    });
    return result;
}

py::buffer_info bytes_of(RenderResult& result) {
    const auto bytes = static_cast<py::ssize_t>(result.frame.pixels.size() * sizeof(PixelRecord));
    return {result.frame.pixels.data(),
            1,
            py::format_descriptor<unsigned char>::format(),
            1,
            {bytes},
            {1}};
}

/// name, NumPy's format, offset.
py::list pixel_layout() {
    py::list fields;
    const auto field = [&](const char* name, const char* format, std::size_t offset) {
        fields.append(py::make_tuple(name, format, offset));
    };
    field("color", "(3,)f4", offsetof(PixelRecord, color));
    field("alpha", "f4", offsetof(PixelRecord, alpha));
    field("z", "f4", offsetof(PixelRecord, z));
    field("normal", "(3,)f4", offsetof(PixelRecord, normal));
    field("object", "i4", offsetof(PixelRecord, object));
    field("level", "i4", offsetof(PixelRecord, level));
    field("word", "u4", offsetof(PixelRecord, word));
    field("volumes", "u4", offsetof(PixelRecord, volumes));
    field("cycles", "u8", offsetof(PixelRecord, cycles));
    field("heap", "u4", offsetof(PixelRecord, heap));
    field("node", "u2", offsetof(PixelRecord, node));
    field("alarms", "u1", offsetof(PixelRecord, alarms));
    return fields;
}

/// The counts of each node, in the order of node_fields.
py::list nodes(const RenderResult& result) {
    py::list all;
    if (!result.statistics.machine) return all;
    for (const NodeStatistics& n : result.statistics.machine->nodes) {
        const RayStatistics& r = n.rays;
        all.append(py::make_tuple(n.id, n.column, n.row, n.instructions, n.cycles, r.pixels,
                                  r.eye_rays, r.light_rays, r.reflect_rays, r.hits,
                                  r.volumes_tested, r.heap_pushes, r.heap_peak, r.heap_overflows,
                                  r.restarts, r.capped_rays));
    }
    return all;
}

void put_srgb(const RenderResult& result, const py::buffer& to) {
    const py::buffer_info info = to.request(true);
    if (info.itemsize != 1 ||
        info.size != static_cast<py::ssize_t>(3 * result.frame.pixels.size())) {
        throw py::value_error("expected three bytes a pixel");
    }
    put_srgb_bytes(result.frame.pixels, static_cast<unsigned char*>(info.ptr));
}

void save(const RenderResult& result, const std::string& path, const std::string& aov_text) {
    const AtWork at_work;
    const py::gil_scoped_release others;
    const auto aovs = aov_text.empty() ? std::vector<Aov>{} : parse_aovs(aov_text);
    require_image_format(path, aovs);
    const Statistics& s = result.statistics;
    write_image(path, result.frame, aovs,
                {{"version", PXM_VERSION},
                 {"scene", s.scene},
                 {"engine", s.engine},
                 {"model", s.model},
                 {"numeric", s.numeric},
                 {"options", ""},
                 {"pixel_at_eye", fmt::format("{:.17g}", result.pixel_at_eye)},
                 {"pixel_growth", fmt::format("{:.17g}", result.pixel_growth)}});
}

void add_options(py::module_& module) {
    py::class_<Options>(module, "Options")
        .def(py::init<>())
        .def_readwrite("size", &Options::size)
        .def_readwrite("crop", &Options::crop)
        .def_readwrite("shading", &Options::shading)
        .def_readwrite("covers", &Options::covers)
        .def_readwrite("intersect", &Options::intersect)
        .def_readwrite("numeric", &Options::numeric)
        .def_readwrite("lipschitz", &Options::lipschitz)
        .def_readwrite("volume", &Options::volume)
        .def_readwrite("machine", &Options::machine)
        .def_readwrite("cost_model", &Options::cost_model)
        .def_readwrite("levels", &Options::levels)
        .def_readwrite("samples", &Options::samples)
        .def_readwrite("heap", &Options::heap)
        .def_readwrite("detail", &Options::detail)
        .def_readwrite("zoom", &Options::zoom)
        .def_readwrite("frame", &Options::frame)
        .def_readwrite("threads", &Options::threads);
}

void add_result(py::module_& module) {
    py::class_<RenderResult>(module, "Rendered", py::buffer_protocol())
        .def_buffer(&bytes_of)
        .def_property_readonly("columns", [](const RenderResult& r) { return r.frame.columns(); })
        .def_property_readonly("rows", [](const RenderResult& r) { return r.frame.rows(); })
        .def_property_readonly("window",
                               [](const RenderResult& r) {
                                   return py::make_tuple(r.window.x0, r.window.y0, r.window.x1,
                                                         r.window.y1);
                               })
        .def_readonly("warnings", &RenderResult::warnings)
        .def_readonly("pixel_at_eye", &RenderResult::pixel_at_eye)
        .def_readonly("pixel_growth", &RenderResult::pixel_growth)
        .def("statistics", [](const RenderResult& r) { return statistics_json(r.statistics); })
        .def("nodes", &nodes)
        .def("put_srgb", &put_srgb, py::arg("to"))
        .def("save", &save, py::arg("path"), py::arg("aovs"));
}

py::list all_models() {
    py::list list;
    for (const Model& model : models())
        list.append(py::make_tuple(model.name, model.columns, model.rows));
    return list;
}

}  // namespace

void add_render(py::module_& module) {
    add_options(module);
    add_result(module);
    module.def("render", &rendered, py::arg("scene"), py::arg("options"), py::arg("progress"));
    module.def("pixel_layout", &pixel_layout);
    module.def("models", &all_models);
}

}  // namespace pxm::python
