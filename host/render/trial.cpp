#include "host/render/trial.hpp"

#include <glm/geometric.hpp>

#include "host/render/engine.hpp"

namespace pxm::host {

namespace {

constexpr long rays_a_side = 5;         // of the square that each view sends rays through
constexpr double pixel = 1.0 / 256;     // smaller ones cost all kinds alike
constexpr std::uint32_t cap = 10'000;   // cells tested for one ray: enough to call it hopeless
constexpr double oriented_test = 1.15;  // measured: tests of spheres that a test costs
constexpr double half_space = 0.02;     // ... and each half-space of a hull adds

/// Directions that no symmetric shape has faces or edges along.
constexpr glm::dvec3 directions[] = {{0.91, 0.31, 0.28},  {-0.27, 0.93, 0.25}, {0.22, -0.33, 0.92},
                                     {0.58, -0.63, 0.51}, {-0.49, 0.57, 0.66}, {0.71, 0.55, -0.44}};

CompiledCamera view_along(const glm::dvec3& direction) {
    const glm::dvec3 forward = glm::normalize(direction);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3{0.1, 1, 0.2}, forward));
    const glm::dvec3 up = glm::cross(forward, right);
    CompiledCamera camera;
    camera.projection = kernels::Projection::orthographic;
    camera.forward = forward;
    camera.corner = -4.0 * forward - right + up;
    camera.across = right * (2.0 / rays_a_side);
    camera.down = up * (-2.0 / rays_a_side);
    camera.pixel_at_eye = pixel;
    return camera;
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

double trial_cost(const CompiledShape& shape, std::uint32_t levels) {
    CompiledScene scene;
    scene.size = {rays_a_side, rays_a_side};
    scene.crop = {0, 0, rays_a_side, rays_a_side};
    scene.shapes.push_back(shape);
    scene.cell_cap = cap;
    CompiledObject object;
    object.constant = 1;
    object.diameter = 2;
    object.levels = levels;
    object.start = shape.start;
    scene.objects.push_back(object);
    double tests = 0;
    for (const glm::dvec3& direction : directions) {
        scene.camera = view_along(direction);
        tests += static_cast<double>(
            run_natively(scene, {nullptr, Numeric::twice, 1}, {}).rays.volumes_tested);
    }
    return tests * test_cost(shape) / (std::size(directions) * rays_a_side * rays_a_side);
}

}  // namespace pxm::host
