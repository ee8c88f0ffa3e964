// Scenes as text, for the laws of the renderer: small systems that between them have everything a
// kernel must get right.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace pxm::test {

/// The text of an ifs block, named as below. Five non-Platonic non-solids (App. B.3, with exact
/// numbers): tetra octo menger icos dodec. The graph: `asymmetric` follow rules, `hierarchical`
/// components. The maps: `mirrored` (negative determinants), `squashed` (needs polar), `elm`
/// (App. B.2.2), `bulging` (images that stick out of the volume, Erratum 3), `grass` (App. B.2.1),
/// `narrow` (fits the unit cone).
[[nodiscard]] std::string ifs(const std::string& name);

/// ifs(name) with an image of that size and, if not empty, a render block with those directives.
[[nodiscard]] std::string scene_of(const std::string& name, const std::string& render = "",
                                   const std::string& image = "size: 40,30");

struct Example {
    std::string name;  // letters, digits and underscores: also the name of a test
    std::string text;
};
/// What GoogleTest says for it.
inline void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

/// Whole scenes: the systems above, several views, objects, volumes, methods, details and levels.
/// `size` is the image's, "columns,rows".
[[nodiscard]] std::vector<Example> example_scenes(const std::string& size);

}  // namespace pxm::test
