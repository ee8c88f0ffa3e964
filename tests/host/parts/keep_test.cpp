// Laws of --keep: a run that ended in any way goes on, and ends with the bytes of one that did not.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Keep : public testing::Test {
  protected:
    Keep() { folder.write("tetra.pxm", tetra_scene); }

    [[nodiscard]] Arguments command(const std::string& out, const Arguments& options = {}) const {
        Arguments all{"render", "tetra.pxm", "-o", out, "--size", "70x53"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    /// What a run that was killed leaves: some of the units.
    void half_done(const Arguments& options = {}) const {
        Arguments all = command("kept", options);
        all.insert(all.end(), {"--part", "1/2"});
        expect_done(folder, all);
    }
    Folder folder;
};

TEST_F(Keep, changes_nothing_of_picture_and_counts) {
    expect_done(folder, command("one.exr", {"--aov", "Z,word", "--stats", "one.json"}));
    for (int run = 0; run < 2; ++run) {  // the second finds everything
        expect_done(folder, command("kept.exr", {"--aov", "Z,word", "--stats", "kept.json",
                                                 "--keep", "kept", "--threads", "2"}));
        EXPECT_TRUE(folder.read("kept.exr") == folder.read("one.exr"));
        Json one = Json::parse(folder.read("one.json")),
             kept = Json::parse(folder.read("kept.json"));
        EXPECT_GT(kept["seconds"]["total"], 0);
        for (const char* key : {"seconds", "threads", "threads_because"})
            one.erase(key), kept.erase(key);
        EXPECT_EQ(kept, one);
    }
}

TEST_F(Keep, goes_on_from_what_is_there) {
    for (const Arguments& engine : {Arguments{}, Arguments{"--machine", "964dX"}}) {
        fs::remove_all(folder.path("kept"));
        expect_done(folder, command("one.exr", engine));
        half_done(engine);
        Arguments options = engine;
        options.insert(options.end(), {"--keep", "kept"});
        const std::string said = expect_done(folder, command("kept.exr", options));
        EXPECT_NE(said.find(" units are there already\n"), std::string::npos) << said;
        EXPECT_TRUE(folder.read("kept.exr") == folder.read("one.exr"));
    }
}

TEST_F(Keep, refuses_what_is_of_another_picture_and_says_why) {
    half_done();
    expect_refusal(folder, command("kept.exr", {"--keep", "kept", "--detail", "2"}), 4,
                   "kept/part-1-of-2.pxmpart: is a part of another picture (its detail: as the "
                   "scene has it, not 2)");
}

TEST_F(Keep, renders_again_what_was_damaged) {
    expect_done(folder, command("one.exr"));
    half_done();
    const std::string name = "kept/part-1-of-2.pxmpart";
    std::string text = folder.read(name);
    const std::size_t heading_end = text.find('\n', text.find('\n') + 1);
    text[heading_end + 300] = static_cast<char>(text[heading_end + 300] ^ 1);  // in a unit
    folder.write(name, text);
    const std::string said = expect_done(folder, command("kept.exr", {"--keep", "kept"}));
    EXPECT_TRUE(
        said.starts_with("warning: " + name + ": is damaged: what it holds is rendered again\n"))
        << said;
    EXPECT_TRUE(folder.read("kept.exr") == folder.read("one.exr"));
}

TEST_F(Keep, is_no_way_to_make_a_part) {
    expect_refusal_naming(folder, command("d", {"--keep", "kept", "--part", "1/2"}), 2,
                          {"--keep", "--part"});
}

}  // namespace
}  // namespace pxm::test
