// Single kernels on the cores at hand, in each of the three numbers: what a step of the search
// costs. One scene's records (eight corners of a sponge) and the rays of its picture.
//
//   build/release/bin/bench_kernels [--benchmark_filter=float]
#include <benchmark/benchmark.h>

#include <vector>

#include "dsp_kernels/camera.hpp"
#include "dsp_kernels/first_cell.hpp"
#include "dsp_kernels/heap.hpp"
#include "dsp_kernels/pixel_program.hpp"
#include "host/compile/compile.hpp"
#include "host/node_program/native_node.hpp"
#include "host/node_program/write_scene_block.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm {
namespace {

using namespace kernels;

constexpr const char* text = R"(
    ifs sponge {
        newmap scale: 1/3 translate: 0.385,0.385,0.385
        newmap scale: 1/3 translate: -0.385,0.385,0.385
        newmap scale: 1/3 translate: 0.385,-0.385,0.385
        newmap scale: 1/3 translate: -0.385,-0.385,0.385
        newmap scale: 1/3 translate: 0.385,0.385,-0.385
        newmap scale: 1/3 translate: -0.385,0.385,-0.385
        newmap scale: 1/3 translate: 0.385,-0.385,-0.385
        newmap scale: 1/3 translate: -0.385,-0.385,-0.385
    }
    image { size: 16,16 })";

/// A native node with a scene, and the rays of its picture.
template <class Real>
class Bench {
  public:
    using Node = host::NativeNode<Real>;
    using Object = ObjectRecord<real_words<Real>>;
    using Header = HeaderRecord<real_words<Real>>;
    using FollowSet = FollowSetRecord<real_words<Real>>;

    explicit Bench(host::VolumeKind volume)
        : block_(make_block(volume)), node(block_, {}, 256, sizeof(Cell<Real>)), heap(node) {
        frame = read_frame_constants(node);
        object = node.shape_word(Header::objects);
        for (std::uint32_t y = 0; y < 16; ++y) {
            for (std::uint32_t x = 0; x < 16; ++x) rays.push_back(eye_ray(node, x, y, 0));
        }
        frame.search.ray = rays[120];
        outermost_cell(node, frame.search, object, cell);
        (void)meet(node, frame.search, cell, Real(0), far_away<Real>);
        const Vec3<Real> center = read_vector(node, cell.follow_set + FollowSet::center);
        const AffineMap<Real> back = read_affine(node, object + Object::inverse);
        for (const Ray<Real>& ray : rays) {
            local_rays.push_back(rebase(node, transform_ray(node, ray, back), center));
        }
    }
    /// The next ray, so that no branch is always the same.
    const Ray<Real>& next_ray() { return rays[++at_ % rays.size()]; }
    /// The next ray near the outermost volume, as a volume is to be given it.
    const Ray<Real>& next_local_ray() { return local_rays[++at_ % local_rays.size()]; }
    /// The next map of the outermost cell.
    std::uint32_t next_map() {
        return node.shape_word(cell.follow_set + FollowSet::maps + ++at_ % 8);
    }

  private:
    static std::vector<std::uint32_t> make_block(host::VolumeKind volume) {
        host::Diagnostics diagnostics;
        host::Scene scene = host::parse_text("bench", text, diagnostics);
        scene.render.emplace().volume = volume;
        return host::make_scene_block<Real>(host::compile(scene, 1, diagnostics));
    }

    std::vector<std::uint32_t> block_;
    std::size_t at_ = 0;

  public:
    Node node;
    Heap<Node> heap;
    FrameConstants<Real> frame;
    std::uint32_t object;
    std::vector<Ray<Real>> rays;
    std::vector<Ray<Real>> local_rays;
    Cell<Real> cell;  // the outermost
};

template <class Real>
void multiply_add(benchmark::State& state) {
    Real a = from_double<Real>(1.000001);
    Real b = from_double<Real>(0.999999);
    Real sum = Real(1);
    for (auto _ : state) {
        sum = sum * a + b;
        benchmark::DoNotOptimize(sum);
        sum = sum * b - a;
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(2 * static_cast<std::int64_t>(state.iterations()));
}

template <class Real>
void volume_sphere(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            intersect_volume(bench.node, bench.next_local_ray(), bench.cell.follow_set));
    }
}

template <class Real>
void volume_box(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::box);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            intersect_volume(bench.node, bench.next_local_ray(), bench.cell.follow_set));
    }
}

template <class Real>
void ray_through_inverse(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    using Map = MapRecord<real_words<Real>>;
    for (auto _ : state) {
        const AffineMap<Real> map = read_affine(bench.node, bench.next_map() + Map::inverse);
        benchmark::DoNotOptimize(transform_ray(bench.node, bench.next_ray(), map));
    }
}

template <class Real>
void ray_rebase(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    const Vec3<Real> center =
        read_vector(bench.node, bench.cell.follow_set + Bench<Real>::FollowSet::center);
    for (auto _ : state) benchmark::DoNotOptimize(rebase(bench.node, bench.next_ray(), center));
}

