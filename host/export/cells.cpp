#include "host/export/cells.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "host/math/lipschitz.hpp"
#include "host/process/interrupt.hpp"

namespace pxm::host {

namespace {

constexpr double sheared_by = 1e-9;  // cosine between axes, beyond what rounding makes of it

bool is_sheared(const glm::dmat3& linear) {
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = linear[i], b = linear[(i + 1) % 3];
        if (std::abs(glm::dot(a, b)) > sheared_by * glm::length(a) * glm::length(b)) return true;
    }
    return false;
}

/// At least the largest singular value, and that itself where it decides what is more than `limit`:
/// the root of the sum of squares is at most sqrt 3 times as much.
double longest_axis(const glm::dmat3& linear, double limit) {
    const double most = std::sqrt(glm::dot(linear[0], linear[0]) + glm::dot(linear[1], linear[1]) +
                                  glm::dot(linear[2], linear[2]));
    if (most <= limit || most > 1.75 * limit) return most;
    return singular_values(linear).values[0];
}

}  // namespace

std::uint64_t ExportedObject::cells() const {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

CellWalk::CellWalk(const ExportedObject& object, const CellLimit& limit)
    : object_(object), limit_(limit) {
    if (object.levels)
        limit_.levels = std::min(limit_.levels.value_or(*object.levels), *object.levels);
    stack_.push_back({{object.instance, object.rifs.start, object.color}});
}

bool CellWalk::is_last(const Step& step) const {
    if (object_.rifs.maps.empty()) return true;
    const auto level = static_cast<long>(stack_.size()) - 1;
    if (limit_.levels && level >= *limit_.levels) return true;
    if (!limit_.length) return false;
    const double diameter = object_.diameters[static_cast<std::size_t>(step.cell.set)];
    return longest_axis(step.cell.place.linear, *limit_.length / diameter) * diameter <=
           *limit_.length;
}

const Cell* CellWalk::next() {
    while (!stack_.empty()) {
        Step& step = stack_.back();
        if (step.child == 0 && is_last(step)) {
            taken_ = step.cell;
            stack_.pop_back();
            return &taken_;
        }
        const std::vector<int>& maps =
            object_.rifs.follow_sets[static_cast<std::size_t>(step.cell.set)].maps;
        if (step.child == maps.size()) {
            stack_.pop_back();
            continue;
        }
        const auto map = static_cast<std::size_t>(maps[step.child++]);
        const glm::dvec4& paint = object_.colors[map];
        stack_.push_back(
            {{then(object_.rifs.maps[map], step.cell.place), object_.rifs.follow_of[map],
              step.cell.color * (1 - paint.a) + glm::dvec3{paint} * paint.a}});
    }
    return nullptr;
}

bool count_cells(ExportedObject& object, const CellLimit& limit, std::uint64_t most) {
    object.counts.assign(std::max<std::size_t>(1, object.rifs.follow_sets.size()), 0);
    object.sheared = false;
    std::uint64_t count = 0;
    CellWalk walk(object, limit);
    while (const Cell* cell = walk.next()) {
        if (++count > most) return false;
        if (count % 65'536 == 0 && stop_requested()) return false;
        ++object.counts[static_cast<std::size_t>(cell->set)];
        object.sheared = object.sheared || is_sheared(cell->place.linear);
    }
    return true;
}

double cells_at(const Rifs& rifs, long levels) {
    constexpr double enough = 1e18;
    std::vector<double> below(rifs.follow_sets.size(), 1.0);
    for (long level = 0; level < levels; ++level) {
        std::vector<double> next(below.size(), 0.0);
        for (std::size_t set = 0; set < below.size(); ++set) {
            for (const int map : rifs.follow_sets[set].maps) {
                next[set] +=
                    below[static_cast<std::size_t>(rifs.follow_of[static_cast<std::size_t>(map)])];
            }
        }
        if (next == below) break;
        below = next;
        if (below[static_cast<std::size_t>(rifs.start)] > enough) break;
    }
    return below[static_cast<std::size_t>(rifs.start)];
}

}  // namespace pxm::host
