// The cells of a HomothetyTable as they are seen along rays of nearly one direction, and where.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

/// Cells that a ray may meet, in units of a cell's radius.
struct ListedCells {
    const float* x;  // of the centres
    const float* y;
    const float* z;
    const float* radius;
    const float* diameter;     // times the maps' Lipschitz constant
    const std::int32_t* lane;  // in the homothety table
    int count;
};

/// All cells of a table of at most most_maps, with their centres as given.
[[nodiscard]] ListedCells whole_table(const HomothetyTable& table, const LaneTable<float>& centers);

/// Rays go along z of the view's frame, more or less: a ray moves sideways by (a, b) per depth,
/// where a^2 + b^2 <= reach^2.
struct ViewFrame {
    glm::dvec3 axis[3];  // unit vectors in scene units, perpendicular
    double reach = 0;
    bool shared = false;  // by so many rays that lists are worth their making
};

/// The cells of a HomothetyTable as they are seen. What the list of a square holds lies side by
/// side in each row.
class CandidateLists {
  public:
    /// Turns the table into the frame, and makes the lists if the view is shared.
    void make(const HomothetyTable& table, const glm::dmat3& to_frame, const ViewFrame& view);

    /// The cells that a ray may meet that is at (x, y) where it passes the centre's depth.
    [[nodiscard]] ListedCells at(const HomothetyTable& table, float x, float y) const {
        if (side_ == 0) return whole_table(table, centers_);
        const auto square = static_cast<std::size_t>(place(y) * side_ + place(x));
        const std::uint32_t begin = begin_[square];
        const float* first = rows_.data() + begin;
        return {first,
                first + room_,
                first + 2 * room_,
                first + 3 * room_,
                first + 4 * room_,
                lane_.data() + begin,
                static_cast<int>(begin_[square + 1] - begin)};
    }
    std::uint64_t made_for = 0;  // the view's number

  private:
    [[nodiscard]] int place(float beside) const {
        return static_cast<int>(std::clamp((beside + half_width_) * per_square_, 0.0F, last_));
    }
    void list(const HomothetyTable& table, const ViewFrame& view);
    void divide(const HomothetyTable& table, const std::vector<float>& room);
    template <class Each>
    void for_squares(float x, float y, float room, const Each& each) const;

    int side_ = 0;  // squares along a side; 0: no lists
    float half_width_ = 0;
    float per_square_ = 0;
    float last_ = 0;           // square of a side
    std::ptrdiff_t room_ = 0;  // of a row
    std::vector<std::uint32_t> begin_;
    std::vector<float> rows_;
    std::vector<std::int32_t> lane_;
    LaneTable<float> centers_;
};

}  // namespace pxm::host::wide
