// `pxm models`: the members of the family and the memories of a node, every number with a mark that
// says how surely it is known (docs/machine.md). `--token MODEL` runs the diagnostic program of the
// torus links.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "dsp_kernels/token_program.hpp"
#include "host/commands/cmd.hpp"
#include "host/process/granted_threads.hpp"
#include "host/process/terminal.hpp"
#include "host/render/render_options.hpp"
#include "host/text/json_text.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

struct ModelsArguments {
    bool json = false;
    std::string token;
};

struct Mark {
    Certainty certainty;
    const char* meaning;
};
constexpr std::array<Mark, 4> marks{{{Certainty::seen, "seen in a source"},
                                     {Certainty::derived, "derived from sources by arithmetic"},
                                     {Certainty::recalled, "recalled, no source seen"},
                                     {Certainty::assumed, "assumed for the emulation"}}};

std::string letter(Certainty certainty) { return {static_cast<char>(certainty)}; }

std::string with_mark(const std::string& number, Certainty certainty) {
    return number + " " + letter(certainty);
}

std::string models_text() {
    std::string text = fmt::format("{:<7} {:>10} {:>7} {:>15} {:>12}\n", "model", "array", "nodes",
                                   "natural raster", "pixels/node");
    for (const Model& m : models()) {
        text += fmt::format("{:<7} {:>10} {:>7} {:>15} {:>12}\n", m.name,
                            with_mark(fmt::format("{} x {}", m.columns, m.rows), m.array_certainty),
                            with_mark(fmt::format("{}", m.nodes()), m.array_certainty),
                            with_mark(fmt::format("{} x {}", m.natural_width, m.natural_height),
                                      m.raster_certainty),
                            with_mark(fmt::format("{}", m.pixels_per_node()), Certainty::derived));
    }
    text += fmt::format("\n{:<13} {:>10}   every node's, in all models\n", "memory", "bytes");
    for (const Memory& memory : node_memories) {
        text +=
            fmt::format("{:<13} {:>10}   {}\n", memory.name,
                        with_mark(fmt::format("{}", memory.bytes), memory.certainty), memory.use);
    }
    text += fmt::format("\none instruction cycle: {:.0f} ns D\n\n", instruction_seconds * 1e9);
    for (const Mark& mark : marks) text += letter(mark.certainty) + "  " + mark.meaning + "\n";
    return text;
}

Json model_json(const Model& m) {
    return {{"name", m.name},
            {"array",
             {{"columns", m.columns},
              {"rows", m.rows},
              {"nodes", m.nodes()},
              {"mark", letter(m.array_certainty)}}},
            {"natural_raster",
             {{"width", m.natural_width},
              {"height", m.natural_height},
              {"mark", letter(m.raster_certainty)}}},
            {"pixels_per_node",
             {{"value", m.pixels_per_node()}, {"mark", letter(Certainty::derived)}}}};
}

std::string models_json() {
    Json json;
    for (const Model& model : models()) json["models"].push_back(model_json(model));
    for (const Memory& memory : node_memories) {
        json["memories"].push_back({{"name", memory.name},
                                    {"bytes", memory.bytes},
                                    {"mark", letter(memory.certainty)},
                                    {"use", memory.use}});
    }
    json["cycle_seconds"] = {{"value", instruction_seconds}, {"mark", letter(Certainty::derived)}};
    for (const Mark& mark : marks) json["marks"][letter(mark.certainty)] = mark.meaning;
    return json_text(json, 2) + "\n";
}

/// Sends the token round the model's torus.
ExitCode send_token(const Model& model) {
    std::vector<kernels::TokenNode> nodes;
    for (int i = 0; i < model.nodes(); ++i) {
        nodes.emplace_back(i % model.columns, i / model.columns, model.columns, model.rows);
    }
    Torus torus(model);
    const auto steps = run_supersteps(
        torus,
        [&](int node, Ports& ports) { return nodes[static_cast<std::size_t>(node)].step(ports); },
        granted_threads().threads, 4 * model.nodes());
    const auto home = nodes.front().home();
    if (!steps || !home) throw Error(ErrorKind::failed, "the token did not come home");
    put_result(fmt::format(
        "{}: the token visited {} of {} nodes over {} links and was home after {} supersteps\n",
        model.name, home->visited, model.nodes(), home->hops, *steps));
    return ExitCode::done;
}

}  // namespace

AddedCommand add_models_command(CommandLine& line) {
    const auto a = std::make_shared<ModelsArguments>();
    CommandOptions command = line.add_command("models", "The machine models and their memories");
    const Option json = command.add_flag("--json", a->json, "As JSON");
    command.add_option("--token", a->token, "Send a token round the torus links of this model")
        .excludes(json);
    return {command, [a] {
                if (!a->token.empty()) return send_token(parse_model("--token", a->token));
                put_result(a->json ? models_json() : models_text());
                return ExitCode::done;
            }};
}

}  // namespace pxm::host
