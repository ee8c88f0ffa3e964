// Laws of pictures that are scenes: what pxm wrote renders again to the same bytes, and what others
// wrote into a picture reaches nothing.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "host/files/carried_text.hpp"
#include "host/files/deflated.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using namespace std::string_literals;

/// A text of bytes, as a chunk of a PNG; nobody looks at its checksum.
std::string chunk(const std::string& type, const std::string& data) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(data.size() >> static_cast<unsigned>(shift) & 255U);
    return bytes + type + data + "\0\0\0\0"s;
}

const std::string signature = "\x89PNG\r\n\x1a\n";

/// A PNG without pixels that carries what pxm would put around this text.
std::string png_with(const std::string& text) {
    return signature + chunk("IHDR", std::string(13, '\1')) +
           chunk("iTXt", host::png_carried(text)) + chunk("IEND", "");
}

/// One with this content of the chunk.
std::string png_of(const std::string& content) {
    return signature + chunk("iTXt", content) + chunk("IEND", "");
}

std::string json_of(const std::string& files, const std::string& options = "",
                    const std::string& pictures = "") {
    return R"({"pxm":"1","files":[)" + files + R"(],"pictures":[)" + pictures + R"(],"options":[)" +
           options + "]}";
}

const std::string tetra_file =
    R"({"name":"t.pxm","text":"ifs t { newmap scale: .5 newmap scale: .5 translate: 1,0,0 }"})";

class PictureScenes : public testing::Test {
  protected:
    PictureScenes() { folder.write("tetra.pxm", tetra_scene); }

    void render(const std::string& scene, const std::string& out, Arguments options = {},
                const Environment& environment = {}) const {
        options.insert(options.begin(), {"render", scene, "-o", out, "--quiet"});
        EXPECT_EQ(expect_done(folder, options, environment), "");
    }
    void expect_same(const std::string& a, const std::string& b) const {
        EXPECT_TRUE(folder.read(a) == folder.read(b)) << a << " and " << b;
    }
    /// Of everything that reads a scene.
    void expect_refused(const std::string& picture, const std::string& message) const {
        for (const Arguments& command :
             {Arguments{"render", picture, "-o", "new.png", "--quiet"},
              Arguments{"inspect", picture}, Arguments{"inspect", picture, "--scene"},
              Arguments{"points", picture, "-n", "9", "-o", "p.ply", "--quiet"}})
            expect_refusal(folder, command, 3, message);
        const Outcome checked = run(folder, {"check", picture});
        EXPECT_EQ(checked.exit_code, 3);
        EXPECT_EQ(checked.err, message + "\n");
    }
    Folder folder;
};

TEST_F(PictureScenes, a_picture_renders_to_the_same_bytes) {
    for (const std::string ending : {"png", "exr"}) {
        const std::string old = "old." + ending;
        render("tetra.pxm", old,
               {"--size", "40x30", "--levels", "4", "--set", "camera.fov=20", "--zoom", "1.5",
                "--samples", "2", "--shading", "facet", "--crop", "3,4,33,24"});
        Folder other;
        other.write(old, folder.read(old));
        EXPECT_EQ(expect_done(other, {"render", old, "-o", "new.png", "--quiet"}), "");
        render("tetra.pxm", "direct.png",
               {"--size", "40x30", "--levels", "4", "--set", "camera.fov=20", "--zoom", "1.5",
                "--samples", "2", "--shading", "facet", "--crop", "3,4,33,24"});
        EXPECT_TRUE(other.read("new.png") == folder.read("direct.png")) << old;
    }
}

TEST_F(PictureScenes, what_is_given_anew_wins) {
    render("tetra.pxm", "old.png",
           {"--size", "40x30", "--crop", "0,0,8,8", "--levels", "3", "--set", "camera.fov=20",
            "--machine", "964dX", "--zoom", "2", "--detail", "2"});
    render("old.png", "new.png",
           {"--size", "24x18", "--set", "camera.fov=25", "--native", "--zoom", "1"});
    render("tetra.pxm", "direct.png",
           {"--size", "24x18", "--levels", "3", "--set", "camera.fov=20", "--set", "camera.fov=25",
            "--zoom", "1", "--detail", "2"});
    expect_same("new.png", "direct.png");
}

