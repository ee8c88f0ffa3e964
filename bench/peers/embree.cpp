// A peer: Embree with two-level instancing. The cells of k levels are one geometry, instanced by
// the upper cells in view; rays one by one, or in coherent packets of 8 (4x2 pixels).
//
//   bench_embree DESCRIPTION THREADS K (sphere|hull) (eye|shadow) (1|8) [DEPTHS]
//
// prints `seconds hits setup_seconds cells instances`; exits with 3 if K does not
// suit the scene. `shadow`: a ray to pxm's default light from every hit.
#include <embree3/rtcore.h>
#include <omp.h>

#include <chrono>
#include <cstring>
#include <limits>
#include <string>

#include "bench/peers/cells.hpp"

namespace {

using namespace bench;

constexpr std::size_t most = 3'000'000;  // cells, and instances
constexpr int lanes = 8;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

RTCGeometry spheres(RTCDevice device, const Shape& shape, const std::vector<Affine>& cells) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* out = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                            RTC_FORMAT_FLOAT4, 16, cells.size()));
    const FollowSet& set = shape.sets[0];
    for (const Affine& cell : cells) {
        const Vec3 center = transform_point(set.center, cell);
        for (const double x : center) *out++ = static_cast<float>(x);
        *out++ = static_cast<float>(length(cell.row[0]) * set.radius);
    }
    return geometry;
}

RTCGeometry hulls(RTCDevice device, const Shape& shape, const std::vector<Affine>& cells) {
    const std::vector<Triangle> faces = hull_faces(shape);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t count = faces.size() * cells.size();
    auto* out = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                            RTC_FORMAT_FLOAT3, 12, 3 * count));
    auto* index = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, count));
    for (unsigned i = 0; i < 3 * count; ++i) index[i] = i;
    for (const Affine& cell : cells) {
        for (const Triangle& face : faces) {
            for (const Vec3& corner : face) {
                for (const double x : transform_point(corner, cell)) {
                    *out++ = static_cast<float>(x);
                }
            }
        }
    }
    return geometry;
}

void attach(RTCScene scene, RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

RTCScene build(RTCDevice device, RTCScene master, const std::vector<Affine>& upper) {
    RTCScene world = rtcNewScene(device);
    for (const Affine& cell : upper) {
        RTCGeometry instance = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(instance, master);
        float columns[12];
        for (std::size_t i = 0; i < 12; ++i)
            columns[i] = static_cast<float>(cell.row[i / 3][i % 3]);
        rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
        attach(world, instance);
    }
    rtcCommitScene(world);
    return world;
}

/// Renders packets of 4x2 pixels.
class Tracer {
  public:
    Tracer(const Scene& scene, RTCScene world, bool shadow, bool packets,
           std::vector<float>& depths)
        : scene_(scene), world_(world), shadow_(shadow), packets_(packets), depths_(depths) {
        const Vec3 toward{0.5, 1, -0.7};
        light_ = (1 / length(toward)) * toward;
    }
    /// Returns the hits.
    long packet(int left, int top) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRayHit8 rays;
        alignas(32) int valid[lanes];
        for (int lane = 0; lane < lanes; ++lane) {
            const int x = left + lane % 4;
            const int y = top + lane / 4;
            valid[lane] = x < scene_.columns && y < scene_.rows ? -1 : 0;
            const Ray ray = eye_ray(scene_, x, y);
            set(rays.ray, lane, ray.origin, ray.direction, 0);
            rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
            rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
        }
        if (packets_) {
            rtcIntersect8(valid, world_, &context, &rays);
        } else {
            one_by_one(rays, valid, context);
        }
        long hits = 0;
        for (int lane = 0; lane < lanes; ++lane) {
            if (valid[lane] == 0) continue;
            const bool hit = rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
            hits += hit ? 1 : 0;
            const std::ptrdiff_t at =
                std::ptrdiff_t{top + lane / 4} * scene_.columns + left + lane % 4;
            depths_[static_cast<std::size_t>(at)] =
                hit ? rays.ray.tfar[lane] * static_cast<float>(scene_.unit)
                    : std::numeric_limits<float>::infinity();
            if (!hit) valid[lane] = 0;
        }
        if (shadow_ && hits > 0) shade(rays, valid, context);
        return hits;
    }

  private:
    static void set(RTCRay8& ray, int lane, const Vec3& o, const Vec3& d, double from) {
        ray.org_x[lane] = static_cast<float>(o[0]);
        ray.org_y[lane] = static_cast<float>(o[1]);
        ray.org_z[lane] = static_cast<float>(o[2]);
        ray.dir_x[lane] = static_cast<float>(d[0]);
        ray.dir_y[lane] = static_cast<float>(d[1]);
        ray.dir_z[lane] = static_cast<float>(d[2]);
        ray.tnear[lane] = static_cast<float>(from);
        ray.tfar[lane] = std::numeric_limits<float>::infinity();
        ray.time[lane] = 0;
        ray.mask[lane] = ~0U;
        ray.flags[lane] = 0;
    }
    static RTCRay one(const RTCRay8& rays, int lane) {
        RTCRay ray{};
        ray.org_x = rays.org_x[lane];
        ray.org_y = rays.org_y[lane];
        ray.org_z = rays.org_z[lane];
        ray.dir_x = rays.dir_x[lane];
        ray.dir_y = rays.dir_y[lane];
        ray.dir_z = rays.dir_z[lane];
        ray.tnear = rays.tnear[lane];
        ray.tfar = rays.tfar[lane];
        ray.mask = ~0U;
        return ray;
    }
    void one_by_one(RTCRayHit8& rays, const int* valid, RTCIntersectContext& context) const {
        for (int lane = 0; lane < lanes; ++lane) {
            if (valid[lane] == 0) continue;
            RTCRayHit found{one(rays.ray, lane), {}};
            found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(world_, &context, &found);
            rays.ray.tfar[lane] = found.ray.tfar;
            rays.hit.geomID[lane] = found.hit.geomID;
        }
    }
    void shade(const RTCRayHit8& eye, const int* valid, RTCIntersectContext& context) const {
        RTCRay8 rays;
        for (int lane = 0; lane < lanes; ++lane) {
            const double t = valid[lane] != 0 ? double{eye.ray.tfar[lane]} : 0;
            const Vec3 d{double{eye.ray.dir_x[lane]}, double{eye.ray.dir_y[lane]},
                         double{eye.ray.dir_z[lane]}};
            set(rays, lane, t * d, light_, 2 * scene_.pixel_growth * t);
        }
        if (packets_) {
            rtcOccluded8(valid, world_, &context, &rays);
        } else {
            for (int lane = 0; lane < lanes; ++lane) {
                if (valid[lane] == 0) continue;
                RTCRay ray = one(rays, lane);
                rtcOccluded1(world_, &context, &ray);
                rays.tfar[lane] = ray.tfar;
            }
        }
        volatile float sink = rays.tfar[0];  // so that the rays are not thrown away
        (void)sink;
    }

    const Scene& scene_;
    RTCScene world_;
    bool shadow_;
    bool packets_;
    std::vector<float>& depths_;
    Vec3 light_{};
};

