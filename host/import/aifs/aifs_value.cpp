#include "host/import/aifs/aifs_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "host/scene/check/limits.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t most_numbers = 50'000'000;  // of all matrices that an evaluation makes
constexpr long largest_power = 10'000;            // of a map
constexpr int longest_chain = 1'000;              // of unions inside one another

/// True if the value is one map, and not a union or a set.
bool is_map(const AifsValue& value) { return !std::holds_alternative<AifsUnion>(value.value); }

bool is_number(const AifsValue& value) { return std::holds_alternative<double>(value.value); }

/// A union of one map and no set.
const AffineN* single_map(const AifsUnion& node) {
    if (node->edges.size() != 1) return nullptr;
    const AifsEdge& edge = node->edges.front();
    return edge.inside == nullptr && edge.set < 0 ? &edge.map : nullptr;
}

int depth_inside(const std::vector<AifsEdge>& edges) {
    int depth = 0;
    for (const AifsEdge& edge : edges)
        if (edge.inside) depth = std::max(depth, edge.inside->depth);
    return depth;
}

AifsUnion node_of(std::vector<AifsEdge> edges, const Position& place) {
    if (edges.size() > maps_an_ifs)
        throw AifsMistake{place, fmt::format("a union of more than {} maps", maps_an_ifs)};
    const int depth = depth_inside(edges) + 1;
    if (depth > longest_chain)
        throw AifsMistake{place, fmt::format("a product of more than {} unions", longest_chain)};
    return std::make_shared<const AifsNode>(AifsNode{std::move(edges), depth});
}

double checked(double number, const Position& place) {
    if (!std::isfinite(number)) throw AifsMistake{place, "a number that is not finite"};
    return number;
}

}  // namespace

double number_of(const AifsValue& value, const Position& place) {
    if (const double* number = std::get_if<double>(&value.value)) return *number;
    throw AifsMistake{place, "expected a number"};
}

void AifsArithmetic::spend(std::size_t maps, const Position& place) {
    numbers_ += maps * (dimension_ * dimension_ + dimension_);
    if (numbers_ > most_numbers)
        throw AifsMistake{place,
                          "too much to compute: the maps are too "
                          "many, or of too many dimensions"};
}

AffineN AifsArithmetic::map(const AifsValue& value, const Position& place) {
    spend(1, place);
    if (const AffineN* affine = std::get_if<AffineN>(&value.value)) return *affine;
    if (is_number(value)) return scaling_n(dimension_, std::get<double>(value.value));
    if (const AifsUnion* node = std::get_if<AifsUnion>(&value.value)) {
        if (const AffineN* single = single_map(*node)) return *single;
        throw AifsMistake{place, "expected one map, found a union or a set"};
    }
    const std::vector<AifsValue>& parts = *std::get<AifsVector>(value.value);
    if (parts.size() != dimension_ && parts.size() != dimension_ * dimension_)
        throw AifsMistake{
            place, fmt::format("a vector of {} is neither a translation ({}) nor a matrix ({}) of "
                               "{} dimension{}",
                               parts.size(), dimension_, dimension_ * dimension_, dimension_,
                               dimension_ == 1 ? "" : "s")};
    AffineN affine = scaling_n(dimension_, 1);
    std::vector<double>& target = parts.size() == dimension_ ? affine.offset : affine.linear;
    for (std::size_t i = 0; i < parts.size(); ++i) target[i] = number_of(parts[i], place);
    return affine;
}

AifsUnion AifsArithmetic::as_union(const AifsValue& value, const Position& place) {
    if (const AifsUnion* node = std::get_if<AifsUnion>(&value.value)) return *node;
    return node_of({{map(value, place), nullptr, -1}}, place);
}

AifsValue AifsArithmetic::set(int number) {
    return {node_of({{scaling_n(dimension_, 1), nullptr, number}}, {})};
}

AifsValue AifsArithmetic::unite(const std::vector<AifsValue>& parts, const Position& place) {
    std::vector<AifsEdge> edges;
    for (const AifsValue& part : parts) {
        const AifsUnion node = as_union(part, place);
        spend(node->edges.size(), place);
        edges.insert(edges.end(), node->edges.begin(), node->edges.end());
        if (edges.size() > maps_an_ifs) break;
    }
    return {node_of(std::move(edges), place)};
}

