// pxm as a library: a scene that came with pxm is read by its name and rendered before and after
// one of its maps is changed; depths, words and normals are read, and a long render is ended.
#include <atomic>
#include <cmath>
#include <cstdio>
#include <span>

#include "host/error.hpp"
#include "host/render/render.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/scene_path.hpp"

using namespace pxm::host;

namespace {

RenderResult rendered(const Scene& scene, long samples, const RunControl& control) {
    RenderRequest request;
    request.scene_path = "tetra";  // what messages call it
    request.scene = scene;
    request.overrides.size = PixelSize{96, 72};
    request.overrides.samples = samples;
    return render(request, control);
}

void tell(const char* when, const Scene& scene) {
    RunControl control;
    control.progress = [](double share) { std::fprintf(stderr, "\r%3.0f %%", 100 * share); };
    const RenderResult result = rendered(scene, 1, control);
    const std::span<const PixelRecord> pixels = result.frame.pixels;
    long hits = 0, faces = 0, whole = 0;
    for (const PixelRecord& pixel : pixels) {
        if (!std::isfinite(pixel.z)) continue;  // nothing was hit
        ++hits;
        faces += pixel.normal[2] < 0 ? 1 : 0;  // toward the eye
        whole += pixel.word != 0 ? 1 : 0;
    }
    std::printf("%s: %ld hits, %ld with words, %s\n", when, hits, whole,
                faces > 0 ? "some face the eye" : "none faces the eye");
}

}  // namespace

int main() {
    try {
        const auto found = find_scene("tetra");
        if (!found) throw Error(ErrorKind::file, "tetra: not found");
        Diagnostics diagnostics;
        Scene scene = parse_scene(found->path, diagnostics, {found->folder});
        diagnostics.throw_if_errors(scene.files);
        tell("before", scene);
        scene.ifs[0].maps[0].commands.push_back({ScaleCommand{glm::dvec3{0.5}}, {}});
        tell("after", scene);

        std::atomic<bool> stop = false;
        RunControl control;
        control.stop = &stop;
        control.progress = [&](double) { stop = true; };
        const bool stopped = rendered(scene, 65536, control).stopped;
        std::printf("%s\n", stopped ? "stopped" : "went on to its end");
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
