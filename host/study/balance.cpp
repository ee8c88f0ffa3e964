// The balance study: from the cycles of every pixel of one render, who waits for whom under each
// way of sharing the pixels out, on each model, and with 1 to 65,536 nodes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/output/image.hpp"
#include "host/study/page/balance_page.hpp"
#include "host/study/partition.hpp"
#include "host/study/study_scene.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

namespace {

constexpr long most_nodes = 65'536;
constexpr long tile_sides[] = {1, 2, 4, 8, 16, 32, 64};
constexpr long hover_cells = 64;           // a side
constexpr double dark_percentile = 0.995;  // of the picture of cycles: a few pixels outshine all

Json share_json(const Share& share) {
    return {{"efficiency", share.efficiency()},
            {"predicted_seconds", share.seconds()},
            {"speed_up", share.speed_up()},
            {"overhead_share", share.useful == 0 ? 0.0
                                                 : static_cast<double>(share.overhead) /
                                                       static_cast<double>(share.useful)}};
}

Json partitions_json(const Work& work, const NodeArray& array) {
    Json json = Json::object();
    for (const Partition partition : all_partitions)
        json[std::string(name_of(partition))] = share_json(share_out(work, array, partition));
    return json;
}

Json models_json(const Work& work) {
    Json json = Json::array();
    for (const Model& model : models()) {
        Json one = {{"model", model.name}, {"nodes", model.nodes()}};
        one.update(
            share_json(share_out(work, {model.columns, model.rows}, Partition::interleaved)));
        json.push_back(one);
    }
    return json;
}

Json curve_json(const Work& work) {
    Json json = Json::array();
    for (const Partition partition : all_partitions) {
        for (long nodes = 1; nodes <= most_nodes; nodes *= 2) {
            Json one = {{"nodes", nodes}, {"partition", name_of(partition)}};
            one.update(share_json(share_out(work, array_of(nodes), partition)));
            json.push_back(one);
        }
    }
    return json;
}

Json tiles_json(const Work& work, const NodeArray& array) {
    Json json = Json::array();
    for (const long side : tile_sides) {
        HandOutCosts costs;
        costs.tile = side;
        Json one = {{"tile", side}};
        one.update(share_json(share_out(work, array, Partition::dynamic, costs)));
        json.push_back(one);
    }
    return json;
}

std::uint64_t rays_of(const RayStatistics& rays) {
    return rays.eye_rays + rays.light_rays + rays.reflect_rays;
}

Json nodes_json(const MachineStatistics& machine) {
    Json json = Json::array();
    for (const NodeStatistics& node : machine.nodes) {
        json.push_back({{"id", node.id},
                        {"column", node.column},
                        {"row", node.row},
                        {"pixels", node.rays.pixels},
                        {"rays", rays_of(node.rays)},
                        {"volumes_tested", node.rays.volumes_tested},
                        {"heap_peak", node.rays.heap_peak},
                        {"cycles", node.cycles}});
    }
    return json;
}

std::vector<double> cycles_of(const Frame& frame) {
    std::vector<double> values;
    for (const PixelRecord& pixel : frame.pixels)
        values.push_back(static_cast<double>(pixel.cycles));
    return values;
}

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

/// The picture and its cycles as files; how they are called, and the cycles under the pointer.
Json pictures_json(const Frame& frame, const std::string& name, const std::string& folder) {
    const std::vector<double> cycles = cycles_of(frame);
    const double dark = percentile(cycles, dark_percentile);
    const double light = *std::ranges::min_element(cycles);
    write_image(folder + "/" + name + ".png", frame, {}, {});
    write_value_picture(folder + "/" + name + "-cycles.png", frame, cycles, light, dark);
    return {{"picture", name + ".png"},
            {"cycles_picture", name + "-cycles.png"},
            {"cycles_light", light},
            {"cycles_dark", dark},
            {"cycles_grid", json_of(coarse_grid(frame, cycles, hover_cells))}};
}

Json measure_scene(const RenderRequest& request, const std::string& name,
                   const UnitControl& control) {
    const RenderResult result = render_unit(request, control);
    const Frame& frame = result.frame;
    const Statistics& s = result.statistics;
    std::vector<std::uint64_t> cycles;
    for (const PixelRecord& pixel : frame.pixels) cycles.push_back(pixel.cycles);
    const Work work(frame.columns(), frame.rows(), std::move(cycles));
    const NodeArray array{request.machine->columns, request.machine->rows};
    const Share own = share_out(work, array, Partition::interleaved);

    Json json = {{"scene", request.scene_path},
                 {"model", request.machine->name},
                 {"numeric", s.numeric},
                 {"size", {frame.columns(), frame.rows()}},
                 {"pixels", s.rays.pixels},
                 {"rays", rays_of(s.rays)},
                 {"hits", s.rays.hits},
                 {"volumes_tested", s.rays.volumes_tested},
                 {"cycles", own.useful},
                 {"cycles_per_pixel",
                  static_cast<double>(own.useful) / static_cast<double>(frame.pixels.size())}};
    json.update(share_json(own));
    json["host"] = {{"render_seconds", s.seconds.render},
                    {"threads", s.threads},
                    {"what", "host time of this one render; not comparable with other runs"}};
    json["partitions"] = partitions_json(work, array);
    json["models"] = models_json(work);
    json["tiles"] = tiles_json(work, array);
    json["curve"] = curve_json(work);
    json["nodes"] = nodes_json(*s.machine);
    json.update(pictures_json(frame, name, control.folder));
    return json;
}

Json costs_json() {
    const HandOutCosts costs;
    return {{"gather_cycles_per_pixel", costs.gather},
            {"hand_out_cycles_per_tile", costs.hand_out},
            {"tile_pixels", costs.tile}};
}

}  // namespace

StudyPlan plan_balance(const StudyRequest& request) {
    if (request.scenes.empty())
        throw Error(ErrorKind::setting, "study balance: give it at least one scene");
    StudyPlan plan;
    const std::vector<std::string> names = file_names_of(request.scenes);
    for (std::size_t i = 0; i < names.size(); ++i) {
        RenderRequest render;
        render.scene_path = request.scenes[i];
        render.settings = request.settings;
        render.allowed = request.allowed;
        render.overrides.size = request.size;
        render.overrides.numeric = request.numeric;
        render.machine = request.machine ? request.machine : find_model("964dX");
        render.threads = request.threads;
        Json settings = {
            {"study", "balance"},
            {"pxm", PXM_VERSION},
            {"scene", render.scene_path},
            {"content", fingerprint_of(render.scene_path, request.settings, render.allowed)},
            {"model", render.machine->name},
            {"numeric", request.numeric ? static_cast<int>(*request.numeric) : -1},
            {"costs", costs_json()}};
        settings["size"] =
            request.size ? Json{request.size->columns, request.size->rows} : Json(nullptr);
        plan.units.push_back({names[i], settings, [=, name = names[i]](const UnitControl& control) {
                                  return measure_scene(render, name, control);
                              }});
    }
    plan.assemble = [](const std::vector<Json>& results) {
        Json data = {{"costs", costs_json()}, {"scenes", Json::array()}};
        for (const Json& result : results) data["scenes"].push_back(result);
        return data;
    };
    plan.tables = balance_tables;
    plan.page = balance_page;
    return plan;
}

}  // namespace pxm::host
