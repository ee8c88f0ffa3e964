// The checks of single blocks, which check.cpp puts together.
#pragma once

#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

void check_ifs(const IfsBlock& ifs, Diagnostics& diagnostics);
void check_object(const ObjectBlock& object, Diagnostics& diagnostics);
void check_plane(const PlaneBlock& plane, Diagnostics& diagnostics);
void check_texture(const TextureBlock& texture, Diagnostics& diagnostics);
void check_light(const LightBlock& light, Diagnostics& diagnostics);
void check_camera(const CameraBlock& camera, Diagnostics& diagnostics);
void check_image(const ImageBlock& image, Diagnostics& diagnostics);
void check_render(const RenderBlock& render, Diagnostics& diagnostics);
void check_animation(const AnimationBlock& animation, Diagnostics& diagnostics);

}  // namespace pxm::host