TEST_F(PictureScenes, channels_stay_where_there_is_room_for_them) {
    render("tetra.pxm", "old.exr", {"--size", "16x12", "--aov", "Z,object"});
    render("old.exr", "again.exr");
    EXPECT_NE(folder.read("again.exr").find("object.V"), std::string::npos);
    render("old.exr", "flat.png");
    render("tetra.pxm", "direct.png", {"--size", "16x12"});
    expect_same("flat.png", "direct.png");
}

TEST_F(PictureScenes, includes_come_along) {
    std::filesystem::create_directories(folder.path("a/b"));
    std::filesystem::create_directories(folder.path("shared"));
    folder.write("a/scene.pxm",
                 "include: \"b/one.pxm\"\ninclude: \"../shared/two.pxm\"\nobject o { ifs: one }\n");
    folder.write("a/b/one.pxm",
                 "include: \"../../shared/two.pxm\"\n# \"\\\x01\xe9\n" +
                     std::string("ifs one { newmap scale: s newmap scale: s "
                                 "translate: 1,1,0 newmap scale: s translate: 1,0,1 }"));
    folder.write("shared/two.pxm", "let s = 1/2\n");
    render("a/scene.pxm", "direct.exr", {"--size", "16x12", "--allow", "."});
    Folder other;
    other.write("old.exr", folder.read("direct.exr"));
    EXPECT_EQ(expect_done(other, {"render", "old.exr", "-o", "new.png", "--quiet"}), "");
    render("a/scene.pxm", "direct.png", {"--size", "16x12", "--allow", "."});
    EXPECT_TRUE(other.read("new.png") == folder.read("direct.png"));
    EXPECT_EQ(other.read("new.png").find(folder.path()), std::string::npos);
    expect_done(other, {"inspect", "new.png", "--scene", "-o", "scene.txt"});
    EXPECT_EQ(other.read("scene.txt"),
              folder.read("a/scene.pxm") + "\n# --- b/one.pxm\n" + folder.read("a/b/one.pxm") +
                  "\n# --- ../shared/two.pxm\n" + folder.read("shared/two.pxm"));
}

TEST_F(PictureScenes, so_does_what_was_found_in_a_scene_folder) {
    std::filesystem::create_directories(folder.path("mine/parts"));
    folder.write("mine/parts/one.pxm", "include: \"two.pxm\"\n" + std::string(tetra_scene));
    folder.write("mine/parts/two.pxm", "let s = 1/2\n");
    folder.write("scene.pxm", "include: \"parts/one.pxm\"\n");
    render("scene.pxm", "old.png", {"--size", "16x12"}, {"PXM_SCENE_PATH=" + folder.path("mine")});
    std::filesystem::remove_all(folder.path("mine"));
    render("old.png", "new.png");
    expect_same("old.png", "new.png");
}

TEST_F(PictureScenes, no_string_of_an_exr_is_longer_than_readers_bear) {
    std::string noise;
    for (unsigned i = 0, x = 1; i < 3000; ++i)
        noise += static_cast<char>('a' + (x = x * 1103515245U + 12345U) / 65536U % 26);
    folder.write("long.pxm", tetra_scene + "\n# "s + noise + "\n");
    render("long.pxm", "old.exr", {"--size", "8x8"});
    const std::string bytes = folder.read("old.exr");
    int pieces = 0;
    for (std::size_t at = 8; bytes.at(at) != '\0';) {
        const std::string name = bytes.c_str() + at;
        const std::string type = bytes.c_str() + at + name.size() + 1;
        const std::size_t size = at + name.size() + type.size() + 2;
        std::uint32_t count = 0;
        std::memcpy(&count, bytes.data() + size, sizeof count);
        if (type == "string") {
            EXPECT_LE(count, 255U) << name;
        }
        if (name.starts_with("pxm_source")) ++pieces;
        at = size + sizeof count + count;
    }
    EXPECT_GT(pieces, 5);
    expect_done(folder, {"inspect", "old.exr", "--scene", "-o", "text"});
    EXPECT_EQ(folder.read("text"), folder.read("long.pxm"));
    std::string broken = bytes;
    broken[broken.find("pxm_source_0002") + 16 + 7 + 4] = '*';
    folder.write("broken.exr", broken);
    expect_refused("broken.exr",
                   "broken.exr: the scene that it carries is not written as pxm does it");
    broken = bytes;
    broken.replace(broken.find("pxm_source_0002") + 16, 6, "strinG");
    folder.write("broken.exr", broken);
    expect_refused("broken.exr",
                   "broken.exr: the scene that it carries is no text, or larger than "
                   "1048576 bytes");
}

