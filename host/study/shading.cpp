// The shading study (Sec. 17.5): hierarchical shading of a plane. 10,000 points of the planar side
// of the extruded gasket (App. B.1) are looked at, and the dot product of the total normal with the
// plane's own normal is plotted for the three weightings. The thesis gives neither the view nor the
// volume: both are varied here.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/files/safe_file.hpp"
#include "host/study/page/shading_page.hpp"
#include "host/study/study_scene.hpp"

namespace pxm::host {

namespace {

/// The side y = 0 of the prism 0 <= x, 0 <= y, x + y <= 1, -1 <= z <= 1, which four of the six maps
/// tile: a rectangle. Its outer normal is (0,-1,0), its middle (0.5,0,0).
constexpr const char* gasket =
    "ifs esg {\n"
    "    newmap scale: 0.5 translate: 0,0,-0.5\n"
    "    newmap scale: 0.5 translate: 0.5,0,-0.5\n"
    "    newmap scale: 0.5 translate: 0,0.5,-0.5\n"
    "    newmap scale: 0.5 translate: 0,0,0.5\n"
    "    newmap scale: 0.5 translate: 0.5,0,0.5\n"
    "    newmap scale: 0.5 translate: 0,0.5,0.5\n"
    "}\n";

struct ViewChoice {
    const char* name;
    double tilt_degrees;  // between the view and the normal
    double fov_degrees;   // 0: parallel rays
};
constexpr ViewChoice views[] = {{"parallel rays along the normal", 0, 0},
                                {"parallel rays at 30 degrees", 30, 0},
                                {"perspective of 20 degrees, 10 degrees off the normal", 10, 20},
                                {"perspective of 40 degrees along the normal", 0, 40}};

struct VolumeChoice {
    const char* name;
    const char* directive;  // of the object
    const char* kind;       // of the render block
};
constexpr VolumeChoice volumes[] = {
    {"smallest spheres", "auto", "sphere"},
    {"spheres of 1.5 times that radius", "sphere: (0.5,0.5,0) 1.8372", "auto"},
    {"spheres of 2 times that radius", "sphere: (0.5,0.5,0) 2.4495", "auto"},
    {"spheres of 3 times that radius", "sphere: (0.5,0.5,0) 3.6743", "auto"},
    {"boxes", "auto", "box"}};

constexpr double details[] = {1, 0.25};  // cells are terminal at so many pixels

struct Weighting {
    const char* name;
    Shading shading;
    double thesis_sd;
};
constexpr Weighting weightings[] = {{"constant", Shading::constant, 0.036},
                                    {"low-pass", Shading::low_pass, 0.084},
                                    {"high-pass", Shading::high_pass, 0.031}};

constexpr double window = 0.55;  // side of what is seen of the plane, perpendicular to the view
constexpr int bins = 200;        // of the dot product from 0 to 1

std::string scene_text(const ViewChoice& view, const VolumeChoice& volume, double detail,
                       long side) {
    // Turned about the view, so that rows of rays are no rows of cells.
    const double tilt = view.tilt_degrees * std::numbers::pi / 180;
    const double far =
        view.fov_degrees > 0 ? window / 2 / std::tan(view.fov_degrees * std::numbers::pi / 360) : 5;
    const std::string lens = view.fov_degrees > 0 ? fmt::format("fov: {}", view.fov_degrees)
                                                  : fmt::format("orthographic: {}", window);
    return fmt::format(
        "# The planar side of the extruded gasket: {}, {}, detail {}.\n{}"
        "object side {{ ifs: esg {} }}\n"
        "camera {{ eye: {:.9f},{:.9f},{:.9f} look: 0.5,0,0 up: 0.31,0,1 {} }}\n"
        "image {{ size: {},{} }}\n"
        "render {{ volume: {} detail: {} numeric: double }}\n",
        view.name, volume.name, detail, gasket, volume.directive, 0.5, -far * std::cos(tilt),
        -far * std::sin(tilt), lens, side, side, volume.kind, detail);
}

/// What 10,000 total normals say.
struct Spread {
    std::vector<long> histogram = std::vector<long>(bins, 0);
    double squares = 0;  // of 1 - dot
    double sum = 0;      // of dot
    long samples = 0;

