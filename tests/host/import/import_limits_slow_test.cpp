// What is larger than a reader takes ends in a message, in bounded time and memory.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

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

TEST(ImportLimits, a_block_of_millions_of_numbers_is_refused) {
    std::string many = "@\n$dim=2\nS=[1";
    for (int i = 0; i < 2'000'001; ++i) many += ",1";
    EXPECT_THAT(refusal([&] {
                    return import_aifs({"f.aifs", many + "]*S\n"}, {});
                }),
                HasSubstr("more than 2000000 numbers and names in a file"));
}

/// Of more than 4 MB and 2,000,000 numbers: blocks with a parent, a hidden one, and one that is
/// called.
std::string many_blocks() {
    std::string text =
        "# made by the test\n@base\n$dim=1\n$a=h\nhalf=1/2\n@f\n$a=h\n$dim=1\nA=x*A\n";
    for (int i = 0; i < 250'000; ++i)
        text += fmt::format("@b{}:base\n$n=number {}\nS=(1|[{}])*half*(1|2*1/2)*S\n", i, i, i);
    return text;
}

TEST(ImportLimits, a_long_file_is_listed_and_read_block_by_block) {
    const std::string text = many_blocks();
    ASSERT_GT(text.size(), std::size_t{4} << 20U);
    try {
        (void)import_aifs({"f.aifs", text}, {});
        ADD_FAILURE() << "one of many was chosen";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::setting);
        EXPECT_THAT(error.what(), HasSubstr("f.aifs has 250000 entries; choose one with --entry "
                                            "NAME:\n  number 0\n  number 1\n"));
    }
    for (const std::string entry : {"number 249999", "#250000", "number 249999:S"}) {
        const Imported imported = import_aifs({"f.aifs", text}, entry);
        ASSERT_EQ(imported.scene.ifs.size(), 1U);
        EXPECT_EQ(imported.name, "number_249999");
        const std::vector<MapBlock>& maps = imported.scene.ifs[0].maps;
        ASSERT_EQ(maps.size(), 4U);
        double farthest = 0;
        for (const MapBlock& map : maps)
            farthest = std::max(farthest, compose(map.commands).translation.x);
        EXPECT_EQ(farthest, 249'999) << entry;
    }
    const auto refused_end = [&](const std::string& end, const std::string& entry) {
        return refusal([&] { return import_aifs({"f.aifs", text + end}, entry); });
    };
    // What is wrong has the line that it stands in, and spoils no other block.
    const std::string broken = "@last\n$dim=1\nS=(\n";
    EXPECT_THAT(refused_end(broken, "last"),
                HasSubstr("f.aifs:750013:1: error: expected a number"));
    EXPECT_EQ(import_aifs({"f.aifs", text + broken}, "#3").scene.ifs[0].maps.size(), 4U);
    EXPECT_THAT(refused_end("@@import x\n", "#3"),
                HasSubstr("f.aifs:750010:1: error: '@@import x'"));
    EXPECT_THAT(refusal([&] {
                    return import_aifs({"f.aifs", "var x;\n" + text}, "#3");
                }),
                HasSubstr("f.aifs:1:1: error: expected '@', the begin of a block"));
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
