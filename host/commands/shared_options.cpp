#include "host/commands/shared_options.hpp"

#include <limits>
#include <optional>

#include "host/commands/option_checks.hpp"
#include "host/process/granted_threads.hpp"
#include "host/scene/scene_path.hpp"

namespace pxm::host {

void add_threads_option(CommandOptions& command, int& threads) {
    command
        .add_option("--threads", threads,
                    "Host threads; default: the cores that the process may use")
        .transform(whole_number(1, most_threads));
}

void add_set_option(CommandOptions& command, std::vector<std::string>& texts) {
    command
        .add_option("--set", texts,
                    "NAME=NUMBER of a `let`, or BLOCK.DIRECTIVE=VALUE, as camera.fov=30 or "
                    "object.elm.levels=5; any number of times")
        .one_value();
}

void add_allow_option(CommandOptions& command, std::vector<std::string>& folders) {
    command
        .add_option("--allow", folders,
                    "Scenes may include files and show pictures of this folder too; default: "
                    "their own folder only. May be given again")
        .one_value()  // what follows DIR is another argument
        .check(some_text());
}

void add_limit_options(CommandOptions& command, LimitArguments& limits) {
    command
        .add_option("--limit-seconds", limits.seconds,
                    "End the run after so long, with what is done so far")
        .transform(positive_number());
    command
        .add_option("--limit-memory", limits.memory_bytes,
                    "End the run when it holds more bytes; default: 3/4 of the memory that the "
                    "process may use")
        .transform(whole_number(1, std::numeric_limits<long>::max()));
}

void find_scene_by_name(std::string& scene, std::vector<std::string>& folders) {
    const std::optional<FoundScene> found = find_scene(scene);
    if (!found) return;
    scene = found->path;
    if (!found->folder.empty()) folders.push_back(found->folder);
}

}  // namespace pxm::host
