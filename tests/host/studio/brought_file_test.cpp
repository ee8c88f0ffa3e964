// The laws of host/studio/brought_file.hpp and jobs.hpp: a file's bytes become a scene's text and
// leave nothing behind; what is under way can be looked at.
#include "host/studio/brought_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "host/error.hpp"
#include "host/studio/jobs.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* two_systems =
    "a {\n .5 0 0 .5 0 0 .5\n .5 0 0 .5 .5 0 .5\n}\nb {\n .4 0 0 .4 0 0 .5\n .4 0 0 .4 .5 0 "
    ".5\n}\n";

std::string refusal_of(const BroughtFile& brought) {
    const std::atomic<bool> stop = false;
    try {
        (void)scene_from(brought, stop);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(BroughtFile, base64_is_read_and_what_is_none_is_not) {
    EXPECT_EQ(bytes_of_base64(""), "");
    EXPECT_EQ(bytes_of_base64("TQ=="), "M");
    EXPECT_EQ(bytes_of_base64("TWE="), "Ma");
    EXPECT_EQ(bytes_of_base64("TWFu"), "Man");
    EXPECT_EQ(bytes_of_base64("//8A"), std::string("\xFF\xFF\0", 3));
    for (const char* none : {"T W", "TQ===", "<>", "TQ=x=A"})
        EXPECT_EQ(bytes_of_base64(none), std::nullopt) << none;
}

TEST(BroughtFile, a_system_becomes_a_scene) {
    const std::atomic<bool> stop = false;
    const MadeScene made = scene_from({"two.ifs", two_systems, "b", 4}, stop);
    EXPECT_EQ(made.name, "b.pxm");
    EXPECT_THAT(made.text, HasSubstr("ifs b"));
}

TEST(BroughtFile, several_systems_are_named_and_no_place_of_this_computer_is) {
    const std::string refusal = refusal_of({"../../two.ifs", two_systems, {}, 4});
    EXPECT_THAT(refusal, HasSubstr("\n  a\n  b"));
    EXPECT_THAT(refusal, Not(HasSubstr("pxm-studio-")));
    EXPECT_THAT(refusal_of({".pxm", "x", {}, 4}), Not(HasSubstr("pxm-studio-")));
    EXPECT_THAT(refusal_of({"a.png", "no picture", {}, 4}), HasSubstr("no format"));
}

TEST(Jobs, a_job_is_there_until_it_is_let_go) {
    Jobs jobs;
    EXPECT_EQ(jobs.find("a"), nullptr);
    auto job = jobs.begin("a", 4);
    job->share = 0.5;
    job->watch.tell(3, 700);
    job->watch.tell(9, 1);
    ASSERT_NE(jobs.find("a"), nullptr);
    EXPECT_EQ(jobs.find("a")->watch.nodes()[3].cycles, 700U);
    EXPECT_EQ(jobs.find("a")->watch.nodes()[3].pixels, 1U);
    EXPECT_EQ(jobs.find("b"), nullptr);
    const auto newer = jobs.begin("a");
    EXPECT_EQ(jobs.find("a"), newer);
    job.reset();
    EXPECT_EQ(jobs.find("a"), newer);
}

}  // namespace
}  // namespace pxm::host
