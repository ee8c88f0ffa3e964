// Laws of `pxm check`, and of `--set` on every command that reads a scene.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

class CheckCommand : public testing::Test {
  protected:
    CheckCommand() {
        folder.write("good.pxm", tetra_scene);
        folder.write("syntax.pxm", "ifs a { newmap scael: 0.5 }\n");
        folder.write("wide.pxm", "let k = 1.5\nifs a {\n    newmap scale: k\n}\n");
        folder.write("warned.pxm",
                     "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 }\n"
                     "object a { ifs: a sphere: (9,9,9) 0.1 }\n");
        folder.write("bare.pxm",
                     "ifs a { newmap scale: 0.5 }\n"
                     "texture t { file: \"none.png\" }\n"
                     "plane { normal: 0,1,0 texture: t }\n");
    }
    /// Expects that exit code and these parts of what is told, and nothing on stdout or in files.
    void told(const Arguments& options, int exit_code,
              const std::vector<std::string>& parts) const {
        Arguments words{"check"};
        words.insert(words.end(), options.begin(), options.end());
        const auto before = folder.contents();
        const Outcome outcome = run(folder, words);
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        if (parts.empty()) {
            EXPECT_EQ(outcome.err, "");
        }
        for (const std::string& part : parts)
            EXPECT_NE(outcome.err.find(part), std::string::npos) << part << " in\n" << outcome.err;
        EXPECT_EQ(folder.contents(), before);
    }
    Folder folder;
};

TEST_F(CheckCommand, a_scene_without_mistakes_is_code_0_and_nothing_is_said) {
    told({"good.pxm"}, 0, {});
    told({"good.pxm", "good.pxm", "--werror"}, 0, {});
}

TEST_F(CheckCommand, mistakes_of_syntax_of_meaning_and_of_compiling_are_code_3) {
    told({"syntax.pxm"}, 3,
         {"syntax.pxm:1:16: error: unknown directive 'scael' in 'ifs' (did you mean 'scale'?)\n",
          "\n                   ^\n"});
    told({"wide.pxm"}, 3, {"wide.pxm:2:1: error: ", "contract"});
    told({"bare.pxm"}, 3, {"bare.pxm:2:19: texture \"t\": ", "none.png"});
}

TEST_F(CheckCommand, a_warning_is_code_0_and_with_werror_3) {
    told({"warned.pxm"}, 0, {"warned.pxm:2:19: warning: "});
    told({"--werror", "warned.pxm"}, 3, {"warned.pxm:2:19: warning: "});
}

TEST_F(CheckCommand, all_scenes_are_checked_and_the_worst_counts) {
    told({"good.pxm", "syntax.pxm", "warned.pxm"}, 3, {"syntax.pxm:1:16", "warned.pxm:2:19"});
    told({"nowhere.pxm", "syntax.pxm"}, 4, {"nowhere.pxm: no such file\n", "syntax.pxm:1:16"});
    told({"."}, 4, {".: is a directory"});
}

TEST_F(CheckCommand, what_is_set_is_checked_as_well) {
    told({"wide.pxm", "--set", "k=0.5"}, 0, {});
    expect_refusal(folder, {"check", "good.pxm", "--set", "camera.fov=x"}, 2,
                   "--set camera.fov=x: expected a number, found 'x', which no 'let' has named");
    expect_refusal(folder, {"check", "good.pxm", "--set", "k=1"}, 2,
                   "--set k=1: the scene has no 'let'");
    expect_refusal(folder, {"check", "good.pxm", "--set", "k"}, 2,
                   "--set: found \"k\", expected NAME=VALUE or BLOCK.DIRECTIVE=VALUE");
}

