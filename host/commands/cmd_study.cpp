// `pxm study KIND SCENE... -o DIR`: an experiment with a report (docs/studies.md).
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/shared_options.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/limits.hpp"
#include "host/render/render_options.hpp"
#include "host/scene/carried/carried_scene.hpp"
#include "host/study/study.hpp"
#include "host/text/nearest.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

struct StudyArguments {
    std::string kind;
    StudyRequest request;
    std::string size, machine, numeric;
    int threads = 0;  // 0: those granted
    std::vector<std::string> set;
    LimitArguments limits;
};

ExitCode study(const StudyArguments& a) {
    StudyRequest request = a.request;
    const std::map<std::string, StudyKind> kinds{{"balance", StudyKind::balance},
                                                 {"error", StudyKind::error},
                                                 {"stability", StudyKind::stability},
                                                 {"shading", StudyKind::shading}};
    const auto kind = kinds.find(a.kind);
    if (kind == kinds.end()) {
        throw Error(ErrorKind::setting,
                    "study: found \"" + a.kind +
                        "\", expected one of balance, error, stability, shading" +
                        suggestion(a.kind, {"balance", "error", "stability", "shading"}));
    }
    request.kind = kind->second;
    if (!a.size.empty()) request.size = parse_size(a.size);
    if (!a.machine.empty()) request.machine = &parse_model("--machine", a.machine);
    if (!a.numeric.empty()) request.numeric = parse_numeric(a.numeric);
    request.threads = choose_threads(a.threads).threads;
    request.settings = parse_settings(a.set);
    if (!request.settings.empty() && request.scenes.empty())
        throw Error(ErrorKind::setting, "--set: there is no scene to set anything of");
    return run_study(request)
               ? ExitCode::done
               : exit_code_of_stop(
                     "what was measured is kept; the same command goes on from there");
}

/// A picture has options of its own, which a study would not mind.
void require_text(const std::string& scene) {
    if (!carried_scene_at(scene)) return;
    throw Error(ErrorKind::setting,
                fmt::format("{0} is a picture: pxm inspect {0} --scene -o FILE.pxm takes its scene "
                            "out, for a study",
                            printable_path(scene)));
}

}  // namespace

AddedCommand add_study_command(CommandLine& line) {
    const auto a = std::make_shared<StudyArguments>();
    CommandOptions command =
        line.add_command("study", "Measure balance, error, stability or shading, with a report");
    command.add_option("kind", a->kind, "balance, error, stability or shading").required();
    command.add_option("scenes", a->request.scenes, "The scene files (.pxm)");
    command.add_option("-o,--out", a->request.folder, "The folder of the report").required();
    command.add_option("--size", a->size, "WxH in pixels, of every render");
    command.add_option("--machine", a->machine, "The model to measure on; default 964dX");
    command.add_option("--numeric", a->numeric, "balance: dsp32, float or double");
    add_threads_option(command, a->threads);
    add_limit_options(command, a->limits);
    add_set_option(command, a->set);
    command.add_option("--samples", a->request.samples, "shading: points looked at")
        .transform(whole_number(100, 10'000'000));
    command.add_option("--repeats", a->request.repeats, "error: renders a host time is taken of")
        .transform(whole_number(1, 100));
    command
        .add_option("--budget", a->request.budget_seconds,
                    "error: name the best settings within so many host seconds")
        .transform(positive_number());
    command
        .add_option("--target", a->request.target_error,
                    "error: name the fastest settings with no more than this RMSE")
        .transform(positive_number());
    command.add_flag("--fresh", a->request.fresh, "Measure again what is there already");
    command.add_flag("--quiet", a->request.quiet, "No progress");
    add_allow_option(command, a->request.allowed);
    return {command, [a] {
                for (std::string& scene : a->request.scenes) {
                    find_scene_by_name(scene, a->request.allowed);
                    require_text(scene);
                }
                const LimitWatch watch(a->limits.limits());
                return study(*a);
            }};
}

}  // namespace pxm::host
