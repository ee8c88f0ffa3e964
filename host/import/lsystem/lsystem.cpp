#include "host/import/lsystem/lsystem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "host/error.hpp"
#include "host/import/lsystem/lsystem_growth.hpp"
#include "host/scene/check/limits.hpp"

namespace pxm::host {
namespace {

using Complex = std::complex<double>;

class SystemBuilder {
  public:
    SystemBuilder(const Lsystem& lsystem, const Grammar& grammar, const LsystemGrowth& growth)
        : lsystem_(lsystem), grammar_(grammar), growth_(growth) {}

    EdgeSystem build() {
        system_.growth = growth_.factor;
        for (std::size_t phase = 0; phase < periods(); ++phase)
            for (std::size_t s = 0; s < symbols(); ++s) add_kind(s, phase);
        for (const Occurrence& o : occurrences(grammar_.axiom, grammar_.compass, phase(0)))
            system_.start.push_back({similarity(o, 1.0), o.symbol});
        open_rigid_cycles();
        drop_empty_kinds();
        if (system_.start.empty())
            throw Error(ErrorKind::scene,
                        fmt::format("L-system \"{}\" has no exact linear fractal: what it draws "
                                    "does not grow with the level",
                                    lsystem_.name));
        normalize();
        turn_single_start();
        return std::move(system_);
    }

  private:
    [[nodiscard]] std::size_t periods() const { return growth_.phases.size(); }
    [[nodiscard]] std::size_t symbols() const { return grammar_.rules.size(); }
    [[nodiscard]] const Level& phase(std::size_t k) const { return growth_.phases[k]; }

    [[nodiscard]] Similarity similarity(const Occurrence& o, Complex growth) const {
        const double radians = grammar_.compass.degrees(o.turn.direction) * std::numbers::pi / 180;
        const auto step = o.turn.step.convert_to<double>();
        return {std::polar(step, radians) / growth, o.turn.flip, o.place / growth};
    }

    void add_kind(std::size_t s, std::size_t k) {
        const Rule& rule = grammar_.rules[s];
        EdgeKind kind{lsystem_symbol_name(rule.symbol), {}};
        if (periods() > 1) kind.name += fmt::format("{}", static_cast<char>('a' + k));
        const std::size_t before = (k + periods() - 1) % periods();
        if (phase(k).drawn[s] && rule.constant) {
            constant(kind, static_cast<int>(k * symbols() + s));
        } else if (phase(k).drawn[s]) {
            for (const Occurrence& o :
                 occurrences(rule.commands, grammar_.compass, phase(before))) {
                if (!phase(before).drawn[static_cast<std::size_t>(o.symbol)]) continue;
                const int inside = static_cast<int>(before * symbols()) + o.symbol;
                kind.maps.push_back({similarity(o, growth_.factor), inside});
            }
        }
        count_ += kind.maps.size();
        if (count_ > maps_an_ifs)
            throw Error(ErrorKind::scene, fmt::format("L-system \"{}\" has more than {} maps",
                                                      lsystem_.name, maps_an_ifs));
        system_.kinds.push_back(std::move(kind));
    }

    /// A stroke that no rule changes is its own image if lengths do not grow; else it shrinks to a
    /// point of its neighbours and is left out.
    void constant(EdgeKind& kind, int self) const {
        if (std::abs(growth_.factor) > 1 + 1e-9) return;
        kind.maps = {{{}, self}};
    }

    /// A stroke that is drawn again at the next level just as long as everything else has grown, by
    /// itself or by way of other symbols, stays the segment that it is: its own two halves.
    void open_rigid_cycles() {
        for (std::size_t kind = 0; kind < system_.kinds.size(); ++kind) {
            const Complex edge = to_double(phase(kind / symbols()).displacement[kind % symbols()]);
            if (edge == 0.0 || !is_its_own_image(kind, std::abs(edge))) continue;
            const int self = static_cast<int>(kind);
            system_.kinds[kind].maps = {{{0.5, false, 0.0}, self},
                                        {{0.5, false, edge / 2.0}, self}};
        }
    }

