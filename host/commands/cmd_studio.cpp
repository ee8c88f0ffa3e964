// `pxm studio [SCENE]`: a page of this computer to look at scenes and to shape them.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <system_error>
#include <thread>

#include "host/commands/browser.hpp"
#include "host/commands/cmd.hpp"
#include "host/commands/option_checks.hpp"
#include "host/commands/shared_options.hpp"
#include "host/error.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/interrupt.hpp"
#include "host/process/terminal.hpp"
#include "host/studio/studio.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {

namespace {

struct StudioArguments {
    std::string scene;
    int port = 0;
    int threads = 0;
    bool no_browser = false;
};

/// The scene's name from the folder one is in. Throws Error(ErrorKind::setting) if it lies outside.
std::string name_below_here(const std::string& scene) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path whole = fs::weakly_canonical(fs::current_path(failed) / scene, failed);
    const fs::path name = whole.lexically_relative(fs::canonical(".", failed));
    if (failed || name.empty() || *name.begin() == "..")
        throw Error(ErrorKind::setting,
                    fmt::format("{}: the studio opens scenes below the folder that it is started "
                                "in: start it there",
                                printable_path(scene)));
    return name.generic_string();
}

ExitCode run_studio(const StudioArguments& arguments) {
    StudioSettings settings;
    if (!arguments.scene.empty()) settings.scene = name_below_here(arguments.scene);
    settings.port = arguments.port;
    settings.threads = choose_threads(arguments.threads).threads;
    const Studio studio(settings);
    put_result(studio.address() + "\n");
    finish_results();
    if (!arguments.no_browser) {
        const bool opened = open_in_browser(studio.address_for_once());
        tell(fmt::format(
            "{} The studio ends {:g} seconds after its last page is closed, or with "
            "Ctrl-C.\n",
            opened ? "The browser shows it." : "Open it in a browser.", Studio::grace_seconds));
    } else {
        tell("Open it in a browser. The studio ends with Ctrl-C.\n");
    }
    while (!stop_requested() && (arguments.no_browser || !studio.is_deserted()))
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return received_signal() == 0 ? ExitCode::done : exit_code_of_signal(received_signal());
}

}  // namespace

AddedCommand add_studio_command(CommandLine& line) {
    const auto a = std::make_shared<StudioArguments>();
    CommandOptions command =
        line.add_command("studio", "Look at scenes and shape them, in a page of this computer");
    command.add_option("scene", a->scene, "The scene file (.pxm); without it: a gallery")
        .check(some_text());
    constexpr int last_port = 65'535;
    command.add_option("--port", a->port, "Of the loopback address; default: one that is free")
        .transform(whole_number(0, last_port));
    add_threads_option(command, a->threads);
    command.add_flag("--no-browser", a->no_browser,
                     "Open no browser, and go on when the page is closed");
    return {command, [a] { return run_studio(*a); }};
}

}  // namespace pxm::host
