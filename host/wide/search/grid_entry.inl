// An entry cell of boxes in slices, and the rays of the packet that meet it: what grid_lanes.inl
// needs of each, rays in lanes, and what it has found.
#if defined(PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL
#undef PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL
#else
#define PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "host/wide/search/grid_lanes.inl"
#include "host/wide/search/homothety_entry.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// An entry cell of an object with a common grid. No ray of the packet is parallel to a face.
class GridVisit {
  public:
    /// `box` is the cell as the packet sees it.
    GridVisit(const WideScene& scene, SearchWorkspace& work, const EntryBelow& start,
              const SharedCell& box)
        : scene_(scene),
          work_(work),
          start_(start),
          grid_(scene.common_grids[static_cast<std::size_t>(start.object.common_grid)]) {
        for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i] = static_cast<float>(box.rows[i]);
    }

    /// Follows those of the rays that meet the cell; `touching` as in PacketPace.
    void visit(std::uint64_t rays, float touching) {
        const auto lanes = static_cast<int>(hn::Lanes(d));
        const std::uint64_t all = ~std::uint64_t{0} >> (packet_rays - lanes);
        for (int i = 0; i < packet_rays; i += lanes) {
            if ((rays >> i & all) != 0) take_lanes(rays >> i & all, i, touching);
        }
        if (rays_.count == 0) return;
        const GridEntry entry{grid_, grid_.number_of(start_.cell.set),
                              static_cast<float>(start_.cell.constant),
                              start_.object.levels - start_.cell.level, start_.least};
        constexpr int few_slices = 3;
        const bool few = *std::ranges::max_element(grid_.slices) <= few_slices;
        for (int first = 0; first < rays_.count; first += lanes) {
            if (few) {
                follow<few_slices>(entry, first);
            } else {
                follow<ChildGrid::most_slices>(entry, first);
            }
        }
    }

  private:
    static constexpr hn::CappedTag<float, GridRays::most_lanes> d{};
    static constexpr hn::RebindToSigned<hn::CappedTag<float, GridRays::most_lanes>> di{};
    using V = hn::VFromD<decltype(d)>;

    /// Lanes of rays in the entry cell, as GridRays has them, and where they leave it.
    struct InCell {
        V center[3], pace[3];
        V key, exit;
    };
    /// What is computed of the rays in double. It takes several registers, and is read as floats in
    /// one only after other work: a load waits for stores that are narrower.
    struct InDouble {
        alignas(64) float start[GridRays::most_lanes];
        alignas(64) float best[GridRays::most_lanes];
        alignas(64) float pixel_base[GridRays::most_lanes];
        alignas(64) float pixel_growth[GridRays::most_lanes];
    };

    /// As ray_below() and follow_rays() have it.
    HWY_INLINE void compute_in_double(int first, InDouble& rays) const {
        const hn::CappedTag<double, GridRays::most_lanes> dd;
        const hn::Rebind<float, decltype(dd)> narrow;
        const RayPacket& packet = work_.packet;
        const auto base = hn::Set(dd, start_.base), detail = hn::Set(dd, scene_.detail);
        for (int i = 0; i < static_cast<int>(hn::Lanes(d)); i += static_cast<int>(hn::Lanes(dd))) {
            const auto promoted = [&](const float* from) HWY_ATTR {
                return hn::PromoteTo(dd, hn::LoadU(narrow, from + first + i));
            };
            const auto put = [&](auto v, float* to)
                                 HWY_ATTR { hn::StoreU(hn::DemoteTo(narrow, v), narrow, to + i); };
            const auto pixel1 = promoted(packet.pixel1);
            const auto pixel0 = hn::Add(promoted(packet.pixel0), hn::Mul(pixel1, base));
            put(hn::Sub(promoted(packet.start), base), rays.start);
            put(hn::Sub(hn::LoadU(dd, work_.best.data() + first + i), base), rays.best);
            put(hn::Mul(detail, pixel0), rays.pixel_base);
            put(hn::Mul(detail, pixel1), rays.pixel_growth);
        }
    }
    /// As meet_entry_cell() has it.
    [[nodiscard]] HWY_INLINE InCell in_cell(int i) const {
        const RayPacket& packet = work_.packet;
        const V base = hn::Set(d, static_cast<float>(start_.base));
        const V u1 = hn::LoadU(d, packet.u1 + i), v1 = hn::LoadU(d, packet.v1 + i);
        const V u = hn::Add(hn::LoadU(d, packet.u0 + i), hn::Mul(u1, base));
        const V v = hn::Add(hn::LoadU(d, packet.v0 + i), hn::Mul(v1, base));
        InCell rays;
        rays.key = hn::Sub(hn::LoadU(d, packet.start + i), base);
        rays.exit = hn::Set(d, std::numeric_limits<float>::infinity());
        for (std::size_t k = 0; k < 3; ++k) {
            const auto row = [&](std::size_t r) HWY_ATTR { return hn::Set(d, rows_[3 * r + k]); };
            const V origin = hn::Add(hn::Add(row(3), hn::Mul(u, row(0))), hn::Mul(v, row(1)));
            const V speed = hn::Add(hn::Add(row(2), hn::Mul(u1, row(0))), hn::Mul(v1, row(1)));
            const V still = hn::Set(d, 1e-30F);
            const V pace =
                hn::Div(hn::Set(d, 1.0F), hn::IfThenElse(hn::Eq(speed, hn::Zero(d)), still, speed));
            const V center = hn::Neg(hn::Mul(origin, pace));
            rays.key = hn::Max(rays.key, hn::Sub(center, hn::Abs(pace)));
            rays.exit = hn::Min(rays.exit, hn::Add(center, hn::Abs(pace)));
            rays.center[k] = center;
            rays.pace[k] = pace;
        }
        return rays;
    }
    /// Puts those of the rays close together that go on, of `wanted` from lane i on.
    HWY_INLINE void take_lanes(std::uint64_t wanted, int i, float touching) {
        InDouble rays;
        compute_in_double(i, rays);
        const InCell at = in_cell(i);
        // That the cell is entered before it is left follows, as the key is no less than where.
        const std::uint64_t met =
            lane_bits(d, hn::Le(at.key, hn::Add(at.exit, hn::Set(d, touching)))) & wanted;
        for (std::uint64_t rest = met; rest != 0; rest &= rest - 1) {
            ++work_.found[static_cast<std::size_t>(i + std::countr_zero(rest))].tested;
        }
        const std::uint64_t near = lane_bits(d, hn::Lt(at.key, hn::LoadU(d, rays.best))) & met;
        if (near == 0) return;
        const std::uint64_t terminal = lane_bits(d, is_terminal(rays, at.key)) & near;
        if (terminal != 0) note_terminal(terminal, i, at.key);
        if (near != terminal) put_close(near & ~terminal, i, at, rays);
    }
    /// Puts the rays of lanes close together.
    HWY_INLINE void put_close(std::uint64_t lanes, int first, const InCell& at,
                              const InDouble& rays) {
        constexpr int numbers = 11;
        const V all[numbers] = {at.center[0],
                                at.center[1],
                                at.center[2],
                                at.pace[0],
                                at.pace[1],
                                at.pace[2],
                                at.key,
                                hn::LoadU(d, rays.start),
                                hn::LoadU(d, rays.best),
                                hn::LoadU(d, rays.pixel_base),
                                hn::LoadU(d, rays.pixel_growth)};
        float* const places[numbers] = {rays_.center[0],  rays_.center[1],   rays_.center[2],
                                        rays_.pace[0],    rays_.pace[1],     rays_.pace[2],
                                        rays_.key,        rays_.start,       rays_.best,
                                        rays_.pixel_base, rays_.pixel_growth};
        // Only these registers can do it; for others Highway 1.0.3 copies a table of orders to the
        // stack each time.
        if constexpr (HWY_TARGET <= HWY_AVX3) {
            const auto mask = hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&lanes));
            for (int k = 0; k < numbers; ++k) {
                hn::StoreU(hn::Compress(all[k], mask), d, places[k] + rays_.count);
            }
            for (std::uint64_t rest = lanes; rest != 0; rest &= rest - 1) {
                rays_.ray[rays_.count++] = first + std::countr_zero(rest);
            }
        } else {
            alignas(64) float rows[numbers][GridRays::most_lanes];
            for (int k = 0; k < numbers; ++k) hn::StoreU(all[k], d, rows[k]);
            for (std::uint64_t rest = lanes; rest != 0; rest &= rest - 1) {
                const int lane = std::countr_zero(rest);
                for (int k = 0; k < numbers; ++k) places[k][rays_.count] = rows[k][lane];
                rays_.ray[rays_.count++] = first + lane;
            }
        }
    }
    /// Whether the entry cell itself is.
    [[nodiscard]] HWY_INLINE auto is_terminal(const InDouble& rays, V key) const
        -> hn::Mask<hn::CappedTag<float, GridRays::most_lanes>> {
        const V growth = hn::LoadU(d, rays.pixel_growth);
        const V p = hn::Max(hn::Add(hn::LoadU(d, rays.pixel_base), hn::Mul(growth, key)),
                            hn::Set(d, start_.least));
        const float diameter = start_.last ? -std::numeric_limits<float>::infinity()
                                           : static_cast<float>(start_.cell.diameter);
        return hn::Le(hn::Set(d, diameter), p);
    }
    void note_terminal(std::uint64_t rays, int first, V key) {
        alignas(64) float keys[GridRays::most_lanes];
        hn::StoreU(key, d, keys);
        for (; rays != 0; rays &= rays - 1) {
            const int i = std::countr_zero(rays);
            work_.found[static_cast<std::size_t>(first + i)].below_count = 0;
            note(first + i, keys[i]);
        }
    }
    template <int most>
    void follow(const GridEntry& entry, int first) {
        constexpr int n = GridRays::most_lanes;
        alignas(64) std::int32_t left[n] = {}, levels[n];
        alignas(64) float depth[n];
        const int count = std::min(rays_.count - first, static_cast<int>(hn::Lanes(d)));
        for (int i = 0; i < count; ++i) left[i] = may_test(rays_.ray[first + i]);
        GridLanes<most> lanes(entry, rays_, first, left);
        lanes.follow(count);
        lanes.store(depth, levels, left);
        const std::uint64_t given_up = lanes.given_up(), found = lanes.found();
        for (int i = 0; i < count; ++i) {
            const int ray = rays_.ray[first + i];
            Found& here = work_.found[static_cast<std::size_t>(ray)];
            here.tested += static_cast<std::uint32_t>(may_test(ray) - left[i]);
            if ((given_up >> i & 1) != 0) {
                leave_ray(work_, ray);
            } else if ((found >> i & 1) != 0) {
                here.below_count = levels[i];
                lanes.put_word(i, levels[i], here.below.data());
                note(ray, depth[i]);
            }
        }
    }
    /// How many boxes more a ray may test.
    [[nodiscard]] std::int32_t may_test(int ray) const {
        const std::uint32_t tested = work_.found[static_cast<std::size_t>(ray)].tested;
        constexpr std::uint32_t most = std::numeric_limits<std::int32_t>::max();
        return static_cast<std::int32_t>(
            std::min(most, scene_.cell_cap - std::min(scene_.cell_cap, tested)));
    }
    /// Depths are from the entry cell's base.
    void note(int ray, float depth) {
        note_found(work_, ray, start_.index, start_.base + static_cast<double>(depth));
    }

    const WideScene& scene_;
    SearchWorkspace& work_;
    const EntryBelow& start_;
    const CommonGrid& grid_;
    std::array<float, 12> rows_;
    GridRays rays_;
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
