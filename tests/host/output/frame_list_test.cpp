// Laws of lists of frames and of the names of their files.
#include "host/output/frame_list.hpp"

#include <gtest/gtest.h>

#include "host/error.hpp"

namespace pxm::host {
namespace {

std::string refusal(const std::string& text) {
    try {
        (void)frames_of(text, 100);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::setting);
        return error.what();
    }
    return "";
}

TEST(Frames, are_ranges_with_steps_and_single_ones_in_the_order_written) {
    EXPECT_EQ(frames_of("0-4", 100), (std::vector<long>{0, 1, 2, 3, 4}));
    EXPECT_EQ(frames_of("0-9:4", 100), (std::vector<long>{0, 4, 8}));
    EXPECT_EQ(frames_of("7,3,20-22", 100), (std::vector<long>{7, 3, 20, 21, 22}));
    EXPECT_EQ(frames_of("007", 100), std::vector<long>{7});
    EXPECT_EQ(frames_of("99-99", 100), std::vector<long>{99});
    EXPECT_EQ(frames_of("1-3:9223372036854775807", 100), std::vector<long>{1});
    EXPECT_EQ(frames_of("1-3:2", 100), (std::vector<long>{1, 3}));
}

TEST(Frames, that_are_none_are_refused) {
    EXPECT_EQ(refusal("x"), "--frames x: expected frames as 0-599, 0-599:10 or 3,7,20-30");
    for (const char* text : {"", ",", "1,", "-1", "1-", "1-2:", "1:2", "1-2-3", "0x1", "1 2"})
        EXPECT_NE(refusal(text), "") << text;
    EXPECT_EQ(refusal("90-100"), "--frames 90-100: the animation has the frames 0 to 99");
    EXPECT_EQ(refusal("5-3"), "--frames 5-3: 5-3 runs backwards");
    EXPECT_EQ(refusal("1-5:0"), "--frames 1-5:0: a step is 1 or more");
    EXPECT_EQ(refusal("1,0-2"), "--frames 1,0-2: 1 is said twice");
}

TEST(FramePath, has_the_number_in_its_place) {
    EXPECT_TRUE(has_frame_number("a/%04d.png"));
    EXPECT_FALSE(has_frame_number("a/%%.png"));
    EXPECT_EQ(path_of_frame("a/%04d.png", 7), "a/0007.png");
    EXPECT_EQ(path_of_frame("a/%d.png", 12345), "a/12345.png");
    EXPECT_EQ(path_of_frame("100%%/%02d%%.png", 123), "100%/123%.png");
    EXPECT_EQ(path_of_frame("plain.png", 3), "plain.png");
}

TEST(FramePath, takes_no_other_sign) {
    for (const char* path : {"%s", "%", "a%", "%4d", "%0x4d", "%-4d", "%04d%n", "%d%d", "%0123d"})
        EXPECT_THROW((void)has_frame_number(path), Error) << path;
}

}  // namespace
}  // namespace pxm::host
