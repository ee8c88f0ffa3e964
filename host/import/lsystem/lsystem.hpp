// L-systems with turtle interpretation (Sec. 7.3) and the recurrent IFS of their limit.
// The words of level n are drawn by a turtle; scaled back by the growth of one level, the drawings
// converge if the rules replace edges by chains of similar edges. An occurrence of a symbol in a
// rule is then one map, and inside it come the occurrences of that symbol's own rule.
#pragma once

#include <complex>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/scene/scene.hpp"

namespace pxm::host {

enum class TurtleOp { symbol, turn, turn_degrees, pitch, roll, round, flip, step, push, pop };

/// What multiplies the length of a step: a decimal number, or 1 over it, or the square root of
/// either. It is kept as it is written, since a double would round it.
struct StepFactor {
    std::string decimal;
    bool inverse = false;
    bool root = false;
};

/// One command of the turtle. `turn` is to the left, in steps of `Lsystem::steps_a_turn`, and
/// `turn_degrees` in degrees; `round` is in steps too, and is not reversed by `flip`. In space
/// `turn` is about the turtle's up, `pitch` about its left and `roll` about its forward axis, back
/// if the value is negative, by the step or by as many degrees as `factor` has.
struct TurtleCommand {
    TurtleOp op = TurtleOp::symbol;
    char symbol = 0;
    double value = 0;
    StepFactor factor;  // of `step`
};

struct Lsystem {
    std::string name;
    double steps_a_turn = 2;  // of + and -
    bool in_space = false;    // space_system.hpp
    std::string degrees;      // in space, of a step: as written, or empty
    std::vector<TurtleCommand> axiom;
    std::map<char, std::vector<TurtleCommand>> rules;  // a symbol without a rule stays as it is
};

/// 'f' and 'd' draw a step; 'g' and 'm' move a step.
[[nodiscard]] bool draws(char symbol);
[[nodiscard]] bool moves(char symbol);

/// What a symbol's maps are named after.
[[nodiscard]] std::string lsystem_symbol_name(char symbol);

/// The kinds of a system of any dimension: of each map, the kind inside it.
struct GraphKind {
    std::string name;
    std::vector<int> inside;
};

/// The block of a graph of maps. `block(kind, map, name)` makes a map; those of the start have the
/// number behind the last kind's. A single start is the identity. Throws Error(ErrorKind::scene) if
/// the graph has too many edges.
[[nodiscard]] IfsBlock graph_block(
    const std::vector<GraphKind>& kinds, const std::vector<int>& start,
    const std::function<MapBlock(std::size_t, std::size_t, const std::string&)>& block);

/// x' = linear x + offset in the complex plane, x conjugated first if `flip`.
struct Similarity {
    std::complex<double> linear{1.0};
    bool flip = false;
    std::complex<double> offset{0.0};

    [[nodiscard]] std::complex<double> point(std::complex<double> x) const {
        return linear * (flip ? std::conj(x) : x) + offset;
    }
};

/// The map that applies `first` and then `second`.
[[nodiscard]] Similarity then(const Similarity& first, const Similarity& second);

/// A map of the system: the place of `symbol` in a rule. Inside it come the maps of kind `inside`.
struct EdgeMap {
    Similarity map;
    int inside = 0;
};
/// A symbol, at the levels of one phase if the rules repeat only every few levels.
struct EdgeKind {
    std::string name;
    std::vector<EdgeMap> maps;
};
/// E_kind = union of map(E_inside) over the kind's maps; the picture is that of `start`.
struct EdgeSystem {
    std::vector<EdgeKind> kinds;
    std::vector<EdgeMap> start;
    std::complex<double> growth{1.0};  // of lengths, from one level to the next
};

/// The system of the limit. Throws Error(ErrorKind::scene) with the reason if the L-system has no
/// exact one.
[[nodiscard]] EdgeSystem edge_system(const Lsystem& lsystem);

/// The system as a block named like the L-system; contraction is not checked here.
[[nodiscard]] IfsBlock lsystem_maps(const EdgeSystem& system);

}  // namespace pxm::host
