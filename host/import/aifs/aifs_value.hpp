// What expressions of IFStile's language stand for: numbers, vectors, affine maps, and unions of
// products of maps that end in sets. A union is a node with a map an edge; the edge leads to the
// node of what comes inside, to a set by its number, or ends where nothing was said yet. A product
// of unions is a chain of nodes, so that m^11 of three maps is 33 edges and not 177,147.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "host/import/aifs/affine_n.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {

/// A mistake at a place of the file, thrown by the evaluation and caught around it.
struct AifsMistake {
    Position position;
    std::string message;
};

struct AifsNode;
using AifsUnion = std::shared_ptr<const AifsNode>;

struct AifsEdge {
    AffineN map;
    AifsUnion inside;  // null: a set, or the end
    int set = -1;      // number of a set; -1: none
};
struct AifsNode {
    std::vector<AifsEdge> edges;
    int depth = 1;  // longest chain of nodes from here
};

struct AifsValue;
using AifsVector = std::shared_ptr<const std::vector<AifsValue>>;
struct AifsValue {
    std::variant<double, AifsVector, AffineN, AifsUnion> value = 0.0;
};

/// Arithmetic of values in a space of some dimension. All of it throws AifsMistake where something
/// has no meaning, or grows beyond what a scene may have.
class AifsArithmetic {
  public:
    explicit AifsArithmetic(std::size_t dimension) : dimension_(dimension) {}

    [[nodiscard]] AifsValue unite(const std::vector<AifsValue>& parts, const Position& place);
    [[nodiscard]] AifsValue sum(const AifsValue& a, const AifsValue& b, double factor,
                                const Position& place);
    [[nodiscard]] AifsValue product(const AifsValue& a, const AifsValue& b, const Position& place);
    [[nodiscard]] AifsValue quotient(const AifsValue& a, const AifsValue& b, const Position& place);
    [[nodiscard]] AifsValue power(const AifsValue& a, const AifsValue& b, const Position& place);
    /// The set of that number, as a union of one.
    [[nodiscard]] AifsValue set(int number);
    /// The value as a union: what a set is equal to.
    [[nodiscard]] AifsUnion as_union(const AifsValue& value, const Position& place);

    [[nodiscard]] std::size_t dimension() const { return dimension_; }

  private:
    [[nodiscard]] AffineN map(const AifsValue& value, const Position& place);
    [[nodiscard]] AifsUnion power_of_union(const AifsUnion& base, long exponent,
                                           const Position& place);
    [[nodiscard]] AifsUnion chain(const AifsUnion& outer, const AifsUnion& inner,
                                  const Position& place);
    void spend(std::size_t maps, const Position& place);

    std::size_t dimension_;
    std::size_t numbers_ = 0;  // of matrices that were made
};

/// The number, or AifsMistake.
[[nodiscard]] double number_of(const AifsValue& value, const Position& place);

}  // namespace pxm::host