TEST_F(PictureScenes, no_place_of_a_disk_is_told) {
    render(folder.path("tetra.pxm"), folder.path("old.exr"), {"--size", "16x12"});
    const host::RegularFile file(folder.path("old.exr"));
    EXPECT_EQ(folder.read("old.exr").find(folder.path()), std::string::npos);
    EXPECT_EQ(host::carried_text(file)->find(folder.path()), std::string::npos);
    render("tetra.pxm", "here.exr", {"--size", "16x12"});
    expect_same("old.exr", "here.exr");
    folder.write("far.pxm", "include: \"" + folder.path("tetra.pxm") + "\"\n");
    EXPECT_EQ(
        run(folder, {"render", "far.pxm", "-o", "far.png", "--size", "8x8"}).err.substr(0, 77),
        "the picture carries no scene: it includes a file by its place on a disk\nfar.p");
    expect_refused("far.png",
                   "pxm: far.png: a picture that carries no scene: it includes a file by its place "
                   "on a disk"s.substr(5));
}

TEST_F(PictureScenes, a_scene_is_left_out_on_demand_or_when_it_is_large) {
    render("tetra.pxm", "without.png", {"--size", "16x12", "--no-scene"});
    expect_refused("without.png",
                   "without.png: a picture that carries no scene: pxm has not made it, or did so "
                   "with --no-scene");
    folder.write("large.pxm", tetra_scene + "\n#"s + std::string(host::carried_bytes, 'x') + "\n");
    EXPECT_EQ(
        run(folder, {"render", "large.pxm", "-o", "large.exr", "--size", "8x8"}).err.substr(0, 65),
        "the picture carries no scene: it was larger than 1048576 bytes\nla");
    expect_refused("large.exr",
                   "large.exr: a picture that carries no scene: it was larger than 1048576 bytes");
}

TEST_F(PictureScenes, of_others_have_none) {
    folder.write("plain.png", signature + chunk("IHDR", std::string(13, '\1')) + chunk("IEND", ""));
    expect_refused("plain.png",
                   "plain.png: a picture that carries no scene: pxm has not made it, or did so "
                   "with --no-scene");
    folder.write("cut.png", signature + "\0\0\0"s);
    expect_refused("cut.png",
                   "cut.png: a picture that carries no scene: pxm has not made it, or did so with "
                   "--no-scene");
    folder.write("photo.jpg", "\xff\xd8\xff\xe0 and so on");
    expect_refused(
        "photo.jpg",
        "photo.jpg: a JPEG picture carries no scene: PNG and OpenEXR pictures of pxm do");
    folder.write("broken.exr", "\x76\x2f\x31\x01\2\0\0\0name"s);
    const Outcome broken = run(folder, {"render", "broken.exr", "-o", "new.png"});
    EXPECT_EQ(broken.exit_code, 4);
    EXPECT_EQ(broken.err, "pxm: broken.exr: its OpenEXR header is broken or cut off\n");
}

