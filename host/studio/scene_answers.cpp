#include "host/studio/scene_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "host/error.hpp"
#include "host/inspect/inspect_json.hpp"
#include "host/inspect/inspection.hpp"
#include "host/render/render.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/default_objects.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/studio/answers_json.hpp"
#include "host/studio/exact_point.hpp"
#include "host/studio/picked_cell.hpp"
#include "host/studio/scene_view.hpp"

namespace pxm::host {

namespace {

/// The scene of a text, checked.
Scene read_scene(const AskedScene& asked, Diagnostics& diagnostics) {
    Scene scene = parse_scene(asked.name, diagnostics, {"."}, nullptr, asked.text, asked.frame);
    if (!diagnostics.has_errors()) check_scene(scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    return scene;
}

}  // namespace

std::string check_answer(const AskedCheck& asked) {
    Diagnostics diagnostics;
    const Scene scene = read_scene(asked.scene, diagnostics);
    const PixelSize own = scene.image ? scene.image->size.value_or(PixelSize{}) : PixelSize{};
    const PixelSize size = asked.size.value_or(own);
    const SceneView view = view_of(scene, size, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    return checked_json(scene, view, diagnostics.warnings_text(scene.files));
}

std::string inspect_answer(const AskedScene& asked) {
    Diagnostics diagnostics;
    const Scene scene = read_scene(asked, diagnostics);
    std::size_t maps = 0;
    for (const IfsBlock& ifs : scene.ifs) maps += ifs.maps.size();
    if (maps > asked_maps)
        throw Error(ErrorKind::failed,
                    fmt::format("the studio inspects scenes of up to {} maps; pxm inspect has no "
                                "such limit",
                                asked_maps));
    const Inspection found = inspect(scene, asked.name, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    return inspect_json(found);
}

std::string pick_answer(const AskedPixel& asked, int threads) {
    RenderRequest request = request_of(asked.picture, threads);
    request.overrides.samples = 1;
    const Scene scene = scene_of(request);
    const auto picked = pick_cell(compiled_scene_of(request), asked.x, asked.y);
    if (!picked) return picked_json(std::nullopt);
    const std::vector<ObjectBlock> objects = objects_of(scene);
    const ObjectBlock& object = objects[static_cast<std::size_t>(picked->object)];
    PickedPlace place{object.name, object.ifs.value_or(""), {}, picked->distance, {}};
    if (object.ifs) {
        const auto ifs = std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name);
        for (const int map : picked->word) {
            const std::string& name = ifs->maps[static_cast<std::size_t>(map)].name;
            place.word.push_back(name.empty() ? std::to_string(map + 1) : name);
        }
        place.point = decimal_texts(exact_point(scene, object, picked->word));
    }
    return picked_json(place);
}

}  // namespace pxm::host
