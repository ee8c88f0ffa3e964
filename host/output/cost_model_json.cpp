#include "host/output/cost_model_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/error.hpp"
#include "host/files/regular_file.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t longest_file_bytes = 1'000'000;
constexpr double largest_cost = 1e6;  // cycles; keeps every sum exact enough to be a whole number

/// Reads values out of one file's objects and refuses what is wrong by its place in the file.
class Reader {
  public:
    explicit Reader(const std::string& path) : path_(path) {}

    [[noreturn]] void refuse(const std::string& what) const {
        throw Error(ErrorKind::setting, fmt::format("--cost-model {}: {}", path_, what));
    }

    [[nodiscard]] const nlohmann::json& object(const nlohmann::json& json,
                                               const std::string& place) const {
        if (!json.is_object()) refuse(fmt::format("{} is not an object", place));
        return json;
    }

    /// Every key of the object is one of `known`.
    void only(const nlohmann::json& json, const std::string& place, const auto& known) const {
        for (const auto& [key, value] : json.items()) {
            if (std::ranges::find(known, key) == std::ranges::end(known)) {
                refuse(fmt::format("unknown entry \"{}\" in {}", key, place));
            }
        }
    }

    [[nodiscard]] const nlohmann::json& entry(const nlohmann::json& json, const std::string& key,
                                              const std::string& place) const {
        if (!json.contains(key)) refuse(fmt::format("{} has no entry \"{}\"", place, key));
        return json.at(key);
    }

    /// A number from 0 to `most`.
    [[nodiscard]] double number(const nlohmann::json& json, const std::string& place,
                                double most) const {
        if (!json.is_number()) refuse(fmt::format("{} is not a number", place));
        const double value = json.get<double>();
        if (!(value >= 0)) refuse(fmt::format("{} is negative: {}", place, value));
        if (value > most) refuse(fmt::format("{} is over {}: {}", place, most, value));
        return value;
    }

  private:
    const std::string& path_;
};

constexpr std::array<std::string_view, 3> top_keys{"plain_share", "compiled_code_factor",
                                                   "operations"};
constexpr std::array<std::string_view, 2> cost_keys{"tight", "plain"};

OperationCost read_cost(const Reader& reader, const nlohmann::json& operations,
                        std::string_view name) {
    const std::string key(name);
    const std::string place = fmt::format("operation \"{}\"", key);
    const nlohmann::json& cost =
        reader.object(reader.entry(operations, key, "\"operations\""), place);
    reader.only(cost, place, cost_keys);
    const auto column = [&](const char* which) {
        return reader.number(reader.entry(cost, which, place),
                             fmt::format("\"{}\" of {}", which, place), largest_cost);
    };
    return {column("tight"), column("plain")};
}

std::string text_of(const std::string& path) {
    const RegularFile file(path);
    if (file.bytes() > longest_file_bytes)
        throw Error(ErrorKind::file, fmt::format("{}: larger than 1 MB", path));
    return file.read(0, static_cast<std::size_t>(file.bytes()));
}

}  // namespace

CostModel parse_cost_model(const std::string& text, const std::string& path) {
    const Reader reader(path);
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& error) {
        reader.refuse(fmt::format("not JSON: {}", error.what()));
    }
    const std::string whole = "the file";
    reader.only(reader.object(json, whole), whole, top_keys);
    CostModel model{path, default_cost_table()};
    const auto optional = [&](const char* key, double most, double& target) {
        if (json.contains(key)) target = reader.number(json[key], fmt::format("\"{}\"", key), most);
    };
    optional("plain_share", 1, model.table.plain_share);
    optional("compiled_code_factor", 1000, model.table.compiled_code_factor);
    const nlohmann::json& operations =
        reader.object(reader.entry(json, "operations", whole), "\"operations\"");
    reader.only(operations, "\"operations\"", operation_names);
    for (std::size_t i = 0; i < operation_count; ++i) {
        model.table.operations[i] = read_cost(reader, operations, operation_names[i]);
    }
    return model;
}

CostModel read_cost_model(const std::string& path) { return parse_cost_model(text_of(path), path); }

}  // namespace pxm::host
