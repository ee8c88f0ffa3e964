// An entry cell of boxes in slices, and the rays of the packet that meet it: what grid_lanes.inl
// needs of each, rays in lanes, and what it has found.
#if defined(PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL
#undef PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL
#else
#define PXM_HOST_WIDE_SEARCH_GRID_ENTRY_INL
#endif

#include <algorithm>
#include <bit>
#include <limits>

#include "host/wide/search/grid_lanes.inl"
#include "host/wide/search/homothety_entry.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// An entry cell of an object with a common grid.
class GridVisit {
  public:
    GridVisit(const WideScene& scene, SearchWorkspace& work, const EntryBelow& start)
        : scene_(scene),
          work_(work),
          start_(start),
          grid_(scene.common_grids[static_cast<std::size_t>(start.object.common_grid)]) {}

    /// Follows those of the rays that have `met` the cell which are parallel to none of its faces;
    /// returns the others.
    std::uint64_t visit(std::uint64_t met) {
        take_rays(met);
        const std::uint64_t followed = met & ~parallel_;
        for (std::uint64_t rest = followed; rest != 0; rest &= rest - 1) {
            ++work_.found[static_cast<std::size_t>(std::countr_zero(rest))].tested;
        }
        for (std::uint64_t rest = terminal_; rest != 0; rest &= rest - 1) {
            const int i = std::countr_zero(rest);
            work_.found[static_cast<std::size_t>(i)].below_count = 0;
            note(i, work_.start.key[i]);
        }
        const GridEntry entry{grid_, grid_.number_of(start_.cell.set),
                              static_cast<float>(start_.cell.constant),
                              start_.object.levels - start_.cell.level, start_.least};
        constexpr int few_slices = 3;
        const bool few = *std::ranges::max_element(grid_.slices) <= few_slices;
        const auto lanes = static_cast<int>(hn::Lanes(d));
        for (int first = 0; first < rays_.count; first += lanes) {
            if (few) {
                follow<few_slices>(entry, first);
            } else {
                follow<ChildGrid::most_slices>(entry, first);
            }
        }
        return parallel_;
    }

  private:
    static constexpr hn::CappedTag<float, GridRays::most_lanes> d{};
    static constexpr hn::RebindToSigned<hn::CappedTag<float, GridRays::most_lanes>> di{};
    using V = hn::VFromD<decltype(d)>;

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
    /// As BoxRay::know_faces().
    HWY_INLINE static auto is_parallel(const V* pace) {
        const V x = hn::Abs(pace[0]), y = hn::Abs(pace[1]), z = hn::Abs(pace[2]);
        const V passing = hn::Min(hn::Min(x, y), z);
        const V slowest = hn::Mul(passing, hn::Set(d, static_cast<float>(1 / slowest_share)));
        return hn::Lt(slowest, max3(x, y, z));
    }
    /// Puts the rays that go on close together.
    void take_rays(std::uint64_t met) {
        const auto lanes = static_cast<int>(hn::Lanes(d));
        const std::uint64_t all = ~std::uint64_t{0} >> (packet_rays - lanes);
        for (int i = 0; i < packet_rays; i += lanes) {
            if ((met >> i & all) != 0) take_lanes(met, i);
        }
    }
    HWY_INLINE void take_lanes(std::uint64_t met, int i) {
        const RayPacket& packet = work_.packet;
        const auto promoted = [&](auto dd, const float* from) HWY_ATTR {
            return hn::PromoteTo(dd, hn::LoadU(hn::Rebind<float, decltype(dd)>(), from));
        };
        const V best = in_double([&](auto dd, int j) HWY_ATTR {
            return hn::Sub(hn::LoadU(dd, work_.best.data() + i + j), hn::Set(dd, start_.base));
        });
        const V key = hn::LoadU(d, work_.start.key + i);
        const std::uint64_t near = lane_bits(d, hn::Lt(key, best)) << i & met;
        if (near == 0) return;
        const V start = in_double([&](auto dd, int j) HWY_ATTR {
            return hn::Sub(promoted(dd, packet.start + i + j), hn::Set(dd, start_.base));
        });
        const V pixel_base = in_double([&](auto dd, int j) HWY_ATTR {
            const auto pixel1 = promoted(dd, packet.pixel1 + i + j);
            const auto pixel0 = hn::Add(promoted(dd, packet.pixel0 + i + j),
                                        hn::Mul(pixel1, hn::Set(dd, start_.base)));
            return hn::Mul(hn::Set(dd, scene_.detail), pixel0);
        });
        const V pixel_growth = in_double([&](auto dd, int j) HWY_ATTR {
            return hn::Mul(hn::Set(dd, scene_.detail), promoted(dd, packet.pixel1 + i + j));
        });
        V center[3], pace[3];
        for (int k = 0; k < 3; ++k) {
            const V s = hn::LoadU(d, work_.start.direction[k] + i);
            const V still = hn::Set(d, 1e-30F);
            pace[k] = hn::Div(hn::Set(d, 1.0F), hn::IfThenElse(hn::Eq(s, hn::Zero(d)), still, s));
            center[k] = hn::Mul(hn::Neg(hn::LoadU(d, work_.start.origin[k] + i)), pace[k]);
        }
        const V p =
            hn::Max(hn::Add(pixel_base, hn::Mul(pixel_growth, key)), hn::Set(d, start_.least));
        const float diameter = start_.last ? -std::numeric_limits<float>::infinity()
                                           : static_cast<float>(start_.cell.diameter);
        const std::uint64_t terminal = lane_bits(d, hn::Le(hn::Set(d, diameter), p)) << i & near;
        const std::uint64_t parallel = lane_bits(d, is_parallel(pace)) << i & near & ~terminal;
        terminal_ |= terminal;
        parallel_ |= parallel;
        const std::uint64_t go = near & ~terminal & ~parallel;
        if (go == 0) return;
        const std::uint64_t bits = go >> i;
        const auto mask = hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
        const auto put = [&](V v, float* to)
                             HWY_ATTR { hn::StoreU(hn::Compress(v, mask), d, to + rays_.count); };
        for (int k = 0; k < 3; ++k) {
            put(center[k], rays_.center[k]);
            put(pace[k], rays_.pace[k]);
        }
        put(key, rays_.key);
        put(start, rays_.start);
        put(best, rays_.best);
        put(pixel_base, rays_.pixel_base);
        put(pixel_growth, rays_.pixel_growth);
        for (std::uint64_t rest = go & all_lanes(i); rest != 0; rest &= rest - 1) {
            rays_.ray[rays_.count++] = std::countr_zero(rest);
        }
    }
    [[nodiscard]] static std::uint64_t all_lanes(int i) {
        return ~std::uint64_t{0} >> (packet_rays - static_cast<int>(hn::Lanes(d))) << i;
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
    std::uint64_t parallel_ = 0, terminal_ = 0;
    GridRays rays_;
};

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