    void add(double dot) {
        const int bin = std::clamp(static_cast<int>(dot * bins), 0, bins - 1);
        ++histogram[static_cast<std::size_t>(bin)];
        squares += (1 - dot) * (1 - dot);
        sum += dot;
        ++samples;
    }
    /// The upper end of the fullest bin.
    [[nodiscard]] double mode() const {
        const auto fullest = std::ranges::max_element(histogram) - histogram.begin();
        return static_cast<double>(fullest + 1) / bins;
    }
    /// About one, the value a plane has.
    [[nodiscard]] double deviation() const {
        return std::sqrt(squares / static_cast<double>(std::max(1L, samples)));
    }
};

Spread spread_of(const Frame& frame) {
    Spread spread;
    for (const PixelRecord& pixel : frame.pixels) {
        if (pixel.level < 0) continue;
        spread.add(-static_cast<double>(pixel.normal[1]));
    }
    return spread;
}

Json spread_json(const Spread& spread, double thesis_sd) {
    return {{"mode", spread.mode()},
            {"sd", spread.deviation()},
            {"mean", spread.sum / static_cast<double>(std::max(1L, spread.samples))},
            {"thesis_sd", thesis_sd},
            {"samples", spread.samples},
            {"histogram", spread.histogram}};
}

Json measure_setup(const std::string& name, const std::string& text, const Json& setup,
                   const UnitControl& control, int threads) {
    const std::string path = control.folder + "/" + name + ".pxm";
    write_text_safely(path, text);
    Json result = setup;
    result["scene"] = name + ".pxm";
    result["weights"] = Json::object();
    for (const Weighting& weighting : weightings) {
        RenderRequest request;
        request.scene_path = path;
        request.threads = threads;
        request.overrides.shading = weighting.shading;
        const RenderResult rendered = render_unit(request, control);
        result["weights"][weighting.name] =
            spread_json(spread_of(rendered.frame), weighting.thesis_sd);
    }
    return result;
}

/// How far a set-up's deviations are from the thesis', as the mean of |log| ratios.
double distance_to_thesis(const Json& setup) {
    double sum = 0;
    for (const auto& [name, weight] : setup["weights"].items()) {
        const double sd = weight["sd"].get<double>();
        if (sd <= 0) return 1e9;
        sum += std::abs(std::log(sd / weight["thesis_sd"].get<double>()));
    }
    return sum / 3;
}

Json assemble(const std::vector<Json>& results, long samples) {
    Json data = {{"samples", samples}, {"weights", Json::object()}, {"setup", Json::object()}};
    Json setups = Json::array();
    std::size_t nearest = 0;
    for (const Json& result : results) {
        setups.push_back(result);
        setups.back()["distance_to_thesis"] = distance_to_thesis(result);
        if (distance_to_thesis(result) < distance_to_thesis(results[nearest]))
            nearest = setups.size() - 1;
        if (result["view"] == views[0].name && result["volume"] == volumes[0].name &&
            result["detail"] == 1.0) {
            data["weights"] = result["weights"];
            data["setup"] = {{"view", result["view"]}, {"volume", result["volume"]}, {"detail", 1}};
        }
    }
    data["nearest"] = nearest;
    data["setups"] = setups;
    return data;
}

}  // namespace

StudyPlan plan_shading(const StudyRequest& request) {
    if (!request.scenes.empty()) {
        throw Error(ErrorKind::setting,
                    "study shading: it makes its own scenes (the extruded gasket), give it none");
    }
    const long side = std::lround(std::sqrt(static_cast<double>(request.samples)));
    StudyPlan plan;
    for (const ViewChoice& view : views) {
        for (const VolumeChoice& volume : volumes) {
            for (const double detail : details) {
                const std::string name = fmt::format("setup-{:02}", plan.units.size() + 1);
                const std::string text = scene_text(view, volume, detail, side);
                const Json setup = {
                    {"view", view.name}, {"volume", volume.name}, {"detail", detail}};
                plan.units.push_back({name,
                                      {{"study", "shading"}, {"pxm", PXM_VERSION}, {"scene", text}},
                                      [=, threads = request.threads](const UnitControl& control) {
                                          return measure_setup(name, text, setup, control, threads);
                                      }});
            }
        }
    }
    plan.assemble = [side](const std::vector<Json>& results) {
        return assemble(results, side * side);
    };
    plan.tables = shading_tables;
    plan.page = shading_page;
    return plan;
}

}  // namespace pxm::host
