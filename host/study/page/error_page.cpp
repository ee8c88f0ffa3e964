#include "host/study/page/error_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/study/page/page.hpp"
#include "host/study/page/plot.hpp"
#include "host/study/study_scene.hpp"

namespace pxm::host {

namespace {

std::string name_of(const Json& point) {
    return point.at("settings").at("name").get<std::string>();
}

std::string shown(const Json& value) {
    return value.is_null() ? "-" : number_text(value.get<double>());
}

/// Short enough to stand beside a mark: `--samples 4 --detail 2` is `samples 4, detail 2`.
std::string label_of(const std::string& name) {
    std::string label = name.substr(name.starts_with("--") ? 2 : 0);
    for (auto at = label.find(" --"); at != label.npos; at = label.find(" --"))
        label.replace(at, 3, ", ");
    return label;
}

/// `time` and `mark` choose the machine or the host.
std::string diagram(const Json& scene, const char* title, const char* time, const char* mark) {
    LinePlot plot;
    plot.title = title;
    plot.x.label = "seconds";
    plot.x.scale = AxisScale::logarithmic;
    plot.y.label = "RMSE of colour";
    plot.y.scale = AxisScale::logarithmic;
    PlotSeries front{"best for their time", {}};
    PlotSeries others{"others", {}, false};
    for (const Json& point : scene["points"]) {
        if (point[time].is_null()) continue;
        const bool pareto = point[mark].get<bool>();
        (pareto ? front : others)
            .points.push_back(
                {point[time].get<double>(), point["rmse"].get<double>(),
                 fmt::format("{}\n{} s, RMSE {:.5f}\nwrong hits {:.2f} %", name_of(point),
                             shown(point[time]), point["rmse"].get<double>(),
                             100 * point["wrong_hits"].get<double>()),
                 pareto, pareto ? label_of(name_of(point)) : ""});
    }
    std::ranges::sort(front.points, {}, &PlotPoint::x);
    plot.series = {front, others};
    return svg_of(plot);
}

PageTable point_table(const Json& scene) {
    PageTable table{{"settings", "machine s", "host s (spread)", "RMSE", "99 %", "perceived",
                     "wrong hits", "depth error, pixels", "rays given up", "beaten by"},
                    {}};
    for (const Json& point : scene["points"]) {
        table.rows.push_back(
            {name_of(point), shown(point["machine_seconds"]),
             fmt::format("{:.3g} ({:.3g} to {:.3g})", point["host_seconds"].get<double>(),
                         point["host_spread"][0].get<double>(),
                         point["host_spread"][1].get<double>()),
             fmt::format("{:.4f}", point["rmse"].get<double>()),
             fmt::format("{:.3f}", point["color_99"].get<double>()),
             fmt::format("{:.2f} %", 100 * point["perceived"].get<double>()),
             fmt::format("{:.2f} %", 100 * point["wrong_hits"].get<double>()),
             fmt::format("{:.3f}", point["depth_error_pixels"].get<double>()),
             point["capped_rays"] == 0 ? "" : number_text(point["capped_rays"].get<double>()),
             point["dominated_by"].is_null() ? "" : point["dominated_by"].get<std::string>()});
    }
    return table;
}

void add_choice(Page& page, const Json& scene, const char* key, const char* what) {
    if (!scene.contains(key)) return;
    const Json& choice = scene[key]["settings"];
    page.paragraph(fmt::format("{}: {}.", what,
                               choice.is_null() ? "no setting does" : choice.get<std::string>()));
}

}  // namespace

std::vector<TextFile> error_tables(const Json& data) {
    PageTable table{{"scene", "settings", "machine_seconds", "host_seconds", "host_low",
                     "host_high", "rmse", "color_99", "perceived", "wrong_hits",
                     "depth_error_pixels", "capped_rays", "pareto", "pareto_host"},
                    {}};
    for (const Json& scene : data["scenes"]) {
        for (const Json& p : scene["points"]) {
            table.rows.push_back(
                {scene["scene"].get<std::string>(), name_of(p), p["machine_seconds"].dump(),
                 p["host_seconds"].dump(), p["host_spread"][0].dump(), p["host_spread"][1].dump(),
                 p["rmse"].dump(), p["color_99"].dump(), p["perceived"].dump(),
                 p["wrong_hits"].dump(), p["depth_error_pixels"].dump(), p["capped_rays"].dump(),
                 p["pareto"].dump(), p["pareto_host"].dump()});
        }
    }
    return {{"points.csv", csv_of(table)}};
}

std::string error_page(const Json& data, const std::string&) {
    Page page("Error against run time");
    page.paragraph(
        "Each point is a render with other settings. Colours are compared with double, 64 "
        "stratified samples a pixel, cells ten times finer and no limit of the heap; hits and "
        "depths with the same along the ray through the pixel's middle. Machine time is counted; "
        "host time is the median of repeats in this run, with its spread, and means nothing "
        "elsewhere. A setting is beaten if another is no slower and no less exact. "
        "A ray is given up after 5,000 cells. A dash: it does not fit the machine, or is no "
        "program of it.");
    for (const Json& scene : data["scenes"]) {
        page.heading(stem_of(scene["scene"].get<std::string>()));
        std::string advice = scene["advice"].get<std::string>();
        std::erase(advice, '`');  // of the documents
        page.paragraph(advice);
        add_choice(page, scene, "budget", "Best within the budget");
        add_choice(page, scene, "target", "Fastest that reaches the target");
        page.plot(diagram(scene, "Machine time", "machine_seconds", "pareto"));
        page.plot(diagram(scene, "Host time of this run", "host_seconds", "pareto_host"));
        page.table(point_table(scene));
        for (const Json& one : scene["refused"]) {
            page.paragraph(
                fmt::format("{} was refused: {}", name_of(one), one["refused"].get<std::string>()));
        }
    }
    return page.html();
}

}  // namespace pxm::host
