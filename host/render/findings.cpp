#include "host/render/findings.hpp"

#include <fmt/format.h>

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

/// Of one frame; `frames` becomes how many the scene has, if it can be read.
Findings findings_of_frame(const RenderRequest& request, long& frames) {
    Prepared prepared;
    Diagnostics diagnostics;
    prepared.scene = parse_scene(request.scene_path, request.settings, diagnostics, request.allowed,
                                 {}, request.frame);
    if (!diagnostics.has_errors()) check_scene(prepared.scene, diagnostics);
    std::string mistake;
    if (!diagnostics.has_errors()) mistake = compile_mistake(request, prepared, diagnostics);
    const std::vector<SourceFile>& files = prepared.scene.files;
    Findings findings;
    findings.text = diagnostics.text(files);
    if (!mistake.empty()) findings.text += (findings.text.empty() ? "" : "\n") + mistake;
    findings.errors = diagnostics.has_errors() || !mistake.empty();
    findings.warnings = !diagnostics.warnings_text(files).empty();
    if (!findings.errors && prepared.scene.animation) frames = prepared.scene.animation->frames;
    return findings;
}

}  // namespace

Findings findings_of(const std::string& scene_path, const Settings& settings,
                     const std::vector<std::string>& allowed) {
    RenderRequest request;
    request.scene_path = scene_path;
    request.settings = settings;
    request.allowed = allowed;
    long frames = 1;
    Findings findings = findings_of_frame(request, frames);
    for (long frame = 1; frame < frames && !findings.errors; ++frame) {
        request.frame = static_cast<double>(frame);
        const Findings more = findings_of_frame(request, frames);
        findings.errors = more.errors;
        // A warning of many frames is told once.
        if (!more.errors && (findings.warnings || !more.warnings)) continue;
        findings.warnings = findings.warnings || more.warnings;
        findings.text +=
            fmt::format("{}frame {}: {}", findings.text.empty() ? "" : "\n", frame, more.text);
    }
    return findings;
}

}  // namespace pxm::host
