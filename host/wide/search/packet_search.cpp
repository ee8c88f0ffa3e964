// Highway compiles this file once for every kind of register and picks one at run time.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "host/wide/search/packet_search.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "host/wide/search/packet_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "host/wide/search/entry_ball.inl"
#include "host/wide/search/entry_box.inl"
#include "host/wide/search/entry_cell.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

// The largest diameter of an entry cell: sharing costs more where maps turn and squash.
constexpr double entry_pixels_of_homotheties = 16;
constexpr double entry_pixels_of_maps = 24;

/// The depth beyond which no ray of the packet looks any more.
inline double farthest_best(const SearchWorkspace& work) {
    const hn::ScalableTag<double> d;
    auto farthest = hn::Zero(d);
    for (std::size_t i = 0; i < packet_rays; i += hn::Lanes(d)) {
        farthest = hn::Max(farthest, hn::LoadU(d, work.best.data() + i));
    }
    return hn::GetLane(hn::MaxOfLanes(d, farthest));
}

/// Whether a shared cell is small enough for the rays to go on alone.
template <class Shared>
inline bool is_entry(const WideScene& scene, const SearchWorkspace& work, const Shared& cell,
                     double near, double most_pixels) {
    return cell.level == scene.objects[static_cast<std::size_t>(cell.object)].levels ||
           cell.diameter <= most_pixels * pixel_at(scene, work.packet, cell.object, near);
}

/// As visit_entry_cell(), for an object of homotheties.
inline void visit_homotheties(const WideScene& scene, SearchWorkspace& work, int index) {
    begin_looking(work);
    const HomothetyCell cell = work.homothety_cells[static_cast<std::size_t>(index)];
    if (scene.objects[static_cast<std::size_t>(cell.object)].spheres) {
        spread_in_candidate_view(scene, work);
        BallVisit(scene, work, cell, index).visit();
    } else {
        visit_box(scene, work, cell, index);
    }
}

/// Goes down into a cell of the queue, or gives it to the rays.
inline void take_cell(const WideScene& scene, SearchWorkspace& work, double near, int index) {
    if (index < 0) {
        const HomothetyCell& cell = work.homothety_cells[static_cast<std::size_t>(~index)];
        if (is_entry(scene, work, cell, near, entry_pixels_of_homotheties)) {
            visit_homotheties(scene, work, ~index);
        } else {
            open_homothety_cell(scene, work, ~index);
        }
        return;
    }
    const SharedCell& cell = work.cells[static_cast<std::size_t>(index)];
    if (is_entry(scene, work, cell, near, entry_pixels_of_maps)) {
        visit_entry_cell(scene, work, index);
    } else {
        open_shared_cell(scene, work, index);
    }
}

/// Whether a tile's cells are too many for its tables: they are far smaller than its pixels.
inline bool has_too_many_cells(const SearchWorkspace& work) {
    return work.cells.size() + work.homothety_cells.size() > most_shared_cells ||
           work.arena.is_full();
}

/// Leaves the rays that may find something at `near` or beyond to the reference kernels.
inline void give_up_from(SearchWorkspace& work, double near) {
    begin_looking(work);
    for (std::uint64_t rest = work.packet.inside; rest != 0; rest &= rest - 1) {
        const auto ray = static_cast<std::size_t>(std::countr_zero(rest));
        if (near < work.best[ray]) work.found[ray].given_up = true;
    }
}

void search(const WideScene& scene, SearchWorkspace& work) {
    for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
        if (scene.objects[static_cast<std::size_t>(i)].of_homotheties) {
            push_homothety_object(scene, work, i);
        } else {
            push_object(scene, work, i);
        }
    }
    while (!work.queue.empty()) {
        const auto [near, index] = work.queue.front();
        if (work.improved) {
            work.farthest = farthest_best(work);
            work.improved = false;
        }
        if (work.farthest <= near) return;
        if (has_too_many_cells(work)) return give_up_from(work, near);
        std::pop_heap(work.queue.begin(), work.queue.end(), IsFarther{});
        work.queue.pop_back();
        take_cell(scene, work, near, index);
    }
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pxm::host::wide {

HWY_EXPORT(search);

float* Arena::floats(std::size_t count) {
    if (used_ + count > chunk_floats) {
        ++chunk_;
        used_ = 0;
    }
    if (chunks_.size() <= chunk_) chunks_.push_back(hwy::AllocateAligned<float>(chunk_floats));
    float* room = chunks_[chunk_].get() + used_;
    used_ += count;
    return room;
}

bool search_packet(const WideScene& scene, SearchWorkspace& work) {
    work.cells.clear();
    work.queue.clear();
    work.blocks.clear();
    work.arena.clear();
    ++work.packet_number;
    work.homothety_cells.clear();
    work.box_frusta.resize(scene.objects.size());
    work.turned.resize(scene.sets.size());
    work.turned_for.resize(scene.sets.size(), 0);
    work.shared_tests = 0;
    work.looking = false;
    work.improved = true;
    work.best = work.packet.end;
    for (std::uint64_t rest = ~work.packet.inside; rest != 0; rest &= rest - 1) {
        work.best[static_cast<std::size_t>(std::countr_zero(rest))] = 0;  // nothing to look for
    }
    HWY_DYNAMIC_DISPATCH(search)(scene, work);
    return work.looking;
}

}  // namespace pxm::host::wide
#endif
