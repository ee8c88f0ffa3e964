#include "host/study/page/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/study/page/plot_labels.hpp"
#include "host/study/page/plot_mapping.hpp"

namespace pxm::host {

namespace {

constexpr double width = 720;  // of a plot, SVG units
constexpr double height = 340;
constexpr double left = 92;
constexpr double right = 150;  // the legend's
constexpr double top = 34;
constexpr double bottom = 48;
constexpr double bottom_line = height - bottom;
constexpr double right_line = width - right;
constexpr double legend_top = top + 8;  // base line of the first name
constexpr double legend_line = 18;

struct Style {
    const char* color;
    const char* dashes;
};
constexpr Style styles[] = {{"#14213d", ""},        {"#d1495b", "7 3"},        {"#2e8b57", "2 3"},
                            {"#e08a00", "9 3 2 3"}, {"#5b5bd6", "4 4"},        {"#8a8a8a", "1 2"},
                            {"#00798c", "12 3"},    {"#9c3587", "6 2 2 2 2 2"}};

std::string text_at(double x, double y, const char* anchor, const std::string& text,
                    const char* more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                       anchor, more, escaped(text));
}

std::string line_between(double x1, double y1, double x2, double y2, const char* kind) {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", x1, y1,
        x2, y2, kind);
}

std::string opening(double w, double h, const std::string& title) {
    return fmt::format(
               "<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\" "
               "xmlns=\"http://www.w3.org/2000/svg\">\n",
               w, h, escaped(title)) +
           text_at(0, 16, "start", title, " class=\"title\"");
}

/// Large numbers have many digits, which would meet along an axis, or its label.
std::string tick_text(const PlotAxis& axis, double value) {
    const bool power = axis.scale == AxisScale::logarithmic && axis.ticks.empty();
    if (!power && value >= 1e7) return fmt::format("{:g}e6", value / 1e6);
    return power && value >= 1e5 ? fmt::format("1e{:.0f}", std::log10(value)) : number_text(value);
}

std::string x_axis(const PlotAxis& axis, const Mapping& map) {
    std::string svg = line_between(left, bottom_line, right_line, bottom_line, "axis");
    for (const double tick : axis.ticks.empty() ? map.ticks() : axis.ticks) {
        svg += line_between(map(tick), bottom_line, map(tick), bottom_line + 4, "axis");
        svg += text_at(map(tick), bottom_line + 17, "middle", tick_text(axis, tick));
    }
    return svg + text_at((left + right_line) / 2, height - 8, "middle", axis.label);
}

std::string y_axis(const PlotAxis& axis, const Mapping& map) {
    std::string svg = line_between(left, top, left, bottom_line, "axis");
    for (const double tick : axis.ticks.empty() ? map.ticks() : axis.ticks) {
        svg += line_between(left, map(tick), right_line, map(tick), "grid");
        svg += text_at(left - 6, map(tick) + 4, "end", tick_text(axis, tick));
    }
    return svg + text_at(-(top + bottom_line) / 2, 14, "middle", axis.label,
                         " transform=\"rotate(-90)\"");
}

std::string mark(double x, double y, const PlotPoint& point, const Style& style) {
    return fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2}\" fill=\"{3}\" stroke=\"{3}\"/>"
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"8\" class=\"hit\" data-tip=\"{4}\"/>\n",
        x, y, point.marked ? 5 : 2.5, style.color, escaped(point.tip));
}

std::string series_of(const PlotSeries& series, const Mapping& x, const Mapping& y,
                      const Style& style) {
    std::string svg;
    if (series.line) {
        std::string path;
        for (const PlotPoint& p : series.points)
            path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : " L", x(p.x), y(p.y));
        svg += fmt::format(
            "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" "
            "stroke-dasharray=\"{}\"/>\n",
            path, style.color, style.dashes);
    }
    for (const PlotPoint& p : series.points) svg += mark(x(p.x), y(p.y), p, style);
    return svg;
}

PlotArea legend_area(std::size_t names) {
    const double height_of_all = legend_line * static_cast<double>(names);
    return {right_line + 10, legend_top - 14, width, legend_top - 14 + height_of_all};
}

/// The names of the points that have one. Marks and the legend come first, so that no label lies
/// on them: where a point of measured time falls is not known beforehand.
std::string labels_of(const std::vector<PlotSeries>& all, const Mapping& x, const Mapping& y) {
    LabelPlacer placer({left + 4, top, width, bottom_line});
    placer.keep_clear(legend_area(all.size()));
    for (const PlotSeries& series : all)
        for (const PlotPoint& p : series.points) placer.mark(x(p.x), y(p.y));
    std::string svg;
    for (const PlotSeries& series : all) {
        for (const PlotPoint& p : series.points) {
            if (p.label.empty()) continue;
            const auto place = placer.place(x(p.x), y(p.y), p.label);
            if (place)
                svg += text_at(place->x, place->y, place->anchor, p.label, " class=\"label\"");
        }
    }
    return svg;
}

