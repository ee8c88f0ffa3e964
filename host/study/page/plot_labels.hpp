// Where the names of marks go: beside them, clear of one another and of the other marks. A printed
// plot has no pointer to ask with.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pxm::host {

/// Part of a plot, in SVG units, y downward.
struct PlotArea {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

struct LabelPlace {
    double x = 0;
    double y = 0;  // of the base line
    const char* anchor = "start";
};

class LabelPlacer {
  public:
    explicit LabelPlacer(const PlotArea& inside) : inside_(inside) {}
    /// Keeps the labels that follow clear of a mark.
    void mark(double x, double y);
    /// Keeps the labels that follow clear of a part of the plot, the legend's for example.
    void keep_clear(const PlotArea& area) { taken_.push_back(area); }
    /// The place of a label beside (x, y); nothing where there is no room.
    [[nodiscard]] std::optional<LabelPlace> place(double x, double y, const std::string& text);

  private:
    [[nodiscard]] bool is_free(const PlotArea& area) const;
    PlotArea inside_;
    std::vector<PlotArea> taken_;
};

}  // namespace pxm::host
