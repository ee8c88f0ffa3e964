// One ray below an entry cell whose children are boxes in slices along the axes, as Menger's
// sponge: the ray goes through the slices one after another, and the first terminal cell it comes
// to is the nearest. No order has to be made, and cells that are not on the ray are never looked
// at. Conditions: host/wide/tables/child_grid.hpp.
#if defined(PXM_HOST_WIDE_SEARCH_GRID_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_GRID_WALK_INL
#undef PXM_HOST_WIDE_SEARCH_GRID_WALK_INL
#else
#define PXM_HOST_WIDE_SEARCH_GRID_WALK_INL
#endif

#include <algorithm>
#include <array>

#include "host/wide/search/homothety_entry.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

/// A cell that the ray is in, and the slices of its children that it has come to.
struct WalkedCell {
    const WideSet* set;
    float center[3];  // depth at which the ray passes the centre's three planes
    float reach[3];   // from there to the depth at which it leaves by the far or the near plane
    float constant;   // Lipschitz constant of the composed map
    int slice[3];
    float exit[3];  // depth at which the ray leaves the slice
    int lane;       // of the child it went into
};

/// A walk of one ray through the children of cells, and theirs.
class GridWalk {
  public:
    GridWalk(const WideScene& scene, const BoxRay& ray) : scene_(scene), ray_(ray) {
        for (int k = 0; k < 3; ++k) step_[k] = ray.pace[k] > 0 ? 1 : -1;
    }

    /// From the entry cell on, whose centre's planes the ray passes at `center`: the nearest
    /// terminal cell that is nearer than the ray's best. True, and what is known of the ray
    /// changed, if there is one. `parallel`: the ray may lie in faces.
    template <bool parallel>
    bool follow(const HomothetyCell& start, const float* center, std::uint32_t levels_left,
                RayBelow& below) {
        Found& found = below.found;
        enter(start.set, center, ray_.pace, static_cast<float>(start.constant), below.depth);
        while (true) {
            WalkedCell& cell = cells_[static_cast<std::size_t>(level_)];
            const HomothetyTable& table = cell.set->children;
            cell.lane = cell.set->grid.lane_at(cell.slice);
            if constexpr (parallel) {
                if (in_face(cell)) {
                    found.given_up = true;
                    return false;
                }
            }
            if (cell.lane >= 0) {
                ++found.tested;
                if (found.tested >= scene_.cell_cap) found.given_up = true;
                if (found.given_up) return false;
                float key = ray_.start;
                if (meets(cell, table, cell.lane, key)) {
                    if (!(key < ray_.best)) return false;  // what comes later is farther
                    const float diameter =
                        cell.constant * table.rows.row(HomothetyTable::diameter)[cell.lane];
                    const bool last = static_cast<std::uint32_t>(level_) + 1 == levels_left;
                    if (last || diameter <= ray_.pixel(key)) {
                        below.depth = key;
                        keep_word(found);
                        return true;
                    }
                    if (level_ + 1 == Found::most_below) {
                        found.given_up = true;
                        return false;
                    }
                    go_inside(cell, table, key);
                    continue;
                }
            }
            while (!next_slice()) {
                if (level_ == 0) return false;
                --level_;
            }
        }
    }

  private:
    /// Whether the ray meets a child at `key` or later; then `key` is where it enters.
    [[nodiscard]] bool meets(const WalkedCell& cell, const HomothetyTable& table, int lane,
                             float& key) {
        const float scale = table.rows.row(HomothetyTable::scale)[lane];
        float exit = std::numeric_limits<float>::infinity();
        for (int k = 0; k < 3; ++k) {
            center_[k] = cell.center[k] + cell.reach[k] * table.rows.row(k)[lane];
            const float half = scale * std::abs(cell.reach[k]);
            key = std::max(key, center_[k] - half);
            exit = std::min(exit, center_[k] + half);
        }
        return key <= exit + ray_.touching;
    }
    /// Whether the ray lies in a face of the slice that it has come to, or of the child there.
    [[nodiscard]] bool in_face(const WalkedCell& cell) const {
        for (int k = 0; k < 3; ++k) {
            if (ray_.room[k] < 0) continue;
            const auto near = [&](float plane) {
                return std::abs(cell.center[k] + cell.reach[k] * plane) <= ray_.room[k];
            };
            if (near(cell.set->grid.plane(k, cell.slice[k])) ||
                near(cell.set->grid.plane(k, cell.slice[k] + 1))) {
                return true;
            }
            if (cell.lane < 0) continue;
            const HomothetyTable& table = cell.set->children;
            const float middle = table.rows.row(k)[cell.lane];
            const float half = table.rows.row(HomothetyTable::scale)[cell.lane];
            if (near(middle - half) || near(middle + half)) return true;
        }
        return false;
    }
    /// Goes into the child that meets() has looked at.
    void go_inside(const WalkedCell& cell, const HomothetyTable& table, float key) {
        const int lane = cell.lane;
        const float scale = table.rows.row(HomothetyTable::scale)[lane];
        const float constant = cell.constant * table.rows.row(HomothetyTable::constant)[lane];
        const float reach[3] = {scale * cell.reach[0], scale * cell.reach[1],
                                scale * cell.reach[2]};
        ++level_;
        enter(table.sets[static_cast<std::size_t>(lane)], center_, reach, constant, key);
    }
    void enter(int set, const float* center, const float* reach, float constant, float key) {
        WalkedCell& cell = cells_[static_cast<std::size_t>(level_)];
        cell.set = &scene_.sets[static_cast<std::size_t>(set)];
        cell.constant = constant;
        for (int k = 0; k < 3; ++k) {
            cell.center[k] = center[k];
            cell.reach[k] = reach[k];
            cell.slice[k] = step_[k] > 0 ? 0 : cell.set->grid.slices[k] - 1;
            cell.exit[k] = exit_of(cell, k);
            while (cell.exit[k] <= key && advance(cell, k)) {
            }
        }
    }
    /// Where the ray leaves a cell's slice along an axis.
    [[nodiscard]] float exit_of(const WalkedCell& cell, int axis) const {
        const int plane = cell.slice[axis] + (step_[axis] > 0 ? 1 : 0);
        return cell.center[axis] + cell.reach[axis] * cell.set->grid.plane(axis, plane);
    }
    /// To the next slice along an axis; false if there is none.
    bool advance(WalkedCell& cell, int axis) {
        const int next = cell.slice[axis] + step_[axis];
        if (next < 0 || next >= cell.set->grid.slices[axis]) return false;
        cell.slice[axis] = next;
        cell.exit[axis] = exit_of(cell, axis);
        return true;
    }
    /// To the slice behind the nearest plane; false if the ray leaves the cell there.
    bool next_slice() {
        WalkedCell& cell = cells_[static_cast<std::size_t>(level_)];
        int axis = cell.exit[1] < cell.exit[0] ? 1 : 0;
        if (cell.exit[2] < cell.exit[axis]) axis = 2;
        return advance(cell, axis);
    }
    void keep_word(Found& found) const {
        found.below_count = level_ + 1;
        for (int i = 0; i <= level_; ++i) {
            const WalkedCell& cell = cells_[static_cast<std::size_t>(i)];
            found.below[static_cast<std::size_t>(i)] =
                cell.set->children.lanes[static_cast<std::size_t>(cell.lane)][0];
        }
    }

    const WideScene& scene_;
    const BoxRay& ray_;
    int level_ = 0;  // below the entry cell
    int step_[3];    // from slice to slice
    float center_[3];
    std::array<WalkedCell, Found::most_below> cells_;
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
