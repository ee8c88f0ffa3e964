// What rays see of cells below the same start cell: as seen_cell.inl, a ray in each lane. The levels
// that the rays share are broadcast; of the others each ray has its own. What is rare is left to
// see(): point lights, cells around an object, rays that begin inside of all cells.
#if defined(PXM_HOST_WIDE_SEEN_TOGETHER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SEEN_TOGETHER_INL
#undef PXM_HOST_WIDE_SEEN_TOGETHER_INL
#else
#define PXM_HOST_WIDE_SEEN_TOGETHER_INL
#endif

#include <hwy/highway.h>

#include <bit>

#include "host/wide/seen_cell.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE hn::VFromD<D> load_floats(D d, const float* from) {
    if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
        return hn::LoadU(d, from);
    } else {
        return hn::PromoteTo(d, hn::LoadU(hn::Rebind<float, D>(), from));
    }
}

/// Takes a ray into a lane: where it goes, and how p grows along it.
inline void take_ray(const WideScene& scene, const Workspace& work, const Path& path, int ray,
                     int lane, SeenTogether& t) {
    const RayBundle& bundle = work.bundle;
    const PathRay path_ray(scene, work, path, ray);
    t.beside[0][lane] = bundle.u0[ray];
    t.beside[1][lane] = bundle.u1[ray];
    t.beside[2][lane] = bundle.v0[ray];
    t.beside[3][lane] = bundle.v1[ray];
    t.start[lane] = path_ray.start;
    t.pixel_base[lane] = path_ray.pixel_base;
    t.pixel_growth[lane] = path_ray.pixel_growth;
}

/// The levels of a ray's own, of homotheties: centre and 1 / size seen from the start cell.
inline bool take_own_homotheties(const WideScene& scene, const Workspace& work, const Path& path,
                                 const Found& found, int lane, SeenTogether& t) {
    if (found.below_count > SeenTogether::most_own) return false;
    const FixedCell& cell = work.fixed_cells[static_cast<std::size_t>(found.start)];
    const WideObject& object = scene.objects[static_cast<std::size_t>(cell.object)];
    std::array<float, 3> center{};
    float size = 1;
    auto constant = static_cast<float>(cell.constant);
    int set_index = cell.set;
    SeenColor& color = t.color[static_cast<std::size_t>(lane)];
    color = {path.hash, path.color};
    for (int k = 0; k < found.below_count; ++k) {
        const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
        const std::size_t child = found.below[static_cast<std::size_t>(k)];
        const HomothetyTable& table = set.children;
        const auto field = [&](int row) { return table.rows.row(row)[child]; };
        for (int axis = 0; axis < 3; ++axis) {
            center[static_cast<std::size_t>(axis)] += size * field(axis);
            t.map[k][axis][lane] = center[static_cast<std::size_t>(axis)];
        }
        size *= field(HomothetyTable::scale);
        t.map[k][3][lane] = 1 / size;
        t.diameter[k][lane] = constant * field(HomothetyTable::diameter);
        constant *= field(HomothetyTable::constant);
        color.hash = hash_symbol(color.hash, set.maps[child]);
        if (object.colored) blend(color.color, set.colors[child]);
        set_index = set.sets[child];
    }
    t.levels[lane] = path.shared + found.below_count;
    return true;
}

/// The same of other maps: from the start cell's unit coordinates to the cell's.
inline bool take_own_maps(const WideScene& scene, const Workspace& work, const Path& path,
                          const Found& found, int lane, SeenTogether& t) {
    SeenColor& color = t.color[static_cast<std::size_t>(lane)];
    color = {path.hash, path.color};
    t.levels[lane] = path.shared;
    if (found.block < 0) return true;
    const Block* blocks = work.blocks.data();
    const int own = static_cast<int>(blocks[found.block].level) + 1 - path.shared;
    if (own > SeenTogether::most_own) return false;
    std::array<std::pair<int, int>, SeenTogether::most_own> word;  // set and child
    int child = found.lane;
    for (int k = own - 1, index = found.block; k >= 0; --k) {
        const Block& block = blocks[index];
        const int stride = scene.sets[static_cast<std::size_t>(block.set)].stride;
        for (int i = 0; i < 12; ++i) t.map[k][i][lane] = block.rows[i * stride + child];
        t.diameter[k][lane] = block.rows[Block::diameter * stride + child];
        word[static_cast<std::size_t>(k)] = {block.set, child};
        child = block.lane;
        index = block.parent;
    }
    const bool colored = scene.objects[static_cast<std::size_t>(path.object)].colored;
    for (int k = 0; k < own; ++k) {
        const auto [set_index, symbol] = word[static_cast<std::size_t>(k)];
        const WideSet& set = scene.sets[static_cast<std::size_t>(set_index)];
        const auto at = static_cast<std::size_t>(symbol);
        color.hash = hash_symbol(color.hash, set.maps[at]);
        if (colored) blend(color.color, set.colors[at]);
    }
    t.levels[lane] = path.shared + own;
    return true;
}

