// Laws of films: frames, pictures of them, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "host/files/image_reader.hpp"
#include "host/render/render.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::test {
namespace {

class Films : public testing::Test {
  protected:
    Films() { folder.write("film.pxm", turning_film); }
    void refuse(const Arguments& more, int code, const std::string& message) const {
        Arguments all{"render", "film.pxm"};
        all.insert(all.end(), more.begin(), more.end());
        expect_refusal(folder, all, code, message);
    }
    Folder folder;
};

TEST_F(Films, a_frame_does_not_depend_on_which_others_are_rendered) {
    expect_done(folder, {"render", "film.pxm", "--frames", "0-4", "-o", "a%02d.exr", "--quiet"});
    expect_done(folder, {"render", "film.pxm", "--frames", "3,1", "-o", "b%d.exr", "--quiet",
                         "--threads", "1"});
    EXPECT_TRUE(folder.read("a03.exr") == folder.read("b3.exr"));
    EXPECT_TRUE(folder.read("a01.exr") == folder.read("b1.exr"));
    EXPECT_FALSE(folder.read("a00.exr") == folder.read("a04.exr"));
    // Without --frames it is the first one.
    expect_done(folder, {"render", "film.pxm", "-o", "c.exr", "--quiet"});
    EXPECT_TRUE(folder.read("a00.exr") == folder.read("c.exr"));
}

TEST_F(Films, a_frame_is_the_picture_of_the_scene_with_its_numbers) {
    expect_done(folder,
                {"render", "film.pxm", "--frames", "2", "-o", "a.png", "--quiet", "--no-scene"});
    std::string still = turning_film;
    still.erase(0, still.find("ifs"));
    still.replace(still.find("90*t"), 4, "45");
    const std::string key = "key(t: 0 -> 1, 1 -> 0.5)";
    still.replace(still.find(key), key.size(), "0.75");
    folder.write("still.pxm", still);
    expect_done(folder, {"render", "still.pxm", "-o", "b.png", "--quiet", "--no-scene"});
    EXPECT_TRUE(folder.read("a.png") == folder.read("b.png"));
}

TEST_F(Films, mistakes_are_told_before_anything_is_rendered) {
    refuse({"--frames", "0-9", "-o", "a%d.png"}, 2,
           "--frames 0-9: the animation has the frames 0 to 4");
    refuse({"--frames", "0-2", "-o", "a.png"}, 2,
           "--frames: 3 frames cannot be one picture, a.png: put the frame's number into its "
           "name, as %04d");
    refuse({"--frames", "0-2"}, 2,
           "--frames: say where the frames go, as -o frames/%04d.png or -o film.mp4");
    refuse({"-o", "-"}, 2,
           "-o -: say what goes to the standard output, --format y4m or --format ppm");
    refuse({"-o", "-", "--format", "avi"}, 2, "--format: found \"avi\", expected y4m or ppm");
    refuse({"--format", "ppm", "-o", "a.png"}, 2,
           "--format: it is of frames on the standard output (-o -)");
    refuse({"--frames", "0-1", "-o", "none/%d.png"}, 4,
           "cannot write none/0.png: its folder does not exist");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"film.pxm"});
    folder.write("still.pxm", "ifs a { newmap scale: 0.5 }");
    expect_refusal(folder, {"render", "still.pxm", "--frames", "0", "-o", "a.png"}, 2,
                   "--frames: the scene has no 'animation'");
}

TEST_F(Films, a_frame_that_does_not_contract_is_named) {
    std::string text = turning_film;
    text.replace(text.find("scale: 0.5 rotate"), 17, "scale: 0.5+t rotate");
    folder.write("film.pxm", text);
    const std::string check = "$PXM check film.pxm";
    const Outcome checked = run_shell(folder, check);
    EXPECT_EQ(checked.exit_code, 3);
    EXPECT_NE(checked.err.find("frame 2: "), std::string::npos) << checked.err;
    const Outcome rendered =
        run_shell(folder, "$PXM render film.pxm --frames 0-4 -o a%d.png --quiet");
    EXPECT_EQ(rendered.exit_code, 3);
    EXPECT_NE(rendered.err.find("frame 2: "), std::string::npos) << rendered.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"a0.png", "a1.png", "film.pxm"}));
}