template <class Real>
void child_of_heap(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    Cell<Real> child;
    for (auto _ : state) {
        child_cell(bench.node, bench.frame.search, bench.cell, bench.next_map(), child);
        benchmark::DoNotOptimize(
            meet(bench.node, bench.frame.search, child, bench.cell.key, bench.cell.exit));
    }
}

template <class Real>
void child_of_fast(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    ProjectedCell<Real> cell;
    const auto ray = project_ray(bench.node, bench.frame.search, bench.object, cell);
    (void)include_point(bench.node, cell, Real(0), far_away<Real>);
    const Vec3<Real> center =
        read_vector(bench.node, cell.follow_set + Bench<Real>::FollowSet::center);
    for (auto _ : state) {
        ProjectedCell<Real> child;
        project_child(bench.node, ray, cell, center, bench.next_map(), child);
        benchmark::DoNotOptimize(include_point(bench.node, child, cell.key, cell.exit));
    }
}

template <class Real>
void diameter_polar(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    using Map = MapRecord<real_words<Real>>;
    Linear<Real> turned{{{from_double<Real>(0.4), from_double<Real>(0.3), Real(0)},
                         {from_double<Real>(-0.3), from_double<Real>(0.5), from_double<Real>(0.1)},
                         {Real(0), from_double<Real>(-0.2), from_double<Real>(0.7)}}};
    for (auto _ : state) {
        const Linear<Real> map = read_linear(bench.node, bench.next_map() + Map::linear);
        benchmark::DoNotOptimize(
            largest_singular_value(bench.node, compose(bench.node, turned, map)));
    }
}

/// Thirty-two cells in, thirty-two out; the time is of one cell.
template <class Real>
void heap_push_and_pop(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    Cell<Real> cell = bench.cell;
    for (auto _ : state) {
        bench.heap.clear();
        for (int i = 0; i < 32; ++i) {
            cell.key = from_double<Real>(static_cast<double>(i * 21 % 32));
            bench.heap.push(cell);
        }
        while (!bench.heap.empty()) bench.heap.pop(cell);
        benchmark::DoNotOptimize(cell.key);
    }
    state.SetItemsProcessed(32 * static_cast<std::int64_t>(state.iterations()));
}

template <class Real>
void ray_of_the_eye(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    std::uint32_t x = 0;
    for (auto _ : state) benchmark::DoNotOptimize(eye_ray(bench.node, ++x % 16, 7, 0));
}

template <class Real, Method method>
void whole_search(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    bench.frame.search.method = method;
    std::uint64_t volumes = 0;
    for (auto _ : state) {
        bench.frame.search.ray = bench.next_ray();
        SearchCounts counts;  // of one ray: the cap looks at it
        benchmark::DoNotOptimize(first_cell(bench.node, bench.frame.search, bench.heap, counts));
        volumes += counts.volumes_tested;
    }
    state.counters["volumes"] =
        static_cast<double>(volumes) / static_cast<double>(state.iterations());
}

template <class Real>
void shade_of_a_hit(benchmark::State& state) {
    Bench<Real> bench(host::VolumeKind::sphere);
    SearchCounts counts;
    SearchResult<Real> found;
    while (found.outcome == Outcome::miss) {
        bench.frame.search.ray = bench.next_ray();
        found = first_cell(bench.node, bench.frame.search, bench.heap, counts);
    }
    const Sighting<Real> seen{bench.frame.search, found.cell, 0};
    for (auto _ : state) {
        benchmark::DoNotOptimize(surface_at(bench.node, seen, ShadingMode::constant));
    }
}

#define PXM_BENCH_IN_ALL_NUMBERS(kernel)      \
    BENCHMARK_TEMPLATE(kernel, dsp32::Float); \
    BENCHMARK_TEMPLATE(kernel, float);        \
    BENCHMARK_TEMPLATE(kernel, double)

PXM_BENCH_IN_ALL_NUMBERS(multiply_add);
PXM_BENCH_IN_ALL_NUMBERS(volume_sphere);
PXM_BENCH_IN_ALL_NUMBERS(volume_box);
PXM_BENCH_IN_ALL_NUMBERS(ray_through_inverse);
PXM_BENCH_IN_ALL_NUMBERS(ray_rebase);
PXM_BENCH_IN_ALL_NUMBERS(child_of_heap);
PXM_BENCH_IN_ALL_NUMBERS(child_of_fast);
PXM_BENCH_IN_ALL_NUMBERS(diameter_polar);
PXM_BENCH_IN_ALL_NUMBERS(heap_push_and_pop);
PXM_BENCH_IN_ALL_NUMBERS(ray_of_the_eye);
PXM_BENCH_IN_ALL_NUMBERS(shade_of_a_hit);
BENCHMARK_TEMPLATE(whole_search, dsp32::Float, Method::heap);
BENCHMARK_TEMPLATE(whole_search, dsp32::Float, Method::fast);
BENCHMARK_TEMPLATE(whole_search, float, Method::heap);
BENCHMARK_TEMPLATE(whole_search, float, Method::fast);
BENCHMARK_TEMPLATE(whole_search, double, Method::heap);
BENCHMARK_TEMPLATE(whole_search, double, Method::fast);

}  // namespace
}  // namespace pxm
