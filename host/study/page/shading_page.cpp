#include "host/study/page/shading_page.hpp"

#include <fmt/format.h>

#include "host/study/page/page.hpp"
#include "host/study/page/plot.hpp"

namespace pxm::host {

namespace {

double deviation(const Json& setup, const char* weighting) {
    return setup["weights"][weighting]["sd"].get<double>();
}

PageTable weights_table(const Json& weights) {
    PageTable table{{"weighting", "mode", "mean", "deviation about 1", "the thesis'"}, {}};
    for (const auto& [name, weight] : weights.items()) {
        table.rows.push_back({name, fmt::format("{:.3f}", weight["mode"].get<double>()),
                              fmt::format("{:.4f}", weight["mean"].get<double>()),
                              fmt::format("{:.3f}", weight["sd"].get<double>()),
                              fmt::format("{:.3f}", weight["thesis_sd"].get<double>())});
    }
    return table;
}

std::string distribution(const std::string& title, const Json& weights) {
    LinePlot plot;
    plot.title = title;
    plot.x.label = "dot product of the total normal with the plane's";
    plot.x.low = 0.6;
    plot.x.high = 1;
    plot.y.label = "share of the samples";
    plot.y.low = 0;
    for (const auto& [name, weight] : weights.items()) {
        PlotSeries series{name, {}};
        const std::size_t bins = weight["histogram"].size();
        const auto samples = weight["samples"].get<double>();
        for (std::size_t i = bins * 6 / 10; i < bins; ++i) {
            const double low = static_cast<double>(i) / static_cast<double>(bins);
            const double high = static_cast<double>(i + 1) / static_cast<double>(bins);
            const double share = weight["histogram"][i].get<double>() / samples;
            series.points.push_back(
                {(low + high) / 2, share,
                 fmt::format("{}\n{:.3f} to {:.3f}: {:.2f} %", name, low, high, 100 * share)});
        }
        plot.series.push_back(series);
    }
    return svg_of(plot);
}

std::string spoken(const Json& setup) {
    return fmt::format("{}, {}, cells down to {} pixels", setup["view"].get<std::string>(),
                       setup["volume"].get<std::string>(), setup["detail"].dump());
}

PageTable setups_table(const Json& data) {
    PageTable table{{"view", "volumes", "detail", "constant", "low-pass", "high-pass"}, {}};
    for (const Json& setup : data["setups"]) {
        table.rows.push_back({setup["view"].get<std::string>(), setup["volume"].get<std::string>(),
                              setup["detail"].dump(),
                              fmt::format("{:.3f}", deviation(setup, "constant")),
                              fmt::format("{:.3f}", deviation(setup, "low-pass")),
                              fmt::format("{:.3f}", deviation(setup, "high-pass"))});
    }
    return table;
}

}  // namespace

std::vector<TextFile> shading_tables(const Json& data) {
    PageTable table{
        {"view", "volume", "detail", "weighting", "samples", "mode", "mean", "sd", "thesis_sd"},
        {}};
    for (const Json& setup : data["setups"]) {
        for (const auto& [name, weight] : setup["weights"].items()) {
            table.rows.push_back(
                {setup["view"].get<std::string>(), setup["volume"].get<std::string>(),
                 setup["detail"].dump(), name, weight["samples"].dump(), weight["mode"].dump(),
                 weight["mean"].dump(), weight["sd"].dump(), weight["thesis_sd"].dump()});
        }
    }
    return {{"shading.csv", csv_of(table)}};
}

std::string shading_page(const Json& data, const std::string&) {
    Page page("Hierarchical shading of a plane (Sec. 17.5)");
    page.paragraph(fmt::format(
        "The planar side of the extruded gasket is looked at along {} rays. A plane's normal gives "
        "a dot product of 1; hierarchical shading gathers the normals of the bounding volumes "
        "instead. The thesis reports the mode 1 and the deviations about 1, but neither the view "
        "nor the volumes; the first table is for {}.",
        data["samples"].dump(), spoken(data["setup"])));
    page.table(weights_table(data["weights"]));
    page.plot(distribution(spoken(data["setup"]), data["weights"]));
    const Json& nearest = data["setups"][data["nearest"].get<std::size_t>()];
    page.subheading("The set-up that comes nearest to the thesis");
    page.paragraph(fmt::format("{}.", spoken(nearest)));
    page.table(weights_table(nearest["weights"]));
    page.plot(distribution(spoken(nearest), nearest["weights"]));
    page.subheading("All set-ups: deviations about 1");
    page.table(setups_table(data));
    return page.html();
}

}  // namespace pxm::host