std::string legend(const std::vector<PlotSeries>& series) {
    std::string svg;
    double y = legend_top;
    for (std::size_t i = 0; i < series.size(); ++i, y += legend_line) {
        const Style& style = styles[i % std::size(styles)];
        if (series[i].line) {
            svg += fmt::format(
                "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{2:.1f}\" y2=\"{1:.1f}\" stroke=\"{3}\" "
                "stroke-width=\"2\" stroke-dasharray=\"{4}\"/>\n",
                right_line + 10, y - 4, right_line + 34, style.color, style.dashes);
        } else {
            svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n",
                               right_line + 22, y - 4, style.color);
        }
        svg += text_at(right_line + 40, y, "start", series[i].name);
    }
    return svg;
}

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    void add(double value) {
        if (!std::isfinite(value)) return;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool empty() const { return low > high; }
};

/// A logarithmic axis has no place for 0.
bool can_show(const PlotAxis& axis, double value) {
    return std::isfinite(value) && (axis.scale == AxisScale::linear || value > 0);
}

}  // namespace

ScaleColor scale_color(double share) {
    // Lightness falls all the way, so that the scale survives a grey print.
    constexpr double stops[5][3] = {
        {252, 250, 232}, {250, 198, 110}, {226, 110, 70}, {140, 40, 95}, {28, 14, 62}};
    const double place = std::clamp(std::isfinite(share) ? share : 0.0, 0.0, 1.0) * 4;
    const int i = std::min(3, static_cast<int>(place));
    const double f = place - i;
    const auto part = [&](int k) {
        return static_cast<int>(std::lround(stops[i][k] * (1 - f) + stops[i + 1][k] * f));
    };
    return {part(0), part(1), part(2)};
}

std::string svg_of(const LinePlot& plot) {
    Extent xs;
    Extent ys;
    std::vector<PlotSeries> shown = plot.series;
    for (PlotSeries& series : shown) {
        std::erase_if(series.points, [&](const PlotPoint& p) {
            return !can_show(plot.x, p.x) || !can_show(plot.y, p.y);
        });
        for (const PlotPoint& p : series.points) {
            xs.add(p.x);
            ys.add(p.y);
        }
    }
    if (xs.empty()) xs = ys = {1, 2};
    const Mapping x(plot.x, xs.low, xs.high, left, right_line);
    const Mapping y(plot.y, ys.low, ys.high, bottom_line, top);
    std::string svg = opening(width, height, plot.title) + x_axis(plot.x, x) + y_axis(plot.y, y);
    for (std::size_t i = 0; i < shown.size(); ++i)
        svg += series_of(shown[i], x, y, styles[i % std::size(styles)]);
    return svg + labels_of(shown, x, y) + legend(shown) + "</svg>\n";
}

std::string svg_of(const BarPlot& plot) {
    Extent ys;
    double sum = 0;
    ys.add(0);
    for (const PlotBar& bar : plot.bars) {
        ys.add(bar.value);
        sum += bar.value;
    }
    const Mapping y(plot.y, ys.low, ys.high, bottom_line, top);
    std::string svg = opening(width, height, plot.title) + y_axis(plot.y, y) +
                      line_between(left, bottom_line, right_line, bottom_line, "axis") +
                      text_at((left + right_line) / 2, height - 8, "middle", plot.x_label);
    const auto count = static_cast<double>(std::max<std::size_t>(1, plot.bars.size()));
    const double step = (right_line - left) / count;
    for (std::size_t i = 0; i < plot.bars.size(); ++i) {
        const double at = y(plot.bars[i].value);
        svg += fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" class=\"bar\" "
            "data-tip=\"{}\"/>\n",
            left + step * static_cast<double>(i), at, step * 0.86, bottom_line - at,
            escaped(plot.bars[i].tip));
    }
    const double mean = sum / count;
    svg += line_between(left, y(mean), right_line, y(mean), "mean");
    svg += text_at(right_line + 6, y(mean) + 4, "start", fmt::format("mean {}", number_text(mean)));
    return svg + "</svg>\n";
}

std::string svg_of(const HeatMap& map) {
    constexpr double side = 300;
    const double cell = side / static_cast<double>(std::max(map.columns, map.rows));
    Extent extent;
    for (const double value : map.values) extent.add(value);
    if (extent.empty()) extent = {0, 0};
    const double span = extent.high - extent.low;
    const double grid_width = cell * static_cast<double>(map.columns);
    const double grid_height = cell * static_cast<double>(map.rows);
    std::string svg = opening(side + 2, grid_height + top + 26, map.title);
    for (long i = 0; i < map.columns * map.rows; ++i) {
        const double value = map.values[static_cast<std::size_t>(i)];
        const ScaleColor c = scale_color(span > 0 ? (value - extent.low) / span : 0.5);
        const long column = i % map.columns;
        const long row = i / map.columns;
        svg += fmt::format(
            "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
            "fill=\"#{:02x}{:02x}{:02x}\" class=\"cell\" data-tip=\"{}\"/>\n",
            cell * static_cast<double>(column), top - 8 + cell * static_cast<double>(row), cell,
            cell, c.red, c.green, c.blue,
            escaped(fmt::format("{} {},{}\n{} {}", map.cell, column, row, number_text(value),
                                map.unit)));
    }
    svg += text_at(0, grid_height + top + 10, "start",
                   fmt::format("light {}", number_text(extent.low)));
    svg += text_at(grid_width, grid_height + top + 10, "end",
                   fmt::format("dark {} {}", number_text(extent.high), map.unit));
    return svg + "</svg>\n";
}

}  // namespace pxm::host
