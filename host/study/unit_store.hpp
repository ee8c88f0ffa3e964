// Results of a study's units, one file each, so that a study can be interrupted and continued.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace pxm::host {

class UnitStore {
  public:
    /// The folder is made when the first result comes.
    explicit UnitStore(std::string folder) : folder_(std::move(folder)) {}

    /// Throws Error(ErrorKind::file) if what has the name of a result is no file, as a pipe that
    /// writing would wait for.
    void require_place(const std::string& name) const;
    /// The result stored under that name, if it was measured with exactly these settings. A file
    /// that cannot be read or understood counts as absent.
    [[nodiscard]] std::optional<nlohmann::ordered_json> find(
        const std::string& name, const nlohmann::ordered_json& settings) const;
    /// Stores a result, whole or not at all. Throws Error(ErrorKind::file).
    void put(const std::string& name, const nlohmann::ordered_json& settings,
             const nlohmann::ordered_json& result);

  private:
    [[nodiscard]] std::string path(const std::string& name) const;
    std::string folder_;
};

}  // namespace pxm::host
