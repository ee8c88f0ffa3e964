// Laws of parts: joined, they are what one run writes, to the last byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "tests/support/command.hpp"
#include "tests/support/example_scenes.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Arguments with(Arguments first, const Arguments& rest) {
    first.insert(first.end(), rest.begin(), rest.end());
    return first;
}

/// Statistics without what depends on how the picture was made.
Json counts_in(const Folder& folder, const std::string& name) {
    Json json = Json::parse(folder.read(name));
    for (const char* key : {"seconds", "threads", "threads_because"}) json.erase(key);
    return json;
}

class Join : public testing::Test {
  protected:
    Join() { folder.write("tetra.pxm", tetra_scene); }

    void one_run(const Arguments& options = {}) const {
        expect_done(folder, with({"render", "tetra.pxm", "-o", "one.exr", "--stats", "one.json",
                                  "--size", "70x53"},
                                 options));
    }
    void part(long i, long n, const Arguments& options = {},
              const std::string& to = "parts") const {
        expect_done(folder,
                    with({"render", "tetra.pxm", "--part",
                          std::to_string(i) + "/" + std::to_string(n), "-o", to, "--size", "70x53"},
                         options));
    }
    void all_parts(long n, const Arguments& options = {}) const {
        std::vector<long> order;
        for (long i = 1; i <= n; ++i) order.push_back(i);
        std::ranges::shuffle(order, std::mt19937(static_cast<unsigned>(n)));
        for (const long i : order) part(i, n, options);
    }
    Outcome joined(const std::string& from = "parts", const std::string& to = "joined.exr") const {
        return run(folder, {"join", from, "-o", to, "--stats", "joined.json"});
    }
    void expect_one_run() const {
        const Outcome outcome = joined();
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_TRUE(folder.read("joined.exr") == folder.read("one.exr"));
        EXPECT_EQ(counts_in(folder, "joined.json"), counts_in(folder, "one.json"));
    }
    Folder folder;
};

const Arguments all_channels{"--aov", "Z,node,volumes,level,heap,alpha,object,word,N"};

TEST_F(Join, gives_the_bytes_and_counts_of_one_run_for_any_number_of_parts) {
    one_run(all_channels);
    for (const long n : {1, 2, 7, 64, 1000}) {
        fs::remove_all(folder.path("parts"));
        all_parts(n, all_channels);
        expect_one_run();
    }
}

TEST_F(Join, does_so_for_each_engine) {
    for (const Arguments& options :
         std::vector<Arguments>{{"--intersect", "heap"},
                                {"--intersect", "heap", "--numeric", "double", "--samples", "3"},
                                {"--covers", "area"},
                                {"--covers", "on", "--crop", "9,5,66,47"},
                                {"--zoom", "1000", "--heap", "5"},
                                {"--machine", "964dX", "--aov", "cycles,node,Z"},
                                {"--machine", "916", "--crop", "9,5,66,47", "--heap", "5"},
                                {"--machine", "964", "--numeric", "float"}}) {
        fs::remove_all(folder.path("parts"));
        one_run(options);
        all_parts(5, options);
        expect_one_run();
        if (HasFailure()) FAIL() << options.front() << " " << options.back();
    }
}

TEST_F(Join, takes_any_parts_that_together_are_the_picture) {
    one_run();
    for (const long i : {1, 2, 4}) part(i, 4);
    for (const long i : {1, 2, 3}) part(i, 3);
    expect_one_run();
}

TEST_F(Join, writes_every_format_as_one_run_does) {
    all_parts(3);
    for (const char* name : {"a.png", "a.tif", "a.jpg", "a.hdr"}) {
        expect_done(folder, {"render", "tetra.pxm", "-o", name, "--size", "70x53"});
        const std::string one = folder.read(name);
        EXPECT_EQ(joined("parts", name).exit_code, 0);
        EXPECT_TRUE(folder.read(name) == one) << name;
    }
}

TEST_F(Join, does_not_ask_how_a_part_was_made) {
    one_run();
    part(1, 2, {"--threads", "1"});
    fs::create_directories(folder.path("elsewhere"));
    folder.write("elsewhere/another_name.pxm", "# moved\n" + std::string(tetra_scene));
    expect_done(folder, {"render", "elsewhere/another_name.pxm", "--part", "2/2", "-o", "parts",
                         "--size", "070x053", "--threads", "3"});
    expect_one_run();
}

TEST_F(Join, a_part_made_twice_is_the_same_file) {
    part(2, 3, {"--threads", "1"}, "a");
    part(2, 3, {"--threads", "3"}, "b");
    const std::string name = "part-2-of-3.pxmpart";
    EXPECT_FALSE(folder.read("a/" + name).empty());
    EXPECT_TRUE(folder.read("a/" + name) == folder.read("b/" + name));
}

TEST_F(Join, of_some_parts_is_a_picture_that_says_what_is_missing) {
    one_run();
    all_parts(7);
    fs::remove(folder.path("parts/part-3-of-7.pxmpart"));
    fs::remove(folder.path("parts/part-5-of-7.pxmpart"));
    const Outcome outcome = joined("parts", "partial.exr");
    EXPECT_EQ(outcome.exit_code, 7);
    EXPECT_EQ(outcome.err.substr(0, outcome.err.find(';')),
              "parts: 2 of 7 parts are missing: 3, 5");
    const Outcome compared = run(folder, {"compare", "partial.exr", "one.exr"});
    EXPECT_EQ(compared.exit_code, 6) << "a whole file, not the whole picture";
    part(3, 7);
    part(5, 7);
    expect_one_run();
}

