// The error study: what every setting costs in time and in error, against a reference (a
// work-precision diagram). Counted time is the machine's; host time is the median of repeats.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "host/study/deviation.hpp"
#include "host/study/error_settings.hpp"
#include "host/study/page/error_page.hpp"
#include "host/study/pareto.hpp"
#include "host/study/study_scene.hpp"

namespace pxm::host {

namespace {

const PixelSize default_size{160, 128};
constexpr std::uint32_t cell_cap = 5'000;  // of the settings: hopeless ones shall end

/// A scene's references, rendered when the first of its settings is measured.
struct References {
    std::optional<RenderResult> color;
    std::optional<RenderResult> depth;
};

RenderRequest request_for(const std::string& scene, const SceneOverrides& overrides,
                          const StudyRequest& study) {
    RenderRequest request;
    request.scene_path = scene;
    request.settings = study.settings;
    request.allowed = study.allowed;
    request.overrides = overrides;
    request.overrides.size = study.size.value_or(default_size);
    request.threads = study.threads;
    return request;
}

/// Predicted seconds on the machine; nothing if the scene or the heap does not fit.
Json machine_seconds(RenderRequest request, const StudyRequest& study, const UnitControl& control,
                     std::optional<RenderResult>& picture) {
    request.machine = study.machine ? study.machine : find_model("964dX");
    try {
        picture = render_unit(request, control);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::machine_limit) throw;
        return nullptr;
    }
    std::uint64_t slowest = 0;
    for (const NodeStatistics& node : picture->statistics.machine->nodes)
        slowest = std::max(slowest, node.cycles);
    return static_cast<double>(slowest) * instruction_seconds;
}

void render_references(const std::string& scene, const StudyRequest& study, References& references,
                       const UnitControl& control) {
    references.depth = render_unit(request_for(scene, depth_reference(), study), control);
    references.color = render_unit(request_for(scene, color_reference(), study), control);
}

/// Median and spread of the host's seconds for a native render.
Json host_seconds(const RenderRequest& request, int repeats, const UnitControl& control,
                  std::optional<RenderResult>& picture) {
    std::vector<double> seconds;
    for (int i = 0; i < repeats; ++i) {
        const RenderResult again = render_unit(request, control);
        seconds.push_back(again.statistics.seconds.render);
        if (!picture) picture = again;
    }
    std::ranges::sort(seconds);
    return {{"host_seconds", seconds[seconds.size() / 2]},
            {"host_spread", {seconds.front(), seconds.back()}}};
}

Json measure_setting(const std::string& scene, const ErrorSetting& setting,
                     const StudyRequest& study, const References& references,
                     const UnitControl& control) {
    RenderRequest request = request_for(scene, setting.overrides, study);
    request.cell_cap = cell_cap;
    std::optional<RenderResult> picture;
    Json result = {{"settings", {{"name", setting.name}}}};
    result["machine_seconds"] = nullptr;
    if (!setting.native_only)
        result["machine_seconds"] = machine_seconds(request, study, control, picture);
    result.update(host_seconds(request, study.repeats, control, picture));
    const Deviation color = deviation_of(*picture, *references.color);
    const Deviation depth = deviation_of(*picture, *references.depth);
    result["capped_rays"] = picture->statistics.rays.capped_rays;
    result["rmse"] = color.rmse;
    result["color_99"] = color.color_99;
    result["perceived"] = color.perceived;
    result["wrong_hits"] = depth.wrong_hits;
    result["depth_error_pixels"] = depth.mean_depth;
    result["worst_depth_pixels"] = depth.worst_depth;
    return result;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// A setting that the scene does not allow (`fast` takes homotheties alone) is no point: it says
/// why.
Json measure_if_allowed(const std::string& scene, const ErrorSetting& setting,
                        const StudyRequest& study, References& references,
                        const UnitControl& control) {
    if (!references.color) render_references(scene, study, references, control);
    try {
        return measure_setting(scene, setting, study, references, control);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::scene && error.kind() != ErrorKind::setting) throw;
        return {{"settings", {{"name", setting.name}}}, {"refused", first_line(error.what())}};
    }
}

Json scene_json(const std::string& scene, const Json& results, const StudyRequest& study) {
    Json points = Json::array();
    Json refused = Json::array();
    for (const Json& result : results)
        (result.contains("refused") ? refused : points).push_back(result);
    mark_pareto(points, "machine_seconds", "pareto", "dominated_by");
    mark_pareto(points, "host_seconds", "pareto_host", "dominated_by_host");
    const PixelSize size = study.size.value_or(default_size);
    Json json = {
        {"scene", scene},
        {"size", {size.columns, size.rows}},
        {"cell_cap", cell_cap},
        {"reference", {{"numeric", "double"}, {"samples", 64}, {"detail", 0.1}, {"heap", 65'536}}}};
    if (study.budget_seconds) {
        const Json* point = best_point(points, "rmse", "host_seconds", *study.budget_seconds);
        json["budget"] = {{"seconds", *study.budget_seconds},
                          {"settings", point ? (*point)["settings"]["name"] : Json(nullptr)}};
    }
    if (study.target_error) {
        const Json* point = best_point(points, "host_seconds", "rmse", *study.target_error);
        json["target"] = {{"rmse", *study.target_error},
                          {"settings", point ? (*point)["settings"]["name"] : Json(nullptr)}};
    }
    json["advice"] = advice_for(points);
    json["points"] = std::move(points);
    json["refused"] = std::move(refused);
    return json;
}

}  // namespace

StudyPlan plan_error(const StudyRequest& request) {
    if (request.scenes.empty())
        throw Error(ErrorKind::setting, "study error: give it at least one scene");
    StudyPlan plan;
    const std::vector<std::string> names = file_names_of(request.scenes);
    const std::vector<ErrorSetting> settings = error_settings();
    const PixelSize size = request.size.value_or(default_size);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string scene = request.scenes[i];
        const std::string content = fingerprint_of(scene, request.settings, request.allowed);
        const auto references = std::make_shared<References>();
        for (std::size_t k = 0; k < settings.size(); ++k) {
            plan.units.push_back({fmt::format("{}-{:02}", names[i], k),
                                  {{"study", "error"},
                                   {"pxm", PXM_VERSION},
                                   {"scene", scene},
                                   {"content", content},
                                   {"settings", settings[k].name},
                                   {"size", {size.columns, size.rows}},
                                   {"repeats", request.repeats},
                                   {"model", request.machine ? request.machine->name : "964dX"}},
                                  [=, setting = settings[k]](const UnitControl& control) {
                                      return measure_if_allowed(scene, setting, request,
                                                                *references, control);
                                  }});
        }
    }
    plan.assemble = [=, count = settings.size()](const std::vector<Json>& results) {
        Json data = {{"scenes", Json::array()}};
        for (std::size_t i = 0; i < request.scenes.size(); ++i) {
            const auto first = results.begin() + static_cast<std::ptrdiff_t>(i * count);
            const Json of_scene(
                std::vector<Json>(first, first + static_cast<std::ptrdiff_t>(count)));
            data["scenes"].push_back(scene_json(request.scenes[i], of_scene, request));
        }
        return data;
    };
    plan.tables = error_tables;
    plan.page = error_page;
    return plan;
}

}  // namespace pxm::host
