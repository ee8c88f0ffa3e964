#include "host/study/study.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include "host/files/new_folder.hpp"
#include "host/files/safe_file.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/progress.hpp"
#include "host/process/terminal.hpp"
#include "host/study/study_files.hpp"
#include "host/study/unit_store.hpp"
#include "host/study/watched_study.hpp"
#include "host/text/json_text.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

constexpr int schema_version = 1;  // docs/studies-format.md

StudyPlan plan_of(const StudyRequest& request) {
    switch (request.kind) {
        case StudyKind::balance:
            return plan_balance(request);
        case StudyKind::error:
            return plan_error(request);
        case StudyKind::stability:
            return plan_stability(request);
        case StudyKind::shading:
            return plan_shading(request);
    }
    return {};
}

void make_folder(const std::string& path) {
    if (std::filesystem::exists(path) && !std::filesystem::is_directory(path))
        throw Error(ErrorKind::file,
                    fmt::format("cannot make the folder {}: it is a file", printable_path(path)));
    const std::error_code error = make_folders(path);
    if (error) {
        throw Error(ErrorKind::file, fmt::format("cannot make the folder {}: {}",
                                                 printable_path(path), error.message()));
    }
    require_writable(path + "/data.json");
}

/// A line a unit where there is no terminal for a bar.
void tell_unit(const StudyRequest& request, const Progress& progress, std::size_t done,
               std::size_t all, const std::string& name, double seconds) {
    if (request.quiet || progress.enabled()) return;
    tell(fmt::format("{}/{} {} in {:.1f} s\n", done, all, name, seconds));
}

/// The results of all units, those that are stored and those measured now; nothing if a signal
/// came.
std::optional<std::vector<Json>> measure_all(const StudyRequest& request, const StudyPlan& plan,
                                             const RunControl& watching) {
    UnitStore store(request.folder + "/units");
    std::vector<std::optional<Json>> results;
    std::size_t missing = 0;
    for (const Unit& unit : plan.units) {
        store.require_place(unit.name);
        results.push_back(request.fresh ? std::nullopt : store.find(unit.name, unit.settings));
        missing += !results.back();
    }
    const std::size_t known = plan.units.size() - missing;
    if (known > 0 && !request.quiet) {
        tell(fmt::format("{} of {} measurements are there already\n", known, plan.units.size()));
    }
    Progress progress(request.quiet);
    std::size_t measured = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i]) continue;
        UnitControl control{{watching.stop, nullptr}, request.folder};
        if (progress.enabled() || watching.progress) {
            control.run.progress = [&](double share) {
                const double all_share =
                    (static_cast<double>(measured) + share) / static_cast<double>(missing);
                progress.update(all_share);
                if (watching.progress) watching.progress(all_share);
            };
        }
        const auto start = std::chrono::steady_clock::now();
        try {
            results[i] = plan.units[i].measure(control);
        } catch (const StudyStopped&) {
            return std::nullopt;
        }
        if (watching.stop != nullptr && *watching.stop) return std::nullopt;
        store.put(plan.units[i].name, plan.units[i].settings, *results[i]);
        ++measured;
        progress.update(static_cast<double>(measured) / static_cast<double>(missing));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        tell_unit(request, progress, known + measured, results.size(), plan.units[i].name,
                  took.count());
    }
    std::vector<Json> all;
    for (std::optional<Json>& result : results) all.push_back(std::move(*result));
    return all;
}

Json heading(const StudyRequest& request) {
    Json json = {
        {"study", name_of(request.kind)}, {"pxm", PXM_VERSION}, {"schema_version", schema_version}};
    Json options = Json::object();
    if (request.size) options["size"] = {request.size->columns, request.size->rows};
    if (request.machine) options["machine"] = request.machine->name;
    options["threads"] = request.threads;
    for (const Setting& setting : request.settings) options["set"][setting.key] = setting.value;
    json["options"] = options;
    return json;
}

}  // namespace

const char* name_of(StudyKind kind) {
    switch (kind) {
        case StudyKind::balance:
            return "balance";
        case StudyKind::error:
            return "error";
        case StudyKind::stability:
            return "stability";
        case StudyKind::shading:
            return "shading";
    }
    return "";
}

bool run_study(const StudyRequest& request) {
    return run_watched_study(request, {&stop_requested(), nullptr});
}

bool run_watched_study(const StudyRequest& request, const RunControl& control) {
    const StudyPlan plan = plan_of(request);
    require_spared_scenes(request, plan);
    make_folder(request.folder);
    const auto results = measure_all(request, plan, control);
    if (!results) {
        if (!request.quiet) tell(fmt::format("stopped; the same command goes on from here\n"));
        return false;
    }
    Json data = heading(request);
    data.update(plan.assemble(*results));
    for (const TextFile& table : plan.tables(data))
        write_text_safely(request.folder + "/" + table.name, table.text);
    write_text_safely(request.folder + "/report.html", plan.page(data, request.folder));
    write_text_safely(request.folder + "/data.json", json_text(data, 1) + "\n");
    if (!request.quiet) tell(fmt::format("{}/report.html\n", printable_path(request.folder)));
    return true;
}

}  // namespace pxm::host
