#include "host/study/page/stability_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "host/study/page/page.hpp"
#include "host/study/page/plot.hpp"

namespace pxm::host {

namespace {

std::string text(const Json& json, const char* key) { return json.at(key).get<std::string>(); }
double real(const Json& json, const char* key) {
    return json.contains(key) ? json.at(key).get<double>() : 0.0;
}

std::string alarms_text(const Json& one, const char* gap = " ") {
    if (one.contains("message")) return fmt::format("exit {}", one.at("exit_code").dump());
    std::string result;
    for (const auto& [name, count] : one.at("alarms").items())
        result += fmt::format("{}{}{}{}", result.empty() ? "" : ", ", name, gap, count.dump());
    return result;
}

std::string count_text(const Json& one, const char* key) {
    return one.contains(key) && one.at(key) != 0 ? number_text(real(one, key)) : "";
}

std::string seconds_text(const Json& one) {
    return one.contains("host") ? fmt::format("{:.3f}", real(one.at("host"), "render_seconds"))
                                : "";
}

/// The numbers, and who computed where the wide engine does not apply.
std::string numbers_text(const Json& one) {
    const std::string numeric = text(one, "numeric");
    const bool left = numeric == "wide" && one.contains("engine") && text(one, "engine") != "wide";
    return left ? "wide (left to float)" : numeric;
}

std::string grade_text(const Json& one) {
    if (one.contains("exit_code")) return fmt::format("refused, exit {}", one["exit_code"].dump());
    const std::string grade = text(one, "grade");
    if (real(one, "wrong_share") == 0) return grade;
    return fmt::format("{}, {:.2f} %", grade, 100 * real(one, "wrong_share"));
}

/// A row a case, a column for each of the numbers.
PageTable overview_table(const Json& data) {
    PageTable table{{"case"}, {}};
    for (const Json& one : data["cases"]) {
        const std::string numeric = text(one, "numeric");
        if (std::ranges::find(table.columns, numeric) == table.columns.end())
            table.columns.push_back(numeric);
        if (table.rows.empty() || table.rows.back()[0] != text(one, "name"))
            table.rows.push_back({text(one, "name")});
        table.rows.back().push_back(grade_text(one));
    }
    return table;
}

/// Nothing to tell: right, and without alarms and restarts.
bool is_quiet(const Json& one) {
    return text(one, "grade") == "right" && one["alarms"].empty() && real(one, "restarts") == 0;
}

/// Everything known of the cases in which something happened.
PageTable case_table(const Json& data) {
    PageTable table{{"case", "numbers", "grade", "wrong pixels", "of them no alarm",
                     "worst depth, pixels", "restarts", "cells a ray", "host s", "alarms"},
                    {}};
    for (const Json& one : data["cases"]) {
        if (one.contains("exit_code") || is_quiet(one)) continue;
        table.rows.push_back({text(one, "name"), numbers_text(one), text(one, "grade"),
                              fmt::format("{:.2f} %", 100 * real(one, "wrong_share")),
                              fmt::format("{:.2f} %", 100 * real(one, "missed_share")),
                              number_text(real(one, "worst_depth_pixels")),
                              count_text(one, "restarts"), number_text(real(one, "cells_per_ray")),
                              seconds_text(one), alarms_text(one, "\u00a0")});
    }
    return table;
}

/// What became of the cases in one number type.
struct Outcome {
    std::map<std::string, int> grades;
    double pixels = 0;
    double wrong = 0;
    double missed = 0;  // wrong and without an alarm of their own
};

std::vector<std::pair<std::string, Outcome>> outcomes_of(const Json& data) {
    std::vector<std::pair<std::string, Outcome>> outcomes;
    for (const Json& one : data["cases"]) {
        const std::string numeric = text(one, "numeric");
        auto found = std::ranges::find(outcomes, numeric, &std::pair<std::string, Outcome>::first);
        if (found == outcomes.end()) found = outcomes.insert(found, {numeric, {}});
        Outcome& outcome = found->second;
        ++outcome.grades[text(one, "grade")];
        outcome.pixels += real(one, "pixels");
        outcome.wrong += real(one, "pixels") * real(one, "wrong_share");
        outcome.missed += real(one, "pixels") * real(one, "missed_share");
    }
    return outcomes;
}

PageTable grade_table(const Json& data) {
    PageTable table{{"numbers", "right", "degraded", "reported", "silent", "pixels", "wrong",
                     "wrong without an alarm"},
                    {}};
    for (auto& [numeric, outcome] : outcomes_of(data)) {
        std::vector<std::string> row{numeric};
        for (const char* grade : {"right", "degraded", "reported", "silent"}) {
            const auto count = outcome.grades.find(grade);
            row.push_back(fmt::format("{}", count == outcome.grades.end() ? 0 : count->second));
        }
        for (const double pixels : {outcome.pixels, outcome.wrong, outcome.missed})
            row.push_back(number_text(std::round(pixels)));
        table.rows.push_back(row);
    }
    return table;
}

/// How much an alarm is worth in one number type: of the pixels that have it, how many are wrong.
struct AlarmWorth {
    int cases = 0;
    double pixels = 0;
    double wrong = 0;
};

/// A row an alarm of pixels and number type. An alarm of which few pixels are wrong cries wolf.
PageTable alarm_table(const Json& data) {
    std::map<std::pair<std::string, std::string>, AlarmWorth> worths;
    for (const Json& one : data["cases"]) {
        if (!one.contains("alarmed")) continue;
        for (const auto& [alarm, counts] : one["alarmed"].items()) {
            AlarmWorth& worth = worths[{alarm, text(one, "numeric")}];
            ++worth.cases;
            worth.pixels += real(counts, "pixels");
            worth.wrong += real(counts, "wrong");
        }
    }
    PageTable table{{"alarm", "numbers", "cases", "pixels", "of them wrong", "share"}, {}};
    for (const auto& [key, worth] : worths)
        table.rows.push_back({key.first, key.second, fmt::format("{}", worth.cases),
                              number_text(worth.pixels), number_text(worth.wrong),
                              fmt::format("{:.1f} %", 100 * worth.wrong / worth.pixels)});
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
    PageTable table{{"name", "family", "value", "numeric", "engine", "grade", "wrong_share",
                     "missed_share", "worst_depth_pixels", "overflowed_pixels", "heap_overflows",
                     "restarts", "capped_rays", "cells_per_ray", "host_seconds", "alarms"},
                    {}};
    for (const Json& one : data["cases"]) {
        std::vector<std::string> row{text(one, "name"),
                                     text(one, "family"),
                                     one["value"].dump(),
                                     text(one, "numeric"),
                                     one.contains("engine") ? text(one, "engine") : "",
                                     text(one, "grade")};
        for (const char* key :
             {"wrong_share", "missed_share", "worst_depth_pixels", "overflowed_pixels",
              "heap_overflows", "restarts", "capped_rays", "cells_per_ray"})
            row.push_back(one.contains(key) ? one[key].dump() : "");
        row.push_back(one.contains("host") ? one["host"]["render_seconds"].dump() : "");
        row.push_back(alarms_text(one));
        table.rows.push_back(row);
    }
    return {{"cases.csv", csv_of(table)}, {"alarms.csv", csv_of(alarm_table(data))}};
}

std::string stability_page(const Json& data, const std::string&) {
    Page page("Stability in each number type");
    page.paragraph(fmt::format(
        "Every case is rendered in each number type by the reference kernels, and by the wide "
        "engine where it applies. A pixel is wrong if it hits where the reference misses, or the "
        "other way round, or lies more than a pixel away from it, or if the reference itself had "
        "to "
        "give it up. Up to {:.1f} % wrong pixels are right, up to {:.0f} % degraded; beyond that a "
        "render has failed: reported if it raised an alarm or was refused, silent if not. The "
        "reference is the same program in {}, with {} bits of mantissa.",
        100 * data["right_share"].get<double>(), 100 * data["degraded_share"].get<double>(),
        text(data["reference"], "numeric"), data["reference"]["mantissa_bits"].dump()));
    page.paragraph(
        "The alarm overflow counts pixels in whose computation a result was beyond the range of "
        "its numbers, or "
        "something was divided by zero (dsp32 saturates); not counted in the wide engine.");
    page.table(grade_table(data));
    for (const char* family : {"zoom", "contraction", "squash"})
        page.plot(family_plot(data, family));
    page.table(overview_table(data));
    page.heading("What alarms are worth");
    page.table(alarm_table(data));
    page.heading("Cases with alarms, restarts or wrong pixels");
    page.table(case_table(data));
    return page.html();
}

}  // namespace pxm::host
