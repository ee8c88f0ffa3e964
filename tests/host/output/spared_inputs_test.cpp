// Laws of what a run reads: nothing is written over it, by whatever name.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "host/output/image.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

constexpr const char* gasket =
    "ifs a { newmap scale: 0.5 newmap scale: 0.5 translate: 1,0,0 newmap scale: 0.5 translate: "
    "0,1,0 }\n";

/// A scene with all that it can be read from: an included file and a texture, in another folder.
class SparedInputs : public testing::Test {
  protected:
    SparedInputs() {
        std::filesystem::create_directory(folder.path("parts"));
        folder.write("parts/a.pxm", gasket);
        folder.write("s.pxm",
                     "include: \"parts/a.pxm\"\nobject o { ifs: a }\n"
                     "texture t { file: \"parts/t.png\" }\n"
                     "plane p { normal: 0,1,0 point: 0,-1,0 texture: t }\n");
        host::write_image(folder.path("parts/t.png"), host::Frame({4, 4}, {0, 0, 4, 4}), {}, {});
        folder.write("costs.json", text_of(source_dir + "/docs/cost-model.json"));
        folder.write("f.ifs", "b { .5 0 0 .5 0 0 .5 .5 0 0 .5 1 0 .5 }");
        link(folder.path("parts/t.png").c_str(), folder.path("hard.png").c_str());
        symlink("parts/a.pxm", folder.path("soft.pxm").c_str());
    }
    void refuse(const Arguments& arguments, const std::string& message) const {
        expect_refusal(folder, arguments, 2, message);
    }
    Folder folder;
};

TEST_F(SparedInputs, a_render_spares_the_scene_what_it_includes_and_its_textures) {
    const auto render = [&](const Arguments& more) {
        Arguments all{"render", "s.pxm", "--size", "8x8", "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    refuse(render({"-o", "parts/t.png"}),
           "parts/t.png would be written over a texture of the scene");
    refuse(render({"-o", "hard.png"}),
           "hard.png would be written over a texture of the scene (parts/t.png)");
    refuse(render({"-o", "a.png", "--stats", "s.pxm"}), "s.pxm would be written over the scene");
    refuse(render({"-o", "a.png", "--stats", "soft.pxm"}),
           "soft.pxm would be written over a file that it includes (parts/a.pxm)");
    refuse(render({"-o", "a.png", "--stats", "parts/../parts/a.pxm"}),
           "parts/../parts/a.pxm would be written over a file that it includes (parts/a.pxm)");
    refuse(render({"-o", "a.png", "--stats", "./a.png"}),
           "./a.png would be written over the picture");
    refuse(render({"-o", "a.png", "--machine", "964", "--cost-model", "costs.json", "--stats",
                   "costs.json"}),
           "costs.json would be written over the cost model");
    expect_done(folder, render({"-o", "a.png", "--stats", "a.json"}));
}

TEST_F(SparedInputs, so_does_the_default_name) {
    folder.write(
        "t.pxm",
        "texture t { file: \"t.png\" }\nplane p { normal: 0,1,0 point: 0,-1,0 texture: t }");
    host::write_image(folder.path("t.png"), host::Frame({4, 4}, {0, 0, 4, 4}), {}, {});
    refuse({"render", "t.pxm"}, "t.png would be written over a texture of the scene");
}

TEST_F(SparedInputs, points_and_inspect_spare_them_too) {
    for (const char* output : {"s.pxm", "parts/a.pxm", "parts/t.png"}) {
        const std::string what = std::string(output) == "s.pxm"         ? "the scene"
                                 : std::string(output) == "parts/a.pxm" ? "a file that it includes"
                                                                        : "a texture of the scene";
        const std::string message = std::string(output) + " would be written over " + what;
        refuse({"points", "s.pxm", "-n", "10", "-o", output}, message);
        refuse({"inspect", "s.pxm", "-o", output}, message);
    }
}

TEST_F(SparedInputs, an_import_spares_what_is_imported_and_any_scene_of_that_name) {
    refuse({"import", "f.ifs", "-o", "f.ifs"}, "f.ifs would be written over what is imported");
    expect_done(folder, {"import", "f.ifs"});
    folder.write("b.pxm", "mine");
    refuse({"import", "f.ifs"}, "b.pxm is there already: --force replaces it, -o writes elsewhere");
    expect_done(folder, {"import", "f.ifs", "--force"});
    EXPECT_NE(folder.read("b.pxm"), "mine");
    folder.write("b.pxm", "mine");
    expect_done(folder, {"import", "f.ifs", "-o", "b.pxm"});
    EXPECT_NE(folder.read("b.pxm"), "mine") << "a place that was named is meant";
}

TEST_F(SparedInputs, a_study_writes_over_no_scene_that_it_measures) {
    std::filesystem::create_directory(folder.path("out"));
    folder.write("out/case-01.pxm", gasket);
    refuse({"study", "stability", "out/case-01.pxm", "-o", "out"},
           "out/case-01.pxm would be written over the scene");
    folder.write("parts/s.png", folder.read("parts/t.png"));
    folder.write("parts/s.pxm", std::string(gasket) +
                                    "object o { ifs: a }\ntexture t { file: \"s.png\" }\n"
                                    "plane p { normal: 0,1,0 point: 0,-1,0 texture: t }\n");
    refuse({"study", "balance", "parts/s.pxm", "-o", "parts"},
           "parts/s.png would be written over a texture of the scene");
}

}  // namespace
}  // namespace pxm::test
