// The two exhibitions of Ch. 20 on the simulated machine: their node programs fit (Ch. 19), and the
// statistics say what was left out.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "host/render/render.hpp"
#include "pxm/node.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

using namespace host;

Statistics statistics_of(const std::string& name, const CoversChoice& covers) {
    RenderRequest request;
    request.allowed = {source_dir + "/scenes"};
    request.scene_path = source_dir + "/scenes/exhibition/" + name + ".pxm";
    request.machine = find_model("964dX");
    request.overrides.size = host::PixelSize{24, 16};
    request.overrides.samples = 2;
    request.overrides.covers = covers;
    request.threads = 2;
    return render(request, {}).statistics;
}

std::set<std::string> left_out(const Statistics& statistics) {
    std::set<std::string> names;
    for (const ProgramModule& module : statistics.program.left_out) {
        EXPECT_NE(module.because, "") << module.name;
        names.insert(module.name);
    }
    return names;
}

TEST(Exhibition, programs_fit_and_leave_out_what_they_do_not_need) {
    for (const char* name : {"five_solids", "forest"}) {
        for (const CoversChoice& covers :
             {CoversChoice{CoversOff{}}, CoversChoice{Covers{}}, CoversChoice{AreaCovers{}}}) {
            const Statistics statistics = statistics_of(name, covers);
            EXPECT_LE(statistics.program.used_bytes(), fast_memory_bytes) << name;
            EXPECT_EQ(statistics.machine->fast_memory.used_bytes, statistics.program.used_bytes());
            EXPECT_GT(statistics.rays.hits, 50U) << name;
            const auto names = left_out(statistics);
            EXPECT_TRUE(names.contains("point_light") && names.contains("flatness")) << name;
            EXPECT_EQ(names.contains("covers"), !std::holds_alternative<Covers>(covers));
            EXPECT_EQ(names.contains("beam"), !std::holds_alternative<AreaCovers>(covers));
            // The solids' floor has boards, an inlay and a mirror's share, the forest's soil none.
            const bool forest = name == std::string("forest");
            for (const char* module : {"texture_wood", "texture_inclusion", "mirror"}) {
                EXPECT_EQ(names.contains(module), forest) << module;
            }
            EXPECT_EQ(names.contains("polar"), !forest);
        }
    }
}

}  // namespace
}  // namespace pxm::test
