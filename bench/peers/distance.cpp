// A peer: sphere tracing with a distance estimator by folding, 8 rays in the lanes of a register.
// Folding finds the nearest cell only where the maps are exactly symmetric: Sierpinski's
// tetrahedron and Menger's sponge, with exact numbers (scenes/*_exact.pxm). It folds down to the
// level whose cells are no larger than a pixel, or until all lanes are far from the cell they are
// in, and stops within an eighth of a pixel of a ball, or of the hull.
//
//   bench_distance DESCRIPTION THREADS (sphere|hull) [DEPTHS]     prints `seconds hits`
#include <immintrin.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

#include "bench/peers/cells.hpp"

#pragma GCC target("avx2,fma")

namespace {

using namespace bench;

using Lanes = float __attribute__((vector_size(32)));
using Mask = int __attribute__((vector_size(32)));

constexpr int lanes = 8;
constexpr int most_steps = 512;
constexpr float within_pixels = 0.125F;

Lanes all(float x) { return Lanes{x, x, x, x, x, x, x, x}; }
Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
Lanes larger(Lanes a, Lanes b) { return a < b ? b : a; }
Lanes magnitude(Lanes a) { return larger(a, -a); }
Lanes root(Lanes a) { return reinterpret_cast<Lanes>(_mm256_sqrt_ps(reinterpret_cast<__m256>(a))); }
bool none(Mask m) {
    return _mm256_testz_si256(reinterpret_cast<__m256i>(m), reinterpret_cast<__m256i>(m)) != 0;
}
float smallest(Lanes a, Mask of) {
    float least = std::numeric_limits<float>::infinity();
    for (int i = 0; i < lanes; ++i) {
        if (of[i] != 0 && a[i] < least) least = a[i];
    }
    return least;
}

struct Point {
    Lanes x, y, z;
};

Lanes norm2(const Point& p) { return p.x * p.x + p.y * p.y + p.z * p.z; }

void order(Lanes& a, Lanes& b) {
    const Lanes larger_one = larger(a, b);
    b = smaller(a, b);
    a = larger_one;
}

/// The sponge in [-1,1]^3: into the nearest of its twenty cubes, which becomes that cube again.
struct Sponge {
    static constexpr float ratio = 3;
    static constexpr float radius = 1.7320508F;
    static void fold(Point& p) {
        p = {magnitude(p.x), magnitude(p.y), magnitude(p.z)};
        order(p.x, p.y);
        order(p.x, p.z);
        order(p.y, p.z);
        const Lanes aside = p.z > all(1.0F / 3) ? all(2) : all(0);
        p = {3 * p.x - 2, 3 * p.y - 2, 3 * p.z - aside};
    }
    static Lanes to_hull(const Point& p) {
        const Point q{magnitude(p.x) - 1, magnitude(p.y) - 1, magnitude(p.z) - 1};
        const Lanes zero = all(0);
        const Lanes outside =
            root(norm2({larger(q.x, zero), larger(q.y, zero), larger(q.z, zero)}));
        return outside + smaller(larger(larger(q.x, q.y), q.z), zero);
    }
};

/// The tetrahedron with the corners (1,1,1), (1,-1,-1), (-1,1,-1), (-1,-1,1).
struct Tetrahedron {
    static constexpr float ratio = 2;
    static constexpr float radius = 1.7320508F;
    static void reflect(Lanes& a, Lanes& b) {
        const Mask over = a + b < 0;
        const Lanes old = a;
        a = over ? -b : a;
        b = over ? -old : b;
    }
    static void fold(Point& p) {
        reflect(p.x, p.y);
        reflect(p.x, p.z);
        reflect(p.y, p.z);
        p = {2 * p.x - 1, 2 * p.y - 1, 2 * p.z - 1};
    }
    static Lanes to_hull(const Point& p) {
        const Lanes a = larger(-p.x - p.y - p.z, -p.x + p.y + p.z);
        const Lanes b = larger(p.x - p.y + p.z, p.x + p.y - p.z);
        return (larger(a, b) - 1) * 0.57735027F;
    }
};

/// From the description's coordinates to those of the fold, a similarity.
Affine to_sponge(const Shape& shape) {
    double half = 0;
    for (const Map& map : shape.maps) half = std::max(half, std::abs(fixed_point(map)[0]));
    return inverse({{{{half, 0, 0}, {0, half, 0}, {0, 0, half}, {0, 0, 0}}}});
}
Affine to_tetrahedron(const Shape& shape) {
    Vec3 middle{};
    for (const Map& map : shape.maps) middle = middle + 0.25 * fixed_point(map);
    Affine from;
    for (std::size_t i = 0; i < 3; ++i) from.row[i] = fixed_point(shape.maps[i]) - middle;
    const Affine to{{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {0, 0, 0}}}};
    Affine result = compose(inverse(from), to);
    result.row[3] = -1 * transform_direction(middle, result);
    return result;
}

