#include "host/inspect/exact_json.hpp"

#include <cmath>
#include <string>

#include "host/inspect/dimension_order.hpp"

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
    json["decided_by"] = exact.degree > 0            ? Json("exact numbers")
                         : exact.interval_digits > 0 ? Json("intervals")
                                                     : Json(nullptr);
    json["interval_digits"] =
        exact.interval_digits > 0 ? Json(exact.interval_digits) : Json(nullptr);
    json["field_degree"] = exact.degree > 0 ? Json(exact.degree) : Json(nullptr);
    return json;
}

Json number_json(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json point_json(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

void add_measure_json(const IfsFacts& ifs, Json& json) {
    const auto& moments = ifs.moments;
    const std::string why =
        moments ? "of the measure by the maps' weights, from its own equation; the error is proven"
                : "the measure's equation does not come to rest";
    json["centroid"] = moments ? point_json(moments->centroid) : Json(nullptr);
    json["centroid_error"] = moments ? number_json(moments->centroid_error) : Json(nullptr);
    json["centroid_why"] = why;
    json["principal_axes"] = moments ? Json::array() : Json(nullptr);
    for (std::size_t i = 0; moments && i < moments->axes.size(); ++i)
        json["principal_axes"].push_back(
            {{"direction", point_json(moments->axes[i])},
             {"direction_error", moments->axis_errors[i]},
             {"variance", moments->variances[i]},
             {"variance_error", number_json(moments->variance_error)}});
    json["principal_axes_why"] = why;
    json["diameter"] = {
        {"value", ifs.diameter.value},
        {"lower", ifs.diameter.lower},
        {"upper", ifs.diameter.upper},
        {"between", {point_json(ifs.diameter.between[0]), point_json(ifs.diameter.between[1])}}};
}

/// Whether exact numbers say the same of the subspace.
bool is_exact(const IfsFacts& ifs) {
    return ifs.exact.degree > 0 && ifs.rifs.follow_sets.size() == 1 &&
           ifs.exact.dimensions == ifs.subspace.dimension;
}

Json subspace_json(const IfsFacts& ifs) {
    Json directions = Json::array();
    for (int i = 0; i < ifs.subspace.dimension; ++i)
        directions.push_back(point_json(ifs.subspace.axes[static_cast<std::size_t>(i)]));
    return {{"dimension", ifs.subspace.dimension},
            {"exact", is_exact(ifs)},
            {"point", point_json(ifs.subspace.point)},
            {"directions", directions}};
}

Json order_json(const IfsFacts& ifs) {
    const DimensionOrder order = dimension_order(ifs);
    Json list = Json::array();
    for (std::size_t i = 0; i < order.dimensions.size(); ++i) {
        const OrderedDimension& one = order.dimensions[i];
        Json json = {{"name", one.name},
                     {"value", one.value ? number_json(*one.value) : Json(nullptr)},
                     {"known", known_name(one.known)},
                     {"why", one.why}};
        if (i < order.links.size())
            json["next"] = {{"relation", order.links[i].relation},
                            {"known", known_name(order.links[i].known)},
                            {"why", order.links[i].why}};
        list.push_back(json);
    }
    return list;
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
    dimension["hausdorff_exact"] = decided && exact.degree > 0;
    dimension["order"] = order_json(ifs);
    json["neighbours"] = neighbours_json(ifs);
    add(json, "exact_overlaps", exact.overlaps);
    json["overlapping_words"] = Json::array();
    if (exact.overlaps.value.value_or(false))
        for (const auto& word : exact.overlapping_words)
            json["overlapping_words"].push_back(names_json(ifs, word));
    add(json, "connected", exact.connected);
    json["parts_of_levels"] = exact.parts_of_levels;
    json["connected_pieces"] = {
        {"number", value_json(exact.components)},
        {"infinite", exact.infinite_components ? Json(*exact.infinite_components) : Json(nullptr)},
        {"why", exact.components.why}};
    json["boundary"] = {{"dimension", value_json(exact.boundary)}, {"why", exact.boundary.why}};
    add(json, "interior", exact.interior);
    add(json, "volume", exact.volume);
    json["volume_between"] = exact.volume_between
                                 ? Json{exact.volume_between->low, exact.volume_between->high}
                                 : Json(nullptr);
    add_measure_json(ifs, json);
    json["subspace"] = subspace_json(ifs);
}

}  // namespace pxm::host
