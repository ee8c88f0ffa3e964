// The frozen baseline: what every engine of pxm is measured against. Alg. 12.4 as printed, with
// Errata 1, 2 and 3: scalar, double, bounding balls, one binary heap a ray, inverse maps composed
// cell by cell and the eye's ray taken back through them, OpenMP over rows. It says which cell is
// seen and how far away; it does not shade. Nothing here may be made faster.
//
//   bench_baseline DESCRIPTION [THREADS [DEPTHS]]
//
// prints `seconds hits cells`, and writes to DEPTHS the distance of every pixel in world units
// (floats row by row, inf on a miss), to be compared with the channel Z of pxm.
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "bench/described.hpp"

namespace {

using namespace bench;

/// The triple (t_0, B, M^-1) of Alg. 12.4 and what Erratum 3 and the diameter need.
struct Cell {
    double key;       // t_0, never below the parent's
    double exit;      // never above the parent's
    Affine back;      // M^-1
    Affine map;       // M, where products of Lipschitz constants are not exact
    double constant;  // Lip M, by product
    int object;
    int set;
    long level;
};

/// A heap of cells, the smallest key on top (Def. 12.1, Erratum 1).
class Heap {
  public:
    void clear() {
        cells_.clear();
        order_.clear();
    }
    bool empty() const { return order_.empty(); }
    void push(const Cell& cell) {
        cells_.push_back(cell);
        order_.push_back({cell.key, cells_.size() - 1});
        std::push_heap(order_.begin(), order_.end(), later);
    }
    Cell pop() {
        std::pop_heap(order_.begin(), order_.end(), later);
        const std::size_t index = order_.back().index;
        order_.pop_back();
        return cells_[index];
    }

  private:
    struct Place {
        double key;
        std::size_t index;
    };
    static bool later(const Place& a, const Place& b) { return a.key > b.key; }

    std::vector<Cell> cells_;  // of this ray, in the order they came
    std::vector<Place> order_;
};

/// The largest singular value of M, by Jacobi's rotations of T T^t: Lip of the composed map.
double largest_singular_value(const Affine& m) {
    double s[3][3];
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) s[i][j] = dot(m.row[i], m.row[j]);
    }
    for (int turn = 0; turn < 24; ++turn) {
        const double off = s[0][1] * s[0][1] + s[1][2] * s[1][2] + s[2][0] * s[2][0];
        const double trace = s[0][0] + s[1][1] + s[2][2];
        if (off <= 1e-24 * trace * trace) break;
        const std::size_t p = static_cast<std::size_t>(turn % 3);
        const std::size_t q = (p + 1) % 3;
        const std::size_t r = (p + 2) % 3;
        if (s[p][q] == 0) continue;
        const double theta = (s[q][q] - s[p][p]) / (2 * s[p][q]);
        const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
        const double c = 1 / std::hypot(t, 1.0);
        s[p][p] -= t * s[p][q];
        s[q][q] += t * s[p][q];
        s[p][q] = s[q][p] = 0;
        const double rp = s[r][p];
        s[r][p] = s[p][r] = c * rp - t * c * s[r][q];
        s[r][q] = s[q][r] = t * c * rp + c * s[r][q];
    }
    return std::sqrt(std::max({s[0][0], s[1][1], s[2][2]}));
}

/// One thread's search.
class Search {
  public:
    explicit Search(const Scene& scene) : scene_(scene) {}

    /// t_0 of the first cell no larger than a pixel, infinite if there is none.
    double first_hit(const Ray& ray) {
        heap_.clear();
        for (std::size_t i = 0; i < scene_.objects.size(); ++i)
            push_object(ray, static_cast<int>(i));
        while (!heap_.empty()) {
            const Cell cell = heap_.pop();           // 2.1
            if (is_terminal(cell)) return cell.key;  // 2.2, 2.3
            const Shape& shape = shape_of(cell);
            for (const int map : set_of(cell).maps) push_child(ray, cell, shape, map);  // 2.4
        }
        return std::numeric_limits<double>::infinity();
    }
    long cells() const { return cells_; }

  private:
    const Object& object_of(const Cell& cell) const {
        return scene_.objects[static_cast<std::size_t>(cell.object)];
    }
    const Shape& shape_of(const Cell& cell) const {
        return scene_.shapes[static_cast<std::size_t>(object_of(cell).shape)];
    }
    const FollowSet& set_of(const Cell& cell) const {
        return shape_of(cell).sets[static_cast<std::size_t>(cell.set)];
    }

