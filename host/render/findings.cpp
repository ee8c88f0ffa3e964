#include "host/render/findings.hpp"

#include "host/compile/compile.hpp"
#include "host/error.hpp"
#include "host/render/prepare.hpp"
#include "host/scene/check/check.hpp"

namespace pxm::host {

namespace {

/// Compiles as a render does; what it throws is known of the scene too (a texture's file that
/// cannot be read).
std::string compile_mistake(const RenderRequest& request, Prepared& prepared,
                            Diagnostics& diagnostics) {
    try {
        apply(request.overrides, prepared.scene);
        prepared.compiled = compile(prepared.scene, request.overrides.zoom, diagnostics);
        if (!diagnostics.has_errors()) (void)intersect_of(prepared, request);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

}  // namespace

Findings findings_of(const std::string& scene_path, const Settings& settings,
                     const std::vector<std::string>& allowed) {
    RenderRequest request;
    request.scene_path = scene_path;
    request.settings = settings;
    Prepared prepared;
    Diagnostics diagnostics;
    prepared.scene = parse_scene(scene_path, settings, diagnostics, allowed);
    if (!diagnostics.has_errors()) check_scene(prepared.scene, diagnostics);
    std::string mistake;
    if (!diagnostics.has_errors()) mistake = compile_mistake(request, prepared, diagnostics);
    const std::vector<SourceFile>& files = prepared.scene.files;
    Findings findings;
    findings.text = diagnostics.text(files);
    if (!mistake.empty()) findings.text += (findings.text.empty() ? "" : "\n") + mistake;
    findings.errors = diagnostics.has_errors() || !mistake.empty();
    findings.warnings = !diagnostics.warnings_text(files).empty();
    return findings;
}

}  // namespace pxm::host
