#include "python/module/scene.hpp"

#include <pybind11/stl.h>

#include "host/inspect/inspect_json.hpp"
#include "host/inspect/inspection.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/print.hpp"
#include "host/scene/scene_path.hpp"
#include "python/module/work.hpp"

namespace pxm::python {

namespace py = pybind11;
using namespace host;

namespace {

/// Puts the file that a name stands for in its place.
void find(ReadScene& read) {
    const std::optional<FoundScene> found = find_scene(read.path);
    if (!found) return;
    read.path = found->path;
    if (!found->folder.empty()) read.allowed.push_back(found->folder);
}

ReadScene read_scene(const std::string& path, const std::optional<std::string>& text,
                     const std::vector<std::string>& allowed,
                     const std::vector<std::string>& settings) {
    const AtWork at_work;
    const py::gil_scoped_release others;
    ReadScene read{path, text, allowed, parse_settings(settings), {}};
    if (!text) find(read);
    Diagnostics diagnostics;
    read.scene = parse_scene(read.path, read.settings, diagnostics, read.allowed, read.text);
    if (!diagnostics.has_errors()) check_scene(read.scene, diagnostics);
    diagnostics.throw_if_errors(read.scene.files);
    return read;
}

std::string inspected(const ReadScene& read, const py::object& progress) {
    std::string json;
    watch(progress, [&](const RunControl&) {
        Diagnostics diagnostics;
        const Inspection found = inspect(read.scene, read.path, diagnostics);
        diagnostics.throw_if_errors(read.scene.files);
        json = inspect_json(found);
    });
    return json;
}

py::object reference(const MapReference& reference) {
    if (const auto* name = std::get_if<std::string>(&reference.map)) return py::str(*name);
    return py::int_(std::get<long>(reference.map) - 1);  // Python counts from 0
}

py::list references(const std::vector<MapReference>& list) {
    py::list all;
    for (const MapReference& one : list) all.append(reference(one));
    return all;
}

/// The matrix of a map, for columns: three rows of four numbers.
py::tuple matrix(const Affine& map) {
    py::tuple numbers(12);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            numbers[4 * row + column] = map.linear[column][row];
        numbers[4 * row + 3] = map.translation[row];
    }
    return numbers;
}

py::tuple map_of(const MapBlock& map) {
    py::object color = py::none(), weight = py::none();
    if (map.color) color = py::make_tuple(map.color->r, map.color->g, map.color->b, map.color->a);
    if (map.weight) weight = py::float_(*map.weight);
    return py::make_tuple(map.name, matrix(compose(map.commands)), color, weight);
}

py::list systems(const ReadScene& read) {
    py::list all;
    for (const IfsBlock& block : read.scene.ifs) {
        py::list maps, follow;
        for (const MapBlock& map : block.maps) maps.append(map_of(map));
        for (const FollowRule& rule : block.follow)
            follow.append(py::make_tuple(reference(rule.map), references(rule.followers)));
        all.append(py::make_tuple(block.name, maps, follow, references(block.start)));
    }
    return all;
}

}  // namespace

RenderRequest ReadScene::request(double frame) const {
    RenderRequest made;
    made.scene_path = path;
    made.allowed = allowed;
    if (frame == 0) {
        made.scene = scene;
        return made;
    }
    made.scene_text = text;
    made.settings = settings;
    made.frame = frame;
    return made;
}

void add_scene(py::module_& module) {
    py::class_<ReadScene>(module, "ReadScene")
        .def(py::init(&read_scene), py::arg("path"), py::arg("text"), py::arg("allowed"),
             py::arg("settings"))
        .def_readonly("path", &ReadScene::path)
        .def_readonly("allowed", &ReadScene::allowed)
        .def("frames",
             [](const ReadScene& read) {
                 return read.scene.animation ? read.scene.animation->frames : 1;
             })
        .def("text", [](const ReadScene& read) { return print_scene(read.scene); })
        .def("systems", &systems)
        .def("inspect", &inspected, py::arg("progress") = py::none());
    module.def("scene_names", &scene_names);
}

}  // namespace pxm::python
