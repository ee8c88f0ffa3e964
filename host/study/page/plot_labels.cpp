#include "host/study/page/plot_labels.hpp"

#include <algorithm>

namespace pxm::host {

namespace {

constexpr double mark_radius = 3.5;
constexpr double away = 8;  // from a mark to its label
// Of a font of 10.5 units. Which font a browser has for Georgia is not known here: the digits of
// DejaVu Serif, which Linux has, are the widest.
constexpr double letter_width = 6.7;
constexpr double line_height = 11;
constexpr double steps[] = {0, -11, 11, -22, 22, -33, 33};  // up and down from the mark

bool overlap(const PlotArea& a, const PlotArea& b) {
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

void LabelPlacer::mark(double x, double y) {
    taken_.push_back({x - mark_radius, y - mark_radius, x + mark_radius, y + mark_radius});
}

bool LabelPlacer::is_free(const PlotArea& area) const {
    if (area.left < inside_.left || area.right > inside_.right) return false;
    if (area.top < inside_.top || area.bottom > inside_.bottom) return false;
    return std::ranges::none_of(taken_, [&](const PlotArea& one) { return overlap(area, one); });
}

std::optional<LabelPlace> LabelPlacer::place(double x, double y, const std::string& text) {
    const double width = letter_width * static_cast<double>(text.size());
    for (const double step : steps) {
        for (const bool to_the_right : {true, false}) {
            const double left = to_the_right ? x + away : x - away - width;
            const double middle = y + step;
            const PlotArea area{left, middle - line_height / 2, left + width,
                                middle + line_height / 2};
            if (!is_free(area)) continue;
            taken_.push_back(area);
            return LabelPlace{to_the_right ? area.left : area.right, middle + 4,
                              to_the_right ? "start" : "end"};
        }
    }
    return std::nullopt;
}

}  // namespace pxm::host
