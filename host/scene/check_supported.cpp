// What the language can say and this version cannot render.
#include <fmt/format.h>

#include "host/scene/check.hpp"
#include "host/scene/range_check.hpp"
#include "host/scene/words.hpp"

namespace pxm::host {
namespace {

void unsupported(const Position& position, const std::string& what, Diagnostics& diagnostics) {
    diagnostics.error(position, what + ": not supported yet");
}

void check_render(const RenderBlock& render, Diagnostics& diagnostics) {
    if (render.intersect == IntersectMethod::wide)
        unsupported(
            render.intersect_position,
            fmt::format("render: 'intersect: {}'", word_of(intersect_words, *render.intersect)),
            diagnostics);
}

}  // namespace

void check_supported(const Scene& scene, Diagnostics& diagnostics) {
    if (scene.render) check_render(*scene.render, diagnostics);
}

}  // namespace pxm::host
