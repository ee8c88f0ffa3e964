// Laws of `pxm study`: what it writes, and that it goes on where it stopped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::IsSupersetOf;

class Study : public testing::Test {
  protected:
    Study() {
        folder.write("tetra.pxm", tetra_scene);
        folder.write("dust.pxm",
                     "ifs dust { newmap scale: 0.3 newmap scale: 0.3 translate: 1,0,0 }");
    }
    std::string balance(const std::string& out, Arguments more = {}) const {
        more.insert(more.begin(), {"study", "balance", "tetra.pxm", "dust.pxm", "-o", out, "--size",
                                   "40x24", "--threads", "1"});
        return expect_done(folder, more);
    }
    [[nodiscard]] Json data(const std::string& out) const {
        return Json::parse(folder.read(out + "/data.json"));
    }
    [[nodiscard]] static Json counted(Json data) {
        for (Json& scene : data["scenes"]) scene.erase("host");
        return data;
    }
    Folder folder;
};

TEST_F(Study, balance_writes_what_the_documents_say) {
    balance("out");
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder.path("out")))
        names.push_back(entry.path().filename().string());
    EXPECT_THAT(names,
                testing::UnorderedElementsAre("report.html", "data.json", "scenes.csv", "nodes.csv",
                                              "curves.csv", "tetra.png", "tetra-cycles.png",
                                              "dust.png", "dust-cycles.png", "units"));
    const Json json = data("out");
    EXPECT_EQ(json["study"], "balance");
    EXPECT_EQ(json["schema_version"], 1);
    ASSERT_EQ(json["scenes"].size(), 2U);
    const Json& scene = json["scenes"][0];
    EXPECT_EQ(scene["scene"], "tetra.pxm");
    EXPECT_EQ(scene["model"], "964dX");
    EXPECT_EQ(scene["nodes"].size(), 64U);
    EXPECT_EQ(scene["efficiency"], scene["partitions"]["interleaved"]["efficiency"]);
    EXPECT_EQ(scene["curve"].size(), 6U * 17);
    EXPECT_EQ(scene["models"].size(), 6U);
}

TEST_F(Study, a_second_run_measures_nothing_and_ends_in_the_same_data) {
    balance("out");
    const std::string before = folder.read("out/data.json");
    EXPECT_THAT(balance("out"), HasSubstr("2 of 2 measurements are there already"));
    EXPECT_EQ(folder.read("out/data.json"), before);
}

TEST_F(Study, what_is_missing_is_measured_and_counts_the_same) {
    balance("whole");
    balance("part");
    fs::remove(folder.path("part/units/dust.json"));
    fs::remove(folder.path("part/data.json"));
    EXPECT_THAT(balance("part"), HasSubstr("1 of 2 measurements"));
    EXPECT_EQ(counted(data("part")), counted(data("whole")));
}

TEST_F(Study, other_options_another_scene_or_a_broken_file_are_measured_again) {
    balance("out");
    folder.write("dust.pxm", "ifs dust { newmap scale: 0.2 newmap scale: 0.2 translate: 1,0,0 }");
    folder.write("out/units/tetra.json", "{\"settings\":");
    EXPECT_THAT(balance("out"), testing::Not(HasSubstr("already")));
    EXPECT_THAT(balance("out", {"--numeric", "float"}), testing::Not(HasSubstr("already")));
    EXPECT_EQ(data("out")["scenes"][0]["numeric"], "float");
    EXPECT_THAT(balance("out", {"--numeric", "float", "--fresh"}),
                testing::Not(HasSubstr("already")));
}

TEST_F(Study, a_result_that_is_a_pipe_is_refused_before_anything_is_measured) {
    fs::create_directories(folder.path("out/units"));
    ASSERT_EQ(mkfifo(folder.path("out/units/dust.json").c_str(), 0666), 0);
    for (const char* more : {"--quiet", "--fresh"}) {
        const Outcome outcome = run(folder, {"study", "balance", "tetra.pxm", "dust.pxm", "-o",
                                             "out", "--size", "40x24", "--threads", "1", more});
        EXPECT_EQ(outcome.exit_code, 4);
        EXPECT_EQ(outcome.err, "pxm: out/units/dust.json: not a regular file\n");
        EXPECT_FALSE(folder.has("out/units/tetra.json"));
    }
}

TEST_F(Study, counted_figures_do_not_depend_on_threads) {
    balance("one");
    expect_done(folder, {"study", "balance", "tetra.pxm", "dust.pxm", "-o", "two", "--size",
                         "40x24", "--threads", "2", "--quiet"});
    Json one = counted(data("one"));
    Json two = counted(data("two"));
    one.erase("options");
    two.erase("options");
    EXPECT_EQ(one, two);
}

TEST_F(Study, what_is_wrong_is_said_before_anything_is_measured) {
    expect_refusal(folder, {"study", "speed", "tetra.pxm", "-o", "out"}, 2,
                   "study: found \"speed\", expected one of balance, error, stability, shading");
    expect_refusal(folder, {"study", "balance", "-o", "out"}, 2,
                   "study balance: give it at least one scene");
    expect_refusal_naming(folder, {"study", "balance", "gone.pxm", "-o", "out"}, 4, {"gone.pxm"});
    expect_refusal(folder, {"study", "balance", "tetra.pxm", "-o", "dust.pxm"}, 4,
                   "cannot make the folder dust.pxm: it is a file");
    expect_refusal_naming(folder, {"study", "balance", "tetra.pxm", "-o", "out", "--size", "0x2"},
                          2, {"--size"});
}

}  // namespace
}  // namespace pxm::test
