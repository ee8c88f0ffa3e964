#include "host/inspect/node_needs.hpp"

#include <algorithm>

#include "dsp_kernels/cell.hpp"
#include "host/compile/compile.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "pxm/frame_buffer.hpp"
#include "pxm/model.hpp"
#include "pxm/real.hpp"

namespace pxm::host {

namespace {

constexpr const char* inspected_model = "964dX";  // the machine of the thesis (Ch. 19)
constexpr std::int64_t word_bytes = 4;

MachineStatistics memory_of(const CompiledScene& scene, const Model& model) {
    const auto entry = static_cast<std::int64_t>(sizeof(kernels::Cell<dsp32::Float>));
    const auto block = static_cast<std::int64_t>(make_scene_block<dsp32::Float>(scene).size());
    MachineStatistics memory;
    // Node (0, 0) owns the most pixels.
    memory.front_buffer = {
        bank_bytes, word_bytes * owned_pixels(model, {}, static_cast<int>(scene.size.columns),
                                              static_cast<int>(scene.size.rows))};
    memory.back_buffer = {bank_bytes, word_bytes * block};
    memory.zbuffer = {zbuffer_part_bytes, entry * scene.heap};
    memory.texture = {texture_part_bytes,
                      word_bytes * static_cast<std::int64_t>(scene.texture_words.size())};
    return memory;
}

bool is_over(const MemoryUse& use) { return use.used_bytes > use.limit_bytes; }

}  // namespace

NodeNeeds node_needs(const Scene& scene, Diagnostics& diagnostics) {
    NodeNeeds needs;
    needs.model = inspected_model;
    const CompiledScene compiled = compile(scene, 1, diagnostics);
    if (diagnostics.has_errors()) return needs;
    needs.program = link(compiled);
    needs.rerooted = rerooted(compiled);
    needs.native = wide::object_methods(compiled);
    needs.memory = memory_of(compiled, *find_model(inspected_model));
    needs.memory.fast_memory = {fast_memory_bytes, needs.program.used_bytes()};
    needs.over_limit = is_over(needs.memory.fast_memory) || is_over(needs.memory.front_buffer) ||
                       is_over(needs.memory.back_buffer) || is_over(needs.memory.zbuffer) ||
                       is_over(needs.memory.texture);
    return needs;
}

}  // namespace pxm::host