TEST_F(CheckCommand, formatted_is_printed_what_has_no_mistake_of_syntax) {
    folder.write("x.pxm", "ifs  a{newmap scale : 0.5 # half\n}\n");
    const Outcome outcome = run(folder, {"check", "--format", "x.pxm"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "ifs a {\n    newmap scale: 0.5    # half\n}\n");
    const Outcome wide = run(folder, {"check", "--format", "wide.pxm"});
    EXPECT_EQ(wide.exit_code, 3);
    EXPECT_EQ(wide.out, folder.read("wide.pxm"));
    told({"--format", "syntax.pxm"}, 3, {"syntax.pxm:1:16"});
    told({"--format", "nowhere.pxm"}, 4, {"nowhere.pxm: no such file"});
    expect_refusal(folder, {"check", "--format", "x.pxm", "good.pxm"}, 2,
                   "--format: it prints one scene, give it no more");
}

TEST_F(CheckCommand, every_command_that_reads_a_scene_takes_set) {
    const std::string refused =
        "--set camera.fov=0: camera: 'fov' is 0: it must lie between 0 and 180 degrees";
    for (const Arguments& words : {Arguments{"render", "good.pxm", "-o", "a.png"},
                                   {"render", "good.pxm", "--pixel", "0,0"},
                                   {"inspect", "good.pxm"},
                                   {"inspect", "good.pxm", "--point", "1"},
                                   {"points", "good.pxm", "-n", "5", "-o", "a.ply"},
                                   {"check", "good.pxm"}}) {
        Arguments all = words;
        all.insert(all.begin() + 1, {"--set", "camera.fov=0"});
        expect_refusal(folder, all, 2, refused);
    }
    for (const char* kind : {"balance", "error", "stability"})
        expect_refusal(folder, {"study", kind, "--set", "camera.fov=0", "good.pxm", "-o", "."}, 2,
                       refused);
    expect_refusal(folder, {"study", "shading", "--set", "a=1", "-o", "."}, 2,
                   "--set: there is no scene to set anything of");
}

TEST_F(CheckCommand, a_picture_is_of_what_is_set) {
    folder.write("narrow.pxm",
                 std::string(tetra_scene) + "camera { eye: 0,0,-4 look: 0,0,0 fov: 20 }\n");
    folder.write("open.pxm",
                 std::string(tetra_scene) + "camera { eye: 0,0,-4 look: 0,0,0 fov: 50 }\n");
    const auto descent = [&](const Arguments& more) {
        Arguments words{"render", "--size", "64x48", "--pixel", "30,20"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = run(folder, words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    };
    EXPECT_EQ(descent({"narrow.pxm", "--set", "camera.fov=50"}), descent({"open.pxm"}));
    EXPECT_NE(descent({"narrow.pxm"}), descent({"open.pxm"}));
    // An option of its own wins.
    EXPECT_EQ(descent({"open.pxm", "--set", "image.size=8,8"}), descent({"open.pxm"}));
}

TEST_F(CheckCommand, the_examples_of_set_in_the_documents_are_right) {
    std::istringstream lines(
        text_of(std::filesystem::path(source_dir) / "docs" / "scene-language.md"));
    int examples = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("pxm check scenes/")) continue;
        ++examples;
        std::istringstream words(line.substr(4));
        Arguments arguments;
        for (std::string word; words >> word;)
            arguments.push_back(word.starts_with("scenes") ? source_dir + "/" + word : word);
        told({arguments.begin() + 1, arguments.end()}, 0, {});
    }
    EXPECT_EQ(examples, 3);
}

TEST_F(CheckCommand, what_is_set_is_recorded_in_the_picture) {
    expect_done(folder, {"render", "good.pxm", "--size", "8x8", "--set", "camera.fov=30", "--set",
                         "object.tetra.sphere=(0,0,0) 2", "--quiet", "-o", "a.exr"});
    EXPECT_NE(folder.read("a.exr").find("--size 8x8 --set camera.fov=30 --set "
                                        "'object.tetra.sphere=(0,0,0) 2'"),
              std::string::npos);
}

}  // namespace
}  // namespace pxm::test
