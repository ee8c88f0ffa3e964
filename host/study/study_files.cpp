#include "host/study/study_files.hpp"

#include "host/output/spared_inputs.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::host {

namespace {

/// What a unit writes beside its result, after its name.
std::vector<std::string> endings_of(StudyKind kind) {
    switch (kind) {
        case StudyKind::balance:
            return {".png", "-cycles.png"};
        case StudyKind::stability:
            return {".pxm", "-twin.pxm"};
        case StudyKind::shading:
            return {".pxm"};
        case StudyKind::error:
            return {};
    }
    return {};
}

}  // namespace

std::vector<std::string> files_of(const StudyRequest& request, const StudyPlan& plan) {
    const std::string folder = request.folder + "/";
    std::vector<std::string> files{folder + "data.json", folder + "report.html"};
    for (const char* table : {"scenes", "nodes", "curves", "points", "cases", "shading"})
        files.push_back(folder + table + ".csv");
    for (const Unit& unit : plan.units) {
        files.push_back(folder + "units/" + unit.name + ".json");
        for (const std::string& ending : endings_of(request.kind))
            files.push_back(folder + unit.name + ending);
    }
    return files;
}

void require_spared_scenes(const StudyRequest& request, const StudyPlan& plan) {
    std::vector<InputFile> inputs;
    for (const std::string& path : request.scenes) {
        Diagnostics diagnostics;
        const std::vector<InputFile> of_scene =
            inputs_of(parse_scene(path, diagnostics, request.allowed));
        inputs.insert(inputs.end(), of_scene.begin(), of_scene.end());
    }
    if (!inputs.empty()) require_spared(files_of(request, plan), inputs);
}

}  // namespace pxm::host
