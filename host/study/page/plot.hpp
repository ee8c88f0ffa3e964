// Plots as SVG text: vectors, so they are readable on paper, and every mark carries its values in
// `data-tip`, which the page's script shows under the pointer. Colours differ in lightness and
// lines in their dashes, so that a grey print can be read too.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/study/page/plot_text.hpp"

namespace pxm::host {

enum class AxisScale { linear, logarithmic };

struct PlotAxis {
    std::string label = {};  // with its unit
    AxisScale scale = AxisScale::linear;
    std::optional<double> low = {};  // absent: as the values need
    std::optional<double> high = {};
    std::vector<double> ticks = {};  // empty: round numbers
};

struct PlotPoint {
    double x = 0;
    double y = 0;
    std::string tip;         // lines
    bool marked = false;     // drawn larger
    std::string label = {};  // beside the mark, where there is room
};

struct PlotSeries {
    std::string name;
    std::vector<PlotPoint> points;
    bool line = true;  // joined
};

struct LinePlot {
    std::string title;
    PlotAxis x;
    PlotAxis y;
    std::vector<PlotSeries> series;
};

struct PlotBar {
    double value = 0;
    std::string tip;
};

/// Bars side by side in the order given, with a rule at their mean.
struct BarPlot {
    std::string title;
    PlotAxis y;
    std::string x_label;
    std::vector<PlotBar> bars;
};

/// A value a cell, as colours from light (low) to dark (high).
struct HeatMap {
    std::string title;
    std::string unit;
    long columns = 0;
    long rows = 0;
    std::vector<double> values;  // row by row
    std::string cell = "node";   // what a cell is
};

[[nodiscard]] std::string svg_of(const LinePlot& plot);
[[nodiscard]] std::string svg_of(const BarPlot& plot);
[[nodiscard]] std::string svg_of(const HeatMap& map);

/// Red, green, blue (0..255) of a share 0..1 of the colour scale.
struct ScaleColor {
    int red = 0;
    int green = 0;
    int blue = 0;
};
[[nodiscard]] ScaleColor scale_color(double share);

}  // namespace pxm::host