int run(int count, char** values) {
    const Scene scene = read_scene(values[1]);
    const int threads = std::atoi(values[2]);
    const int levels = std::atoi(values[3]);
    const bool hull = std::strcmp(values[4], "hull") == 0;
    const bool shadow = std::strcmp(values[5], "shadow") == 0;
    const bool packets = std::strcmp(values[6], "8") == 0;
    const Shape& shape = only_shape(scene);
    if (std::pow(shape.maps.size(), levels) > most) throw std::runtime_error("too many cells");

    const auto start = std::chrono::steady_clock::now();
    const std::string config = "threads=" + std::to_string(threads);
    RTCDevice device = rtcNewDevice(config.c_str());
    const std::vector<Affine> cells =
        cells_of_level(shape, {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}}, levels);
    const std::vector<Affine> upper = UpperCells(scene, levels, most).take();
    RTCScene master = rtcNewScene(device);
    attach(master, hull ? hulls(device, shape, cells) : spheres(device, shape, cells));
    rtcCommitScene(master);
    RTCScene world = build(device, master, upper);
    const double setup = seconds_since(start);

    std::vector<float> depths(static_cast<std::size_t>(scene.columns) *
                              static_cast<std::size_t>(scene.rows));
    const Tracer tracer(scene, world, shadow, packets, depths);
    long hits = 0;
    const auto render_start = std::chrono::steady_clock::now();
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) reduction(+ : hits)
    for (int top = 0; top < scene.rows; top += 8) {
        for (int left = 0; left < scene.columns; left += 8) {
            for (int part = 0; part < lanes; ++part) {
                const int x = left + part % 2 * 4;
                const int y = top + part / 2 * 2;
                if (x < scene.columns && y < scene.rows) hits += tracer.packet(x, y);
            }
        }
    }
    const double seconds = seconds_since(render_start);
    std::printf("%.6f %ld %.3f %zu %zu\n", seconds, hits, setup, cells.size(), upper.size());
    if (count > 7) {
        std::ofstream out(values[7], std::ios::binary);
        out.write(reinterpret_cast<const char*>(depths.data()),
                  static_cast<std::streamsize>(depths.size() * sizeof(float)));
    }
    rtcReleaseScene(world);
    rtcReleaseScene(master);
    rtcReleaseDevice(device);
    return 0;
}

}  // namespace

int main(int count, char** values) {
    if (count < 7) {
        std::fprintf(stderr,
                     "usage: bench_embree DESCRIPTION THREADS K (sphere|hull) (eye|shadow) "
                     "(1|8) [DEPTHS]\n");
        return 2;
    }
    try {
        return run(count, values);
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