template <class D, class V>
HWY_INLINE void put_level_hits(D d, const LevelHits<V>& met, int level, int lane,
                               SeenTogether& t) {
    put_hits(d, met.key, t.hits[level][0] + lane);
    put_hits(d, met.exit, t.hits[level][1] + lane);
    put_hits(d, met.normal.x, t.hits[level][2] + lane);
    put_hits(d, met.normal.y, t.hits[level][3] + lane);
    put_hits(d, met.normal.z, t.hits[level][4] + lane);
}

/// Where the rays enter the cells that they share; `rows` as in Path, of floats or doubles.
template <class T>
inline void meet_shared_levels(const Path& path, const T* rows, bool spheres, SeenTogether& t) {
    const hn::CappedTag<T, SeenTogether::most_lanes> d;
    using V = hn::VFromD<decltype(d)>;
    const auto step = static_cast<int>(hn::Lanes(d));
    for (int lane = 0; lane < t.count; lane += step) {
        const auto beside = [&](int i) HWY_ATTR { return load_floats(d, t.beside[i] + lane); };
        const BesideAxis<V> ray{beside(0), beside(1), beside(2), beside(3)};
        for (int level = 0; level < path.shared; ++level) {
            const auto number = [&](int i) HWY_ATTR {
                return hn::Set(d, rows[i * Path::capacity + level]);
            };
            const auto row = [&](int i) HWY_ATTR {
                return Lanes3<V>{number(i), number(i + 1), number(i + 2)};
            };
            const V base = number(Path::base);
            V from_start = hn::Sub(base, hn::Set(d, static_cast<T>(path.start_base)));
            if constexpr (sizeof(T) == sizeof(float)) from_start = number(Path::from_start);
            const LevelRows<V> cell{row(0), row(3), row(6), row(9), base, from_start};
            put_level_hits(d, meet_levels(d, cell, ray, spheres, PathSide::entry), level, lane, t);
        }
    }
}

/// Where each ray enters the cells of its own.
inline void meet_own_levels(const Path& path, int most, bool spheres, SeenTogether& t) {
    const hn::CappedTag<float, SeenTogether::most_lanes> d;
    using V = hn::VFromD<decltype(d)>;
    const int start = path.shared - 1;
    const auto number = [&](int i) HWY_ATTR { return hn::Set(d, path.rows[i][start]); };
    const auto row = [&](int i) HWY_ATTR {
        return Lanes3<V>{number(i), number(i + 1), number(i + 2)};
    };
    const LevelRows<V> outer{row(0), row(3), row(6), row(9), number(Path::base), hn::Zero(d)};
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const auto beside = [&](int i) HWY_ATTR { return hn::LoadU(d, t.beside[i] + lane); };
        const BesideAxis<V> ray{beside(0), beside(1), beside(2), beside(3)};
        for (int k = 0; k < most; ++k) {
            LevelRows<V> cell = outer;
            const auto own = [&](int i) HWY_ATTR { return hn::LoadU(d, t.map[k][i] + lane); };
            if (t.fixed) {
                const V inverse = own(3);
                const auto shrink = [&](const Lanes3<V>& v) HWY_ATTR {
                    return Lanes3<V>{hn::Mul(v.x, inverse), hn::Mul(v.y, inverse),
                                     hn::Mul(v.z, inverse)};
                };
                cell.u = shrink(outer.u);
                cell.v = shrink(outer.v);
                cell.w = shrink(outer.w);
                cell.o = shrink({hn::Sub(outer.o.x, own(0)), hn::Sub(outer.o.y, own(1)),
                                 hn::Sub(outer.o.z, own(2))});
            } else {
                const Lanes3x3<V> map{{{own(0), own(1), own(2)},
                                       {own(3), own(4), own(5)},
                                       {own(6), own(7), own(8)}}};
                cell.u = transform(outer.u, map);
                cell.v = transform(outer.v, map);
                cell.w = transform(outer.w, map);
                cell.o = add(transform(outer.o, map), Lanes3<V>{own(9), own(10), own(11)});
            }
            put_level_hits(d, meet_levels(d, cell, ray, spheres, PathSide::entry), path.shared + k,
                           lane, t);
        }
    }
}

/// What came of the walks along the paths, a bit for each lane.
struct WalkedTogether {
    std::uint64_t confirmed = 0;  // as walk_path() says
    std::uint64_t unsure = 0;
    std::uint64_t entered = 0;  // a level gave a normal
};

