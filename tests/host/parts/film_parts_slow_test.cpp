// Laws of films in parts: joined, they are the frames of one run.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;

class FilmParts : public testing::Test {
  protected:
    FilmParts() {
        folder.write("film.pxm", turning_film);
        for (const char* name : {"one", "joined"}) fs::create_directories(folder.path(name));
    }
    [[nodiscard]] static Arguments command(const Arguments& options) {
        Arguments all{"render", "film.pxm", "--frames", "0-4", "--quiet"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    void one_run(const Arguments& options = {}) const {
        Arguments all = command({"-o", "one/%02d.exr"});
        all.insert(all.end(), options.begin(), options.end());
        expect_done(folder, all);
    }
    void expect_frames(const std::string& from) const {
        expect_done(folder, {"join", from, "-o", "joined/%02d.exr", "--quiet"});
        for (int i = 0; i < 5; ++i) {
            const std::string name = "/0" + std::to_string(i) + ".exr";
            EXPECT_FALSE(folder.read("one" + name).empty());
            EXPECT_TRUE(folder.read("joined" + name) == folder.read("one" + name)) << name;
        }
    }
    Folder folder;
};

TEST_F(FilmParts, are_the_frames_of_one_run_for_any_number_of_parts) {
    for (const Arguments& options : {Arguments{"--aov", "Z,word"}, Arguments{"--machine", "964"}}) {
        one_run(options);
        for (const int n : {1, 2, 7}) {
            fs::remove_all(folder.path("parts"));
            for (int i = n; i >= 1; --i) {
                Arguments part =
                    command({"--part", std::to_string(i) + "/" + std::to_string(n), "-o", "parts"});
                part.insert(part.end(), options.begin(), options.end());
                expect_done(folder, part);
            }
            expect_frames("parts");
        }
    }
}

TEST_F(FilmParts, have_frames_with_an_open_shutter) {
    const Arguments shutter{"--set", "animation.shutter=0.5", "--samples", "4", "--aov", "Z"};
    one_run(shutter);
    Arguments stats = command({"-o", "one/%02d.exr", "--stats", "one/%02d.json"});
    stats.insert(stats.end(), shutter.begin(), shutter.end());
    expect_done(folder, stats);
    Arguments part = command({"--part", "1/1", "-o", "parts"});
    part.insert(part.end(), shutter.begin(), shutter.end());
    expect_done(folder, part);
    expect_frames("parts");
    expect_done(folder, {"join", "parts", "-o", "joined/%02d.exr", "--stats", "joined/%02d.json"});
    for (const char* name : {"/02.json", "/04.json"}) {
        auto one = nlohmann::json::parse(folder.read(std::string("one") + name));
        auto joined = nlohmann::json::parse(folder.read(std::string("joined") + name));
        for (const char* key : {"rays", "hits", "volumes_tested", "alarms"})
            EXPECT_EQ(joined[key], one[key]) << key;
    }
    Arguments alone{"render", "film.pxm", "--frames", "2", "--part", "1/2", "-o", "cut"};
    alone.insert(alone.end(), shutter.begin(), shutter.end());
    fs::create_directories(folder.path("cut"));
    expect_refusal(folder, alone, 2,
                   "a frame with an open shutter is not cut into parts (--set "
                   "animation.shutter=0, or several --frames, each of which is a part)");
}

TEST_F(FilmParts, are_made_once_by_workers_that_claim_them) {
    one_run();
    expect_done(folder, command({"--part", "2/3", "-o", "parts"}));
    Arguments claim{"render", "film.pxm", "--frames", "0-4", "--claim", "parts"};
    const std::string said = expect_done(folder, claim);
    EXPECT_TRUE(said.starts_with("3 of 5 frames made here in ")) << said;
    expect_frames("parts");
}

TEST_F(FilmParts, are_kept_by_a_run_that_goes_on) {
    one_run();
    expect_done(folder, command({"--part", "1/2", "-o", "kept"}));
    for (int run = 0; run < 2; ++run) {
        expect_done(folder, command({"--keep", "kept", "-o", "joined/%02d.exr"}));
        expect_frames("kept");
    }
}

TEST_F(FilmParts, that_lack_a_frame_are_joined_without_it_and_name_it) {
    one_run();
    for (const char* part : {"1/5", "3/5", "4/5"})
        expect_done(folder, command({"--part", part, "-o", "parts"}));
    const Outcome outcome = run(folder, {"join", "parts", "-o", "joined/%02d.exr"});
    EXPECT_EQ(outcome.exit_code, 7);
    EXPECT_EQ(outcome.err, "parts: frames that are missing or lack parts: 1, 4 (2 of 5)\n");
    EXPECT_FALSE(folder.has("joined/01.exr"));
    EXPECT_TRUE(folder.read("joined/02.exr") == folder.read("one/02.exr"));
}

TEST_F(FilmParts, of_two_films_are_refused) {
    expect_done(folder, command({"--part", "1/5", "-o", "parts"}));
    folder.write("film.pxm", std::string(turning_film) + "light { direction: 1,1,1 }\n");
    expect_refusal(folder, command({"--part", "2/5", "-o", "parts"}), 4,
                   "parts/frame-0000: is of another film than this (its scene or its options are "
                   "others)");
    expect_done(folder, command({"--part", "2/5", "-o", "other"}));
    fs::rename(folder.path("other/frame-0001"), folder.path("parts/frame-0001"));
    expect_refusal(folder, {"join", "parts", "-o", "joined/%02d.exr"}, 4,
                   "parts/frame-0001: is of another film than parts/frame-0000 (its scene or its "
                   "options are others)");
}

TEST_F(FilmParts, are_refused_where_they_make_no_sense) {
    expect_refusal(folder, command({"--part", "any/3", "--claim", "parts"}), 2,
                   "--part: of a film each frame is a part (--claim)");
    expect_refusal(folder, command({"--part", "1/3"}), 2, "--part: expected -o DIR, for the part");
    expect_refusal_naming(folder, command({"--keep", "kept", "-o", "a.png", "--part", "1/3"}), 2,
                          {"--keep", "--part"});
    fs::create_directories(folder.path("parts"));
    const Outcome outcome = run(folder, command({"--keep", "parts", "-o", "a.png"}));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              "pxm: --frames: 5 frames cannot be one picture, a.png: put the frame's number into "
              "its name, as %04d\n");
}

TEST_F(FilmParts, are_a_stream_too) {
    const Outcome one = run(folder, command({"-o", "-", "--format", "ppm"}));
    expect_done(folder, command({"--part", "1/1", "-o", "parts"}));
    const Outcome joined = run(folder, {"join", "parts", "-o", "-", "--format", "ppm"});
    EXPECT_EQ(joined.exit_code, 0) << joined.err;
    EXPECT_EQ(one.out.size(), 5U * (13 + 3 * 24 * 16));
    EXPECT_TRUE(joined.out == one.out);
}

}  // namespace
}  // namespace pxm::test
