// bench_node_profile WxH SCENE...: where the cycles of a node go, by the cost table and in DSP32
// code, for the same pictures: by what a pixel consists of, and by file of dsp_kernels/asm
// (docs/measurements/node-instructions.md). Scenes are rendered with balls and with constants by
// product, by one node that has all pixels.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "dsp_kernels/pixel_program.hpp"
#include "host/engine/assembled_node.hpp"
#include "host/node_program/assembled_program.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/render/render.hpp"
#include "host/render/render_options.hpp"
#include "pxm/cost.hpp"
#include "pxm/machine.hpp"

namespace {

using namespace pxm;
using namespace pxm::host;
using Real = dsp32::Float;
using DspNode = Node<Real>;

/// What a pixel consists of. `rest`: the loop over pixels, the sum of samples, the pixel's bytes.
enum Stage : std::size_t { eye_rays, search, shading, light, rest, stages };
constexpr std::array<const char*, stages> stage_names{"eye rays", "search", "path and normals",
                                                      "Lambert's law", "the rest"};
using StageCycles = std::array<std::uint64_t, stages>;

Model one_node(const PixelSize& size) {
    return {"one",
            1,
            1,
            Certainty::assumed,
            static_cast<int>(size.columns),
            static_cast<int>(size.rows),
            Certainty::assumed};
}

Machine<Real> loaded(const CompiledScene& scene, const Model& model) {
    Machine<Real> machine(model);
    const bool fits = !machine.open_frame(model.natural_width, model.natural_height) &&
                      !machine.broadcast(make_scene_block<Real>(scene));
    if (!fits) throw std::runtime_error("the picture or the scene is too large for one node");
    return machine;
}

std::uint64_t counted(const DspNode& node) { return cycles(node.tally(), default_cost_table()); }

/// The counted kernels, called one after the other as the node program calls them.
StageCycles count_stages(const CompiledScene& scene) {
    const Model model = one_node(scene.size);
    Machine<Real> machine = loaded(scene, model);
    DspNode& node = machine.nodes()[0];
    if (machine.load_program(0, 0) || machine.reserve_heap(256, sizeof(kernels::Cell<Real>)))
        throw std::runtime_error("no room for the heap");
    kernels::Heap<DspNode> heap(node);
    kernels::FrameConstants<Real> frame = kernels::read_frame_constants(node);
    StageCycles sum{};
    std::uint64_t before = counted(node);
    const auto end = [&](Stage stage) {
        const std::uint64_t now = counted(node);
        sum[stage] += now - before;
        before = now;
    };
    const auto columns = static_cast<std::uint32_t>(scene.size.columns);
    const auto rows = static_cast<std::uint32_t>(scene.size.rows);
    for (std::uint32_t y = 0; y < rows; ++y) {
        for (std::uint32_t x = 0; x < columns; ++x) {
            frame.search.ray = kernels::eye_ray(node, x, y, 0);
            end(eye_rays);
            kernels::SearchCounts counts;
            const auto found = kernels::first_cell(node, frame.search, heap, counts);
            end(search);
            if (found.outcome == kernels::Outcome::miss) continue;
            const kernels::Sighting<Real> sighting{frame.search, found.cell, 0};
            kernels::LitPlace<Real> lit;
            lit.surface = kernels::surface_at(node, sighting, frame.shading);
            lit.sighting = &sighting;
            end(shading);
            static_cast<void>(kernels::illuminate(node, lit, frame.shading,
                                                  [](std::uint32_t) { return Real(1); }));
            end(light);
        }
    }
    return sum;
}

/// All that the counted node program takes for a picture.
std::uint64_t count_all(const CompiledScene& scene) {
    EngineChoice choice;
    const Model model = one_node(scene.size);
    choice.machine = &model;
    choice.numeric = Numeric::dsp32;
    return run_on_machine(scene, choice, {}).machine->nodes[0].cycles;
}

struct Profile {
    StageCycles by_stage{};
    std::map<std::string_view, std::uint64_t> by_source;
};

/// The program in DSP32 code, an instruction at a time.
Profile profile(const CompiledScene& scene) {
    const Model model = one_node(scene.size);
    Machine<Real> machine = loaded(scene, model);
    AssembledNode node(machine.nodes()[0], scene, model,
                       {0, 0, scene.size.columns, scene.size.rows});
    const AssembledProgram& program = assembled_program(scene);
    const std::map<std::uint32_t, Stage> starts{{program.address_of("eye_ray"), eye_rays},
                                                {program.address_of("search"), search},
                                                {program.address_of("walk"), shading},
                                                {program.address_of("lambert"), light},
                                                {program.address_of("program_sample_done"), rest}};
    Profile result;
    Stage stage = rest;
    NodeEvent event = NodeEvent::working;
    while (event != NodeEvent::done) {
        const std::uint32_t address = node.program_counter();
        if (const auto start = starts.find(address); start != starts.end()) stage = start->second;
        const std::uint64_t before = node.cycles();
        event = node.go_on(1);
        if (event != NodeEvent::working && event != NodeEvent::done)
            throw std::runtime_error("the program does not come to its end");
        result.by_stage[stage] += node.cycles() - before;
        result.by_source[program.source_of(address)] += node.cycles() - before;
    }
    return result;
}

CompiledScene compiled(const std::string& path, const char* size) {
    RenderRequest request;
    request.scene_path = path;
    request.overrides.size = parse_size(size);
    request.overrides.volume = VolumeKind::sphere;
    request.overrides.lipschitz = LipschitzMethod::product;
    CompiledScene scene = compiled_scene_of(request);
    const std::string beyond =
        beyond_assembled_program(scene, Numeric::dsp32, make_scene_block<Real>(scene).size());
    if (!beyond.empty()) throw std::runtime_error(path + " has " + beyond);
    return scene;
}

void print_row(const std::string& scene, const char* what, std::uint64_t by_table,
               std::uint64_t in_code) {
    std::fputs(fmt::format("| {} | {} | {} | {} | {:.2f} |\n", scene, what, by_table, in_code,
                           static_cast<double>(in_code) / static_cast<double>(by_table))
                   .c_str(),
               stdout);
}

void print_profile(const std::string& path, const char* size,
                   std::map<std::string_view, std::uint64_t>& by_source) {
    const CompiledScene scene = compiled(path, size);
    StageCycles table = count_stages(scene);
    const std::uint64_t all = count_all(scene);
    std::uint64_t inside = 0, in_code = 0;
    for (const std::uint64_t cycles : table) inside += cycles;
    table[rest] = all - inside;
    const Profile own = profile(scene);
    const auto name_at = path.find_last_of('/') + 1;
    const std::string name = path.substr(name_at, path.find('.', name_at) - name_at);
    for (std::size_t stage = 0; stage < stages; ++stage) {
        in_code += own.by_stage[stage];
        print_row(name, stage_names[stage], table[stage], own.by_stage[stage]);
    }
    print_row(name, "all", all, in_code);
    for (const auto& [source, cycles] : own.by_source) by_source[source] += cycles;
}

}  // namespace

int main(int count, char** words) try {
    std::puts("| scene | what | cycles, cost table | cycles, DSP32 code | ratio |");
    std::puts("| --- | --- | ---: | ---: | ---: |");
    std::map<std::string_view, std::uint64_t> by_source;
    for (int i = 2; i < count; ++i) print_profile(words[i], words[1], by_source);
    std::uint64_t all = 0;
    for (const auto& [source, cycles] : by_source) all += cycles;
    std::puts("\n| file | bytes | share of the cycles |\n| --- | ---: | ---: |");
    const AssembledProgram program(kernels::Volume::sphere);
    for (const ProgramModule& module : program.sizes().modules)
        std::fputs(fmt::format(
                       "| `{}` | {} | {:.1f} % |\n", module.name, module.bytes,
                       100 * static_cast<double>(by_source[module.name]) / static_cast<double>(all))
                       .c_str(),
                   stdout);
    return 0;
} catch (const std::exception& error) {
    std::fputs(fmt::format("{}\n", error.what()).c_str(), stderr);
    return 1;
}