    /// Whether a kind's only map, and the only map inside it, and so on, lead back to it unmoved.
    [[nodiscard]] bool is_its_own_image(std::size_t kind, double length) const {
        constexpr double rounding = 1e-9;
        Similarity map;
        std::size_t inside = kind;
        for (std::size_t steps = 0; steps < system_.kinds.size(); ++steps) {
            const std::vector<EdgeMap>& maps = system_.kinds[inside].maps;
            if (maps.size() != 1) return false;
            map = then(maps[0].map, map);
            inside = static_cast<std::size_t>(maps[0].inside);
            if (inside != kind) continue;
            return !map.flip && std::abs(map.linear - 1.0) < rounding &&
                   std::abs(map.offset) < rounding * length;
        }
        return false;
    }

    /// Kinds without a map, and maps with nothing inside, until none is left; then those that the
    /// start does not lead to.
    void drop_empty_kinds() {
        const auto nothing_inside = [&](const EdgeMap& map) {
            return system_.kinds[static_cast<std::size_t>(map.inside)].maps.empty();
        };
        for (std::size_t dropped = 1; dropped > 0;) {
            dropped = std::erase_if(system_.start, nothing_inside);
            for (EdgeKind& kind : system_.kinds)
                dropped += std::erase_if(kind.maps, nothing_inside);
        }
        std::vector<int> number(system_.kinds.size(), -1);
        std::vector<EdgeKind> kept;
        std::vector<std::size_t> waiting;
        const auto visit = [&](EdgeMap& map) {
            int& n = number[static_cast<std::size_t>(map.inside)];
            if (n < 0) {
                n = static_cast<int>(waiting.size());
                waiting.push_back(static_cast<std::size_t>(map.inside));
            }
            map.inside = n;
        };
        first_symbol_ =
            system_.start.empty() ? 0 : static_cast<std::size_t>(system_.start[0].inside);
        for (EdgeMap& map : system_.start) visit(map);
        for (std::size_t next = 0; next < waiting.size(); ++next) {
            kept.push_back(system_.kinds[waiting[next]]);
            for (EdgeMap& map : kept.back().maps) visit(map);
        }
        system_.kinds = std::move(kept);
    }

    /// The first edge gets the length 1. A picture whose direction changes from level to level has
    /// none of its own: that edge then runs from (0,0) to (1,0).
    void normalize() {
        constexpr double vanishes = 1e-9;  // of the longest edge: what does not grow
        Complex edge = to_double(phase(0).displacement[first_symbol_]);
        for (const Level& level : growth_.phases)
            for (const LongComplex& d : level.displacement)
                if (std::abs(edge) < vanishes) edge = to_double(d);
        const bool turns = growth_.factor.imag() != 0 || growth_.factor.real() < 0;
        const Complex scale = turns && !grammar_.has_flips ? 1.0 / edge : 1.0 / std::abs(edge);
        for (EdgeMap& map : system_.start) map.map.offset *= scale;
        for (EdgeKind& kind : system_.kinds)
            for (EdgeMap& map : kind.maps) map.map.offset *= scale;
    }

    /// A single turned or mirrored start is taken into the maps: A w A^-1.
    void turn_single_start() {
        if (system_.start.size() != 1) return;
        const Similarity a = system_.start[0].map;
        Similarity back{1.0 / a.linear, a.flip, -a.offset / a.linear};
        if (a.flip) back = {std::conj(back.linear), true, std::conj(back.offset)};
        for (EdgeKind& kind : system_.kinds)
            for (EdgeMap& map : kind.maps) map.map = then(then(back, map.map), a);
        system_.start[0].map = {};
    }

