#include "host/fractal/exact/ball_system.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/fractal/exact/number_field.hpp"
#include "host/fractal/system/sensitivity.hpp"

namespace pxm::host::exact {

namespace {

constexpr double nearness = 1e-12;  // of the numbers beside one: blends are computed in double

double entry_of(const Affine& map, std::size_t row, std::size_t column) {
    const int r = static_cast<int>(row), c = static_cast<int>(column);
    return c < 3 ? map.linear[c][r] : map.translation[r];
}

}  // namespace

BallMaps balls_around(const Rifs& rifs) {
    BallMaps balls;
    balls.ratio.resize(rifs.maps.size());
    for (const Affine& map : rifs.maps) {
        BallEntries& entries = balls.maps.emplace_back();
        double largest = 0;
        for (int i = 0; i < 3; ++i) largest = std::max(largest, glm::length(map.linear[i]));
        const double farthest = std::max(largest, glm::length(map.translation));
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 4; ++c) {
                const double x = entry_of(map, r, c);
                const double radius = x == 0 ? 0 : nearness * (c < 3 ? largest : farthest);
                entries[r][c] = RealBall::of_double(x, radius);
            }
    }
    return balls;
}

int digits_of(const BallMaps& balls) {
    constexpr double most = 60;
    double worst = std::pow(10, -most);
    for (const BallEntries& map : balls.maps) {
        double size = 0, radius = 0;
        for (const auto& row : map)
            for (const RealBall& entry : row) {
                size = std::max(size, entry.most());
                radius = std::max(radius, entry.radius());
            }
        if (size > 0) worst = std::max(worst, radius / size);
    }
    return static_cast<int>(-std::log10(worst) + 1e-9);
}

double offset_of(const BallMaps& balls, const Rifs& rifs) {
    constexpr double nearly = 1e-11;
    double change = 0;
    for (std::size_t m = 0; m < balls.maps.size(); ++m) {
        double far = 0;
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 4; ++c)
                far += balls.maps[m][r][c].farthest_from(entry_of(rifs.maps[m], r, c));
        const double size = glm::length(rifs.maps[m].translation) + 1;
        if (!(far <= nearly * size)) throw NotExact{"the rounded maps do not agree with the text"};
        change = std::max(change, far);
    }
    return change * sensitivity(rifs).lipschitz;
}

}  // namespace pxm::host::exact
