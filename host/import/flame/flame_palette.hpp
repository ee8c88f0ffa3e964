// The palette of a flame: 256 colours, in any of three forms.
#pragma once

#include <array>
#include <vector>

#include "host/import/flame/flame_xml.hpp"
#include "host/scene/diagnostics.hpp"

namespace pxm::host {

/// A colour as a screen shows it: red, green and blue, 0 to 1 each.
using PaletteColor = std::array<double, 3>;

/// The palette that the element's children hold: <palette> of hexadecimal text, <colors data>, or a
/// <color> each, what lies between these being interpolated. Empty if there is none in it: then it
/// may be one of flam3's own, by number.
[[nodiscard]] std::vector<PaletteColor> palette_of(const XmlElement& flame,
                                                   Diagnostics& diagnostics);

/// The colour at a place from 0 to 1, in the linear colours of a scene.
[[nodiscard]] PaletteColor palette_color(const std::vector<PaletteColor>& palette, double place);

}  // namespace pxm::host
