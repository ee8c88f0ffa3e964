#include "host/commands/help.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <iterator>

namespace pxm::host {

namespace {

constexpr Example examples[] = {
    {"", "pxm render tetra", "a scene that came with pxm, to tetra.png"},
    {"", "pxm render my.pxm -o my.exr --size 1920x1080 --samples 4", "one of yours"},
    {"render", "pxm render menger --size 1280x960", "a picture, menger.png"},
    {"render", "pxm render tetra --machine 964dX --stats tetra.json",
     "on the simulated machine, with its counts"},
    {"join", "pxm join parts -o tetra.png", "the picture of the parts in a folder"},
    {"join", "pxm join parts -o tetra.exr --stats tetra.json", "with the counts of all parts"},
    {"check", "pxm check tetra menger", "says nothing if all is well"},
    {"check", "pxm check my.pxm --format", "the scene as pxm lays it out"},
    {"inspect", "pxm inspect menger", "its contraction, dimension, bounds, and needs of a node"},
    {"inspect", "pxm inspect menger --json -o menger.json", "the same for programs"},
    {"points", "pxm points tetra -n 1000000 -o tetra.ply", "a million points"},
    {"points", "pxm points tetra -n 1000 --seed 7 -o other.ply", "a thousand others"},
    {"import", "pxm import fractint.ifs --entry fern", "one entry, to fern.pxm"},
    {"import", "pxm import leaf.png --maps 6 -o leaf.pxm", "six maps that make about this picture"},
    {"export", "pxm export menger -o menger.glb --levels 3", "8,000 cubes as instances"},
    {"export", "pxm export menger -o menger.stl --levels 2 --scale 30", "for a printer, in mm"},
    {"compare", "pxm compare a.exr b.exr", "exit code 0 if no pixel differs"},
    {"compare", "pxm compare a.exr b.exr --tolerance 0.001", "one in a thousand may differ"},
    {"study", "pxm study balance menger tetra -o report", "who waits for whom on the machine"},
    {"study", "pxm study error tetra -o report --budget 2", "the most exact picture in 2 seconds"},
    {"models", "pxm models", "the members of the family"},
    {"models", "pxm models --token 964dX", "a token round the links of one"},
    {"asm", "pxm asm sum.s -o sum.o --list", "an object, and its words beside the source"},
    {"asm", "pxm asm sum.s --run main --trace", "every instruction of a run"},
    {"studio", "pxm studio", "the gallery, in the browser"},
    {"studio", "pxm studio my.pxm --port 8080 --no-browser", "one of yours, until it is ended"},
    {"completion", "pxm completion bash > ~/.local/share/bash-completion/completions/pxm",
     "for every bash of yours from now on"},
    {"completion", "pxm completion fish > ~/.config/fish/completions/pxm.fish", "for fish"},
};

constexpr int of_signal(int signal) { return static_cast<int>(exit_code_of_signal(signal)); }

std::string examples_text(std::string_view command) {
    const std::vector<Example> shown = examples_of(command);
    std::size_t width = 0;
    for (const Example& example : shown) width = std::max(width, example.line.size());
    std::string text;
    for (const Example& example : shown)
        text += fmt::format("{:<{}}  # {}\n", example.line, width, example.what);
    return text.empty() ? text : text + "\n";
}

std::string read_on(std::string_view command) {
    const std::string page = command.empty() ? "pxm" : fmt::format("pxm-{}", command);
    return fmt::format("Read on: man {}, man 5 pxm-scene; docs/command-line.md\n", page);
}

}  // namespace

std::vector<Example> examples_of(std::string_view command) {
    std::vector<Example> found;
    std::ranges::copy_if(examples, std::back_inserter(found),
                         [&](const Example& example) { return example.command == command; });
    return found;
}

const std::vector<ExitCodeMeaning>& exit_code_meanings() {
    static const std::vector<ExitCodeMeaning> meanings{
        {0, "done"},
        {1, "the run failed: out of memory, an internal error"},
        {2, "the command line is wrong, or a file that is read would be written over"},
        {3, "the scene is wrong, or the source of a program"},
        {4, "a file could not be read or written"},
        {5, "a limit of the simulated machine was exceeded"},
        {6, "compare: more than the tolerance differs"},
        {7, "join: parts are missing; or --limit-seconds or --limit-memory ended the run"},
        {of_signal(SIGHUP), "ended by SIGHUP"},
        {of_signal(SIGINT), "ended by Ctrl-C"},
        {of_signal(SIGTERM), "ended by SIGTERM"},
        {of_signal(SIGXCPU), "ended by SIGXCPU (ulimit -t)"},
    };
    return meanings;
}

std::string help_text(std::string_view command, std::string options) {
    while (options.ends_with('\n')) options.pop_back();
    std::string text = examples_text(command) + options + "\n\nExit codes:\n";
    for (const ExitCodeMeaning& one : exit_code_meanings())
        text += fmt::format("  {:<4}{}\n", one.code, one.meaning);
    return text + "\n" + read_on(command);
}

}  // namespace pxm::host