template <class Fold>
class Tracer {
  public:
    Tracer(const Scene& scene, const Affine& place, bool hull, std::vector<float>& depths)
        : scene_(scene), place_(place), hull_(hull), depths_(depths) {
        scale_ = static_cast<float>(length(place.row[0]));
        growth_ = static_cast<float>(scene.pixel_growth) * scale_;
    }

    /// 4x2 pixels; returns the hits.
    long packet(int left, int top) const {
        Point o{};
        Point d{};
        for (int i = 0; i < lanes; ++i) {
            const Ray ray = eye_ray(scene_, left + i % 4, top + i / 4);
            const Vec3 from = transform_point(ray.origin, place_);
            const Vec3 along = transform_direction(ray.direction, place_);
            set(o, i, from);
            set(d, i, (1 / double{scale_}) * along);
        }
        // From where the rays enter the ball around everything, to where they leave it.
        const Lanes middle = -(o.x * d.x + o.y * d.y + o.z * d.z);
        const Lanes half2 = Fold::radius * Fold::radius - norm2(o) + middle * middle;
        Mask active = half2 > 0;
        const Lanes half = root(larger(half2, all(0)));
        Lanes t = larger(middle - half, all(0));
        const Lanes exit = middle + half;
        Lanes found = all(std::numeric_limits<float>::infinity());
        for (int step = 0; step < most_steps && !none(active); ++step) {
            const Lanes distance = estimate({o.x + t * d.x, o.y + t * d.y, o.z + t * d.z},
                                            growth_ * smallest(t, active), active);
            const Mask hit = active & (distance <= within_pixels * growth_ * t);
            found = hit ? t : found;
            t = active ? t + distance : t;
            active = active & ~hit & (t < exit);
        }
        long hits = 0;
        for (int i = 0; i < lanes; ++i) {
            hits += std::isfinite(found[i]) ? 1 : 0;
            const std::ptrdiff_t at = std::ptrdiff_t{top + i / 4} * scene_.columns + left + i % 4;
            depths_[static_cast<std::size_t>(at)] =
                found[i] / scale_ * static_cast<float>(scene_.unit);
        }
        return hits;
    }

  private:
    static void set(Point& p, int i, const Vec3& v) {
        p.x[i] = static_cast<float>(v[0]);
        p.y[i] = static_cast<float>(v[1]);
        p.z[i] = static_cast<float>(v[2]);
    }
    /// A lower bound of the distance to the cells no larger than a pixel.
    Lanes estimate(Point p, float pixel, Mask active) const {
        constexpr float far2 = 4 * Fold::radius * Fold::radius;
        float size = 1;
        while (2 * Fold::radius * size > pixel) {
            if (none(active & (norm2(p) < far2))) break;
            Fold::fold(p);
            size /= Fold::ratio;
        }
        const Lanes distance = hull_ ? Fold::to_hull(p) : root(norm2(p)) - Fold::radius;
        return size * distance;
    }

    const Scene& scene_;
    Affine place_;  // scene to fold coordinates
    bool hull_;
    std::vector<float>& depths_;
    float scale_;
    float growth_;  // of a pixel, in fold coordinates
};

template <class Fold>
long render(const Scene& scene, const Affine& place, bool hull, int threads,
            std::vector<float>& depths) {
    const Tracer<Fold> tracer(scene, place, hull, depths);
    long hits = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 4) reduction(+ : hits)
    for (int y = 0; y < scene.rows; y += 2) {
        for (int x = 0; x < scene.columns; x += 4) hits += tracer.packet(x, y);
    }
    return hits;
}

int run(int count, char** values) {
    const Scene scene = read_scene(values[1]);
    const int threads = std::atoi(values[2]);
    const bool hull = std::strcmp(values[3], "hull") == 0;
    const Shape& shape = only_shape(scene);
    const bool sponge = shape.maps.size() == 20;
    if (!sponge && shape.maps.size() != 4) throw std::runtime_error("no fold for this system");
    if (scene.columns % 4 != 0 || scene.rows % 2 != 0)
        throw std::runtime_error("not whole packets");
    const Affine place =
        compose(scene.objects[0].back, sponge ? to_sponge(shape) : to_tetrahedron(shape));
    std::vector<float> depths(static_cast<std::size_t>(scene.columns) *
                              static_cast<std::size_t>(scene.rows));
    const auto start = std::chrono::steady_clock::now();
    const long hits = sponge ? render<Sponge>(scene, place, hull, threads, depths)
                             : render<Tetrahedron>(scene, place, hull, threads, depths);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%.6f %ld\n", seconds.count(), hits);
    if (count > 4) {
        std::ofstream out(values[4], std::ios::binary);
        out.write(reinterpret_cast<const char*>(depths.data()),
                  static_cast<std::streamsize>(depths.size() * sizeof(float)));
    }
    return 0;
}

}  // namespace

int main(int count, char** values) {
    if (count < 4) {
        std::fprintf(stderr, "usage: bench_distance DESCRIPTION THREADS (sphere|hull) [DEPTHS]\n");
        return 2;
    }
    try {
        return run(count, values);
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
