// How many boxes hold points of an attractor, from places of it. One over the measure of a place's
// box is on average the number of boxes; but where boxes have very different measures the average
// soon hangs on few places. So now and then places are drawn anew, each as often as its boxes call
// for (sequential Monte Carlo): the places then stand for all boxes alike.
#pragma once

#include <cstdint>
#include <vector>

#include "host/fractal/dimension/zoom.hpp"

namespace pxm::host {

class BoxPopulation {
  public:
    BoxPopulation(const ZoomSystem& system, std::size_t places, std::uint64_t seed);

    /// The number of boxes of `side`, which is less than before; 0: there are too many cells.
    [[nodiscard]] double count(double side);
    /// Cells looked at.
    [[nodiscard]] long visits() const { return visits_; }

  private:
    void draw_anew(const std::vector<double>& value, const std::vector<double>& ratio, double sum);

    bool independent_;  // places are drawn for each scale as it calls for
    Dice dice_;
    std::vector<Zoom> places_;
    std::vector<double> reference_;  // per place: its value when places were last drawn
    double count_then_ = 1;          // and the number of boxes
    long visits_ = 0;
};

}  // namespace pxm::host
