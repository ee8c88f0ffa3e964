#include "host/inspect/exact_json.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json value_json(const Decided<Value>& decided) {
    return decided.value ? Json(*decided.value) : Json(nullptr);
}

template <class Value>
void add(Json& json, const std::string& key, const Decided<Value>& decided) {
    json[key] = value_json(decided);
    json[key + "_why"] = decided.why;
}

template <class Maps>
Json names_json(const IfsFacts& ifs, const Maps& maps) {
    Json names = Json::array();
    for (const int m : maps) names.push_back(ifs.exact_names[static_cast<std::size_t>(m)]);
    return names;
}

Json neighbours_json(const IfsFacts& ifs) {
    const ExactFindings& exact = ifs.exact;
    const bool finite = exact.finite.value.value_or(false);
    Json json;
    add(json, "finite", exact.finite);
    json["types"] = finite ? Json(exact.types) : Json(nullptr);
    json["touching"] = finite ? Json(exact.touching) : Json(nullptr);
    json["touching_maps"] = finite ? Json::array() : Json(nullptr);
    for (const auto& pair : exact.touching_maps)
        json["touching_maps"].push_back(names_json(ifs, pair));
    add(json, "triples", exact.triples);
    add(json, "triple_dimension", exact.triple_dimension);
    json["numbers"] = exact.numbers;
    json["field_degree"] = exact.degree > 0 ? Json(exact.degree) : Json(nullptr);
    return json;
}

Json point_json(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

void add_measure_json(const IfsFacts& ifs, Json& json) {
    const auto& moments = ifs.moments;
    const std::string why =
        moments ? "of the measure by the maps' weights, from its own equation, in double"
                : "the measure's equation does not come to rest";
    json["centroid"] = moments ? point_json(moments->centroid) : Json(nullptr);
    json["centroid_why"] = why;
    json["principal_axes"] = moments ? Json::array() : Json(nullptr);
    for (std::size_t i = 0; moments && i < moments->axes.size(); ++i)
        json["principal_axes"].push_back(
            {{"direction", point_json(moments->axes[i])}, {"variance", moments->variances[i]}});
    json["principal_axes_why"] = why;
    json["diameter"] = {
        {"value", ifs.diameter.value},
        {"upper", ifs.diameter.upper},
        {"between", {point_json(ifs.diameter.between[0]), point_json(ifs.diameter.between[1])}}};
}

}  // namespace

void add_exact_json(const IfsFacts& ifs, Json& json) {
    const ExactFindings& exact = ifs.exact;
    Json& dimension = json["dimension"];
    const bool decided = exact.hausdorff.value.has_value();
    const auto& known = ifs.dimensions.exact;
    dimension["hausdorff"] = decided ? Json(*exact.hausdorff.value)
                             : known ? Json(*known)
                                     : Json(nullptr);
    dimension["hausdorff_why"] = decided ? exact.hausdorff.why
                                 : known ? ifs.dimensions.meaning
                                         : exact.hausdorff.why;
    dimension["hausdorff_exact"] = decided;
    json["neighbours"] = neighbours_json(ifs);
    add(json, "exact_overlaps", exact.overlaps);
    json["overlapping_words"] = Json::array();
    if (exact.overlaps.value.value_or(false))
        for (const auto& word : exact.overlapping_words)
            json["overlapping_words"].push_back(names_json(ifs, word));
    add(json, "connected", exact.connected);
    json["parts_of_levels"] = exact.parts_of_levels;
    json["boundary"] = {{"dimension", value_json(exact.boundary)}, {"why", exact.boundary.why}};
    add(json, "interior", exact.interior);
    add(json, "volume", exact.volume);
    json["volume_between"] = exact.volume_between
                                 ? Json{exact.volume_between->low, exact.volume_between->high}
                                 : Json(nullptr);
    add_measure_json(ifs, json);
}

}  // namespace pxm::host
