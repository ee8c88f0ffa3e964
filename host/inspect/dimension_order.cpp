#include "host/inspect/dimension_order.hpp"

#include <algorithm>
#include <cmath>

namespace pxm::host {

namespace {

constexpr double rounding = 1e-8;  // of the roots that dimensions are

OrderedDimension hausdorff_of(const IfsFacts& ifs) {
    const ExactFindings& exact = ifs.exact;
    if (exact.hausdorff.value)
        return {"Hausdorff", exact.hausdorff.value, exact.degree > 0 ? Known::exact : Known::proven,
                exact.hausdorff.why};
    const auto& known = ifs.dimensions.exact;
    if (!known) return {"Hausdorff", std::nullopt, Known::unknown, exact.hausdorff.why};
    return {"Hausdorff", known, *known == 0 ? Known::proven : Known::numerical,
            ifs.dimensions.meaning};
}

OrderedDimension box_of(const IfsFacts& ifs, const OrderedDimension& hausdorff,
                        const DimensionLink& equal) {
    if (equal.relation[0] == '=' && hausdorff.value)
        return {"box", hausdorff.value, std::max(hausdorff.known, equal.known), equal.why};
    const BoxCounting& boxes = ifs.dimensions.box_counting;
    if (!boxes.dimension) return {"box", std::nullopt, Known::unknown, boxes.method};
    return {"box", boxes.dimension, Known::numerical, "measured"};
}

OrderedDimension affinity_of(const IfsFacts& ifs) {
    const Affinity& affinity = ifs.dimensions.affinity;
    return {"affinity", affinity.value, affinity.exact ? Known::exact : Known::numerical,
            affinity.why};
}

OrderedDimension similarity_of(const IfsFacts& ifs) {
    const auto& similarity = ifs.dimensions.similarity;
    if (!similarity)
        return {"similarity", std::nullopt, Known::unknown, "not every map is a similitude"};
    return {"similarity", similarity->middle(), Known::exact, "the root of its equation"};
}

/// Of sets that similitudes make the two are the same, whether pieces overlap or not.
DimensionLink hausdorff_and_box(const IfsFacts& ifs, const OrderedDimension& hausdorff) {
    const bool contract =
        std::ranges::all_of(ifs.maps, [](const MapFacts& map) { return map.lipschitz < 1; });
    if (ifs.dimensions.similarity && ifs.graph.strongly_connected && contract)
        return {"=", Known::proven, "similitudes, with overlaps or without [Falconer95]"};
    if (hausdorff.value) return {"=", hausdorff.known, hausdorff.why};
    return {"<=", Known::unknown,
            ifs.dimensions.similarity
                ? "the graph is not strongly connected, or a map does not contract"
                : "the maps are affine, and the Hausdorff dimension is not "
                  "known"};
}

DimensionLink box_and_affinity(const IfsFacts& ifs, const OrderedDimension& box) {
    const Dimensions& found = ifs.dimensions;
    const bool known = box.value && box.why != "measured";
    if (known && *box.value < found.affinity.value - rounding && found.affinity.exact)
        return {"<", box.known, box.why};
    if (known && std::abs(*box.value - found.affinity.value) <= rounding && found.affinity.exact)
        return {"=", std::max(box.known, Known::proven), box.why};
    if (found.hull < found.affinity.value - rounding && found.affinity.exact)
        return {"<", Known::numerical, "the attractor lies in fewer dimensions"};
    return {"<=", Known::unknown,
            found.similarity ? "open-set condition: " + ifs.open_set.why : found.meaning};
}

DimensionLink affinity_and_similarity(const IfsFacts& ifs) {
    if (ifs.dimensions.similarity) return {"=", Known::exact, "all maps are similitudes"};
    return {"<=", Known::unknown, "not every map is a similitude"};
}

}  // namespace

const char* known_name(Known known) {
    constexpr std::array names{"exact", "proven", "numerical", "unknown"};
    return names[static_cast<std::size_t>(known)];
}

DimensionOrder dimension_order(const IfsFacts& ifs) {
    DimensionOrder order;
    const OrderedDimension hausdorff = hausdorff_of(ifs);
    order.links[0] = hausdorff_and_box(ifs, hausdorff);
    order.dimensions[0] = hausdorff;
    order.dimensions[1] = box_of(ifs, hausdorff, order.links[0]);
    order.dimensions[2] = affinity_of(ifs);
    order.dimensions[3] = similarity_of(ifs);
    order.links[1] = box_and_affinity(ifs, order.dimensions[1]);
    order.links[2] = affinity_and_similarity(ifs);
    return order;
}

}  // namespace pxm::host