TEST_F(Join, more_parts_than_there_is_to_do_are_empty) {
    expect_done(folder,
                {"render", "tetra.pxm", "--size", "9x5", "-o", "one.exr", "--stats", "one.json"});
    for (int i = 1; i <= 5; ++i) {
        expect_done(folder, {"render", "tetra.pxm", "--size", "9x5", "-o", "parts", "--part",
                             std::to_string(i) + "/5"});
    }
    expect_one_run();
    fs::remove(folder.path("parts/part-5-of-5.pxmpart"));
    EXPECT_EQ(joined().exit_code, 0) << "nothing is missing";
}

TEST_F(Join, parts_of_two_pictures_are_refused_with_what_differs) {
    part(1, 2);
    part(2, 2, {"--samples", "4"}, "other");
    fs::copy(folder.path("other/part-2-of-2.pxmpart"), folder.path("parts"));
    expect_refusal(folder, {"join", "parts", "-o", "x.exr"}, 4,
                   "parts/part-2-of-2.pxmpart: is a part of another picture than "
                   "parts/part-1-of-2.pxmpart (its samples: 4, not as the scene has it)");
    folder.write("tetra.pxm", std::string(tetra_scene) + "light { direction: 1,1,1 }\n");
    expect_refusal(folder, {"render", "tetra.pxm", "--part", "2/2", "-o", "parts"}, 4,
                   "parts/part-1-of-2.pxmpart: is a part of another picture (its scene is another "
                   "one)");
}

TEST_F(Join, a_part_that_is_there_is_not_made_again) {
    part(1, 2);
    const std::string said = expect_done(
        folder, {"render", "tetra.pxm", "--part", "1/2", "-o", "parts", "--size", "70x53"});
    EXPECT_EQ(said, "part-1-of-2.pxmpart is there already\n");
}

TEST_F(Join, a_damaged_part_is_named_and_made_again) {
    one_run();
    all_parts(2);
    const std::string name = "parts/part-1-of-2.pxmpart";
    const std::string whole = folder.read(name);
    folder.write(name, whole.substr(0, whole.size() / 2));
    expect_refusal(folder, {"join", "parts", "-o", "x.exr"}, 4, name + ": was cut short");
    folder.write(name, "");
    expect_refusal(folder, {"join", "parts", "-o", "x.exr"}, 4, name + ": is no part of a picture");
    for (const std::size_t at : {whole.size() / 3, whole.size() - 100, std::size_t{30}}) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 4);
        folder.write(name, changed);
        expect_refusal(folder, {"join", "parts", "-o", "x.exr"}, 4, name + ": is damaged");
    }
    folder.write(name, whole.substr(0, whole.size() - 1));
    const std::string said = expect_done(
        folder, {"render", "tetra.pxm", "--part", "1/2", "-o", "parts", "--size", "70x53"});
    EXPECT_TRUE(said.starts_with("warning: " + name + ": was cut short: it is made again\n"))
        << said;
    expect_one_run();
}

TEST_F(Join, what_cannot_be_is_refused_before_anything_is_rendered) {
    expect_refusal(folder, {"render", "tetra.pxm", "--part", "0/4", "-o", "parts"}, 2,
                   "--part: found \"0/4\", expected I/N with 1 <= I <= N <= 1000000, or auto");
    expect_refusal(folder, {"render", "tetra.pxm", "--part", "1/4"}, 2,
                   "--part: expected -o DIR, for the part");
    expect_refusal(folder, {"render", "tetra.pxm", "--part", "1/4", "-o", "d", "--stats", "s.json"},
                   2,
                   "--stats: a part has none of its own with --part; pxm join --stats s.json "
                   "writes those of the picture");
    folder.write("file", "");
    expect_refusal_naming(folder, {"render", "tetra.pxm", "--part", "1/4", "-o", "file"}, 4,
                          {"file"});
    expect_refusal(folder, {"join", "nowhere", "-o", "x.exr"}, 4,
                   "nowhere: No such file or directory");
    fs::create_directories(folder.path("empty"));
    expect_refusal(folder, {"join", "empty", "-o", "x.exr"}, 4,
                   "empty: holds no parts (*.pxmpart)");
    part(1, 1, {"--aov", "Z"});
    expect_refusal(folder, {"join", "parts", "-o", "x.png"}, 2,
                   "--aov needs an .exr output, not x.png");
    expect_refusal_naming(folder, {"join", "parts", "-o", "parts/part-1-of-1.pxmpart"}, 2,
                          {"unknown image extension"});
}

TEST_F(Join, without_its_picture_leaves_an_older_one) {
    part(1, 2);
    folder.write("joined.exr", "old");
    const std::string name = "parts/part-1-of-2.pxmpart";
    std::string changed = folder.read(name);
    const std::size_t heading_end = changed.find('\n', changed.find('\n') + 1);
    changed[heading_end + 300] = static_cast<char>(changed[heading_end + 300] ^ 1);
    folder.write(name, changed);
    EXPECT_EQ(joined().exit_code, 4);
    EXPECT_EQ(folder.read("joined.exr"), "old");
    for (const std::string& left : folder.names())
        EXPECT_EQ(left.find(".pxm-part-"), std::string::npos);
}

}  // namespace
}  // namespace pxm::test
