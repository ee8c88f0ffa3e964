// The stability study: extreme scenes in every number type against a reference, graded. A render
// may fail, but never silently.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "host/files/safe_file.hpp"
#include "host/process/exit_code.hpp"
#include "host/study/deviation.hpp"
#include "host/study/extended.hpp"
#include "host/study/grade.hpp"
#include "host/study/page/stability_page.hpp"
#include "host/study/stability_cases.hpp"
#include "host/study/study_scene.hpp"

namespace pxm::host {

namespace {

constexpr int mantissa_bits = std::numeric_limits<long double>::digits;
constexpr double twin_unit = 3;  // no power of 2: everything is rounded otherwise

/// What computes. A line here is an engine that the study knows. `auto` is the wide engine wherever
/// it applies, and what it leaves to the reference kernels they do.
struct NumberChoice {
    const char* name;
    Numeric numeric;
    IntersectMethod intersect;
};
const NumberChoice choices[] = {{"dsp32", Numeric::dsp32, IntersectMethod::heap},
                                {"float", Numeric::single, IntersectMethod::heap},
                                {"wide", Numeric::single, IntersectMethod::automatic},
                                {"double", Numeric::double_, IntersectMethod::heap}};

RenderRequest request_for(const StabilityCase& one, const std::string& path,
                          const NumberChoice& choice, int threads) {
    RenderRequest request;
    request.scene_path = path;
    request.settings = one.settings;
    request.allowed = one.allowed;
    request.threads = threads;
    request.overrides.numeric = choice.numeric;
    request.overrides.intersect = choice.intersect;
    request.overrides.volume = one.volume;
    request.overrides.size = one.size;
    request.overrides.samples = 1;
    request.cell_cap = one.cell_cap;
    return request;
}

/// What the pictures of a case are judged by.
RenderResult reference_for(const StabilityCase& one, const std::string& path,
                           const UnitControl& control) {
    RenderResult result = render_extended(request_for(one, path, choices[0], 1), control.run);
    if (result.stopped) throw StudyStopped{};
    return result;
}

bool any_alarm(const RenderResult& picture) {
    return std::ranges::any_of(picture.statistics.alarms,
                               [](const Alarm& alarm) { return alarm.count > 0; });
}

Json counts_json(const Statistics& s) {
    Json alarms = Json::object();
    for (const Alarm& alarm : s.alarms)
        if (alarm.count > 0) alarms[alarm.name] = alarm.count;
    return {{"alarms", alarms},
            {"pixels", s.rays.pixels},
            {"engine", s.intersect},
            {"hits", s.rays.hits},
            {"overflowed_pixels", alarms.value("overflow", 0)},
            {"heap_overflows", s.rays.heap_overflows},
            {"restarts", s.rays.restarts},
            {"capped_rays", s.rays.capped_rays},
            {"cells_per_ray", static_cast<double>(s.rays.volumes_tested) /
                                  static_cast<double>(std::max<std::uint64_t>(1, s.rays.pixels))},
            {"host", {{"render_seconds", s.seconds.render}}}};
}

/// Of every alarm of pixels that counts any: how many, and how many of those are wrong.
Json alarmed_json(const RenderResult& picture, const std::vector<char>& wrong) {
    constexpr std::pair<PixelAlarm, const char*> of_pixels[] = {
        {alarm_precision, "precision"},   {alarm_floored, "floored"},   {alarm_capped, "capped"},
        {alarm_not_finite, "not_finite"}, {alarm_overflow, "overflow"},
    };
    Json json = Json::object();
    for (const auto& [alarm, name] : of_pixels) {
        const AlarmedPixels alarmed = alarmed_pixels(picture, wrong, alarm);
        if (alarmed.pixels > 0) json[name] = {{"pixels", alarmed.pixels}, {"wrong", alarmed.wrong}};
    }
    return json;
}

Json compared(const RenderResult& picture, const RenderResult& reference) {
    const Deviation d = deviation_of(picture, reference);
    const std::vector<char> wrong = wrong_pixels(d, reference);
    Json json = {{"wrong_share", share_of(wrong)},
                 {"missed_share", missed_share(picture, wrong)},
                 {"alarmed", alarmed_json(picture, wrong)},
                 {"worst_depth_pixels", d.worst_depth},
                 {"rmse", d.rmse},
                 {"grade", grade_of(share_of(wrong), any_alarm(picture))}};
    json.update(counts_json(picture.statistics));
    return json;
}

/// A scene that is refused has said so.
Json refused(const Error& error) {
    return {{"wrong_share", 0.0},
            {"missed_share", 0.0},
            {"worst_depth_pixels", 0.0},
            {"grade", "reported"},
            {"exit_code", static_cast<int>(exit_code_of(error.kind()))},
            {"message", error.what()}};
}

/// The files of a case: the scene, and its twin with all lengths times `twin_unit`, of which a
/// user's scene has none.
struct CaseFiles {
    std::string scene;
    std::string twin;
};

CaseFiles files_of(const StabilityCase& one, const std::string& name, const std::string& folder) {
    if (!one.path.empty()) return {one.path, ""};
    const CaseFiles files{folder + "/" + name + ".pxm", folder + "/" + name + "-twin.pxm"};
    write_text_safely(files.scene, one.text(1));
    write_text_safely(files.twin, one.text(twin_unit));
    return files;
}

/// Pixels of double that the twin's roundings change: the host's part of the error, which the
/// reference shares.
double twin_share(const StabilityCase& one, const CaseFiles& files, const RenderResult& picture,
                  const NumberChoice& choice, int threads, const UnitControl& control) {
    const RenderResult twin = render_unit(request_for(one, files.twin, choice, threads), control);
    return deviation_of(picture, twin, twin_unit).wrong_share;
}

Json measure_case(const StabilityCase& one, const std::string& name, int threads,
                  const UnitControl& control) {
    const CaseFiles files = files_of(one, name, control.folder);
    Json results = Json::array();
    std::optional<RenderResult> reference;
    for (const NumberChoice& choice : choices) {
        Json result = {{"name", one.name},
                       {"family", one.family},
                       {"value", one.value},
                       {"scene", one.path.empty() ? name + ".pxm" : one.path},
                       {"numeric", choice.name}};
        try {
            if (!reference) reference = reference_for(one, files.scene, control);
            const RenderResult picture =
                render_unit(request_for(one, files.scene, choice, threads), control);
            result.update(compared(picture, *reference));
            if (choice.numeric == Numeric::double_ && !files.twin.empty())
                result["twin_share"] = twin_share(one, files, picture, choice, threads, control);
        } catch (const Error& error) {
            result.update(refused(error));
        }
        results.push_back(result);
    }
    return results;
}

}  // namespace

StudyPlan plan_stability(const StudyRequest& request) {
    StudyPlan plan;
    std::vector<StabilityCase> cases = stability_cases();
    for (const std::string& scene : request.scenes) {
        cases.push_back(case_of(scene, request.allowed, request.size));
        cases.back().settings = request.settings;
    }

    for (const StabilityCase& one : cases) {
        const std::string name = fmt::format("case-{:02}", plan.units.size() + 1);
        const PixelSize size = one.size.value_or(PixelSize{});
        plan.units.push_back(
            {name,
             {{"study", "stability"},
              {"pxm", PXM_VERSION},
              {"case", one.name},
              {"size", {size.columns, size.rows}},
              {"volume", static_cast<int>(one.volume.value_or(VolumeKind{}))},
              {"cell_cap", one.cell_cap.value_or(0)},
              {"scene", one.path.empty() ? one.text(1)
                                         : fingerprint_of(one.path, one.settings, one.allowed)}},
             [=, threads = request.threads](const UnitControl& control) {
                 return measure_case(one, name, threads, control);
             }});
    }
    plan.assemble = [](const std::vector<Json>& results) {
        Json data = {{"right_share", right_share},
                     {"degraded_share", degraded_share},
                     {"reference", {{"numeric", "long double"}, {"mantissa_bits", mantissa_bits}}}};
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
