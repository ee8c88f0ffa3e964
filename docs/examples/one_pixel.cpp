// pxm as a library: a system that is given in code, without a file or a scene's text, is rendered,
// and the depth of the pixel in the middle is written.
#include <cstdio>

#include "host/error.hpp"
#include "host/render/render.hpp"

int main() {
    using namespace pxm::host;
    IfsBlock tetra;
    tetra.name = "tetra";
    const glm::dvec3 corners[] = {{0, 1, 0}, {0, -1, -1}, {1, -1, 1}, {-1, -1, 1}};
    for (const glm::dvec3& corner : corners) {  // x' = x/2 + corner/2
        MapBlock map;
        map.commands = {{ScaleCommand{glm::dvec3{0.5}}, {}}, {TranslateCommand{corner / 2.0}, {}}};
        tetra.maps.push_back(map);
    }
    RenderRequest request;
    request.scene_path = "tetra";  // what messages call it
    request.scene.emplace().ifs = {tetra};
    request.overrides.size = PixelSize{64, 64};
    try {
        const RenderResult result = render(request, {});
        std::printf("%.6f\n", static_cast<double>(result.frame.at(32, 32).z));
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