    const Lsystem& lsystem_;
    const Grammar& grammar_;
    const LsystemGrowth& growth_;
    EdgeSystem system_;
    std::size_t first_symbol_ = 0;
    std::size_t count_ = 0;
};

/// Rounding of sums taken off, so that a reader sees the number that is meant.
double clean(double value) {
    constexpr double rounding = 1e-14;
    const double nearest = std::round(value * 1e4) / 1e4;
    if (std::abs(value - nearest) < rounding) return nearest + 0.0;
    return value;
}

/// The same for ratios such as 1/3.
double clean_ratio(double ratio) {
    const double whole = std::round(1 / ratio);
    return std::abs(1 / ratio - whole) < 1e-13 * whole ? 1 / whole : clean(ratio);
}

double degrees_of(Complex linear) {
    const double degrees = std::arg(linear) * 180 / std::numbers::pi;
    const double nearest = std::round(degrees * 1e4) / 1e4;
    return std::abs(degrees - nearest) < 1e-11 ? nearest + 0.0 : degrees;
}

MapBlock map_block(const Similarity& map, const std::string& name) {
    MapBlock block;
    block.name = name;
    const double ratio = clean_ratio(std::abs(map.linear));
    const double turn = degrees_of(map.linear);
    const glm::dvec3 offset{clean(map.offset.real()), clean(map.offset.imag()), 0};
    block.commands.emplace_back().kind = ScaleCommand{{ratio, map.flip ? -ratio : ratio, ratio}};
    if (turn != 0) block.commands.emplace_back().kind = RotateCommand{Axis::z, turn};
    if (offset != glm::dvec3{0.0}) block.commands.emplace_back().kind = TranslateCommand{offset};
    return block;
}

/// The follow rules of the scene name every edge of the graph.
void require_small_graph(const std::vector<GraphKind>& kinds) {
    constexpr std::size_t most_edges = 1'000'000;
    std::size_t edges = 0;
    for (const GraphKind& kind : kinds)
        for (const int inside : kind.inside)
            edges += kinds[static_cast<std::size_t>(inside)].inside.size();
    if (kinds.size() > 1 && edges > most_edges)
        throw Error(ErrorKind::scene,
                    fmt::format("the L-system's graph has {} edges: at most {} are taken", edges,
                                most_edges));
}

}  // namespace

Similarity then(const Similarity& first, const Similarity& second) {
    const Complex linear = second.flip ? std::conj(first.linear) : first.linear;
    return {second.linear * linear, first.flip != second.flip, second.point(first.offset)};
}

EdgeSystem edge_system(const Lsystem& lsystem) {
    const Grammar grammar = grammar_of(lsystem);
    const LsystemGrowth growth = find_growth(grammar, lsystem.name);
    return SystemBuilder(lsystem, grammar, growth).build();
}

IfsBlock lsystem_maps(const EdgeSystem& system) {
    std::vector<GraphKind> kinds;
    for (const EdgeKind& kind : system.kinds) {
        GraphKind& graph = kinds.emplace_back(GraphKind{kind.name, {}});
        for (const EdgeMap& map : kind.maps) graph.inside.push_back(map.inside);
    }
    std::vector<int> start;
    for (const EdgeMap& map : system.start) start.push_back(map.inside);
    return graph_block(
        kinds, start, [&](std::size_t kind, std::size_t map, const std::string& name) {
            const auto& from = kind < kinds.size() ? system.kinds[kind].maps : system.start;
            return map_block(from[map].map, name);
        });
}

std::string lsystem_symbol_name(char symbol) {
    const auto code = static_cast<unsigned char>(symbol);
    if (std::isalpha(code)) return {static_cast<char>(std::toupper(code))};
    if (std::isdigit(code)) return fmt::format("N{}_", symbol);
    return fmt::format("S{}_", static_cast<int>(code));
}

IfsBlock graph_block(
    const std::vector<GraphKind>& kinds, const std::vector<int>& start,
    const std::function<MapBlock(std::size_t, std::size_t, const std::string&)>& make) {
    IfsBlock block;
    require_small_graph(kinds);
    // One kind, begun with itself: any map inside any other, an IFS without a graph.
    const bool single = start.size() == 1;  // its map is the identity
    const bool without_graph = single && kinds.size() == 1;
    std::vector<std::vector<MapReference>> of_kind;
    for (const GraphKind& kind : kinds) {
        std::vector<MapReference>& names = of_kind.emplace_back();
        for (std::size_t i = 0; i < kind.inside.size(); ++i)
            names.push_back({fmt::format("{}{}", kind.name, i + 1), {}});
    }
    const auto add = [&](std::size_t kind, std::size_t map, int inside, const MapReference& name) {
        block.maps.push_back(make(kind, map, std::get<std::string>(name.map)));
        if (!without_graph)
            block.follow.push_back({name, of_kind[static_cast<std::size_t>(inside)]});
    };
    if (single && !without_graph) block.start = of_kind[static_cast<std::size_t>(start[0])];
    for (std::size_t i = 0; !single && i < start.size(); ++i) {
        block.start.push_back({fmt::format("axiom{}", i + 1), {}});
        add(kinds.size(), i, start[i], block.start.back());
    }
    for (std::size_t k = 0; k < kinds.size(); ++k)
        for (std::size_t i = 0; i < kinds[k].inside.size(); ++i)
            add(k, i, kinds[k].inside[i], of_kind[k][i]);
    return block;
}

}  // namespace pxm::host
