#include "host/inspect/inspect_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/inspect/exact_json.hpp"
#include "host/inspect/inspect_names.hpp"
#include "host/output/program_json.hpp"
#include "host/text/json_text.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_follow_names = 200'000;  // of all maps; more are left to follow_sets
constexpr std::size_t most_volumes = 1'000;         // follow sets whose volumes are listed

Json vector_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json names_json(const Rifs& rifs, const std::vector<int>& maps) {
    Json names = Json::array();
    for (const int m : maps) names.push_back(rifs.map_names[m]);
    return names;
}

/// Null for what is not a finite number.
Json number_json(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json matrix_json(const Affine& map) {
    Json numbers = Json::array();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) numbers.push_back(map.linear[row][column]);
    }
    for (int column = 0; column < 3; ++column) numbers.push_back(map.translation[column]);
    return numbers;
}

Json sphere_json(const glm::dvec3& center, double radius) {
    return {{"center", vector_json(center)}, {"radius", radius}};
}

Json box_json(const glm::dvec3& low, const glm::dvec3& high) {
    return {{"min", vector_json(low)}, {"max", vector_json(high)}};
}

bool lists_followers(const Rifs& rifs) {
    std::size_t names = 0;
    for (const int set : rifs.follow_of) names += rifs.follow_sets[set].maps.size();
    return names <= most_follow_names;
}

Json map_json(const IfsFacts& ifs, std::size_t m, bool with_followers) {
    const MapFacts& map = ifs.maps[m];
    const auto& values = map.singular_values;
    const int set = ifs.rifs.follow_of[m];
    Json json = {{"name", ifs.rifs.map_names[m]},
                 {"matrix", matrix_json(ifs.rifs.maps[m])},
                 {"kind", kind_name(map.kind)},
                 {"determinant", map.determinant},
                 {"singular_values", values},
                 {"lipschitz", map.lipschitz},
                 {"lipschitz_product_bound", map.lipschitz},  // Eq. 16.1, of one map
                 {"lipschitz_determinant_bound", map.determinant_bound}};
    json["condition"] =
        map.kind == MapKind::singular ? Json(nullptr) : number_json(values[0] / values[2]);
    json["fixed_point"] = map.fixed_point ? vector_json(*map.fixed_point) : Json(nullptr);
    json["follow"] =
        with_followers ? names_json(ifs.rifs, ifs.rifs.follow_sets[set].maps) : Json(nullptr);
    json["follow_set"] = set;
    return json;
}

Json maps_json(const IfsFacts& ifs) {
    const bool with_followers = lists_followers(ifs.rifs);
    Json list = Json::array();
    for (std::size_t m = 0; m < ifs.maps.size(); ++m) {
        list.push_back(map_json(ifs, m, with_followers));
    }
    return list;
}

Json components_json(const IfsFacts& ifs) {
    Json list = Json::array();
    for (const std::vector<int>& maps : ifs.graph.components) {
        list.push_back(names_json(ifs.rifs, maps));
    }
    return list;
}

Json condensation_json(const GraphFacts& graph) {
    Json edges = Json::array();
    for (const ComponentEdge& edge : graph.condensation) edges.push_back({edge.from, edge.to});
    Json recurrent = Json::array();
    for (const char is : graph.recurrent) recurrent.push_back(is != 0);
    return {{"edges", edges}, {"recurrent", recurrent}};
}

Json words_json(const IfsFacts& ifs) {
    Json list = Json::array();
    for (const WordLipschitz& word : ifs.words) {
        list.push_back({{"length", word.length},
                        {"words", word.words},
                        {"product_over_actual", number_json(word.product_over_actual)},
                        {"product_word", names_json(ifs.rifs, word.product_word)},
                        {"actual_over_determinant", number_json(word.actual_over_determinant)},
                        {"determinant_word", names_json(ifs.rifs, word.determinant_word)}});
    }
    return list;
}

Json follow_sets_json(const IfsFacts& ifs) {
    Json list = Json::array();
    for (std::size_t s = 0; s < ifs.bounds.size() && s < most_volumes; ++s) {
        const Bounds& b = ifs.bounds[s];
        list.push_back({{"maps", names_json(ifs.rifs, ifs.rifs.follow_sets[s].maps)},
                        {"sphere", sphere_json(b.ball.center, b.ball.radius)},
                        {"sphere_slack", number_json(b.ball_slack)},
                        {"box", box_json(b.box.low, b.box.high)}});
    }
    return list;
}

