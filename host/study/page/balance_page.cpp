#include "host/study/page/balance_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/study/page/page.hpp"
#include "host/study/page/plot.hpp"
#include "host/study/partition.hpp"
#include "host/study/study_scene.hpp"

namespace pxm::host {

namespace {

double real(const Json& json, const char* key) { return json.at(key).get<double>(); }
std::string text(const Json& json, const char* key) { return json.at(key).get<std::string>(); }

std::string as_written(const Json& json, const char* key) {
    const Json& value = json.at(key);
    return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string per_cent(double share) { return fmt::format("{:.1f} %", 100 * share); }

PageTable scene_table(const Json& data) {
    PageTable table{{"scene", "hits", "cycles a pixel", "predicted s", "speed-up"}, {}};
    for (const Partition p : all_partitions) table.columns.emplace_back(name_of(p));
    for (const Json& scene : data["scenes"]) {
        std::vector<std::string> row{stem_of(text(scene, "scene")),
                                     per_cent(real(scene, "hits") / real(scene, "pixels")),
                                     number_text(real(scene, "cycles_per_pixel")),
                                     fmt::format("{:.2f}", real(scene, "predicted_seconds")),
                                     fmt::format("{:.1f}", real(scene, "speed_up"))};
        for (const Partition p : all_partitions) {
            const Json& one = scene["partitions"][std::string(name_of(p))];
            row.push_back(per_cent(real(one, "efficiency")));
        }
        table.rows.push_back(row);
    }
    return table;
}

PageTable partition_table(const Json& scene) {
    PageTable table{{"partition", "efficiency", "predicted s", "speed-up", "overhead"}, {}};
    for (const auto& [name, one] : scene["partitions"].items()) {
        table.rows.push_back({name, per_cent(real(one, "efficiency")),
                              fmt::format("{:.3f}", real(one, "predicted_seconds")),
                              fmt::format("{:.2f}", real(one, "speed_up")),
                              per_cent(real(one, "overhead_share"))});
    }
    return table;
}

PageTable model_table(const Json& scene) {
    PageTable table{{"model", "nodes", "efficiency", "predicted s", "speed-up"}, {}};
    for (const Json& one : scene["models"]) {
        table.rows.push_back({text(one, "model"), number_text(real(one, "nodes")),
                              per_cent(real(one, "efficiency")),
                              fmt::format("{:.3f}", real(one, "predicted_seconds")),
                              fmt::format("{:.2f}", real(one, "speed_up"))});
    }
    return table;
}

PageTable tile_table(const Json& scene) {
    PageTable table{{"tile", "efficiency", "predicted s", "overhead"}, {}};
    for (const Json& one : scene["tiles"]) {
        table.rows.push_back({fmt::format("{0} x {0}", one.at("tile").get<long>()),
                              per_cent(real(one, "efficiency")),
                              fmt::format("{:.3f}", real(one, "predicted_seconds")),
                              per_cent(real(one, "overhead_share"))});
    }
    return table;
}

std::string node_map(const Json& scene, const char* title, const char* key, const char* unit) {
    HeatMap map{title, unit, 0, 0, {}};
    for (const Json& node : scene["nodes"]) {
        map.columns = std::max(map.columns, node.at("column").get<long>() + 1);
        map.rows = std::max(map.rows, node.at("row").get<long>() + 1);
        map.values.push_back(real(node, key));
    }
    return svg_of(map);
}

std::string sorted_bars(const Json& scene) {
    std::vector<Json> nodes(scene["nodes"].begin(), scene["nodes"].end());
    std::ranges::stable_sort(
        nodes, [](const Json& a, const Json& b) { return real(a, "cycles") > real(b, "cycles"); });
    BarPlot plot;
    plot.title = "Cycles of the nodes, most first";
    plot.y.label = "cycles (of 200 ns)";
    plot.x_label = "nodes";
    for (const Json& node : nodes) {
        plot.bars.push_back(
            {real(node, "cycles"),
             fmt::format("node {},{}\n{} cycles\n{} pixels, {} volumes tested",
                         as_written(node, "column"), as_written(node, "row"),
                         number_text(real(node, "cycles")), number_text(real(node, "pixels")),
                         number_text(real(node, "volumes_tested")))});
    }
    return svg_of(plot);
}

std::string curve(const Json& scene) {
    LinePlot plot;
    plot.title = "Efficiency as nodes get many";
    plot.x.label = "nodes";
    plot.x.scale = AxisScale::logarithmic;
    plot.x.ticks = {1, 4, 16, 64, 256, 1024, 4096, 16384, 65536};
    plot.y.label = "efficiency";
    plot.y.low = 0;
    plot.y.high = 1;
    for (const Partition p : all_partitions) plot.series.push_back({std::string(name_of(p)), {}});
    for (const Json& one : scene["curve"]) {
        const auto series =
            std::ranges::find(plot.series, text(one, "partition"), &PlotSeries::name);
        series->points.push_back(
            {real(one, "nodes"), real(one, "efficiency"),
             fmt::format("{}, {} nodes\nefficiency {:.3f}\nspeed-up {:.1f}, {:.4g} s", series->name,
                         number_text(real(one, "nodes")), real(one, "efficiency"),
                         real(one, "speed_up"), real(one, "predicted_seconds")),
             real(one, "nodes") == 64});
    }
    return svg_of(plot);
}

void add_scene(Page& page, const Json& scene, const std::string& folder) {
    page.heading(stem_of(text(scene, "scene")));
    page.paragraph(fmt::format(
        "{} on the {} in {}, {} x {} pixels, {} of them hit. {} volumes were tested in {} cycles. "
        "The slowest of the nodes needs {:.3f} s, the mean node {} of that. (This render took "
        "{:.2f} s of host time on {} threads; host time is of this run alone.)",
        text(scene, "scene"), text(scene, "model"), text(scene, "numeric"), scene["size"][0].dump(),
        scene["size"][1].dump(), number_text(real(scene, "hits")),
        number_text(real(scene, "volumes_tested")), number_text(real(scene, "cycles")),
        real(scene, "predicted_seconds"), per_cent(real(scene, "efficiency")),
        real(scene["host"], "render_seconds"), scene["host"]["threads"].dump()));
    const CoarseGrid grid = grid_of(scene["cycles_grid"]);
    page.row({Page::figure({"The picture", folder + "/" + text(scene, "picture"), 0, 0, {}, ""}),
              Page::figure({fmt::format("Cycles of every pixel, light {} to dark {}",
                                        number_text(real(scene, "cycles_light")),
                                        number_text(real(scene, "cycles_dark"))),
                            folder + "/" + text(scene, "cycles_picture"), grid.columns, grid.rows,
                            grid.values, "cycles a pixel"})});
    page.row({node_map(scene, "Cycles", "cycles", "cycles"),
              node_map(scene, "Rays", "rays", "rays"),
              node_map(scene, "Volumes tested", "volumes_tested", "volumes"),
              node_map(scene, "Most cells in the heap", "heap_peak", "cells")});
    page.plot(sorted_bars(scene));
    page.subheading("Who computes which pixel");
    page.table(partition_table(scene));
    page.plot(curve(scene));
    page.subheading("The models, interleaved");
    page.table(model_table(scene));
    page.subheading("Tiles handed out to whoever is free");
    page.table(tile_table(scene));
}

}  // namespace

std::vector<TextFile> balance_tables(const Json& data) {
    PageTable scenes{{"scene", "model", "numeric", "columns", "rows", "hits", "cycles",
                      "predicted_seconds", "efficiency", "speed_up"},
                     {}};
    PageTable nodes{{"scene", "node", "column", "row", "pixels", "rays", "volumes_tested",
                     "heap_peak", "cycles"},
                    {}};
    PageTable curves{{"scene", "partition", "nodes", "efficiency", "predicted_seconds", "speed_up",
                      "overhead_share"},
                     {}};
    for (const Json& s : data["scenes"]) {
        const std::string name = text(s, "scene");
        scenes.rows.push_back({name, as_written(s, "model"), as_written(s, "numeric"),
                               s["size"][0].dump(), s["size"][1].dump(), as_written(s, "hits"),
                               as_written(s, "cycles"), as_written(s, "predicted_seconds"),
                               as_written(s, "efficiency"), as_written(s, "speed_up")});
        for (const Json& n : s["nodes"]) {
            nodes.rows.push_back({name, as_written(n, "id"), as_written(n, "column"),
                                  as_written(n, "row"), as_written(n, "pixels"),
                                  as_written(n, "rays"), as_written(n, "volumes_tested"),
                                  as_written(n, "heap_peak"), as_written(n, "cycles")});
        }
        for (const Json& c : s["curve"]) {
            curves.rows.push_back({name, as_written(c, "partition"), as_written(c, "nodes"),
                                   as_written(c, "efficiency"), as_written(c, "predicted_seconds"),
                                   as_written(c, "speed_up"), as_written(c, "overhead_share")});
        }
    }
    return {{"scenes.csv", csv_of(scenes)},
            {"nodes.csv", csv_of(nodes)},
            {"curves.csv", csv_of(curves)}};
}

std::string balance_page(const Json& data, const std::string& folder) {
    Page page("Load balance of the pixel nodes");
    page.paragraph(
        "Node (i, j) of an m x n array owns the pixels with x mod m = i and y mod n = j. The "
        "frame is done when the slowest node is: efficiency is the mean over the largest of the "
        "nodes' cycles. All figures but the one called host time are counted and the same on "
        "every computer.");
    page.table(scene_table(data));
    page.paragraph(fmt::format(
        "Efficiencies of other ways to share the pixels out come from the same render's cycles "
        "per pixel. A node that computes a pixel which another node holds pays {} cycles to send "
        "it, and {} cycles for each tile it asks for; both are assumptions.",
        data["costs"]["gather_cycles_per_pixel"].dump(),
        data["costs"]["hand_out_cycles_per_tile"].dump()));
    for (const Json& scene : data["scenes"]) add_scene(page, scene, folder);
    return page.html();
}

}  // namespace pxm::host
