#include "host/render/prepare.hpp"

#include "host/compile/compile.hpp"
#include "host/error.hpp"
#include "host/process/phase_clock.hpp"
#include "host/render/native_numeric.hpp"
#include "host/scene/check/check.hpp"
#include "host/wide/tables/eligible.hpp"

namespace pxm::host {

namespace {

/// What `auto` stands for: the wide engine wherever it applies.
IntersectChoice choose_intersect(IntersectMethod asked, const std::string& why_not_wide) {
    if (asked == IntersectMethod::heap || asked == IntersectMethod::fast) {
        return {asked, "it was asked for"};
    }
    if (!why_not_wide.empty()) return {IntersectMethod::heap, why_not_wide};
    return {IntersectMethod::wide, asked == IntersectMethod::wide
                                       ? "it was asked for"
                                       : "a native render in float whose objects it can do"};
}

Scene parsed(const RenderRequest& request, Diagnostics& diagnostics) {
    if (!request.scene) {
        return parse_scene(request.scene_path, request.settings, diagnostics, request.allowed,
                           request.scene_text, request.frame);
    }
    if (!request.settings.empty()) {
        throw Error(ErrorKind::setting,
                    text_of(request.settings) + ": settings are of texts, and this scene has none");
    }
    return *request.scene;
}

}  // namespace

Prepared prepare(const RenderRequest& request) {
    PhaseClock clock;
    Prepared prepared;
    Diagnostics diagnostics;
    prepared.scene = parsed(request, diagnostics);
    if (!diagnostics.has_errors()) {
        apply(request.overrides, prepared.scene);
        check_scene(prepared.scene, diagnostics);
    }
    prepared.parse_seconds = clock.lap();
    if (!diagnostics.has_errors()) {
        prepared.compiled = compile(prepared.scene, request.overrides.zoom, diagnostics);
    }
    if (request.only_sample && !diagnostics.has_errors()) {
        std::vector<glm::dvec2>& samples = prepared.compiled.samples;
        samples = {samples.at(static_cast<std::size_t>(*request.only_sample))};
    }
    if (request.cell_cap) prepared.compiled.cell_cap = *request.cell_cap;
    diagnostics.throw_if_errors(prepared.scene.files);
    if (request.walks) prepared.walks = request.walks(prepared.scene, prepared.compiled);
    prepared.warnings = diagnostics.warnings_text(prepared.scene.files);
    if (!prepared.warnings.empty()) prepared.warnings += '\n';
    prepared.compile_seconds = clock.lap();
    return prepared;
}

Scene scene_of(const RenderRequest& request) {
    Diagnostics diagnostics;
    Scene scene = parsed(request, diagnostics);
    if (!diagnostics.has_errors()) {
        apply(request.overrides, scene);
        check_scene(scene, diagnostics);
    }
    diagnostics.throw_if_errors(scene.files);
    return scene;
}

Numeric numeric_of(const Prepared& prepared, const RenderRequest& request) {
    const RenderBlock render = prepared.scene.render.value_or(RenderBlock{});
    if (render.numeric) return *render.numeric;
    return request.machine ? Numeric::dsp32 : native_numeric(prepared.compiled);
}

IntersectChoice intersect_of(const Prepared& prepared, const RenderRequest& request) {
    const RenderBlock render = prepared.scene.render.value_or(RenderBlock{});
    const IntersectMethod asked = render.intersect.value_or(IntersectMethod::automatic);
    const std::string why_not =
        request.machine ? "the machine's nodes have no wide registers"
        : request.walks ? "the channel neighbours reads the words of cells"
                        : wide::why_not_wide(prepared.compiled, numeric_of(prepared, request));
    if (asked != IntersectMethod::wide || why_not.empty()) return choose_intersect(asked, why_not);
    if (request.overrides.intersect) {
        throw Error(ErrorKind::setting, "--intersect wide: " + why_not);
    }
    Diagnostics diagnostics;
    diagnostics.error(render.intersect_position, "render: 'intersect: wide': " + why_not);
    diagnostics.throw_if_errors(prepared.scene.files);
    return {};
}

}  // namespace pxm::host
