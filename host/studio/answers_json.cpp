#include "host/studio/answers_json.hpp"

#include <nlohmann/json.hpp>

#include "host/output/statistics_json.hpp"
#include "host/scene/default_objects.hpp"
#include "host/studio/asks.hpp"
#include "host/studio/assets.hpp"
#include "host/text/json_text.hpp"
#include "pxm/model.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

const char* kind_text(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::setting:
            return "setting";
        case ErrorKind::scene:
            return "scene";
        case ErrorKind::file:
            return "file";
        case ErrorKind::machine_limit:
            return "machine_limit";
        case ErrorKind::failed:
            break;
    }
    return "failed";
}

Json vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Four rows of three, as `matrix:` has them.
Json matrix_json(const Affine& map) {
    Json numbers = Json::array();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) numbers.push_back(map.linear[row][column]);
    for (int column = 0; column < 3; ++column) numbers.push_back(map.translation[column]);
    return numbers;
}

Json view_json(const SceneView& view) {
    return {{"eye", view.eye},
            {"look", view.look},
            {"up", vector_json(view.up)},
            {"half_width", view.half_width},
            {"orthographic", view.orthographic ? Json(*view.orthographic) : Json(nullptr)},
            {"zoom", view.zoom},
            {"center", vector_json(view.ball.center)},
            {"radius", view.ball.radius}};
}

Json bounds_json(const Bounds& bounds) {
    return {{"center", vector_json(bounds.ball.center)},
            {"radius", bounds.ball.radius},
            {"low", vector_json(bounds.box.low)},
            {"high", vector_json(bounds.box.high)}};
}

/// What stands where, and within what: the follow sets of a system.
Json graph_json(const SystemView& system) {
    Json sets = Json::array();
    for (std::size_t s = 0; s < system.bounds.size() && s < asked_maps; ++s) {
        Json set = bounds_json(system.bounds[s]);
        set["maps"] = system.sets[s].maps;
        sets.push_back(set);
    }
    return {{"start", system.start}, {"inside", system.follow_of}, {"sets", sets}};
}

Json ifs_json(const IfsBlock& ifs, const SceneView& view) {
    Json maps = Json::array();
    for (std::size_t i = 0; i < ifs.maps.size() && i < asked_maps; ++i)
        maps.push_back({{"name", ifs.maps[i].name},
                        {"line", ifs.maps[i].position.line},
                        {"matrix", matrix_json(compose(ifs.maps[i].commands))}});
    Json json = {{"name", ifs.name}, {"count", ifs.maps.size()}, {"maps", maps}};
    const auto ball = view.attractors.find(ifs.name);
    if (ball != view.attractors.end()) {
        json["center"] = vector_json(ball->second.center);
        json["radius"] = ball->second.radius;
    }
    const auto system = view.systems.find(ifs.name);
    if (system != view.systems.end() && ifs.maps.size() <= asked_maps)
        json["graph"] = graph_json(system->second);
    return json;
}

}  // namespace

std::string start_json(const StudioFacts& facts) {
    Json json = {
        {"version", PXM_VERSION},
        {"folder", facts.folder},
        {"scene", facts.scene},
        {"scenes", facts.scenes},
        {"threads", facts.threads},
        {"grace_seconds", facts.grace_seconds},
        {"limits",
         {{"side", asked_side_pixels}, {"pixels", asked_pixels}, {"samples", asked_samples}}}};
    json["shipped"] = Json::array();
    for (const Asset& asset : scene_assets())
        json["shipped"].push_back({{"name", asset.name}, {"text", asset.bytes}});
    json["models"] = Json::array();
    for (const Model& model : models())
        json["models"].push_back({{"name", model.name},
                                  {"columns", model.columns},
                                  {"rows", model.rows},
                                  {"width", model.natural_width},
                                  {"height", model.natural_height}});
    return json_text(json);
}

std::string error_json(const Error& error) {
    Json mistakes = Json::array();
    for (const Mistake& mistake : error.mistakes())
        mistakes.push_back({{"file", mistake.file},
                            {"line", mistake.line},
                            {"column", mistake.column},
                            {"message", mistake.message}});
    return json_text(
        {{"error",
          {{"kind", kind_text(error.kind())}, {"message", error.what()}, {"mistakes", mistakes}}}});
}

std::string superseded_json(double stopping_milliseconds) {
    return json_text({{"superseded", true}, {"stopping_ms", stopping_milliseconds}});
}

std::string progress_json(const Job* job) {
    if (job == nullptr) return json_text({{"share", nullptr}});
    Json nodes = Json::array();
    for (const NodeWatch::Seen& seen : job->watch.nodes())
        nodes.push_back({seen.cycles.load(), seen.pixels.load()});
    return json_text({{"share", job->share.load()}, {"nodes", nodes}});
}

std::string imported_json(const MadeScene& made) {
    return json_text({{"name", made.name}, {"text", made.text}, {"messages", made.messages}});
}

std::string exported_json(const Exported& exported) {
    return json_text(
        {{"exported", exported.end == ExportEnd::written}, {"messages", exported.messages}});
}

std::string study_json(const StudyFindings& findings) {
    Json tables = Json::array();
    for (const TextFile& table : findings.tables)
        tables.push_back({{"name", table.name}, {"text", table.text}});
    return json_text({{"tables", tables}, {"report", findings.report}});
}

std::string opened_json(const SceneFile& file) {
    return json_text({{"text", file.text}, {"digest", file.digest}});
}

std::string saved_json(Saved saved, const std::string& digest) {
    return json_text({{"saved", saved == Saved::done}, {"digest", digest}});
}

std::string checked_json(const Scene& scene, const SceneView& view, const std::string& warnings) {
    Json json = {{"view", view_json(view)}, {"warnings", warnings}};
    json["ifs"] = Json::array();
    for (const IfsBlock& ifs : scene.ifs) json["ifs"].push_back(ifs_json(ifs, view));
    json["objects"] = Json::array();
    for (const ObjectBlock& object : objects_of(scene))
        json["objects"].push_back({{"name", object.name},
                                   {"ifs", object.ifs ? Json(*object.ifs) : Json(nullptr)},
                                   {"matrix", matrix_json(compose(object.commands))}});
    json["frames"] = scene.animation ? scene.animation->frames : 1;
    json["files"] = scene.files.size();
    return json_text(json);
}

std::string picture_json(const RenderResult& result) {
    return "{\"warnings\":" + json_text(result.warnings) +
           ",\"columns\":" + std::to_string(result.window.x1 - result.window.x0) +
           ",\"rows\":" + std::to_string(result.window.y1 - result.window.y0) +
           ",\"statistics\":" + statistics_json(result.statistics) + "}";
}

std::string picked_json(const std::optional<PickedPlace>& place) {
    if (!place) return json_text({{"cell", nullptr}});
    Json cell = {{"object", place->object},
                 {"ifs", place->ifs},
                 {"word", place->word},
                 {"distance", place->distance}};
    cell["point"] = place->point ? Json(*place->point) : Json(nullptr);
    return json_text({{"cell", cell}});
}

std::string text_json(const std::string& text) { return json_text({{"text", text}}); }

}  // namespace pxm::host
