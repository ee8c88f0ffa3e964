#include "host/fractal/dimension/box_population.hpp"

namespace pxm::host {

BoxPopulation::BoxPopulation(const ZoomSystem& system, std::size_t places, std::uint64_t seed)

    : independent_(system.layers.has_value()),
      dice_(seed),
      places_(places, Zoom(system)),
      reference_(places, 1) {}

double BoxPopulation::count(double side) {
    const auto places = static_cast<double>(places_.size());
    std::vector<double> value;
    std::vector<double> ratio;
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        value.push_back(places_[i].to(side, dice_, visits_));
        if (!(value[i] > 0)) return 0;
        ratio.push_back(value[i] / reference_[i]);
        sum += ratio[i];
        squares += ratio[i] * ratio[i];
    }
    const double boxes = count_then_ * sum / places;
    const bool hangs_on_few = !independent_ && sum * sum < places / 2 * squares;
    if (hangs_on_few) {
        count_then_ = boxes;
        draw_anew(value, ratio, sum);
    }
    return boxes;
}

void BoxPopulation::draw_anew(const std::vector<double>& value, const std::vector<double>& ratio,
                              double sum) {
    const double step = sum / static_cast<double>(places_.size());
    double next = dice_.next() * step;
    double passed = 0;
    std::vector<Zoom> drawn;
    reference_.clear();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        passed += ratio[i];
        for (; next < passed && drawn.size() < places_.size(); next += step) {
            drawn.push_back(places_[i]);
            reference_.push_back(value[i]);
        }
    }
    while (drawn.size() < places_.size()) {  // rounding kept the last one out
        drawn.push_back(places_.back());
        reference_.push_back(value.back());
    }
    places_ = std::move(drawn);
}

}  // namespace pxm::host