TEST_F(Films, go_to_a_pipe_frame_after_frame) {
    const Outcome outcome =
        run_shell(folder,
                  "$PXM render film.pxm -o - --format ppm --quiet >all.ppm && $PXM render film.pxm "
                  "--frames 4 -o four.png --quiet && head -c 1165 all.ppm >first.ppm");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string all = folder.read("all.ppm");
    const std::string head = "P6\n24 16\n255\n";
    ASSERT_EQ(all.size(), 5 * (head.size() + 3 * 24 * 16));
    const host::LoadedImage four = host::read_image(folder.path("four.png"));
    const std::string last = all.substr(4 * (head.size() + 3 * 24 * 16) + head.size());
    for (std::size_t i = 0; i < last.size(); ++i)
        ASSERT_EQ(std::lround(four.values[i] * 255), static_cast<unsigned char>(last[i])) << i;
    EXPECT_EQ(
        run_shell(folder, "$PXM render film.pxm -o - --format y4m --quiet >/dev/full").exit_code,
        4);
}

/// The mean of what is seen while the shutter is open, one sample after another.
TEST_F(Films, a_shutter_shows_each_sample_at_its_moment) {
    host::RenderRequest request;
    std::string text = turning_film;
    text.replace(text.find("rate: 10"), 8, "rate: 10 shutter: 1");
    request.scene_path = "film";
    request.scene_text = text;
    request.overrides.samples = 4;
    request.frame = 2;
    const host::Frame blurred = render(request, {}).frame;
    std::vector<std::array<double, 3>> sums(blurred.pixels.size());
    for (long i = 0; i < 4; ++i) {
        host::RenderRequest one = request;
        one.only_sample = i;
        one.frame = 2 + (static_cast<double>(i) + 0.5) / 4 - 0.5;
        const host::Frame moment = render(one, {}).frame;
        for (std::size_t p = 0; p < sums.size(); ++p)
            for (std::size_t k = 0; k < 3; ++k) sums[p][k] += double{moment.pixels[p].color[k]} / 4;
    }
    double moved = 0;
    request.overrides.samples = {};
    const host::Frame still = render(request, {}).frame;
    for (std::size_t p = 0; p < sums.size(); ++p) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(double{blurred.pixels[p].color[k]}, sums[p][k], 1e-6);
            moved = std::max(moved, std::abs(double{still.pixels[p].color[k]} - sums[p][k]));
        }
    }
    EXPECT_GT(moved, 0.05);
}

/// Without a shutter the same samples are taken at once, as they are in a scene without time.
TEST_F(Films, a_closed_shutter_changes_nothing) {
    host::RenderRequest request;
    request.scene_path = "film";
    request.scene_text = turning_film;
    request.overrides.samples = 4;
    request.frame = 2;
    const host::Frame at_once = render(request, {}).frame;
    std::string text = turning_film;
    text.replace(text.find("rate: 10"), 8, "rate: 10 shutter: 1e-9");
    request.scene_text = text;
    const host::Frame open = render(request, {}).frame;
    double most = 0;
    for (std::size_t p = 0; p < open.pixels.size(); ++p)
        for (int k = 0; k < 3; ++k)
            most = std::max(most, std::abs(double{open.pixels[p].color[k]} -
                                           double{at_once.pixels[p].color[k]}));
    EXPECT_LT(most, 0.02);
}

TEST_F(Films, are_written_by_ffmpeg_where_there_is_one) {
    folder.write("film2.pxm", std::string(turning_film) + "render { background: 0,0,0 }");
    const Outcome without = run_program(
        folder, {"render", "film.pxm", "--frames", "0-4", "-o", "a.mp4"}, {"PATH=/nowhere"});
    EXPECT_EQ(without.exit_code, 2);
    EXPECT_NE(without.err.find("apt-get install ffmpeg"), std::string::npos) << without.err;
    if (run_shell(folder, "command -v ffmpeg ffprobe").exit_code != 0)
        GTEST_SKIP() << "ffmpeg is not installed";
    for (const std::string name : {"a.mp4", "a.webm", "a.gif"}) {
        expect_done(folder, {"render", "film2.pxm", "--frames", "0-4", "-o", name, "--quiet"});
        const Outcome probe =
            run_shell(folder,
                      "ffprobe -v error -count_frames -select_streams v -show_entries "
                      "stream=nb_read_frames,width,height,r_frame_rate -of csv=p=0 " +
                          name);
        EXPECT_EQ(probe.out, "24,16,10/1,5\n") << name;
        const std::string first = folder.read(name);
        expect_done(folder, {"render", "film2.pxm", "--frames", "0-4", "-o", name, "--quiet"});
        EXPECT_TRUE(folder.read(name) == first) << name;
    }
}

}  // namespace
}  // namespace pxm::test
