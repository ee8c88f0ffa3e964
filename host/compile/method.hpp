// The method of intersection that a scene asks for, and what it must be like for it.
#pragma once

#include "host/compiled/compiled_scene.hpp"
#include "host/fractal/system/rifs.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// What the nodes search with: Alg. 12.4 unless the scene says `intersect: fast`.
[[nodiscard]] kernels::Method chosen_method(const RenderBlock& render);

/// The kind of volumes of an object: where none is asked for, Ch. 13 takes spheres.
[[nodiscard]] VolumeKind volume_kind(const RenderBlock& render, const ObjectBlock& object);

/// Ch. 13 holds for maps that scale uniformly and translate (Erratum 10): the first map of the
/// system that does more is an error.
void require_homotheties(const IfsBlock& block, const Rifs& rifs, Diagnostics& diagnostics);

/// Ch. 13 finds the first cell and no other: local covers and translucent objects are an error.
void require_solid(const RenderBlock& render, const CompiledScene& scene, Diagnostics& diagnostics);

/// Ch. 13 projects spheres: other volumes are an error.
void require_spheres(const ObjectBlock& object, const CompiledShape& shape,
                     Diagnostics& diagnostics);

}  // namespace pxm::host
