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
    /// Lanes of what is computed of the rays in double.
    struct InDouble {
        V start, best, pixel_base, pixel_growth;
    };

    /// What is computed of the rays in double, in several registers, as floats in one.
    template <class F>
    HWY_INLINE static V in_double(const F& f) {
        const hn::CappedTag<double, GridRays::most_lanes> dd;
        const hn::Rebind<float, decltype(dd)> narrow;
        alignas(64) float floats[GridRays::most_lanes];
        for (int j = 0; j < static_cast<int>(hn::Lanes(d)); j += static_cast<int>(hn::Lanes(dd))) {
            hn::StoreU(hn::DemoteTo(narrow, f(dd, j)), narrow, floats + j);
        }
        return hn::LoadU(d, floats);
    }
    /// As ray_below() and follow_rays() have it.
    [[nodiscard]] HWY_INLINE InDouble in_double_from(int i) const {
        const RayPacket& packet = work_.packet;
        const auto promoted = [&](auto dd, const float* from) HWY_ATTR {
            return hn::PromoteTo(dd, hn::LoadU(hn::Rebind<float, decltype(dd)>(), from));
        };
        InDouble result;
        result.best = in_double([&](auto dd, int j) HWY_ATTR {
            return hn::Sub(hn::LoadU(dd, work_.best.data() + i + j), hn::Set(dd, start_.base));
        });
        result.start = in_double([&](auto dd, int j) HWY_ATTR {
            return hn::Sub(promoted(dd, packet.start + i + j), hn::Set(dd, start_.base));
        });
        result.pixel_base = in_double([&](auto dd, int j) HWY_ATTR {
            const auto pixel1 = promoted(dd, packet.pixel1 + i + j);
            const auto pixel0 = hn::Add(promoted(dd, packet.pixel0 + i + j),
                                        hn::Mul(pixel1, hn::Set(dd, start_.base)));
            return hn::Mul(hn::Set(dd, scene_.detail), pixel0);
        });
        result.pixel_growth = in_double([&](auto dd, int j) HWY_ATTR {
            return hn::Mul(hn::Set(dd, scene_.detail), promoted(dd, packet.pixel1 + i + j));
        });
        return result;
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
        const InDouble rays = in_double_from(i);
        const InCell at = in_cell(i);
        // That the cell is entered before it is left follows, as the key is no less than where.
        const std::uint64_t met =
            lane_bits(d, hn::Le(at.key, hn::Add(at.exit, hn::Set(d, touching)))) & wanted;
        for (std::uint64_t rest = met; rest != 0; rest &= rest - 1) {
            ++work_.found[static_cast<std::size_t>(i + std::countr_zero(rest))].tested;
        }
        const std::uint64_t near = lane_bits(d, hn::Lt(at.key, rays.best)) & met;
        if (near == 0) return;
        const std::uint64_t terminal = lane_bits(d, is_terminal(rays, at.key)) & near;
        if (terminal != 0) note_terminal(terminal, i, at.key);
        const std::uint64_t go = near & ~terminal;
        const auto mask = hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&go));
        const auto put = [&](V v, float* to)
                             HWY_ATTR { hn::StoreU(hn::Compress(v, mask), d, to + rays_.count); };
        for (int k = 0; k < 3; ++k) {
            put(at.center[k], rays_.center[k]);
            put(at.pace[k], rays_.pace[k]);
        }
        put(at.key, rays_.key);
        put(rays.start, rays_.start);
        put(rays.best, rays_.best);
        put(rays.pixel_base, rays_.pixel_base);
        put(rays.pixel_growth, rays_.pixel_growth);
        hn::StoreU(hn::Compress(hn::Iota(di, i), hn::RebindMask(di, mask)), di,
                   rays_.ray + rays_.count);
        rays_.count += std::popcount(go);
    }
    /// Whether the entry cell itself is.
    [[nodiscard]] HWY_INLINE auto is_terminal(const InDouble& rays, V key) const
        -> hn::Mask<hn::CappedTag<float, GridRays::most_lanes>> {
        const V p = hn::Max(hn::Add(rays.pixel_base, hn::Mul(rays.pixel_growth, key)),
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