AifsValue AifsArithmetic::sum(const AifsValue& a, const AifsValue& b, double factor,
                              const Position& place) {
    if (is_number(a) && is_number(b))
        return {checked(std::get<double>(a.value) + factor * std::get<double>(b.value), place)};
    return {plus(map(a, place), map(b, place), factor)};
}

AifsValue AifsArithmetic::product(const AifsValue& a, const AifsValue& b, const Position& place) {
    if (is_number(a) && is_number(b))
        return {checked(std::get<double>(a.value) * std::get<double>(b.value), place)};
    if (is_map(a) && is_map(b)) return {compose(map(a, place), map(b, place))};
    return {chain(as_union(a, place), as_union(b, place), place)};
}

AifsValue AifsArithmetic::quotient(const AifsValue& a, const AifsValue& b, const Position& place) {
    if (is_number(b)) {
        const double divisor = std::get<double>(b.value);
        if (divisor == 0) throw AifsMistake{place, "a division by zero"};
        if (is_number(a)) return {checked(std::get<double>(a.value) / divisor, place)};
        return product(a, {1 / divisor}, place);
    }
    return product(a, power(b, {-1.0}, place), place);
}

/// What stands inside the outer union where it ends: the inner one.
AifsUnion AifsArithmetic::chain(const AifsUnion& outer, const AifsUnion& inner,
                                const Position& place) {
    std::map<const AifsNode*, AifsUnion> done;
    const auto copied = [&](const auto& self, const AifsUnion& node) -> AifsUnion {
        if (const auto found = done.find(node.get()); found != done.end()) return found->second;
        std::vector<AifsEdge> edges;
        spend(node->edges.size(), place);
        for (const AifsEdge& edge : node->edges) {
            if (edge.set >= 0)
                throw AifsMistake{place, "a set cannot stand on the left of a product"};
            if (edge.inside) {
                edges.push_back({edge.map, self(self, edge.inside), -1});
            } else if (inner->edges.size() == 1 || node->edges.size() == 1) {
                spend(inner->edges.size(), place);
                for (const AifsEdge& in : inner->edges)
                    edges.push_back({compose(edge.map, in.map), in.inside, in.set});
            } else {
                edges.push_back({edge.map, inner, -1});
            }
        }
        return done[node.get()] = node_of(std::move(edges), place);
    };
    return copied(copied, outer);
}

AifsUnion AifsArithmetic::power_of_union(const AifsUnion& base, long exponent,
                                         const Position& place) {
    if (exponent < 1 || exponent > longest_chain)
        throw AifsMistake{place, fmt::format("a power of a union: expected an exponent from 1 to "
                                             "{}",
                                             longest_chain)};
    AifsUnion result = base;
    for (long i = 1; i < exponent; ++i) result = chain(base, result, place);
    return result;
}

AifsValue AifsArithmetic::power(const AifsValue& a, const AifsValue& b, const Position& place) {
    const double exponent = number_of(b, place);
    if (is_number(a)) return {checked(std::pow(std::get<double>(a.value), exponent), place)};
    if (exponent != std::round(exponent) || std::abs(exponent) > largest_power)
        throw AifsMistake{place, fmt::format("a power of a map: expected a whole exponent from -{} "
                                             "to {}",
                                             largest_power, largest_power)};
    const AifsUnion* node = std::get_if<AifsUnion>(&a.value);
    if (node != nullptr && single_map(*node) == nullptr)
        return {power_of_union(*node, static_cast<long>(exponent), place)};
    AffineN square = map(a, place);
    if (exponent < 0) {
        const auto turned = inverse(square);
        if (!turned) throw AifsMistake{place, "the inverse of a map that squashes flat"};
        square = *turned;
    }
    AffineN result = scaling_n(dimension_, 1);
    for (long left = std::labs(static_cast<long>(exponent)); left > 0; left /= 2) {
        spend(2, place);
        if (left % 2 == 1) result = compose(square, result);
        if (left > 1) square = compose(square, square);
    }
    return {result};
}

}  // namespace pxm::host
