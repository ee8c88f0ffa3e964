#include "host/export/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "host/error.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr double square = 1e-6;            // columns are as good as perpendicular
constexpr double float_spacing = 0x1p-23;  // relative
constexpr double steps_a_cell = 256;

/// Looks at what a cell's matrix does.
void look_at(const glm::dmat3& m, SetTally& tally) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double lengths = glm::length(m[i]) * glm::length(m[j]);
        if (std::abs(glm::dot(m[i], m[j])) > square * lengths) tally.sheared = true;
        if (m[i][j] != 0 || m[j][i] != 0 || m[i][i] < 0) tally.turned = true;
    }
    if (glm::dot(m[0], glm::cross(m[1], m[2])) < 0) tally.mirrored = true;
}

void add_point(const glm::dvec3& point, glm::dvec3& low, glm::dvec3& high) {
    low = glm::min(low, point);
    high = glm::max(high, point);
}

class Counter {
  public:
    Counter(const ExportSystem& system, std::vector<SetTally>& sets)
        : system_(system), sets_(sets) {
        sets_.resize(system.sets.size());
        for (SetTally& set : sets_) {
            set.low = glm::dvec3{std::numeric_limits<double>::infinity()};
            set.high = -set.low;
        }
    }

    void add(const Cell& cell) {
        SetTally& tally = sets_[static_cast<std::size_t>(cell.set)];
        ++tally.cells;
        look_at(cell.place.linear, tally);
        glm::dvec3 low{std::numeric_limits<double>::infinity()};
        glm::dvec3 high = -low;
        for (const glm::dvec3& v : system_.sets[static_cast<std::size_t>(cell.set)].shape.vertices)
            add_point(cell.place.point(v), low, high);
        const glm::dvec3 size = high - low;
        smallest_ = std::min(smallest_, std::max({size.x, size.y, size.z}));
        add_point(low, tally.low, tally.high);
        add_point(high, tally.low, tally.high);
    }
    [[nodiscard]] double smallest() const { return smallest_; }

  private:
    const ExportSystem& system_;
    std::vector<SetTally>& sets_;
    double smallest_ = std::numeric_limits<double>::infinity();
};

}  // namespace

void Watch::look() {
    stop_if_asked();
    if (expected_ > 0) progress_(static_cast<double>(visited_) / static_cast<double>(expected_));
}

namespace {

/// How many there are where nothing but the levels ends a word.
struct Counts {
    double cells = 0, vertices = 0, triangles = 0;
    void add(const Counts& other) {
        cells += other.cells;
        vertices += other.vertices;
        triangles += other.triangles;
    }
};

Counts by_levels(const ExportSystem& system) {
    std::vector<Counts> ends;  // of a word that ends in a set
    for (const SystemSet& set : system.sets)
        ends.push_back({1, static_cast<double>(set.shape.vertices.size()),
                        static_cast<double>(triangles_of(set.shape).size())});
    std::vector<Counts> inside = ends;  // of what ends after so many more maps
    for (std::uint32_t level = 0; level < system.levels; ++level) {
        std::vector<Counts> around(inside.size());
        for (std::size_t s = 0; s < around.size(); ++s) {
            if (system.sets[s].maps.empty()) around[s] = ends[s];
            for (const int m : system.sets[s].maps) {
                const int set = system.maps[static_cast<std::size_t>(m)].inside;
                around[s].add(inside[static_cast<std::size_t>(set)]);
            }
        }
        inside = std::move(around);
        if (system.maps.empty()) break;
    }
    return inside[static_cast<std::size_t>(system.start)];
}

[[noreturn]] void refuse_number(const ExportSystem& system, double most_cells) {
    throw Error(ErrorKind::setting,
                fmt::format("object \"{}\" has more than {:.0f} cells: fewer --levels or a larger "
                            "--detail",
                            printable(system.name), most_cells));
}

}  // namespace

double cells_by_levels(const ExportSystem& system) { return by_levels(system).cells; }

CellTally forecast(const ExportScene& scene) {
    Counts all;
    for (const ExportSystem& system : scene.systems) {
        if (system.detail > 0 && !system.maps.empty()) return {};
        all.add(by_levels(system));
    }
    const auto whole = [](double count) {
        constexpr auto most = std::numeric_limits<std::uint64_t>::max();
        return count < 1e19 ? static_cast<std::uint64_t>(count) : most;
    };
    CellTally tally;
    tally.cells = whole(all.cells);
    tally.vertices = whole(all.vertices);
    tally.triangles = whole(all.triangles);
    return tally;
}

CellTally tally_of(const ExportScene& scene, Watch& watch) {
    CellTally tally;
    double count = 0;
    tally.low = glm::dvec3{std::numeric_limits<double>::infinity()};
    tally.high = -tally.low;
    tally.smallest = std::numeric_limits<double>::infinity();
    for (const ExportSystem& system : scene.systems) {
        Counter counter(system, tally.systems.emplace_back());
        if (system.detail <= 0 && cells_by_levels(system) > scene.most_cells)
            refuse_number(system, scene.most_cells);
        const bool ended = for_each_cell(system, [&](const Cell& cell) {
            if (++count > scene.most_cells) refuse_number(system, scene.most_cells);
            watch.visit();
            counter.add(cell);
        });
        if (!ended)
            throw Error(ErrorKind::scene,
                        fmt::format("object \"{}\" has cells that are larger than --detail after "
                                    "{} maps",
                                    printable(system.name), longest_word));
        tally.smallest = std::min(tally.smallest, counter.smallest());
        tally.colored = tally.colored || system.colored || system.color != scene.systems[0].color;
    }
    for (std::size_t i = 0; i < scene.systems.size(); ++i)
        for (std::size_t s = 0; s < tally.systems[i].size(); ++s) {
            const SetTally& set = tally.systems[i][s];
            if (set.cells == 0) continue;
            const Mesh& shape = scene.systems[i].sets[s].shape;
            tally.cells += set.cells;
            tally.vertices += set.cells * shape.vertices.size();
            tally.faces += set.cells * shape.faces.size();
            tally.triangles += set.cells * triangles_of(shape).size();
            tally.low = glm::min(tally.low, set.low);
            tally.high = glm::max(tally.high, set.high);
        }
    const glm::dvec3 far = glm::max(glm::abs(tally.low), glm::abs(tally.high));
    if (tally.smallest < steps_a_cell * float_spacing * std::max({far.x, far.y, far.z}))
        tally.number = CoordinateNumber::double_;
    return tally;
}

}  // namespace pxm::host
