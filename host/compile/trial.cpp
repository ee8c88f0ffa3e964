#include "host/compile/trial.hpp"

#include <glm/geometric.hpp>

#include "host/compiled/bounding_volume.hpp"
#include "host/engine/engine.hpp"
#include "host/process/give_up.hpp"

namespace pxm::host {

namespace {

constexpr long rays_a_side = 5;          // of the square that each view sends rays through
constexpr double pixel = 1.0 / 256;      // smaller ones cost all kinds alike
constexpr std::uint32_t cap = 10'000;    // cells tested for one ray: enough to call it hopeless
constexpr double seen_in_volume = 0.25;  // an eighth of a volume: where one is half a pixel, 1/16
constexpr double oriented_test = 1.15;   // measured: tests of spheres that a test costs
constexpr double half_space = 0.02;      // ... and each half-space of a hull adds

/// Directions that no symmetric shape has faces or edges along.
constexpr glm::dvec3 directions[] = {{0.91, 0.31, 0.28},  {-0.27, 0.93, 0.25}, {0.22, -0.33, 0.92},
                                     {0.58, -0.63, 0.51}, {-0.49, 0.57, 0.66}, {0.71, 0.55, -0.44}};

CompiledCamera view_along(const glm::dvec3& direction, double rays) {
    const glm::dvec3 forward = glm::normalize(direction);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3{0.1, 1, 0.2}, forward));
    const glm::dvec3 up = glm::cross(forward, right);
    CompiledCamera camera;
    camera.projection = kernels::Projection::orthographic;
    camera.forward = forward;
    camera.corner = -4.0 * forward - right + up;
    camera.across = right * (2.0 / rays);
    camera.down = up * (-2.0 / rays);
    camera.pixel_at_eye = pixel;
    return camera;
}

/// A set as an object seen through a square of rays that just holds its volume.
CompiledScene scene_of_set(const CompiledShape& shape, std::size_t set) {
    constexpr long side = 24;
    const CompiledVolume& volume = shape.sets[set].volume;
    const double radius = ball_around(volume).radius;
    CompiledScene scene;
    scene.size = {side, side};
    scene.crop = {0, 0, side, side};
    scene.shapes.push_back(shape);
    scene.shapes[0].start = static_cast<int>(set);
    scene.cell_cap = cap;
    CompiledObject object;
    object.instance.linear = glm::dmat3{1 / radius};
    object.instance.translation = -volume.center / radius;
    object.constant = 1 / radius;
    object.diameter = volume.diameter / radius;
    scene.objects.push_back(object);
    return scene;
}

double test_cost(const CompiledShape& shape) {
    double sum = 0;
    for (const CompiledSet& set : shape.sets) {
        if (set.volume.kind == kernels::Volume::oriented)
            sum += oriented_test;
        else
            sum += 1 + half_space * static_cast<double>(set.volume.half_spaces.size());
    }
    return sum / static_cast<double>(shape.sets.size());
}

}  // namespace

Trial::Trial(const CompiledShape& shape, std::uint32_t levels)
    : share_(test_cost(shape) / (std::size(directions) * rays_a_side * rays_a_side)) {
    scene_.size = {rays_a_side, rays_a_side};
    scene_.shapes.push_back(shape);
    scene_.cell_cap = cap;
    CompiledObject object;
    object.constant = 1;
    object.diameter = 2;
    object.levels = levels;
    object.start = shape.start;
    scene_.objects.push_back(object);
}

/// A row of one side's rays.
void Trial::go_on() {
    give_up_if_asked();
    const long row = next_ % rays_a_side;
    scene_.camera = view_along(directions[next_ / rays_a_side], rays_a_side);
    scene_.crop = {0, row, rays_a_side, row + 1};
    tests_ += static_cast<double>(
        run_reference(scene_, {nullptr, Numeric::double_, 1}, {}).rays.volumes_tested);
    ++next_;
}

double Trial::cost(double enough) {
    constexpr long rows = rays_a_side * static_cast<long>(std::size(directions));
    while (next_ < rows && tests_ * share_ < enough) go_on();
    return tests_ * share_;
}

bool is_cheaper(Trial& one, double factor, Trial& other) {
    for (double bound = 64;; bound *= 2) {
        const double cost = one.cost(bound);
        if (cost < bound) return cost < factor * other.cost(cost / factor + 1);
        const double limit = factor * other.cost(bound / factor);
        if (limit < bound) return one.cost(limit) < limit;
    }
}

double mean_coverage(const CompiledShape& shape, std::size_t set,
                     std::span<const glm::dvec3> views) {
    if (views.empty()) views = directions;
    CompiledScene scene = scene_of_set(shape, set);
    const auto hits = [&](std::uint32_t levels) {
        scene.objects[0].levels = levels;
        double sum = 0;
        for (const glm::dvec3& direction : views) {
            give_up_if_asked();
            scene.camera = view_along(direction, static_cast<double>(scene.size.columns));
            scene.camera.pixel_at_eye = seen_in_volume;
            sum += static_cast<double>(
                run_reference(scene, {nullptr, Numeric::double_, 1}, {}).rays.hits);
        }
        return sum;
    };
    const double through = hits(0);
    return through > 0 ? hits(kernels::unlimited_levels) / through : 1;
}

}  // namespace pxm::host
