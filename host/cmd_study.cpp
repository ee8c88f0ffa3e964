// `pxm study KIND SCENE... -o DIR`: an experiment with a report (docs/studies.md).
#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <thread>

#include "host/cmd.hpp"
#include "host/option_checks.hpp"
#include "host/render_options.hpp"
#include "host/study/study.hpp"

namespace pxm::host {

namespace {

struct StudyArguments {
    std::string kind;
    StudyRequest request;
    std::string size, machine, numeric;
    int threads = 0;  // 0: all cores
};

ExitCode study(const StudyArguments& a) {
    StudyRequest request = a.request;
    const std::map<std::string, StudyKind> kinds{{"balance", StudyKind::balance},
                                                 {"error", StudyKind::error},
                                                 {"stability", StudyKind::stability},
                                                 {"shading", StudyKind::shading}};
    const auto kind = kinds.find(a.kind);
    if (kind == kinds.end()) {
        throw Error(
            ExitCode::command_line,
            "study: found \"" + a.kind + "\", expected one of balance, error, stability, shading");
    }
    request.kind = kind->second;
    if (!a.size.empty()) request.size = parse_size(a.size);
    if (!a.machine.empty()) request.machine = &parse_model("--machine", a.machine);
    if (!a.numeric.empty()) request.numeric = parse_numeric(a.numeric);
    request.threads = a.threads > 0
                          ? a.threads
                          : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    return run_study(request);
}

}  // namespace

CommandAction add_study_command(CLI::App& app) {
    const auto a = std::make_shared<StudyArguments>();
    CLI::App* command =
        app.add_subcommand("study", "Measure balance, error, stability or shading, with a report");
    command->add_option("kind", a->kind, "balance, error, stability or shading")->required();
    command->add_option("scenes", a->request.scenes, "The scene files (.pxm)");
    command->add_option("-o,--out", a->request.folder, "The folder of the report")->required();
    command->add_option("--size", a->size, "WxH in pixels, of every render");
    command->add_option("--machine", a->machine, "The model to measure on; default 964dX");
    command->add_option("--numeric", a->numeric, "balance: dsp32, float or double");
    command->add_option("--threads", a->threads, "Host threads; default: all cores")
        ->check(CLI::Range(1, 1024));
    command->add_option("--samples", a->request.samples, "shading: points looked at")
        ->check(CLI::Range(100L, 10'000'000L));
    command->add_option("--repeats", a->request.repeats, "error: renders a host time is taken of")
        ->check(CLI::Range(1, 100));
    command
        ->add_option("--budget", a->request.budget_seconds,
                     "error: name the best settings within so many host seconds")
        ->check(positive_number());
    command
        ->add_option("--target", a->request.target_error,
                     "error: name the fastest settings with no more than this RMSE")
        ->check(positive_number());
    command->add_flag("--fresh", a->request.fresh, "Measure again what is there already");
    command->add_flag("--quiet", a->request.quiet, "No progress");
    return [a] { return study(*a); };
}

}  // namespace pxm::host
