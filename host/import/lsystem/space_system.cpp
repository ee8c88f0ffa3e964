#include "host/import/lsystem/space_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "host/error.hpp"
#include "host/import/lsystem/lsystem_growth.hpp"
#include "host/import/lsystem/space_growth.hpp"
#include "host/scene/check/limits.hpp"

namespace pxm::host {

namespace {

/// From forward, left and up of the turtle as it begins to a scene's x, y and z (away).
const glm::dmat3 to_scene{{0, 1, 0}, {-1, 0, 0}, {0, 0, -1}};

class SpaceBuilder {
  public:
    SpaceBuilder(const Lsystem& lsystem, const Grammar& grammar, const SpaceTurns& turns,
                 const SpaceGrowth& growth)
        : lsystem_(lsystem), grammar_(grammar), turns_(turns), growth_(growth) {}

    SpaceSystem build() {
        system_.growth = growth_.factor;
        for (std::size_t phase = 0; phase < periods(); ++phase)
            for (std::size_t s = 0; s < symbols(); ++s) add_kind(s, phase);
        for (const SpaceOccurrence& o :
             space_occurrences(grammar_.axiom, turns_, growth_.phases[0]))
            system_.start.push_back({similarity(o, 1), o.symbol});
        open_rigid_cycles();
        drop_empty_kinds();
        if (system_.start.empty())
            throw Error(ErrorKind::scene,
                        fmt::format("L-system \"{}\" has no exact linear fractal: what it draws "
                                    "does not grow with the level",
                                    lsystem_.name));
        normalize();
        move_single_start();
        return std::move(system_);
    }

  private:
    [[nodiscard]] std::size_t periods() const { return growth_.phases.size(); }
    [[nodiscard]] std::size_t symbols() const { return grammar_.rules.size(); }

    [[nodiscard]] static Affine similarity(const SpaceOccurrence& o, double growth) {
        const double scale = o.state.step.convert_to<double>() / growth;
        const glm::dmat3 turned = to_scene * o.state.turn.matrix() * glm::transpose(to_scene);
        return {turned * scale, to_scene * o.place / growth};
    }

    void add_kind(std::size_t s, std::size_t k) {
        const Rule& rule = grammar_.rules[s];
        SpaceKind kind{lsystem_symbol_name(rule.symbol), {}};
        if (periods() > 1) kind.name += static_cast<char>('a' + k);
        const std::size_t before = (k + periods() - 1) % periods();
        const SpaceLevel& inner = growth_.phases[before];
        if (growth_.phases[k].drawn[s] && rule.constant) {
            // A stroke that no rule changes shrinks to a point where others grow.
            if (growth_.factor <= 1 + 1e-9)
                kind.maps = {{Affine{}, static_cast<int>(k * symbols() + s)}};
        } else if (growth_.phases[k].drawn[s]) {
            for (const SpaceOccurrence& o : space_occurrences(rule.commands, turns_, inner)) {
                if (!inner.drawn[static_cast<std::size_t>(o.symbol)]) continue;
                kind.maps.push_back({similarity(o, growth_.factor),
                                     static_cast<int>(before * symbols()) + o.symbol});
            }
        }
        count_ += kind.maps.size();
        if (count_ > maps_an_ifs)
            throw Error(ErrorKind::scene, fmt::format("L-system \"{}\" has more than {} maps",
                                                      lsystem_.name, maps_an_ifs));
        system_.kinds.push_back(std::move(kind));
    }

    [[nodiscard]] glm::dvec3 edge_of(std::size_t kind) const {
        return to_scene *
               to_double(growth_.phases[kind / symbols()].displacement[kind % symbols()]);
    }

    /// A stroke that comes again just as long as everything grows stays the segment that it is:
    /// its own two halves.
    void open_rigid_cycles() {
        for (std::size_t kind = 0; kind < system_.kinds.size(); ++kind) {
            const glm::dvec3 edge = edge_of(kind);
            if (glm::length(edge) == 0 || !is_its_own_image(kind, glm::length(edge))) continue;
            const int self = static_cast<int>(kind);
            const Affine half{glm::dmat3(0.5), {}};
            system_.kinds[kind].maps = {{half, self}, {{half.linear, edge / 2.0}, self}};
        }
    }

    /// Whether a kind's only map, and the only map inside it, and so on, lead back to it unmoved,
    /// but for a turn about the stroke.
    [[nodiscard]] bool is_its_own_image(std::size_t kind, double length) const {
        constexpr double rounding = 1e-9;
        const glm::dvec3 edge = edge_of(kind);
        Affine map;
        std::size_t inside = kind;
        for (std::size_t steps = 0; steps < system_.kinds.size(); ++steps) {
            const std::vector<SpaceMap>& maps = system_.kinds[inside].maps;
            if (maps.size() != 1) return false;
            map = then(maps[0].map, map);
            inside = static_cast<std::size_t>(maps[0].inside);
            if (inside != kind) continue;
            return glm::distance(map.linear * edge, edge) < rounding * length &&
                   glm::length(map.translation) < rounding * length;
        }
        return false;
    }

