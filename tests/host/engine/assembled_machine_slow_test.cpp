// Laws of the node program in DSP32 code that take many pictures or larger ones.
#include <algorithm>

#include "host/output/cost_model_json.hpp"
#include "tests/host/engine/assembled.hpp"

namespace pxm::host {
namespace {

TEST(AssembledMachine, larger_pictures_are_those_of_the_counted_kernels) {
    for (const char* name : {"tetra", "menger", "elm"})
        expect_same(name, assembled("964dX", 80, 60));
}

TEST(AssembledMachine, so_are_systems_with_boxes) {
    for (const char* name : {"menger", "tetra", "elm", "octo", "twindragon"}) {
        RenderRequest request = assembled("964dX", 20, 15);
        request.overrides.volume = VolumeKind::box;
        expect_same(name, request);
    }
    // As the scene is, and from within.
    RenderRequest request = test::on_machine("964dX", 20, 15);
    request.code = NodeCode::assembled;
    expect_same("menger", request);
    request.overrides.zoom = 3;
    expect_same("menger", request);
}

TEST(AssembledMachine, so_are_pictures_with_constants_by_determinant_samples_and_levels) {
    RenderRequest request = assembled("920", 17, 13);
    request.overrides.lipschitz = LipschitzMethod::determinant;
    request.overrides.samples = 3;
    request.overrides.zoom = 4;
    expect_same("elm", request);
    request.overrides.levels = 2;
    expect_same("tetra", request);
}

/// The slowest node's cycles.
std::uint64_t slowest(const RenderResult& result) {
    std::uint64_t most = 0;
    for (const NodeStatistics& node : result.statistics.machine->nodes)
        most = std::max(most, node.cycles);
    return most;
}

TEST(AssembledMachine, costs_read_off_the_code_predict_its_time) {
    // The factor was chosen by the first three.
    for (const char* name :
         {"tetra", "menger", "elm", "octo", "icos", "dodec", "twindragon", "fir"}) {
        RenderRequest request = assembled("964dX", 32, 24);
        const auto in_code = static_cast<double>(slowest(render_scene(name, request)));
        request.code = NodeCode::counted;
        const auto by_table = static_cast<double>(slowest(render_scene(name, request)));
        request.costs = read_cost_model(test::source_dir + "/docs/cost-model-asm.json");
        const auto predicted = static_cast<double>(slowest(render_scene(name, request)));
        EXPECT_NEAR(predicted / in_code, 1, 0.12) << name;
        EXPECT_NEAR(in_code / by_table, 1.335, 0.05) << name << ": the default table's error";
    }
}

}  // namespace
}  // namespace pxm::host
