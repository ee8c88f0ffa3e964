// Laws of `pxm --version --json`: what the program says of its own build.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using Json = nlohmann::json;

Json version() {
    const Folder folder;
    const Outcome told = run(folder, {"--version", "--json"});
    EXPECT_EQ(told.exit_code, 0);
    EXPECT_EQ(told.err, "");
    return Json::parse(told.out);
}

TEST(Version, as_json_names_compiler_flags_libraries_registers_and_what_was_left_out) {
    const Json json = version();
    const std::string version_of_this = __VERSION__;  // of clang with its name in front
    EXPECT_THAT(version_of_this,
                testing::HasSubstr(json.at("compiler").at("version").get<std::string>()));
    EXPECT_THAT(json.at("flags").get<std::string>(), testing::HasSubstr("-ffp-contract=off"));
    EXPECT_FALSE(json.at("build_type").get<std::string>().empty());
    EXPECT_FALSE(json.at("target").get<std::string>().empty());
    EXPECT_EQ(json.at("registers").at("used"), json.at("registers").at("supported").at(0));
    EXPECT_TRUE(json.at("left_out").is_array());
    for (const Json& left : json.at("left_out")) {
        EXPECT_FALSE(left.at("what").get<std::string>().empty());
        EXPECT_FALSE(left.at("because").get<std::string>().empty());
    }
}

TEST(Version, as_json_has_the_libraries_of_the_plain_one_with_versions) {
    const Folder folder;
    const std::string plain = run(folder, {"--version"}).out;
    const std::string start = "required: ";
    std::string list = plain.substr(plain.find(start) + start.size());
    list = list.substr(0, list.find('\n')) + ", ";
    std::set<std::string> expected, named;
    for (std::size_t from = 0; from < list.size(); from = list.find(", ", from) + 2)
        expected.insert(list.substr(from, list.find(", ", from) - from));
    const Json json = version();
    for (const Json& library : json.at("libraries")) {
        const std::string name = library.at("name");
        named.insert(name);
        if (name != "pthreads" && name != "Random123") {
            EXPECT_TRUE(library.at("version").is_string()) << name;
        }
    }
    EXPECT_EQ(named, expected);
    for (const Json& left : json.at("left_out"))
        EXPECT_THAT(plain, testing::HasSubstr("\nleft out: " + left.at("what").get<std::string>() +
                                              ": " + left.at("because").get<std::string>()));
    EXPECT_EQ(plain.substr(0, plain.find('\n')), "pxm " + json.at("pxm").get<std::string>());
}

}  // namespace
}  // namespace pxm::test
