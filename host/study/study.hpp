// `pxm study KIND SCENE... -o DIR`: an experiment as a plan of units. A unit's result is stored
// when it is there, so that an interrupted study goes on where it stopped and ends in the same
// data. docs/studies-format.md is what the files hold.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/render/render.hpp"

namespace pxm::host {

using Json = nlohmann::ordered_json;

enum class StudyKind { balance, error, stability, shading };

/// The word of the command line.
[[nodiscard]] const char* name_of(StudyKind kind);

/// What the command line says.
struct StudyRequest {
    StudyKind kind = StudyKind::balance;
    std::vector<std::string> scenes;
    Settings settings;                 // of each of them
    std::vector<std::string> allowed;  // folders beside each scene's own (--allow)
    std::string folder;
    std::optional<PixelSize> size;   // of every render; absent: the scene's or the study's own
    const Model* machine = nullptr;  // absent: 964dX where a machine is needed
    std::optional<Numeric> numeric;
    int threads = 1;
    int repeats = 3;                       // of what host time is measured of
    long samples = 10'000;                 // shading
    std::optional<double> budget_seconds;  // error
    std::optional<double> target_error;    // error
    bool fresh = false;                    // forget what is stored
    bool quiet = false;
};

/// What a unit may use while it measures.
struct UnitControl {
    RunControl run;  // stop flag and progress of one render
    std::string folder;
};

/// Thrown by a unit whose render was given up.
struct StudyStopped {};

/// One measurement: `settings` are all that its result depends on.
struct Unit {
    std::string name;  // of its file
    Json settings;
    std::function<Json(const UnitControl&)> measure;
};

struct TextFile {
    std::string name;
    std::string text;
};

/// An experiment: its units, and what is made of their results, in the units' order.
struct StudyPlan {
    std::vector<Unit> units;
    std::function<Json(const std::vector<Json>&)> assemble;  // data.json without its heading
    std::function<std::vector<TextFile>(const Json&)> tables;
    std::function<std::string(const Json&, const std::string& folder)> page;
};

[[nodiscard]] StudyPlan plan_balance(const StudyRequest& request);
[[nodiscard]] StudyPlan plan_shading(const StudyRequest& request);
[[nodiscard]] StudyPlan plan_stability(const StudyRequest& request);
[[nodiscard]] StudyPlan plan_error(const StudyRequest& request);

/// Runs a study and writes its files. Throws Error as a render does.
[[nodiscard]] bool run_study(const StudyRequest& request);

}  // namespace pxm::host
