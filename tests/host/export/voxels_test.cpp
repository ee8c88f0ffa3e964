// Level sets of cells, by a grid that keeps every sample: known volumes, and the same samples as a
// loop over all cells gives.
#include "host/export/voxels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "host/export/export_scene.hpp"
#include "host/export/tally.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"

namespace pxm::host {
namespace {

/// Samples from -margin to side + margin along every axis.
class AllSamples final : public LevelSet {
  public:
    explicit AllSamples(int side) : edge_(side + 2 * margin) {
        const auto edge = static_cast<std::size_t>(edge_);
        distances_.assign(edge * edge * edge, level_set_band);
    }
    void lower(const glm::ivec3& low, const glm::ivec3& size, const float* distances) override {
        for (int k = 0; k < 3; ++k) EXPECT_EQ(low[k] >> 3, (low[k] + size[k] - 1) >> 3);
        for (int x = 0; x < size.x; ++x)
            for (int y = 0; y < size.y; ++y)
                for (int z = 0; z < size.z; ++z) put(low + glm::ivec3{x, y, z}, *distances++);
    }
    void fill(const glm::ivec3& low, int edge) override {
        ++fills;
        for (int k = 0; k < 3; ++k) EXPECT_EQ(low[k] % edge, 0);
        for (int x = 0; x < edge; ++x)
            for (int y = 0; y < edge; ++y)
                for (int z = 0; z < edge; ++z)
                    put(low + glm::ivec3{x, y, z}, -static_cast<float>(level_set_band));
    }
    std::uint64_t samples() override { return 0; }
    std::string file(const std::string&) override { return ""; }

    double& at(const glm::ivec3& sample) {
        const glm::ivec3 place = sample + margin;
        return distances_[static_cast<std::size_t>((place.x * edge_ + place.y) * edge_ + place.z)];
    }
    [[nodiscard]] double inside() const {
        return static_cast<double>(
            std::ranges::count_if(distances_, [](double d) { return d < 0; }));
    }
    static constexpr int margin = 16;
    int fills = 0;

  private:
    void put(const glm::ivec3& sample, float distance) {
        double& there = at(sample);
        there = std::max(std::min(there, static_cast<double>(distance)), -level_set_band);
    }
    int edge_;
    std::vector<double> distances_;
};

struct Made {
    AllSamples samples;
    SampleGrid grid;
    ExportScene scene;
    CellTally tally;
};

const std::atomic<bool> never{false};

Made made(const std::string& text, int voxels, long levels, VolumeKind kind,
          FileAxes axes = FileAxes::of_scene) {
    Diagnostics diagnostics;
    static Scene scene;  // what is exported refers to it
    scene = parse_text("s.pxm", text, diagnostics);
    check_scene(scene, diagnostics);
    ExportRequest request;
    request.levels = levels;
    request.shape.kind = kind;
    ExportScene cells = export_scene(scene, request, axes, diagnostics);
    EXPECT_FALSE(diagnostics.has_errors());
    const HearShare deaf = [](double) {};
    Watch watch(deaf, never);
    const CellTally tally = tally_of(cells, watch);
    const glm::dvec3 size = tally.high - tally.low;
    const double voxel = std::max({size.x, size.y, size.z}) / voxels;
    Made result{AllSamples(voxels), {voxel, tally.low + voxel / 2}, std::move(cells), tally};
    const std::function<void()> look = [] {};
    for (const ExportSystem& system : result.scene.systems) {
        Voxels cells_of(system, result.grid, result.samples, look);
        (void)for_each_cell(system, [&](const Cell& cell) { cells_of.add(cell); });
    }
    return result;
}

std::string menger() {
    std::string text = "ifs menger {\n";
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if ((x == 0) + (y == 0) + (z == 0) < 2)
                    text += "newmap scale: 1/3 translate: " + std::to_string(x) + "*2/3," +
                            std::to_string(y) + "*2/3," + std::to_string(z) + "*2/3\n";
    return text + "}\nobject sponge { ifs: menger box: (-1,-1,-1)(1,1,1) }\n";
}

TEST(Voxels, of_mengers_cubes_are_as_many_as_its_volume) {
    const Made two = made(menger(), 54, 2, VolumeKind::automatic);  // six voxels a cube
    EXPECT_EQ(two.samples.inside(), 400 * 6 * 6 * 6);
    const Made one = made(menger(), 81, 1, VolumeKind::automatic);
    EXPECT_EQ(one.samples.inside(), 20 * 27 * 27 * 27);
    EXPECT_GT(one.samples.fills, 0);
}

TEST(Voxels, of_a_ball_are_as_many_as_its_volume_within_half_a_voxel) {
    for (const FileAxes axes : {FileAxes::of_scene, FileAxes::z_to_viewer, FileAxes::z_up}) {
        Made ball = made("object ball { sphere: (5,6,7) 2 translate: 1,0,0 }\n", 64, 1,
                         VolumeKind::automatic, axes);
        const double radius = 2 / ball.grid.voxel;
        EXPECT_NEAR(radius, 32, 0.2);  // the box is that of the 80 triangles
        const auto volume = [](double r) { return 4 * std::numbers::pi / 3 * r * r * r; };
        EXPECT_GT(ball.samples.inside(), volume(radius - 0.05));
        EXPECT_LT(ball.samples.inside(), volume(radius + 0.05));
        EXPECT_GT(ball.samples.fills, 0);
    }
}

/// Cells that are turned, mirrored and sheared, with boxes, balls and hulls.
TEST(Voxels, are_the_least_distance_to_any_cell) {
    const std::string scene =
        "ifs a {\n"
        "newmap scale: 0.5,0.25,0.5 rotate: z,30 translate: 1,0,0\n"
        "newmap scale: 0.4 rotate: x,75 translate: 0,1,0\n"
        "newmap scale: -0.5,0.3,0.5 translate: 0,0,1 }\n"
        "object a { ifs: a rotate: y,20 }\n";
    for (const VolumeKind kind : {VolumeKind::box, VolumeKind::sphere, VolumeKind::hull}) {
        Made grid = made(scene, 40, 2, kind);
        const ExportSystem& system = grid.scene.systems[0];
        for (int i = 0; i < 1500; ++i) {
            const glm::ivec3 sample{i * 7 % 44 - 2, i * 11 % 43 - 2, i * 13 % 41 - 2};
            const glm::dvec3 world = grid.grid.first + grid.grid.voxel * glm::dvec3{sample};
            double nearest = level_set_band;
            (void)for_each_cell(system, [&](const Cell& cell) {
                const SystemSet& set = system.sets[static_cast<std::size_t>(cell.set)];
                const Solid solid(set.volume, set.shape, cell.place);
                const double reach = level_set_band * grid.grid.voxel;
                nearest =
                    std::min(nearest, solid.distance(world, reach) / grid.grid.voxel - cell_growth);
            });
            // What is far outside or deep inside is only told to be so, and of ellipsoids the size
            // of a distance is no more than near.
            const double found = grid.samples.at(sample);
            const double expected = std::clamp(nearest, -level_set_band, level_set_band);
            EXPECT_EQ(found < 0, expected < 0) << static_cast<int>(kind) << ' ' << i;
            if (kind == VolumeKind::sphere && std::abs(expected) > 1) continue;
            EXPECT_NEAR(found, expected, 1e-5) << static_cast<int>(kind) << ' ' << i;
        }
    }
}

}  // namespace
}  // namespace pxm::host