Json dimension_json(const Dimensions& found) {
    Json json;
    const auto& similarity = found.similarity;
    const BoxCounting& boxes = found.box_counting;
    json["similarity"] = similarity ? number_json(similarity->middle()) : Json(nullptr);
    json["similarity_error"] = similarity ? number_json(similarity->error()) : Json(nullptr);
    json["affinity"] = number_json(found.affinity.value);
    json["affinity_upper"] = number_json(found.affinity.upper);
    json["affinity_exact"] = found.affinity.exact;
    json["affinity_why"] = found.affinity.why;
    json["affinity_word_length"] = found.affinity.word_length;
    json["box_counting"] = boxes.dimension ? Json(*boxes.dimension) : Json(nullptr);
    json["box_counting_error"] = boxes.dimension ? Json(boxes.error) : Json(nullptr);
    json["box_counting_scales"] = Json::array();
    for (const BoxScale& scale : boxes.scales) {
        json["box_counting_scales"].push_back(
            {{"side", scale.side}, {"boxes", std::llround(scale.boxes)}});
    }
    json["box_counting_points"] = boxes.points;
    json["box_counting_method"] = boxes.method;
    json["hull"] = found.hull;
    json["upper"] = number_json(found.upper);
    json["exact"] = found.exact ? Json(*found.exact) : Json(nullptr);
    json["meaning"] = found.meaning;
    return json;
}

Json ifs_json(const IfsFacts& ifs) {
    const Bounds& all = ifs.bounds[ifs.rifs.start];
    const GraphFacts& graph = ifs.graph;
    Json json;
    json["maps"] = maps_json(ifs);
    json["contractivity"] = ifs.contraction.rate;
    json["contraction_proof"] = proof_name(ifs.contraction.proof);
    json["start"] = names_json(ifs.rifs, graph.start);
    json["components"] = components_json(ifs);
    json["condensation"] = condensation_json(graph);
    json["complete"] = graph.complete;
    json["strongly_connected"] = graph.strongly_connected;
    json["unreachable"] = names_json(ifs.rifs, graph.unreachable);
    json["dead_ends"] = names_json(ifs.rifs, graph.dead_ends);
    json["lipschitz_of_words"] = words_json(ifs);
    json["bounding_sphere"] = sphere_json(all.ball.center, all.ball.radius);
    json["bounding_sphere_slack"] = number_json(all.ball_slack);
    json["bounding_box"] = box_json(all.box.low, all.box.high);
    json["start_set"] = ifs.rifs.start;
    json["follow_sets"] = follow_sets_json(ifs);
    json["dimension"] = dimension_json(ifs.dimensions);
    json["open_set_condition"] = condition_name(ifs.open_set.condition);
    json["open_set_why"] = ifs.open_set.why;
    const auto& disconnected = ifs.disconnected.totally_disconnected;
    json["totally_disconnected"] = disconnected ? Json(*disconnected) : Json(nullptr);
    json["totally_disconnected_why"] = ifs.disconnected.why;
    add_exact_json(ifs, json);
    return json;
}

Json declared_json(const DeclaredVolume& volume) {
    Json json = {{"kind", kind_name(volume)}};
    if (const auto* sphere = std::get_if<SphereVolume>(&volume)) {
        json.update(sphere_json(sphere->center, sphere->radius));
    }
    if (const auto* box = std::get_if<BoxVolume>(&volume)) {
        json.update(box_json(box->low, box->high));
    }
    return json;
}

Json object_json(const ObjectFacts& object) {
    Json json = {{"name", object.name}};
    json["ifs"] = object.ifs ? Json(*object.ifs) : Json(nullptr);
    json["primitive"] = !object.ifs;
    json["volume"] = object.volume;
    json["declared_volume"] = object.declared ? declared_json(*object.declared) : Json(nullptr);
    json["short_by"] = object.short_by;
    json["sphere_slack"] = number_json(object.ball_slack);
    return json;
}

Json use_json(const MemoryUse& use) {
    return {{"limit_bytes", use.limit_bytes}, {"used_bytes", use.used_bytes}};
}

}  // namespace

std::string inspect_json(const Inspection& inspection) {
    const NodeNeeds& needs = inspection.needs;
    Json json = {{"pxm", PXM_VERSION}, {"scene", inspection.scene}};
    json["ifs"] = Json::object();
    for (const IfsFacts& ifs : inspection.ifs) json["ifs"][ifs.rifs.name] = ifs_json(ifs);
    json["objects"] = Json::array();
    for (const ObjectFacts& object : inspection.objects) {
        json["objects"].push_back(object_json(object));
    }
    json["program"] = program_json(needs.program);
    json["memory"] = {{"model", needs.model},
                      {"fast_memory", use_json(needs.memory.fast_memory)},
                      {"front_buffer", use_json(needs.memory.front_buffer)},
                      {"back_buffer", use_json(needs.memory.back_buffer)},
                      {"zbuffer", use_json(needs.memory.zbuffer)},
                      {"texture", use_json(needs.memory.texture)},
                      {"over_limit", needs.over_limit}};
    json["rerooted"] = {{"objects", needs.rerooted.objects}, {"levels", needs.rerooted.levels}};
    json["native"] = Json::array();
    for (const wide::ObjectMethod& object : needs.native) {
        json["native"].push_back(
            {{"object", object.object}, {"method", object.method}, {"because", object.because}});
    }
    return json_text(json, 2) + "\n";
}

}  // namespace pxm::host
