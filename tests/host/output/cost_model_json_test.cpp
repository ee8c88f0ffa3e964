// Laws of host/output/cost_model_json: what a file may say, and how it is refused. Texts are
// compared whole.
#include "host/output/cost_model_json.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/folder.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

using Json = nlohmann::json;

/// The default model as a file would say it.
Json default_file() {
    Json json;
    for (std::size_t i = 0; i < operation_count; ++i) {
        const OperationCost cost = default_cost_table().operations[i];
        json["operations"][std::string(operation_names[i])] = {{"tight", cost.tight},
                                                               {"plain", cost.plain}};
    }
    return json;
}

std::string refusal(const Json& json) {
    return test::error_of([&] { (void)parse_cost_model(json.dump(), "c.json"); });
}

TEST(CostModel, the_committed_file_is_the_default) {
    const CostModel read = read_cost_model(test::source_dir + "/docs/cost-model.json");
    EXPECT_EQ(read.table.plain_share, default_cost_table().plain_share);
    EXPECT_EQ(read.table.compiled_code_factor, default_cost_table().compiled_code_factor);
    for (std::size_t i = 0; i < operation_count; ++i) {
        EXPECT_EQ(read.table.operations[i].tight, default_cost_table().operations[i].tight);
        EXPECT_EQ(read.table.operations[i].plain, default_cost_table().operations[i].plain);
    }
}

TEST(CostModel, the_documented_table_is_the_default) {
    std::ifstream file(test::source_dir + "/docs/machine.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const CostEntry& entry : default_cost_entries()) {
        const std::string sources =
            entry.source.empty() ? "" : " [" + std::string(entry.source) + "]";
        std::ostringstream row;
        row << "| `" << operation_names[static_cast<std::size_t>(entry.operation)] << "` | "
            << entry.cost.tight << " | " << entry.cost.plain << " | "
            << static_cast<char>(entry.certainty) << sources << " | " << entry.sentence << " |\n";
        EXPECT_NE(text.find(row.str()), std::string::npos) << row.str();
    }
}

TEST(CostModel, what_the_file_says_is_taken) {
    Json json = default_file();
    json["plain_share"] = 0.25;
    json["compiled_code_factor"] = 3;
    json["operations"]["divide"] = {{"tight", 100}, {"plain", 200}};
    const CostModel read = parse_cost_model(json.dump(), "c.json");
    EXPECT_EQ(read.name, "c.json");
    EXPECT_EQ(read.table.cycles_of(Operation::divide), 375);
}

TEST(CostModel, every_entry_that_is_missing_is_named) {
    for (const std::string_view name : operation_names) {
        Json json = default_file();
        json["operations"].erase(std::string(name));
        EXPECT_EQ(refusal(json), "2: --cost-model c.json: \"operations\" has no entry \"" +
                                     std::string(name) + "\"");
    }
}

TEST(CostModel, a_wrong_entry_is_named) {
    const auto with = [](const char* name, const Json& value) {
        Json json = default_file();
        json["operations"][name] = value;
        return refusal(json);
    };
    EXPECT_EQ(with("divide", {{"tight", 1}}),
              "2: --cost-model c.json: operation \"divide\" has no entry \"plain\"");
    EXPECT_EQ(with("divide", {{"tight", -1}, {"plain", 1}}),
              "2: --cost-model c.json: \"tight\" of operation \"divide\" is negative: -1");
    EXPECT_EQ(with("divide", {{"tight", 1}, {"plain", "2"}}),
              "2: --cost-model c.json: \"plain\" of operation \"divide\" is not a number");
    EXPECT_EQ(with("divide", {{"tight", 1e9}, {"plain", 1}}),
              "2: --cost-model c.json: \"tight\" of operation \"divide\" is over 1000000: "
              "1000000000");
    EXPECT_EQ(with("divide", {{"tight", 1}, {"plain", 1}, {"loose", 1}}),
              "2: --cost-model c.json: unknown entry \"loose\" in operation \"divide\"");
    EXPECT_EQ(with("divide", 3), "2: --cost-model c.json: operation \"divide\" is not an object");
    EXPECT_EQ(with("teleport", {{"tight", 1}, {"plain", 1}}),
              "2: --cost-model c.json: unknown entry \"teleport\" in \"operations\"");
    Json json = default_file();
    json["plain_share"] = 1.5;
    EXPECT_EQ(refusal(json), "2: --cost-model c.json: \"plain_share\" is over 1: 1.5");
    json = default_file();
    json["speed"] = 1;
    EXPECT_EQ(refusal(json), "2: --cost-model c.json: unknown entry \"speed\" in the file");
    EXPECT_EQ(refusal(Json::object()),
              "2: --cost-model c.json: the file has no entry \"operations\"");
    EXPECT_EQ(refusal(Json::array()), "2: --cost-model c.json: the file is not an object");
}

TEST(CostModel, what_is_no_json_is_refused_as_a_wrong_file) {
    for (const char* text : {"", "{", "cost: 3", "{\"plain_share\": 1e999}", "\xff\xfe"}) {
        const std::string error = test::error_of([&] { (void)parse_cost_model(text, "c.json"); });
        EXPECT_TRUE(error.starts_with("2: --cost-model c.json: not JSON: ")) << text << error;
    }
}

TEST(CostModel, a_file_that_is_not_there_or_none_is_a_file_error_at_once) {
    const test::Folder folder;
    const std::string pipe = folder.path("pipe.json");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
    const auto refused = [](const std::string& path) {
        return test::error_of([&] { (void)read_cost_model(path); });
    };
    EXPECT_EQ(refused("/nowhere/c.json"), "4: /nowhere/c.json: no such file");
    EXPECT_EQ(refused("/"), "4: /: is a directory");
    EXPECT_EQ(refused(pipe), "4: " + pipe + ": not a regular file");
    folder.write("long.json", std::string(1'000'001, ' '));
    EXPECT_EQ(refused(folder.path("long.json")),
              "4: " + folder.path("long.json") + ": larger than 1 MB");
}

}  // namespace
}  // namespace pxm::host
