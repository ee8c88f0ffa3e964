// A fractal flame as flam3 understands it, as far as its transforms are linear (docs/import.md).
// A point goes through randomly chosen transforms; each is post(variations(coefs(x, y))), and the
// variation `linear` of weight v multiplies by v. In the picture y points down.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/import/flame/flame_palette.hpp"
#include "host/import/flame/flame_xml.hpp"
#include "host/import/import.hpp"
#include "host/import/plane_map.hpp"
#include "host/scene/diagnostics.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

enum class Variations { linear_only, affine_part };  // affine_part: all but `linear` is left out

struct FlameTransform {
    PlaneNumbers map;  // coefs, linear's weight and post in one, y down
    double weight = 0;
    double color = 0;  // its place on the palette, 0 to 1
    double color_speed = 0.5;
    double opacity = 1;
    std::vector<double> chaos;  // how much likelier each transform is to come *after* this one;
                                // what is missing is 1
    Position position;
};

struct Flame {
    std::string name;
    Position position;
    std::vector<FlameTransform> transforms;
    std::optional<FlameTransform> final_transform;  // of what is shown, not of what goes on
    int symmetry = 1;                               // n: turned by 1/n; negative: x mirrored, too
    std::vector<PaletteColor> palette;              // empty: not in the file
    glm::dvec2 center{0.0};
    double pixels_a_unit = 50;  // flam3's defaults
    double zoom = 0;            // as a power of 2
    double rotate_degrees = 0;
    PixelSize size{100, 100};
    std::string messages;  // what was left out, a line each
};

/// What the element says. Its mistakes, and what is not linear, are added to `diagnostics`; then
/// the result cannot be used.
[[nodiscard]] Flame flame_of(const XmlElement& element, Variations variations,
                             Diagnostics& diagnostics);

/// Flames of a .flame file. Throws Error as import_file does.
struct FlameRequest {
    std::optional<std::string> entry;
    Variations variations = Variations::linear_only;
};
[[nodiscard]] Imported import_flame(const SourceFile& source, const FlameRequest& request);

}  // namespace pxm::host
