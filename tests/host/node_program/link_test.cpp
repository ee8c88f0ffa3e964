// Laws of host/node_program/link: what is in the node program, why, and what it takes of fast
// memory.
#include "host/node_program/link.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "host/compile/compile.hpp"
#include "host/error.hpp"
#include "host/node_program/module_table.hpp"
#include "host/render/render.hpp"
#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "pxm/model.hpp"

namespace pxm::host {
namespace {

using Names = std::set<std::string>;

const std::string gasket =
    "ifs gasket { newmap scale: 0.5 translate: 0,0.5,0 newmap scale: 0.5 translate: 0.5,-0.5,0\n"
    "             newmap scale: 0.5 translate: -0.5,-0.5,0 }\n";
const std::string ball = "object ball { ifs: gasket sphere: (0,0,0) 2 }\n";
const std::string key = "light key { direction: 0,1,-1 }\n";
const std::string simple = gasket + ball + key;
const std::string mirrored = simple + "object mirror { ifs: gasket sphere: (0,0,0) 2 reflect: 1 }";
const std::string lamps =
    "light lamp { position: 1,2,-3 } light sun { direction: 1,1,-1 shadow: on }";

CompiledScene compiled(const std::string& text) {
    Diagnostics diagnostics;
    const Scene scene = parse_text("test.pxm", text, diagnostics);
    check_scene(scene, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    CompiledScene result = compile(scene, 1, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    return result;
}

NodeProgram linked(const std::string& text) { return link(compiled(text)); }

Names names(const std::vector<ProgramModule>& modules) {
    Names result;
    for (const ProgramModule& module : modules) result.insert(module.name);
    return result;
}

Names added(const NodeProgram& before, const NodeProgram& after) {
    const Names old = names(before.modules);
    Names result;
    for (const std::string& name : names(after.modules)) {
        if (!old.contains(name)) result.insert(name);
    }
    return result;
}

/// One scene with a feature and the same without it; the module the feature needs.
struct Feature {
    std::string without;
    std::string with;
    std::string module;
};

const std::vector<Feature> features{
    {simple, simple + "object case { ifs: gasket box: (-2,-2,-2)(2,2,2) }", "box"},
    {gasket + "object case { ifs: gasket box: (-2,-2,-2)(2,2,2) }" + key,
     simple + "object case { ifs: gasket box: (-2,-2,-2)(2,2,2) }", "sphere"},
    {simple, simple + "object jar { cylinder }", "cylinder"},
    {simple, simple + "object tip { cone }", "cone"},
    {simple, simple + "object case { ifs: gasket hull }", "hull"},
    {simple, simple + "render { lipschitz: polar }", "polar"},
    {simple,
     simple + "ifs slant { newmap scale: 0.5,0.4,0.3 newmap scale: 0.5 translate: 0.5,0,0 }"
              "object slanted { ifs: slant sphere: (0,0,0) 2 }",
     "polar"},
    {simple, simple + "light lamp { position: 1,2,-3 }", "point_light"},
    {simple + "render { lipschitz: product }",
     simple + "ifs leaf { newmap scale: 0.5,0,0.5 newmap scale: 0.5 translate: 0,0.5,0 }"
              "object leaf { ifs: leaf sphere: (0,0,0) 2 } render { lipschitz: product }",
     "flatness"},
    {simple + "render { lipschitz: polar }",
     simple + "ifs thin { newmap scale: 0.5,0.00001,0.5 newmap scale: 0.5 translate: 0,0.5,0 }"
              "object thin { ifs: thin sphere: (0,0,0) 2 } render { lipschitz: polar }",
     "steepness"},
    {simple, simple + "plane floor { normal: 0,1,0 }", "plane"},
    {simple + "texture w { wood } plane { normal: 0,1,0 texture: w }",
     simple + "texture w { wood } texture g { ifs: gasket } plane { normal: 0,1,0 texture: w, g }",
     "texture_inclusion"},
    {simple + "texture g { ifs: gasket } plane { normal: 0,1,0 texture: g }",
     simple + "texture w { wood } texture g { ifs: gasket } plane { normal: 0,1,0 texture: w, g }",
     "texture_wood"},
    {mirrored, mirrored + "light sun { direction: 1,1,-1 shadow: on }", "shadow"},
    {mirrored + lamps, mirrored + lamps + "light spot { position: 3,2,-3 shadow: on }",
     "shadow_point"},
    {simple + "render { covers: on }", mirrored + "render { covers: on }", "mirror"},
};

TEST(Link, a_feature_adds_its_module_and_nothing_else) {
    for (const Feature& feature : features) {
        const NodeProgram without = linked(feature.without);
        const NodeProgram with = linked(feature.with);
        EXPECT_EQ(added(without, with), Names{feature.module}) << feature.with;
        EXPECT_EQ(added(with, without), Names{}) << feature.with;
    }
}

TEST(Link, a_feature_adds_the_bytes_of_its_module) {
    for (const Feature& feature : features) {
        const auto module = std::ranges::find(module_table, feature.module, &MeasuredModule::name);
        ASSERT_NE(module, module_table.end());
        EXPECT_EQ(linked(feature.with).modules_bytes(),
                  linked(feature.without).modules_bytes() + module->bytes());
    }
}

TEST(Link, what_goes_beyond_the_first_cell_replaces_the_tracer) {
    const NodeProgram plain = linked(simple);
    const NodeProgram all = linked(mirrored);
    EXPECT_EQ(added(plain, all), (Names{"trace_rays", "mirror"}));
    EXPECT_EQ(added(all, plain), Names{"trace"});
}

TEST(Link, another_kind_of_volume_replaces_the_module_of_the_first) {
    const NodeProgram sphere = linked(gasket + key + "render { volume: sphere }");
    for (const char* kind : {"box", "oriented", "hull"}) {
        const NodeProgram other =
            linked(gasket + key + fmt::format("render {{ volume: {} }}", kind));
        EXPECT_EQ(added(sphere, other), Names{kind});
        EXPECT_EQ(added(other, sphere), Names{"sphere"});
    }
}

TEST(Link, covers_take_another_tracer_and_their_module) {
    const std::string haze = "object haze { ifs: gasket sphere: (0,0,0) 2 ";
    const NodeProgram rays = linked(mirrored + haze + "}");
    for (const std::string& with :
         {mirrored + haze + "} render { covers: on }", mirrored + haze + "opacity: 0.5 }"}) {
        EXPECT_EQ(added(rays, linked(with)), (Names{"trace_all", "covers"})) << with;
        EXPECT_EQ(added(linked(with), rays), Names{"trace_rays"}) << with;
    }
}

TEST(Link, covers_by_area_take_another_tracer_and_beams) {
    const NodeProgram rays = linked(mirrored);
    const NodeProgram area = linked(mirrored + "render { covers: area }");
    EXPECT_EQ(added(rays, area), (Names{"trace_area", "beam"}));
    EXPECT_EQ(added(area, rays), Names{"trace_rays"});
    EXPECT_GT(area.stack_bytes, rays.stack_bytes);  // what a beam found is kept there
    EXPECT_LE(area.used_bytes(), fast_memory_bytes);
}

TEST(Link, another_projection_replaces_the_module_of_the_first) {
    const NodeProgram perspective = linked(simple);
    const NodeProgram orthographic = linked(simple + "camera { orthographic: 3 }");
    EXPECT_EQ(added(perspective, orthographic), Names{"orthographic"});
    EXPECT_EQ(added(orthographic, perspective), Names{"perspective"});
}

TEST(Link, every_module_of_the_table_is_either_in_or_left_out_with_a_reason) {
    Names table;
    for (const MeasuredModule& module : module_table) table.emplace(module.name);
    for (const Feature& feature : features) {
        const NodeProgram program = linked(feature.with);
        Names both = names(program.modules);
        both.merge(names(program.left_out));
        EXPECT_EQ(both, table);
        EXPECT_EQ(program.modules.size() + program.left_out.size(), table.size());
        for (const auto& list : {program.modules, program.left_out}) {
            for (const ProgramModule& module : list) EXPECT_NE(module.because, "") << module.name;
        }
    }
}

TEST(Link, used_bytes_are_the_sum_of_modules_heap_order_and_stack) {
    const NodeProgram program = linked(simple);
    std::int64_t sum = program.heap_order_bytes + program.stack_bytes;
    for (const ProgramModule& module : program.modules) {
        EXPECT_GT(module.bytes, 0) << module.name;
        sum += module.bytes;
    }
    EXPECT_EQ(program.used_bytes(), sum);
    EXPECT_EQ(program.heap_order_bytes, 4 * 256);
}

/// The function that `caller` (none: the entry of the linked modules) calls by that name.
const MeasuredFunction* called(const MeasuredFunction* caller, const Names& in,
                               const std::string& name) {
    if (caller == nullptr) {
        const auto entry = std::ranges::find_if(function_table, [&](const auto& function) {
            return function.name == entry_function && in.contains(std::string(function.module));
        });
        return entry == function_table.end() ? nullptr : &*entry;
    }
    for (const std::size_t callee : caller->calls) {
        if (function_table[callee].name == name) return &function_table[callee];
    }
    return nullptr;
}

TEST(Link, the_stack_is_that_of_a_chain_of_calls_through_modules_that_are_in) {
    for (const Feature& feature : features) {
        const NodeProgram program = linked(feature.with);
        const Names in = names(program.modules);
        const MeasuredFunction* function = nullptr;
        std::int64_t sum = 0;
        for (const std::string& name : program.deepest_calls) {
            function = called(function, in, name);
            ASSERT_NE(function, nullptr) << name;
            EXPECT_TRUE(in.contains(std::string(function->module))) << name;
            sum += function->stack_bytes;
        }
        EXPECT_EQ(program.stack_bytes, sum);
    }
}

TEST(Link, more_modules_never_need_less_stack) {
    for (const Feature& feature : features) {
        EXPECT_LE(linked(feature.without).stack_bytes, linked(feature.with).stack_bytes);
    }
}

TEST(Link, each_feature_fits_with_a_quarter_of_fast_memory_to_spare) {
    for (const Feature& feature : features) {
        EXPECT_NO_THROW(require_fit(linked(feature.with), "964dX"));
        EXPECT_LT(linked(feature.with).used_bytes(), fast_memory_bytes * 3 / 4);
    }
}

TEST(Link, a_program_that_does_not_fit_names_its_largest_parts) {
    const NodeProgram program = linked(simple + "render { heap: 9000 }");
    std::vector<ProgramModule> largest = program.modules;
    std::ranges::stable_sort(largest, std::ranges::greater{}, &ProgramModule::bytes);
    try {
        require_fit(program, "964dX");
        FAIL() << "a heap of 9000 fits";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::machine_limit);
        EXPECT_EQ(
            error.what(),
            fmt::format("the node program does not fit the fast memory of the 964dX: {} "
                        "bytes wanted, 36864 there\n"
                        "its largest parts: the heap's order 36000 bytes, the stack {} bytes, "
                        "module \"{}\" {} bytes, module \"{}\" {} bytes",
                        program.used_bytes(), program.stack_bytes, largest[0].name,
                        largest[0].bytes, largest[1].name, largest[1].bytes));
    }
}

/// A scene file for a render, removed at the end.
class SceneFile {
  public:
    explicit SceneFile(const std::string& text)
        : path_(testing::TempDir() + "pxm_link_test_" + std::to_string(::getpid()) + ".pxm") {
        std::ofstream(path_) << text;
    }
    ~SceneFile() { std::filesystem::remove(path_); }
    SceneFile(const SceneFile&) = delete;
    SceneFile& operator=(const SceneFile&) = delete;

    [[nodiscard]] RenderRequest request(const Model* machine) const {
        RenderRequest request;
        request.scene_path = path_;
        request.machine = machine;
        return request;
    }

  private:
    std::string path_;
};

TEST(Link, fast_memory_holds_what_the_linker_says) {
    const SceneFile scene(simple + "image { size: 8,8 }");
    const Statistics statistics = render(scene.request(find_model("964dX")), {}).statistics;
    EXPECT_EQ(statistics.machine->fast_memory.used_bytes, statistics.program.used_bytes());
    EXPECT_EQ(statistics.machine->fast_memory.limit_bytes, fast_memory_bytes);
}

TEST(Link, only_the_machine_refuses_a_program_that_does_not_fit) {
    const SceneFile scene(simple + "image { size: 8,8 } render { heap: 9000 }");
    EXPECT_NO_THROW((void)render(scene.request(nullptr), {}));
    try {
        (void)render(scene.request(find_model("964dX")), {});
        FAIL() << "a heap of 9000 fits";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::machine_limit);
        EXPECT_NE(std::string(error.what()).find("the heap's order 36000 bytes"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace pxm::host
