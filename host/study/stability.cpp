// The stability study: extreme scenes in every number type against a reference, graded. A render
// may fail, but never silently.
#include <fmt/format.h>

#include <algorithm>

#include "host/output/safe_file.hpp"
#include "host/study/deviation.hpp"
#include "host/study/stability_cases.hpp"
#include "host/study/stability_page.hpp"
#include "host/study/study_scene.hpp"

namespace pxm::host {

namespace {

constexpr double right_share = 0.001;    // of wrong pixels: design decision 4
constexpr double degraded_share = 0.02;  // more is a failure
constexpr double twin_unit = 3;          // no power of 2: everything is rounded otherwise

/// What computes. A line here is an engine that the study knows.
struct NumberChoice {
    const char* name;
    Numeric numeric;
    std::optional<IntersectMethod> intersect = {};
};
const NumberChoice choices[] = {
    {"dsp32", Numeric::dsp32}, {"float", Numeric::single}, {"double", Numeric::twice}};

RenderResult render_as(const std::string& path, const NumberChoice& choice,
                       const UnitControl& control, int threads) {
    RenderRequest request;
    request.scene_path = path;
    request.threads = threads;
    request.overrides.numeric = choice.numeric;
    request.overrides.intersect = choice.intersect;
    return render_unit(request, control);
}

/// Wrong pixels that no alarm of the pixel's own tells of.
double missed_share(const RenderResult& picture, const std::vector<char>& wrong) {
    double missed = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i)
        missed += wrong[i] && picture.frame.pixels[i].alarms == 0;
    return missed / static_cast<double>(std::max<std::size_t>(1, wrong.size()));
}

bool any_alarm(const RenderResult& picture) {
    return std::ranges::any_of(picture.statistics.alarms,
                               [](const Alarm& alarm) { return alarm.count > 0; });
}

const char* grade_of(double wrong_share, bool alarmed) {
    if (wrong_share <= right_share) return "right";
    if (wrong_share <= degraded_share) return "degraded";
    return alarmed ? "reported" : "silent";
}

Json compared(const RenderResult& picture, const RenderResult& reference, double scale) {
    const Deviation d = deviation_of(picture, reference, scale);
    const Statistics& s = picture.statistics;
    Json alarms = Json::object();
    for (const Alarm& alarm : s.alarms)
        if (alarm.count > 0) alarms[alarm.name] = alarm.count;
    return {{"wrong_share", d.wrong_share},
            {"missed_share", missed_share(picture, d.wrong)},
            {"worst_depth_pixels", d.worst_depth},
            {"grade", grade_of(d.wrong_share, any_alarm(picture))},
            {"alarms", alarms},
            {"hits", s.rays.hits},
            {"heap_overflows", s.rays.heap_overflows},
            {"restarts", s.rays.restarts},
            {"capped_rays", s.rays.capped_rays},
            {"cells_per_ray", static_cast<double>(s.rays.volumes_tested) /
                                  static_cast<double>(std::max<std::uint64_t>(1, s.rays.pixels))},
            {"host", {{"render_seconds", s.seconds.render}}}};
}

/// A scene that is refused has said so.
Json refused(const Error& error) {
    return {{"wrong_share", 0.0},
            {"missed_share", 0.0},
            {"worst_depth_pixels", 0.0},
            {"grade", "reported"},
            {"exit_code", static_cast<int>(error.code())},
            {"message", error.what()}};
}

Json measure_case(const StabilityCase& one, const std::string& name, int threads,
                  const UnitControl& control) {
    const std::string path = control.folder + "/" + name + ".pxm";
    const std::string twin_path = control.folder + "/" + name + "-twin.pxm";
    write_text_safely(path, one.text(1));
    write_text_safely(twin_path, one.text(twin_unit));
    const NumberChoice& exact = choices[std::size(choices) - 1];
    Json results = Json::array();
    std::optional<RenderResult> reference;
    for (auto choice = std::rbegin(choices); choice != std::rend(choices); ++choice) {
        Json result = {{"name", one.name},
                       {"family", one.family},
                       {"value", one.value},
                       {"scene", name + ".pxm"},
                       {"numeric", choice->name}};
        try {
            const RenderResult picture = render_as(path, *choice, control, threads);
            if (!reference) {
                reference = picture;
                result.update(
                    compared(picture, render_as(twin_path, exact, control, threads), twin_unit));
            } else {
                result.update(compared(picture, *reference, 1));
            }
        } catch (const Error& error) {
            result.update(refused(error));
        }
        results.insert(results.begin(), result);
    }
    return results;
}

}  // namespace

StudyPlan plan_stability(const StudyRequest& request) {
    if (!request.scenes.empty()) {
        throw Error(ExitCode::command_line,
                    "study stability: it makes its own scenes, give it none");
    }
    StudyPlan plan;
    for (const StabilityCase& one : stability_cases()) {
        const std::string name = fmt::format("case-{:02}", plan.units.size() + 1);
        plan.units.push_back({name,
                              {{"study", "stability"},
                               {"pxm", PXM_VERSION},
                               {"case", one.name},
                               {"scene", one.text(1)}},
                              [=, threads = request.threads](const UnitControl& control) {
                                  return measure_case(one, name, threads, control);
                              }});
    }
    plan.assemble = [](const std::vector<Json>& results) {
        Json data = {{"right_share", right_share}, {"degraded_share", degraded_share}};
        data["cases"] = Json::array();
        for (const Json& result : results)
            for (const Json& one : result) data["cases"].push_back(one);
        return data;
    };
    plan.tables = stability_tables;
    plan.page = stability_page;
    return plan;
}

}  // namespace pxm::host
