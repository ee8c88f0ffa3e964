// What is larger than a reader takes ends in a message, in bounded time and memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "host/error.hpp"
#include "host/import/aifs/aifs_scene.hpp"
#include "host/import/eisenscript/eisen_scene.hpp"

namespace pxm::host {
namespace {

using testing::HasSubstr;

template <class Import>
std::string refusal(const Import& import) {
    try {
        (void)import();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        return error.what();
    }
    return "it was imported";
}

std::string refused_script(const std::string& text) {
    return refusal([&] { return import_eisenscript({"f.es", text}, 1); });
}

TEST(ImportLimits, a_file_of_millions_of_numbers_is_refused) {
    std::string many;
    for (int i = 0; i < 400'000; ++i) many += "@\n$dim=2\nS=[1,0]*1/2*S\n";
    EXPECT_THAT(refusal([&] {
                    return import_aifs({"f.aifs", many}, {});
                }),
                HasSubstr("more than 2000000 numbers and names in a file"));
}

TEST(ImportLimits, rules_without_end_are_refused) {
    EXPECT_THAT(refused_script("set maxdepth 100000000 R rule R { R }"),
                HasSubstr("rule or shape 'R': more than 65528 maps"));
    EXPECT_THAT(refused_script("R rule R { 10 * { x 1 } R } rule R { 10 * { x 1 } R }"),
                HasSubstr("rule or shape 'R': more than 65528 maps"));
    EXPECT_THAT(refused_script("#define a b b b b b b b b\n#define b a a a a a a a a\na"),
                HasSubstr("is defined by itself, or more than 8 deep"));
}

}  // namespace
}  // namespace pxm::host