    /// Kinds without a map and maps with nothing inside, until none is left; then those that the
    /// start does not lead to.
    void drop_empty_kinds() {
        const auto nothing_inside = [&](const SpaceMap& map) {
            return system_.kinds[static_cast<std::size_t>(map.inside)].maps.empty();
        };
        for (std::size_t dropped = 1; dropped > 0;) {
            dropped = std::erase_if(system_.start, nothing_inside);
            for (SpaceKind& kind : system_.kinds)
                dropped += std::erase_if(kind.maps, nothing_inside);
        }
        std::vector<int> number(system_.kinds.size(), -1);
        std::vector<std::size_t> waiting;
        const auto visit = [&](SpaceMap& map) {
            int& n = number[static_cast<std::size_t>(map.inside)];
            if (n < 0) {
                n = static_cast<int>(waiting.size());
                waiting.push_back(static_cast<std::size_t>(map.inside));
            }
            map.inside = n;
        };
        for (SpaceMap& map : system_.start) visit(map);
        if (!waiting.empty()) unit_ = glm::length(edge_of(waiting[0]));
        std::vector<SpaceKind> kept;
        for (std::size_t next = 0; next < waiting.size(); ++next) {
            kept.push_back(system_.kinds[waiting[next]]);
            for (SpaceMap& map : kept.back().maps) visit(map);
        }
        system_.kinds = std::move(kept);
    }

    /// The first edge gets the length 1; where it is none, the longest of its level does.
    void normalize() {
        constexpr double vanishes = 1e-9;
        for (std::size_t kind = 0; unit_ < vanishes && kind < symbols(); ++kind)
            unit_ = std::max(unit_, glm::length(edge_of(kind)));
        for (SpaceMap& map : system_.start) map.map.translation /= unit_;
        for (SpaceKind& kind : system_.kinds)
            for (SpaceMap& map : kind.maps) map.map.translation /= unit_;
    }

    /// A single start is taken into the maps: A w A^-1.
    void move_single_start() {
        if (system_.start.size() != 1) return;
        const Affine a = system_.start[0].map, back = inverse(a);
        for (SpaceKind& kind : system_.kinds)
            for (SpaceMap& map : kind.maps) map.map = then(then(back, map.map), a);
        system_.start[0].map = {};
    }

    const Lsystem& lsystem_;
    const Grammar& grammar_;
    const SpaceTurns& turns_;
    const SpaceGrowth& growth_;
    SpaceSystem system_;
    double unit_ = 0;
    std::size_t count_ = 0;
};

/// Rounding of sums taken off, so that a reader sees the number that is meant.
double clean(double value) {
    const double nearest = std::round(value * 1e4) / 1e4;
    return std::abs(value - nearest) < 1e-13 ? nearest + 0.0 : value;
}

double clean_ratio(double ratio) {
    const double whole = std::round(1 / ratio);
    return std::abs(1 / ratio - whole) < 1e-12 * whole ? 1 / whole : clean(ratio);
}

/// Turns about x, y and z, one after the other, that are a rotation.
glm::dvec3 angles_of(const glm::dmat3& turn) {
    const double y = std::asin(std::clamp(-turn[0][2], -1.0, 1.0));
    if (std::abs(turn[0][2]) > 1 - 1e-12)  // x and z turn about one line
        return {std::atan2(-turn[2][1], turn[1][1]), y, 0};
    return {std::atan2(turn[1][2], turn[2][2]), y, std::atan2(turn[0][1], turn[0][0])};
}

MapBlock block_of(const Affine& map, const std::string& name) {
    MapBlock block;
    block.name = name;
    const double ratio = glm::length(map.linear[0]);
    block.commands.emplace_back().kind = ScaleCommand{glm::dvec3{clean_ratio(ratio)}};
    const glm::dvec3 angles = angles_of(map.linear / ratio);
    int number = 0;
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
        const double degrees = clean(angles[number++] * 180 / std::numbers::pi);
        if (degrees != 0) block.commands.emplace_back().kind = RotateCommand{axis, degrees};
    }
    const glm::dvec3 offset{clean(map.translation.x), clean(map.translation.y),
                            clean(map.translation.z)};
    if (offset != glm::dvec3{0.0}) block.commands.emplace_back().kind = TranslateCommand{offset};
    return block;
}

}  // namespace

SpaceSystem space_system(const Lsystem& lsystem) {
    const Grammar grammar = grammar_of(lsystem);
    const SpaceTurns turns(lsystem);
    const SpaceGrowth growth = find_space_growth(grammar, turns, lsystem.name);
    return SpaceBuilder(lsystem, grammar, turns, growth).build();
}

IfsBlock space_maps(const SpaceSystem& system) {
    std::vector<GraphKind> kinds;
    for (const SpaceKind& kind : system.kinds) {
        GraphKind& graph = kinds.emplace_back(GraphKind{kind.name, {}});
        for (const SpaceMap& map : kind.maps) graph.inside.push_back(map.inside);
    }
    std::vector<int> start;
    for (const SpaceMap& map : system.start) start.push_back(map.inside);
    return graph_block(
        kinds, start, [&](std::size_t kind, std::size_t map, const std::string& name) {
            const auto& from = kind < kinds.size() ? system.kinds[kind].maps : system.start;
            return block_of(from[map].map, name);
        });
}

}  // namespace pxm::host
