#include "host/output/statistics_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/output/program_json.hpp"
#include "host/text/json_text.hpp"
#include "pxm/cost.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

/// Executions by kind of operation.
Json operations_json(const Tally& tally) {
    Json json = Json::object();
    for (std::size_t i = 0; i < operation_count; ++i) {
        json[std::string(operation_names[i])] = tally.counts[i];
    }
    return json;
}

/// The same with the cycles they stand for.
Json operation_cycles_json(const Tally& tally, const CostTable& table) {
    Json json = Json::object();
    for (std::size_t i = 0; i < operation_count; ++i) {
        const double each = table.cycles_of(static_cast<Operation>(i));
        json[std::string(operation_names[i])] = {
            {"count", tally.counts[i]},
            {"cycles_each", each},
            {"cycles", static_cast<double>(tally.counts[i]) * each}};
    }
    return json;
}

Json cost_model_json(const CostModel& costs) {
    return {{"name", costs.name},
            {"plain_share", costs.table.plain_share},
            {"compiled_code_factor", costs.table.compiled_code_factor},
            {"seconds_per_cycle", instruction_seconds}};
}

Json node_json(const NodeStatistics& node) {
    return {{"id", node.id},
            {"column", node.column},
            {"row", node.row},
            {"pixels", node.rays.pixels},
            {"rays", node.rays.eye_rays + node.rays.light_rays + node.rays.reflect_rays},
            {"volumes_tested", node.rays.volumes_tested},
            {"heap_pushes", node.rays.heap_pushes},
            {"heap_peak", node.rays.heap_peak},
            {"heap_overflows", node.rays.heap_overflows},
            {"capped_rays", node.rays.capped_rays},
            {"operations", operations_json(node.tally)},
            {"instructions", node.instructions},
            {"cycles", node.cycles},
            {"seconds", static_cast<double>(node.cycles) * instruction_seconds}};
}

Json memory_json(const MemoryUse& use) {
    return {{"limit_bytes", use.limit_bytes}, {"used_bytes", use.used_bytes}};
}

Json balance_json(const std::vector<NodeStatistics>& nodes) {
    std::uint64_t largest = 0;
    double sum = 0;
    for (const NodeStatistics& node : nodes) {
        largest = std::max(largest, node.cycles);
        sum += static_cast<double>(node.cycles);
    }
    const double mean = nodes.empty() ? 0 : sum / static_cast<double>(nodes.size());
    return {{"mean_cycles", mean},
            {"max_cycles", largest},
            {"efficiency", largest == 0 ? 1.0 : mean / static_cast<double>(largest)},
            {"predicted_seconds", static_cast<double>(largest) * instruction_seconds}};
}

}  // namespace

std::string statistics_json(const Statistics& s) {
    Json json = {{"pxm", PXM_VERSION}, {"scene", s.scene}, {"engine", s.engine}};
    json["model"] = s.machine ? Json(s.model) : Json(nullptr);
    json["numeric"] = s.numeric;
    json["size"] = {s.size.columns, s.size.rows};
    json["threads"] = s.threads;
    json["threads_because"] = s.threads_because;
    json["seconds"] = {{"parse", s.seconds.parse},   {"compile", s.seconds.compile},
                       {"load", s.seconds.load},     {"render", s.seconds.render},
                       {"encode", s.seconds.encode}, {"write", s.seconds.write},
                       {"total", s.seconds.total}};
    json["intersect"] = {{"method", s.intersect}, {"because", s.intersect_because}};
    json["rerooted"] = {{"objects", s.rerooted.objects}, {"levels", s.rerooted.levels}};
    json["rays"] = {
        {"eye", s.rays.eye_rays}, {"light", s.rays.light_rays}, {"reflect", s.rays.reflect_rays}};
    json["hits"] = s.rays.hits;
    json["volumes_tested"] = s.rays.volumes_tested;
    json["heap_overflows"] = s.rays.heap_overflows;
    json["heap_restarts"] = s.rays.restarts;
    json["capped_rays"] = s.rays.capped_rays;
    json["alarms"] = Json::object();
    for (const Alarm& alarm : s.alarms) json["alarms"][alarm.name] = alarm.count;
    json["scene_block"] = {{"words", s.scene_block_words},
                           {"hash", fmt::format("{:016x}", s.scene_block_hash)}};
    if (!s.machine) return json_text(json, 2) + "\n";

    json["program"] = program_json(s.program);
    json["memory"] = {{"fast_memory", memory_json(s.machine->fast_memory)},
                      {"front_buffer", memory_json(s.machine->front_buffer)},
                      {"back_buffer", memory_json(s.machine->back_buffer)},
                      {"zbuffer", memory_json(s.machine->zbuffer)},
                      {"texture", memory_json(s.machine->texture)}};
    json["cost_model"] = cost_model_json(s.machine->costs);
    json["operations"] = operation_cycles_json(s.machine->tally, s.machine->costs.table);
    json["nodes"] = Json::array();
    for (const NodeStatistics& node : s.machine->nodes) json["nodes"].push_back(node_json(node));
    json["balance"] = balance_json(s.machine->nodes);
    return json_text(json, 2) + "\n";
}

}  // namespace pxm::host
