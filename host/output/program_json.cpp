#include "host/output/program_json.hpp"

#include "pxm/model.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

Json modules_json(const std::vector<ProgramModule>& modules) {
    Json list = Json::array();
    for (const ProgramModule& module : modules) {
        list.push_back(
            {{"name", module.name}, {"bytes", module.bytes}, {"because", module.because}});
    }
    return list;
}

}  // namespace

Json program_json(const NodeProgram& program) {
    return {
        {"limit_bytes", fast_memory_bytes},         {"used_bytes", program.used_bytes()},
        {"modules_bytes", program.modules_bytes()}, {"heap_order_bytes", program.heap_order_bytes},
        {"stack_bytes", program.stack_bytes},       {"deepest_calls", program.deepest_calls},
        {"modules", modules_json(program.modules)}, {"left_out", modules_json(program.left_out)}};
}

}  // namespace pxm::host