    /// Step 1.
    void push_object(const Ray& ray, int index) {
        const Object& object = scene_.objects[static_cast<std::size_t>(index)];
        Cell cell;
        cell.back = object.back;
        cell.map = object.instance;
        cell.constant = object.constant;
        cell.object = index;
        cell.set = scene_.shapes[static_cast<std::size_t>(object.shape)].start;
        cell.level = 0;
        push_if_met(ray, cell, 0, std::numeric_limits<double>::infinity());
    }

    /// Steps 2.4.1 to 2.4.4.
    void push_child(const Ray& ray, const Cell& parent, const Shape& shape, int index) {
        const Map& map = shape.maps[static_cast<std::size_t>(index)];
        Cell cell;
        cell.back = compose(parent.back, map.back);  // 2.4.2: M^-1 W_i^-1
        if (!shape.similar) cell.map = compose(map.map, parent.map);
        cell.constant = parent.constant * map.constant;
        cell.object = parent.object;
        cell.set = map.follow;
        cell.level = parent.level + 1;
        push_if_met(ray, cell, parent.key, parent.exit);
    }

    /// Takes the ray back (2.4.3, Erratum 2), intersects it with the ball, and clips what lies
    /// inside to the parent's interval (Erratum 3).
    void push_if_met(const Ray& ray, Cell& cell, double from, double to) {
        ++cells_;
        const FollowSet& set = set_of(cell);
        const Vec3 o = transform_point(ray.origin, cell.back) - set.center;
        const Vec3 d = transform_direction(ray.direction, cell.back);
        const double dd = dot(d, d);
        const double closest = -dot(o, d) / dd;
        const Vec3 miss = o + closest * d;
        const double half_chord2 = set.radius * set.radius - dot(miss, miss);
        if (half_chord2 < 0) return;
        const double half = std::sqrt(half_chord2 / dd);
        cell.key = std::max(from, closest - half);
        cell.exit = std::min(to, closest + half);
        if (cell.exit < cell.key) return;
        heap_.push(cell);
    }

    /// diam(M(B)) is at most `detail` pixels, p(t_0) of Eq. 15.2; or the last level is reached.
    bool is_terminal(const Cell& cell) const {
        if (cell.level == object_of(cell).levels) return true;
        const double lip =
            shape_of(cell).similar ? cell.constant : largest_singular_value(cell.map);
        const double p = std::max(scene_.pixel_at_eye + scene_.pixel_growth * cell.key,
                                  0x1p-48 * object_of(cell).diameter);
        return lip * set_of(cell).diameter <= scene_.detail * p;
    }

    const Scene& scene_;
    Heap heap_;
    long cells_ = 0;
};

void write_depths(const char* path, const std::vector<float>& depths) {
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(depths.data()),
              static_cast<std::streamsize>(depths.size() * sizeof(float)));
}

}  // namespace

int main(int count, char** values) {
    if (count < 2) {
        std::fprintf(stderr, "usage: bench_baseline DESCRIPTION [THREADS [DEPTHS]]\n");
        return 2;
    }
    const Scene scene = read_scene(values[1]);
    const int threads = count > 2 ? std::atoi(values[2]) : 1;
    std::vector<float> depths(static_cast<std::size_t>(scene.columns) *
                              static_cast<std::size_t>(scene.rows));
    long hits = 0;
    long cells = 0;
    const auto start = std::chrono::steady_clock::now();
#pragma omp parallel num_threads(threads) reduction(+ : hits, cells)
    {
        Search search(scene);
#pragma omp for schedule(dynamic, 1)
        for (int y = 0; y < scene.rows; ++y) {
            float* row = depths.data() + static_cast<std::ptrdiff_t>(y) * scene.columns;
            for (int x = 0; x < scene.columns; ++x) {
                const double t = search.first_hit(eye_ray(scene, x, y));
                row[x] = static_cast<float>(t * scene.unit);
                hits += std::isfinite(t) ? 1 : 0;
            }
        }
        cells += search.cells();
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%.6f %ld %ld\n", seconds.count(), hits, cells);
    if (count > 3) write_depths(values[3], depths);
}
