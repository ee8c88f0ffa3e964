// plane, texture, light, camera, image, render, animation: values in range and nothing
// contradictory.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "host/scene/check/check_blocks.hpp"
#include "host/scene/check/limits.hpp"
#include "host/scene/check/range_check.hpp"

namespace pxm::host {
namespace {

/// A decimal text as sign, digits without zeros at either end, and the power of ten behind the
/// last digit, so that equal numbers beyond a double's digits compare equal.
struct ExactDecimal {
    bool negative = false;
    std::string digits;
    long exponent = 0;
    bool operator==(const ExactDecimal&) const = default;
};

ExactDecimal exact(const Decimal& number) {
    constexpr long clamp = 1'000'000'000'000;  // far below any double, and no overflow below
    const std::string text = number.text.empty() ? fmt::format("{}", number.value) : number.text;
    const std::size_t exponent_at = std::min(text.find_first_of("eE"), text.size());
    ExactDecimal result;
    if (exponent_at < text.size())
        result.exponent =
            std::clamp(std::strtol(text.c_str() + exponent_at + 1, nullptr, 10), -clamp, clamp);
    bool fraction = false;
    for (const char c : text.substr(0, exponent_at)) {
        if (c == '-') result.negative = true;
        if (c == '.') fraction = true;
        if (c < '0' || c > '9') continue;
        if (!result.digits.empty() || c != '0') result.digits += c;
        if (fraction) --result.exponent;
    }
    while (result.digits.ends_with('0')) {
        result.digits.pop_back();
        ++result.exponent;
    }
    return result.digits.empty() ? ExactDecimal{} : result;
}

bool same_point(const DecimalVec3& a, const DecimalVec3& b) {
    return std::ranges::equal(
        a, b, [](const Decimal& x, const Decimal& y) { return exact(x) == exact(y); });
}

glm::dvec3 point_of(const DecimalVec3& v) { return {v[0].value, v[1].value, v[2].value}; }

bool is_parallel(const glm::dvec3& a, const glm::dvec3& b) {
    constexpr double sine = 1e-9;  // less leaves no digits for the camera's axes
    return glm::length(glm::cross(glm::normalize(a), glm::normalize(b))) <= sine;
}

void check_crop(const CropWindow& crop, const PixelSize& size, RangeCheck& check) {
    if (crop.x0 >= crop.x1 || crop.y0 >= crop.y1)
        check.error("'crop' is empty: it is x0,y0,x1,y1 with x0 < x1 and y0 < y1");
    else if (crop.x0 < 0 || crop.y0 < 0 || crop.x1 > size.columns || crop.y1 > size.rows)
        check.error(
            fmt::format("'crop' is not inside the image of {},{}", size.columns, size.rows));
}

}  // namespace

void check_plane(const PlaneBlock& plane, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, plane.position, block_name("plane", plane.name));
    if (!plane.normal) check.error("it needs a 'normal'");
    check.direction("normal", plane.normal);
    if (plane.point) check.finite("point", *plane.point);
    check.color("color", plane.color);
    check.within("reflect", plane.reflect, 0.0, 1.0);
}

void check_texture(const TextureBlock& texture, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, texture.position, block_name("texture", texture.name));
    if (!texture.source) check.error("it needs 'file', 'ifs' or 'wood'");
    if (texture.size) {
        check.positive("size", texture.size->x);
        check.positive("size", texture.size->y);
    }
    check.color("color", texture.color);
    check.color("color2", texture.color2);
}

void check_light(const LightBlock& light, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, light.position, block_name("light", light.name));
    if (!light.direction && !light.location) check.error("it needs a 'direction' or a 'position'");
    if (light.direction && light.location) check.error("it has both 'direction' and 'position'");
    check.direction("direction", light.direction);
    if (light.location) check.finite("position", *light.location);
    check.color("color", light.color);
}

void check_camera(const CameraBlock& camera, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, camera.position, block_name("camera", camera.name));
    if (camera.eye) check.finite("eye", point_of(*camera.eye));
    if (camera.look) check.finite("look", point_of(*camera.look));
    check.direction("up", camera.up);
    if (camera.fov && !(*camera.fov > 0 && *camera.fov < 180))
        check.error(fmt::format("'fov' is {}: it must lie between 0 and 180 degrees", *camera.fov));
    check.positive("orthographic", camera.orthographic);
    check.positive("zoom", camera.zoom);
    if (!camera.eye || !camera.look) return;
    if (same_point(*camera.eye, *camera.look))
        return check.error("'eye' and 'look' are the same point");
    const glm::dvec3 view = point_of(*camera.look) - point_of(*camera.eye);
    const glm::dvec3 up = camera.up.value_or(glm::dvec3{0, 1, 0});
    // Points that differ only beyond a double's digits have no direction here.
    if (view != glm::dvec3{0.0} && up != glm::dvec3{0.0} && is_parallel(view, up))
        check.error(fmt::format("'up' is {},{},{}: the camera looks along it", up.x, up.y, up.z));
}

void check_image(const ImageBlock& image, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, image.position, "image");
    const PixelSize size = image.size.value_or(PixelSize{});
    check.within("size", std::min(size.columns, size.rows), 1, image_side_pixels);
    if (std::min(size.columns, size.rows) >= 1)
        check.within("size", std::max(size.columns, size.rows), 1, image_side_pixels);
    if (image.crop) check_crop(*image.crop, size, check);
}

void check_animation(const AnimationBlock& animation, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, animation.position, "animation");
    check.within("frames", animation.frames, 1, frames_a_film);
    check.within("rate", animation.rate, 1e-3, 1e3);
    check.within("shutter", animation.shutter, 0.0, 1.0);
}

void check_render(const RenderBlock& render, Diagnostics& diagnostics) {
    RangeCheck check(diagnostics, render.position, "render");
    check.color("ambient", render.ambient);
    check.color("background", render.background);
    check.within("samples", render.samples, 1, samples_a_pixel);
    check.positive("detail", render.detail);
    check.within("heap", render.heap, 1, heap_entries);
    check.within("bounces", render.bounces, 0, mirror_bounces);
    const auto* covers = render.covers ? std::get_if<Covers>(&*render.covers) : nullptr;
    if (covers == nullptr) return;
    if (!(covers->tau_min > 0 && covers->tau_min < covers->tau_max &&
          std::isfinite(covers->tau_max)))
        check.error_at(render.covers_position,
                       fmt::format("'covers' is {},{}: it must be tmin,tmax with 0 < tmin < tmax",
                                   covers->tau_min, covers->tau_max));
}

}  // namespace pxm::host
