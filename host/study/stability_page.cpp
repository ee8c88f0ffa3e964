#include "host/study/stability_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "host/study/page.hpp"
#include "host/study/plot.hpp"

namespace pxm::host {

namespace {

std::string text(const Json& json, const char* key) { return json.at(key).get<std::string>(); }
double real(const Json& json, const char* key) {
    return json.contains(key) ? json.at(key).get<double>() : 0.0;
}

std::string alarms_text(const Json& one) {
    if (one.contains("message")) return fmt::format("exit {}", one.at("exit_code").dump());
    std::string result;
    for (const auto& [name, count] : one.at("alarms").items())
        result += fmt::format("{}{} {}", result.empty() ? "" : ", ", name, count.dump());
    return result;
}

PageTable case_table(const Json& data) {
    PageTable table{{"case", "numbers", "grade", "wrong pixels", "of them no alarm",
                     "worst depth, pixels", "cells a ray", "alarms"},
                    {}};
    for (const Json& one : data["cases"]) {
        table.rows.push_back({text(one, "name"), text(one, "numeric"), text(one, "grade"),
                              fmt::format("{:.2f} %", 100 * real(one, "wrong_share")),
                              fmt::format("{:.2f} %", 100 * real(one, "missed_share")),
                              number_text(real(one, "worst_depth_pixels")),
                              number_text(real(one, "cells_per_ray")), alarms_text(one)});
    }
    return table;
}

PageTable grade_table(const Json& data) {
    std::map<std::string, std::map<std::string, int>> counts;
    for (const Json& one : data["cases"]) ++counts[text(one, "numeric")][text(one, "grade")];
    PageTable table{{"numbers", "right", "degraded", "reported", "silent"}, {}};
    for (auto& [numeric, grades] : counts) {
        std::vector<std::string> row{numeric};
        for (const char* grade : {"right", "degraded", "reported", "silent"})
            row.push_back(fmt::format("{}", grades[grade]));
        table.rows.push_back(row);
    }
    return table;
}

/// Wrong pixels over a family's parameter.
std::string family_plot(const Json& data, const std::string& family) {
    LinePlot plot;
    plot.title = fmt::format("Wrong pixels: {}", family);
    plot.x.label = family;
    plot.x.scale = family == "contraction" ? AxisScale::linear : AxisScale::logarithmic;
    plot.y.label = "share of wrong pixels";
    plot.y.low = 0;
    for (const Json& one : data["cases"]) {
        if (text(one, "family") != family) continue;
        const std::string numeric = text(one, "numeric");
        auto series = std::ranges::find(plot.series, numeric, &PlotSeries::name);
        if (series == plot.series.end()) {
            plot.series.push_back({numeric, {}});
            series = plot.series.end() - 1;
        }
        series->points.push_back(
            {real(one, "value"), real(one, "wrong_share"),
             fmt::format("{}, {}\n{:.2f} % wrong, {}", text(one, "name"), numeric,
                         100 * real(one, "wrong_share"), text(one, "grade")),
             text(one, "grade") == "silent"});
    }
    return svg_of(plot);
}

}  // namespace

std::vector<TextFile> stability_tables(const Json& data) {
    PageTable table{{"name", "family", "value", "numeric", "grade", "wrong_share", "missed_share",
                     "worst_depth_pixels", "cells_per_ray", "alarms"},
                    {}};
    for (const Json& one : data["cases"]) {
        table.rows.push_back({text(one, "name"), text(one, "family"), one["value"].dump(),
                              text(one, "numeric"), text(one, "grade"), one["wrong_share"].dump(),
                              one["missed_share"].dump(), one["worst_depth_pixels"].dump(),
                              fmt::format("{}", real(one, "cells_per_ray")), alarms_text(one)});
    }
    return {{"cases.csv", csv_of(table)}};
}

std::string stability_page(const Json& data, const std::string&) {
    Page page("Stability in each number type");
    page.paragraph(fmt::format(
        "Every case is rendered in each number type. A pixel is wrong if it hits where the "
        "reference misses, or the other way round, or lies more than a pixel away from it. Up to "
        "{:.1f} % wrong pixels are right, up to {:.0f} % degraded; beyond that a render has "
        "failed: "
        "reported if it raised an alarm or was refused, silent if not. The reference of dsp32 and "
        "float is double. Double's own is the same scene with all lengths times 3, in which every "
        "number is rounded otherwise.",
        100 * data["right_share"].get<double>(), 100 * data["degraded_share"].get<double>()));
    page.table(grade_table(data));
    for (const char* family : {"zoom", "contraction", "squash"})
        page.plot(family_plot(data, family));
    page.table(case_table(data));
    return page.html();
}

}  // namespace pxm::host