TEST_F(PictureScenes, what_is_hostile_is_refused_with_one_message) {
    const std::string head = "pxm_source\0\1\0\0\0"s;
    const std::string broken =
        "a.png: the scene that it carries is broken or larger than 1048576 bytes";
    const auto refused = [&](const std::string& png, const std::string& message) {
        folder.write("a.png", png);
        expect_refused("a.png", message);
    };
    refused(png_of(head + "no stream"), broken);
    refused(png_of(head), broken);
    const std::string stream = host::deflated(json_of(tetra_file));
    refused(png_of(head + stream.substr(0, stream.size() - 1)), broken);
    refused(png_of(head + stream + "x"), broken);
    refused(png_of(head + host::deflated(std::string(host::carried_bytes + 1, ' '))), broken);
    refused(png_of(head + host::deflated(std::string(std::size_t{40} << 20U, ' '))), broken);
    refused(png_of(head + std::string(std::size_t{3} << 20U, ' ')),
            "a.png: the scene that it carries is larger than 1048576 bytes");
    refused(signature + "\xff\xff\xff\xffiTXt" + head + stream,
            "a.png: the scene that it carries is larger than 1048576 bytes");
    refused(png_of("pxm_source\0\0\0\0\0{}"s),
            "a.png: the scene that it carries is not compressed as pxm does it");
    const std::string odd = "a.png: the scene that it carries is not written as pxm does it";
    refused(png_with(""), odd);
    refused(png_with(std::string(500'000, '[')), odd);
    refused(png_with("{}"), odd);
    refused(png_with(json_of("")), odd);
    refused(png_with(json_of(tetra_file + "," + tetra_file)), odd);
    for (const std::string name : {"", "/etc/hostname", R"(a\u001b[2Jb)", R"(a\u0000b)", R"(a\nb)"})
        refused(png_with(json_of(R"({"name":")" + name + R"(","text":""})")), odd);
    refused(png_with(json_of(tetra_file, R"(["--size"])")), odd);
    refused(png_with(json_of(tetra_file, R"([1,2])")), odd);
}

TEST_F(PictureScenes, options_of_others_are_checked_as_the_command_line_is) {
    const auto refused = [&](const std::string& option, const std::string& message) {
        folder.write("a.png", png_with(json_of(tetra_file, option)));
        expect_refusal(folder, {"render", "a.png", "-o", "new.png", "--quiet"}, 3,
                       "a.png: the scene that it carries: " + message);
    };
    refused(R"(["--out","/tmp/x"])", "there is no option \"--out\" here");
    refused(R"(["--allow","/"])", "there is no option \"--allow\" here");
    refused(R"(["--stats\u001b","x"])", "there is no option \"--stats?\" here");
    refused(R"(["--heap","0"])", "--heap: found \"0\", expected a whole number from 1 to 65536");
    refused(R"(["--zoom","inf"])", "--zoom: found \"inf\", expected a number above 0");
    refused(R"(["--machine","965"])",
            "--machine: found \"965\", expected a model out of 916 920 932 940 964 964dX (did you "
            "mean '964'?)");
}

TEST_F(PictureScenes, a_carried_scene_reaches_no_file) {
    std::filesystem::create_directories(folder.path("in"));
    folder.write("secret.pxm", tetra_scene);
    folder.write("in/beside.pxm", tetra_scene);
    const auto text_of = [](const std::string& text) {
        return json_of(R"({"name":"t.pxm","text":")" + text + R"("})");
    };
    for (const std::string name : {"/etc/hostname", "../secret.pxm", "beside.pxm"}) {
        folder.write("in/a.png", png_with(text_of(R"(include: \")" + name + R"(\")")));
        expect_refusal(folder, {"render", "in/a.png", "-o", "new.png", "--quiet"}, 3,
                       "in/a.png:1:10: error: cannot include \"" + name +
                           "\": the picture does not carry it\n    include: \"" + name +
                           "\"\n             ^");
    }
    folder.write("in/a.png", png_with(text_of(R"(texture t { file: \"../x.png\" })")));
    expect_refusal_naming(folder, {"render", "in/a.png", "-o", "new.png", "--quiet"}, 3,
                          {"texture \"t\": in/../x.png: lies outside the scene's folder"});
}

TEST_F(PictureScenes, a_texture_has_to_be_there_and_the_same) {
    render("tetra.pxm", "tile.png", {"--size", "8x8"});
    folder.write("floor.pxm", tetra_scene +
                                  "\ntexture t { file: \"tile.png\" size: 1,1 }\n"
                                  "plane { point: 0,-1,0 normal: 0,1,0 texture: t }\n"s);
    render("floor.pxm", "old.png", {"--size", "16x12"});
    render("old.png", "new.png");
    expect_same("old.png", "new.png");
    render("tetra.pxm", "tile.png", {"--size", "9x9"});
    expect_refusal_naming(folder, {"render", "old.png", "-o", "x.png", "--quiet"}, 3,
                          {"old.png:",
                           "texture \"t\": tile.png is not the picture that was there "
                           "when this one was rendered"});
    std::filesystem::remove(folder.path("tile.png"));
    expect_refusal_naming(folder, {"render", "old.png", "-o", "x.png", "--quiet"}, 4,
                          {"old.png:", "texture \"t\": cannot read tile.png"});
}

TEST_F(PictureScenes, frames_say_which_they_are) {
    folder.write("film.pxm", turning_film);
    render("film.pxm", "f%d.png", {"--frames", "0-2", "--size", "16x12"});
    render("f2.png", "again.png");
    expect_same("f2.png", "again.png");
    render("f2.png", "other.png", {"--frames", "1"});
    expect_same("f1.png", "other.png");
    render("film.pxm", "film", {"--frames", "0-2", "--size", "16x12", "--part", "1/1"});
    expect_done(folder, {"join", "film", "-o", "j%d.png"});
    expect_same("f2.png", "j2.png");
    render("film.pxm", "k%d.png", {"--frames", "0-2", "--size", "16x12", "--keep", "kept"});
    expect_same("f1.png", "k1.png");
}

TEST_F(PictureScenes, parts_make_the_picture_of_one_run) {
    for (const std::string ending : {".png", ".exr"}) {
        render("tetra.pxm", "whole" + ending, {"--size", "80x60"});
        for (const std::string part : {"1/2", "2/2"})
            render("tetra.pxm", "parts" + ending, {"--size", "80x60", "--part", part});
        expect_done(folder, {"join", "parts" + ending, "-o", "joined" + ending});
        expect_same("whole" + ending, "joined" + ending);
        render("tetra.pxm", "kept" + ending, {"--size", "80x60", "--keep", "keep" + ending});
        expect_same("whole" + ending, "kept" + ending);
        render("whole" + ending, "again" + ending, {"--keep", "keep" + ending});
        if (ending == ".png") expect_same("whole" + ending, "again" + ending);
    }
}

TEST_F(PictureScenes, settings_hold_for_what_does_not_render) {
    folder.write("s.pxm",
                 "let n = 1/2\nifs t { newmap scale: n newmap scale: n translate: 1,0,0 }\n");
    render("s.pxm", "old.png", {"--size", "8x8", "--set", "n=1/3"});
    const std::string set = run(folder, {"inspect", "s.pxm", "--set", "n=1/3"}).out;
    const std::string held = run(folder, {"inspect", "old.png"}).out;
    EXPECT_EQ(held.substr(held.find('\n')), set.substr(set.find('\n')));
    expect_done(folder, {"points", "old.png", "-n", "9", "-o", "a.ply", "--quiet"});
    expect_done(folder, {"points", "s.pxm", "-n", "9", "-o", "b.ply", "--quiet", "--set", "n=1/3"});
    const auto points_of = [&](const std::string& name) {
        const std::string ply = folder.read(name);
        return ply.substr(ply.find("element"));  // behind the name of the scene
    };
    EXPECT_TRUE(points_of("a.ply") == points_of("b.ply"));
    expect_done(folder, {"check", "old.png"});
    const Outcome printed = run(folder, {"inspect", "old.png", "--scene"});
    EXPECT_EQ(printed.out, folder.read("s.pxm"));
    EXPECT_EQ(printed.err,
              "old.png: s.pxm of pxm " PXM_VERSION ", rendered with --size 8x8 --set n=1/3\n");
    expect_refusal(folder, {"render", "old.png", "--quiet"}, 2,
                   "old.png would be written over the scene");
    expect_refusal(folder, {"inspect", "s.pxm", "--scene"}, 2, "--scene: s.pxm is no picture");
}

}  // namespace
}  // namespace pxm::test
