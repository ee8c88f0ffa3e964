// The keys that `pxm inspect --json` promises (docs/inspect.md).
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pxm::test {

inline void expect_keys(const nlohmann::json& json, const std::vector<std::string>& keys,
                        const std::string& where) {
    for (const std::string& key : keys) EXPECT_TRUE(json.contains(key)) << where << ": " << key;
}

inline void expect_map_keys(const nlohmann::json& map, const std::string& where) {
    expect_keys(map,
                {"name", "matrix", "kind", "determinant", "lipschitz", "lipschitz_product_bound",
                 "lipschitz_determinant_bound", "condition", "fixed_point", "follow"},
                where);
    EXPECT_EQ(map["matrix"].size(), 12U) << where;
    EXPECT_GE(map["lipschitz"], map["lipschitz_determinant_bound"].get<double>() * (1 - 1e-12))
        << where;
}

inline void expect_ifs_keys(const nlohmann::json& ifs, const std::string& where) {
    expect_keys(ifs,
                {"maps",
                 "contractivity",
                 "start",
                 "components",
                 "bounding_sphere",
                 "bounding_box",
                 "dimension",
                 "totally_disconnected",
                 "neighbours",
                 "exact_overlaps",
                 "exact_overlaps_why",
                 "overlapping_words",
                 "connected",
                 "connected_why",
                 "parts_of_levels",
                 "connected_pieces",
                 "boundary",
                 "interior",
                 "interior_why",
                 "volume",
                 "volume_why",
                 "volume_between",
                 "centroid",
                 "principal_axes",
                 "diameter"},
                where);
    expect_keys(ifs["neighbours"],
                {"finite", "finite_why", "types", "touching", "triples", "triple_dimension"},
                where);
    expect_keys(ifs["boundary"], {"dimension", "why"}, where);
    expect_keys(ifs["diameter"], {"value", "between"}, where);
    expect_keys(ifs["bounding_sphere"], {"center", "radius"}, where);
    expect_keys(ifs["bounding_box"], {"min", "max"}, where);
    const nlohmann::json& dimension = ifs["dimension"];
    expect_keys(dimension,
                {"similarity", "affinity", "affinity_upper", "affinity_exact", "box_counting",
                 "box_counting_error", "hausdorff", "hausdorff_why", "hausdorff_exact"},
                where);
    if (!dimension["similarity"].is_null()) {
        EXPECT_LE(dimension["similarity"], dimension["affinity_upper"]) << where;
    }
    EXPECT_LE(dimension["affinity"], dimension["affinity_upper"]) << where;
    for (const nlohmann::json& map : ifs["maps"]) expect_map_keys(map, where);
}

/// All documented keys are there.
inline void expect_inspect_keys(const nlohmann::json& json, const std::string& where) {
    expect_keys(json, {"scene", "ifs", "objects", "program", "memory"}, where);
    for (const auto& [name, ifs] : json["ifs"].items()) expect_ifs_keys(ifs, where + " " + name);
    for (const nlohmann::json& object : json["objects"]) {
        expect_keys(object, {"name", "volume", "declared_volume", "short_by"}, where);
    }
    EXPECT_FALSE(json["objects"].empty()) << where;
}

}  // namespace pxm::test
