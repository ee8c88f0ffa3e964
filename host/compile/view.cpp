#include "host/compile/view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace pxm::host {

namespace {

constexpr double default_fov_degrees = 40;
constexpr double margin = 1.1;  // a tenth around the ball

glm::dvec3 value_of(const DecimalVec3& v) { return {v[0].value, v[1].value, v[2].value}; }

bool is_long(const std::optional<DecimalVec3>& v) {
    return v && std::ranges::any_of(*v, [](const Decimal& x) { return host::is_long(x); });
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The distance at which a ball fits into a view of that half width, in both directions.
double fitting_distance(double radius, double half_width, const PixelSize& size) {
    const double aspect = static_cast<double>(size.rows) / static_cast<double>(size.columns);
    const double half_angle = std::atan(half_width * std::min(1.0, aspect));
    return margin * radius / std::sin(half_angle);
}

}  // namespace

View make_view(const CameraBlock& camera, const PixelSize& size, const Ball& ball,
               double outer_zoom) {
    const double zoom = outer_zoom * camera.zoom.value_or(1);
    View view;
    view.orthographic = camera.orthographic.has_value();
    const double fov = camera.fov.value_or(default_fov_degrees);
    view.half_width = std::tan(radians(fov) / 2);
    const glm::dvec3 look = camera.look ? value_of(*camera.look) : ball.center;
    if (camera.eye) {
        view.eye = value_of(*camera.eye);
    } else {
        const double radius = ball.radius > 0 ? ball.radius : 1;
        const glm::dvec3 from = glm::normalize(glm::dvec3{0.4, 0.5, -1});
        view.eye = look + from * fitting_distance(radius, view.half_width, size);
    }
    const PreciseVec3 exact_look = camera.look ? precise(*camera.look) : precise(look);
    const PreciseVec3 exact_ahead =
        subtract(exact_look, camera.eye ? precise(*camera.eye) : precise(view.eye));
    // Of two places that agree in all digits of a double, the difference is in the others.
    const glm::dvec3 ahead =
        is_long(camera.eye) || is_long(camera.look) ? rounded(exact_ahead) : look - view.eye;
    view.forward = glm::length(ahead) > 0 ? glm::normalize(ahead) : glm::dvec3{0, 0, 1};
    glm::dvec3 up = camera.up.value_or(glm::dvec3{0, 1, 0});
    if (glm::length(glm::cross(up, view.forward)) < 1e-9 * glm::length(up)) up = {0, 0, 1};
    view.right = glm::normalize(glm::cross(up, view.forward));
    view.up = glm::cross(view.forward, view.right);
    if (view.orthographic) {
        view.half_width = *camera.orthographic / 2 / zoom;
        view.exact_eye = precise(view.eye);
    } else {
        view.eye = look - ahead / zoom;
        view.exact_eye = subtract(exact_look, scaled(exact_ahead, Precise(1) / Precise(zoom)));
    }
    view.look_distance = glm::length(ahead) / zoom;
    return view;
}

CameraBlock with_places(CameraBlock camera, const PixelSize& size, const Ball& ball) {
    CameraBlock plain = camera;
    plain.zoom.reset();
    const View view = make_view(plain, size, ball, 1);
    const auto decimals = [](const glm::dvec3& v) {
        return DecimalVec3{Decimal{v.x, ""}, Decimal{v.y, ""}, Decimal{v.z, ""}};
    };
    if (!camera.look) camera.look = decimals(ball.center);
    if (!camera.eye) camera.eye = decimals(view.eye);
    return camera;
}

double pixel_size(const View& view, const PixelSize& size, double distance) {
    const double per_column = 2 * view.half_width / static_cast<double>(size.columns);
    return view.orthographic ? per_column : per_column * distance;
}

CompiledCamera compile_view(const View& view, const PixelSize& size, double unit) {
    const auto columns = static_cast<double>(size.columns);
    const auto rows = static_cast<double>(size.rows);
    const double scale = view.orthographic ? 1 / unit : 1;
    const double step = 2 * view.half_width / columns * scale;
    CompiledCamera camera;
    camera.across = view.right * step;
    camera.down = -view.up * step;
    camera.corner = -(camera.across * columns + camera.down * rows) / 2.0;
    camera.forward = view.forward;
    if (view.orthographic) {
        camera.projection = kernels::Projection::orthographic;
        camera.pixel_at_eye = step;
    } else {
        camera.corner += view.forward;
        camera.pixel_growth = step;  // 2 tan(theta/2) / N_h, Erratum 14
    }
    return camera;
}

}  // namespace pxm::host
