// What a program does with an installed pxm: reads a scene, changes a map, renders to memory with
// progress and a way to stop, reads depths, words and normals, asks what inspect knows, runs the
// machine and reads its nodes' counts, and writes a picture through the module. It prints what it
// found; tests/install/run compares that with what the program says.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/files/installed_places.hpp"
#include "host/inspect/inspect_json.hpp"
#include "host/inspect/inspection.hpp"
#include "host/output/image.hpp"
#include "host/render/render.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/scene_path.hpp"
#include "pxm/model.hpp"

namespace {

using namespace pxm::host;

/// A scene by its name, read and checked.
Scene read(const std::string& name) {
    const auto found = find_scene(name);
    if (!found) throw Error(ErrorKind::file, name + ": not found");
    Diagnostics diagnostics;
    Scene scene = parse_scene(found->path, diagnostics, {found->folder});
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    return scene;
}

RenderRequest request_of(const Scene& scene) {
    RenderRequest request;
    request.scene_path = "scene";
    request.scene = scene;
    request.overrides.size = PixelSize{96, 72};
    return request;
}

void print_pixels(const char* what, const RenderResult& result) {
    const std::span<const PixelRecord> pixels = result.frame.pixels;
    long hits = 0;
    double depth = 0, length = 0;
    unsigned words = 0;
    for (const PixelRecord& pixel : pixels) {
        if (!std::isfinite(pixel.z)) continue;
        ++hits;
        depth += pixel.z;
        words ^= pixel.word;
        length += std::hypot(pixel.normal[0], pixel.normal[1], pixel.normal[2]);
    }
    std::printf("%s: %ld hits, mean depth %.4f, words %06x, %s normals\n", what, hits,
                depth / static_cast<double>(hits), words, length > 0 ? "with" : "without");
}

/// Whether a render that is told to stop at its first progress gives up.
bool stops(const Scene& scene) {
    std::atomic<bool> stop = false;
    RunControl control;
    control.stop = &stop;
    control.progress = [&](double) { stop = true; };
    RenderRequest request = request_of(scene);
    request.overrides.size = PixelSize{4096, 4096};
    return render(request, control).stopped;
}

void use(const char* picture) {
    Scene scene = read("tetra");
    std::atomic<int> told = 0;
    RunControl control;
    control.progress = [&](double share) { told += share >= 0 && share <= 1 ? 1 : 0; };
    const RenderResult whole = render(request_of(scene), control);
    print_pixels("as it is", whole);
    std::printf("progress: %s\nstopped: %s\n", told > 0 ? "told" : "never told",
                stops(scene) ? "yes" : "no");

    scene.ifs[0].maps[0].commands.push_back({ScaleCommand{glm::dvec3{0.5}}, {}});
    print_pixels("one map halved", render(request_of(scene), {}));

    Diagnostics diagnostics;
    const Inspection found = inspect(scene, "scene", diagnostics);
    diagnostics.throw_if_errors(scene.files);
    std::printf("maps: %zu, json of %s\n", found.ifs.at(0).maps.size(),
                inspect_json(found).size() > 100 ? "some size" : "no size");

    RenderRequest on_machine = request_of(read("tetra"));
    on_machine.machine = pxm::find_model("964");
    const RenderResult counted = render(on_machine, {});
    const std::vector<NodeStatistics>& nodes = counted.statistics.machine.value().nodes;
    const auto most = std::ranges::max_element(nodes, {}, &NodeStatistics::cycles);
    std::printf("nodes: %zu, busiest %d with %llu cycles\n", nodes.size(), most->id,
                static_cast<unsigned long long>(most->cycles));

    write_image(picture, whole.frame, {Aov::z}, {});
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    look_for_modules_in(MODULE_FOLDER);
    try {
        use(argv[1]);
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
