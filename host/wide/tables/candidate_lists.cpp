#include "host/wide/tables/candidate_lists.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace pxm::host::wide {

namespace {

constexpr float rounding = 1e-5F;  // of a place, in radii

// Rows of the lists.
constexpr int radius_row = 3;
constexpr int diameter_row = 4;
constexpr int row_count = 5;

constexpr std::array<std::int32_t, most_maps> all_lanes = [] {
    std::array<std::int32_t, most_maps> lanes{};
    for (std::size_t i = 0; i < most_maps; ++i) lanes[i] = static_cast<std::int32_t>(i);
    return lanes;
}();

/// Cells from the front to the back: no ray meets one nearer than at z - radius.
std::vector<std::uint32_t> front_to_back(const float* z, const float* radius, int count) {
    std::vector<std::uint32_t> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        const float front_a = z[a] - radius[a], front_b = z[b] - radius[b];
        return front_a < front_b || (front_a == front_b && a < b);
    });
    return order;
}

}  // namespace

ListedCells whole_table(const HomothetyTable& table, const LaneTable<float>& centers) {
    assert(table.count <= static_cast<int>(most_maps));
    return {centers.row(0),
            centers.row(1),
            centers.row(2),
            table.rows.row(HomothetyTable::scale),
            table.rows.row(HomothetyTable::diameter),
            all_lanes.data(),
            table.count};
}

void CandidateLists::make(const HomothetyTable& table, const glm::dmat3& to_frame,
                          const ViewFrame& view) {
    if (centers_.empty()) centers_ = LaneTable<float>(3, table.stride);
    for (int i = 0; i < table.count; ++i) {
        const glm::dvec3 center{table.f64.row(0)[i], table.f64.row(1)[i], table.f64.row(2)[i]};
        const glm::dvec3 turned = to_frame * center;
        for (int axis = 0; axis < 3; ++axis) {
            centers_.row(axis)[i] = static_cast<float>(turned[axis]);
        }
    }
    side_ = 0;
    if (view.shared && table.count > table_step) list(table, view);
}

/// Divides the plane across into squares: `room` is how far from a cell's centre a ray may pass and
/// still meet it.
void CandidateLists::divide(const HomothetyTable& table, const std::vector<float>& room) {
    constexpr float squares_per_radius = 1;
    constexpr int most_side = 64;
    const float* radius = table.rows.row(HomothetyTable::scale);
    float mean = 0;
    half_width_ = 0;
    for (int i = 0; i < table.count; ++i) {
        const float x = std::abs(centers_.row(0)[i]), y = std::abs(centers_.row(1)[i]);
        half_width_ = std::max(half_width_, std::max(x, y) + room[static_cast<std::size_t>(i)]);
        mean += radius[i] / static_cast<float>(table.count);
    }
    const float squares = 2 * half_width_ * squares_per_radius / mean;
    side_ = static_cast<int>(std::clamp(squares, 1.0F, static_cast<float>(most_side)));
    last_ = static_cast<float>(side_ - 1);
    per_square_ = static_cast<float>(side_) / (2 * half_width_);
}

/// Calls `each(square)` for those that a disc touches.
template <class Each>
void CandidateLists::for_squares(float x, float y, float room, const Each& each) const {
    const float width = 1 / per_square_;
    const int last = place(y + room);
    for (int row = place(y - room); row <= last; ++row) {
        const float low = static_cast<float>(row) * width - half_width_;
        const float beside = std::max({low - y, y - low - width, 0.0F}) - rounding;
        const float half2 = room * room - beside * std::abs(beside);
        if (half2 < 0) continue;
        const float half = std::sqrt(half2) + rounding;
        const int end = place(x + half);
        for (int column = place(x - half); column <= end; ++column) {
            each(static_cast<std::size_t>(row * side_ + column));
        }
    }
}

void CandidateLists::list(const HomothetyTable& table, const ViewFrame& view) {
    const float *x = centers_.row(0), *y = centers_.row(1), *z = centers_.row(2);
    const float* radius = table.rows.row(HomothetyTable::scale);
    const float* diameter = table.rows.row(HomothetyTable::diameter);
    const auto reach = static_cast<float>(view.reach);
    const float stretch = std::sqrt(1 + reach * reach);
    const auto count = static_cast<std::size_t>(table.count);
    std::vector<float> room(count);
    for (std::size_t i = 0; i < count; ++i) {
        room[i] = radius[i] * stretch + std::abs(z[i]) * reach + rounding;
    }
    divide(table, room);
    begin_.assign(static_cast<std::size_t>(side_ * side_) + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
        for_squares(x[i], y[i], room[i], [&](std::size_t square) { ++begin_[square]; });
    }
    std::exclusive_scan(begin_.begin(), begin_.end(), begin_.begin(), 0U);
    room_ = static_cast<std::ptrdiff_t>(begin_.back()) + table_step;
    rows_.resize(static_cast<std::size_t>(row_count * room_));
    lane_.resize(static_cast<std::size_t>(room_));
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const std::uint32_t i : front_to_back(z, radius, table.count)) {
        for_squares(x[i], y[i], room[i], [&](std::size_t square) {
            float* entry = rows_.data() + next[square];
            lane_[next[square]++] = static_cast<std::int32_t>(i);
            entry[0] = x[i];
            entry[room_] = y[i];
            entry[2 * room_] = z[i];
            entry[radius_row * room_] = radius[i];
            entry[diameter_row * room_] = diameter[i];
        });
    }
}

}  // namespace pxm::host::wide