template <class D, class M>
HWY_INLINE std::uint64_t bits_of(D d, M mask, int lane) {
    std::uint64_t bits = 0;
    hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(&bits));
    return bits << lane;
}

/// As walk_path(), in lanes. Leaves the depths and the total normals.
inline WalkedTogether walk_together(const Path& path, const PathWeights& weights,
                                    std::uint32_t last_level, float pixel_least, int most,
                                    SeenTogether& t) {
    const hn::CappedTag<float, SeenTogether::most_lanes> d;
    const hn::RebindToSigned<decltype(d)> di;
    using V = hn::VFromD<decltype(d)>;
    const V zero = hn::Zero(d), close = hn::Set(d, 0x1p-16F), one = hn::Set(d, 1.0F);
    WalkedTogether walked;
    for (int lane = 0; lane < t.count; lane += static_cast<int>(hn::Lanes(d))) {
        const V start = hn::LoadU(d, t.start + lane);
        const V pixel_base = hn::LoadU(d, t.pixel_base + lane);
        const V pixel_growth = hn::LoadU(d, t.pixel_growth + lane);
        const auto levels = hn::LoadU(di, t.levels + lane);
        V key = start, exit = hn::Set(d, std::numeric_limits<float>::infinity());
        Lanes3<V> weighted{zero, zero, zero}, plain = weighted;
        V total = zero;
        auto confirmed = hn::FirstN(d, static_cast<std::size_t>(t.count - lane));
        auto unsure = hn::Lt(one, zero), entered = unsure;
        for (int level = 0; level < most; ++level) {
            const auto at = hn::Set(di, level);
            const auto on = hn::RebindMask(d, hn::Lt(at, levels));
            const auto final = hn::RebindMask(d, hn::Eq(hn::Set(di, level + 1), levels));
            const auto hit = [&](int i) HWY_ATTR { return hn::LoadU(d, t.hits[level][i] + lane); };
            const V entry = hit(0), leaving = hit(1);
            const V through = hn::Sub(leaving, entry);
            key = hn::IfThenElse(hn::And(on, hn::Lt(key, entry)), entry, key);
            exit = hn::IfThenElse(hn::And(on, hn::Lt(leaving, exit)), leaving, exit);
            const V diameter = level < path.shared
                                   ? hn::Set(d, path.rows[Path::diameter][level])
                                   : hn::LoadU(d, t.diameter[level - path.shared] + lane);
            const V p = hn::Max(hn::Add(pixel_base, hn::Mul(pixel_growth, key)),
                                hn::Set(d, pixel_least));
            const auto terminal = static_cast<std::uint32_t>(level) == last_level
                                      ? hn::Le(zero, one)
                                      : hn::Le(diameter, p);
            auto right = hn::And(hn::Le(zero, through), hn::Le(key, exit));
            right = hn::AndNot(hn::Xor(terminal, final), right);
            confirmed = hn::And(confirmed, hn::Or(right, hn::Not(on)));
            if (level < path.shared) {
                unsure = hn::Or(unsure, hn::Le(hn::Abs(hn::Sub(entry, start)),
                                               hn::Mul(close, through)));
            }
            auto gives = hn::And(on, hn::Lt(start, entry));
            if (weights.mode == kernels::ShadingMode::facet) gives = hn::And(gives, final);
            entered = hn::Or(entered, gives);
            V weight = one;
            if (weights.mode == kernels::ShadingMode::low_pass) weight = diameter;
            if (weights.mode == kernels::ShadingMode::high_pass) {
                weight = hn::Sub(hn::Set(d, weights.outermost), diameter);
            }
            weight = hn::IfThenElseZero(gives, weight);
            const Lanes3<V> normal{hn::IfThenElseZero(gives, hit(2)),
                                   hn::IfThenElseZero(gives, hit(3)),
                                   hn::IfThenElseZero(gives, hit(4))};
            weighted = add_scaled(weighted, weight, normal);
            plain = add(plain, normal);
            total = hn::Add(total, weight);
        }
        const auto is_weighted = hn::Lt(zero, total);
        const Lanes3<V> sum{hn::IfThenElse(is_weighted, weighted.x, plain.x),
                            hn::IfThenElse(is_weighted, weighted.y, plain.y),
                            hn::IfThenElse(is_weighted, weighted.z, plain.z)};
        const V length = hn::Sqrt(dot(sum, sum));
        hn::StoreU(key, d, t.depth + lane);
        store3(Lanes3<V>{hn::Div(sum.x, length), hn::Div(sum.y, length), hn::Div(sum.z, length)},
               d, t.normal[0] + lane, SeenTogether::most_lanes);
        walked.confirmed |= bits_of(d, confirmed, lane);
        walked.unsure |= bits_of(d, unsure, lane);
        walked.entered |= bits_of(d, entered, lane);
    }
    return walked;
}

