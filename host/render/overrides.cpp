// The command line wins over the scene.
#include "host/render/render.hpp"
#include "host/scene/default_objects.hpp"

#include <fmt/format.h>

#include "host/error.hpp"

namespace pxm::host {

namespace {

template <class T>
void override_with(const std::optional<T>& value, std::optional<T>& target) {
    if (value) target = value;
}

/// A size out of range is the scene's error, and reported as such.
void require_inside(const CropWindow& crop, const PixelSize& size) {
    if (size.columns < 1 || size.rows < 1) return;
    if (crop.x1 <= size.columns && crop.y1 <= size.rows) return;
    throw Error(ErrorKind::setting,
                fmt::format("--crop {},{},{},{} is not inside the {}x{} image", crop.x0, crop.y0,
                            crop.x1, crop.y1, size.columns, size.rows));
}

}  // namespace

void apply(const SceneOverrides& overrides, Scene& scene) {
    if (!scene.image) scene.image.emplace();
    if (!scene.render) scene.render.emplace();
    if (overrides.size && scene.image->crop && !overrides.crop) scene.image->crop.reset();
    override_with(overrides.size, scene.image->size);
    override_with(overrides.crop, scene.image->crop);
    if (overrides.crop) {
        require_inside(*overrides.crop, scene.image->size.value_or(PixelSize{}));
    }
    RenderBlock& render = *scene.render;
    override_with(overrides.shading, render.shading);
    override_with(overrides.covers, render.covers);
    override_with(overrides.samples, render.samples);
    override_with(overrides.intersect, render.intersect);
    override_with(overrides.numeric, render.numeric);
    override_with(overrides.detail, render.detail);
    override_with(overrides.lipschitz, render.lipschitz);
    override_with(overrides.volume, render.volume);
    override_with(overrides.heap, render.heap);
    if (!overrides.levels) return;
    scene.objects = objects_of(scene);
    for (ObjectBlock& object : scene.objects) object.levels = overrides.levels;
}

}  // namespace pxm::host