/// Looks at the cells that rays below one start cell have found: `t.rays` of the bundle.
inline void see_below(const WideScene& scene, Workspace& work, Path& path, std::uint64_t& confirmed,
                      SeenCell* const* seen) {
    SeenTogether& t = work.seen_together;
    const WideObject& object = scene.objects[static_cast<std::size_t>(path.object)];
    const PathWeights weights{scene.shading, path.rows[Path::diameter][0]};
    const auto least = static_cast<float>(scene.detail * object.smallest_pixel);
    const int most = *std::max_element(t.levels, t.levels + t.count);
    meet_own_levels(path, most - path.shared, object.spheres, t);
    WalkedTogether walked;
    while (true) {
        if (path.deep) {
            meet_shared_levels(path, path.twice[0], object.spheres, t);
        } else {
            meet_shared_levels(path, path.rows[0], object.spheres, t);
        }
        walked = walk_together(path, weights, object.levels, least, most, t);
        if (path.deep || walked.unsure == 0) break;
        path.deep = true;
    }
    for (int lane = 0; lane < t.count; ++lane) {
        const int ray = t.rays[lane];
        const std::uint64_t bit = std::uint64_t{1} << ray;
        if ((walked.confirmed >> lane & 1) == 0) continue;
        if ((walked.entered >> lane & 1) == 0) {
            if (see(scene, work, ray, *seen[ray])) confirmed |= bit;
            continue;
        }
        confirmed |= bit;
        SeenCell& cell = *seen[ray];
        const SeenColor& color = t.color[static_cast<std::size_t>(lane)];
        const auto n = [&](int i) { return t.normal[i][lane]; };
        const glm::vec3 normal = to_scene(work.bundle, {n(0), n(1), n(2)});
        cell.normal = {normal.x, normal.y, normal.z};
        cell.color = color.color;
        cell.facing.resize(scene.lights.size());
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            cell.facing[i] = std::max(0.0F, glm::dot(normal, glm::vec3{scene.lights[i].place}));
        }
        cell.depth = path.start_base + static_cast<double>(t.depth[lane]);
        cell.object = path.object;
        cell.level = t.levels[lane] - 1;
        cell.word = folded(color.hash);
    }
}

/// Looks at what rays of the bundle have found; `seen[ray]` is filled in. Returns those that the
/// walk along the path confirms.
inline std::uint64_t see_all(const WideScene& scene, Workspace& work, std::uint64_t rays,
                             SeenCell* const* seen) {
    constexpr int fewest = 3;  // rays that pay
    const hn::CappedTag<float, SeenTogether::most_lanes> d;
    SeenTogether& t = work.seen_together;
    const bool point_lights = std::ranges::any_of(scene.lights, [](const CompiledLight& light) {
        return light.kind != kernels::LightKind::directional;
    });
    std::uint64_t confirmed = 0;
    const auto alone = [&](int ray) {
        if (see(scene, work, ray, *seen[ray])) confirmed |= std::uint64_t{1} << ray;
    };
    while (rays != 0) {
        const Found& first = work.found[static_cast<std::size_t>(std::countr_zero(rays))];
        t.fixed = first.below_count >= 0;
        Path* path = t.fixed ? path_of_fixed(scene, work, first.start)
                             : path_of(scene, work, first.start);
        const bool possible =
            !point_lights && path != nullptr && path->shared <= SeenTogether::most_shared &&
            scene.objects[static_cast<std::size_t>(path->object)].enclosing < 0;
        t.count = 0;
        for (std::uint64_t rest = rays; rest != 0; rest &= rest - 1) {
            const int ray = std::countr_zero(rest);
            const Found& found = work.found[static_cast<std::size_t>(ray)];
            if (found.start != first.start || (found.below_count >= 0) != t.fixed) continue;
            rays &= ~(std::uint64_t{1} << ray);
            const bool taken =
                possible && (t.fixed ? take_own_homotheties(scene, work, *path, found, t.count, t)
                                     : take_own_maps(scene, work, *path, found, t.count, t));
            if (!taken) {
                alone(ray);
                continue;
            }
            take_ray(scene, work, *path, ray, t.count, t);
            t.rays[t.count++] = ray;
            if (t.count == static_cast<int>(hn::Lanes(d))) break;
        }
        if (t.count < fewest) {
            for (int lane = 0; lane < t.count; ++lane) alone(t.rays[lane]);
        } else {
            see_below(scene, work, *path, confirmed, seen);
        }
    }
    return confirmed;
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
