#include "host/study/pareto.hpp"

#include <fmt/format.h>

#include <cmath>

namespace pxm::host {

namespace {

std::string spoken(const Json& point) {
    return fmt::format(
        "`{}` ({:.3g} s on the machine, RMSE {:.4f})", point["settings"]["name"].get<std::string>(),
        point["machine_seconds"].is_null() ? NAN : point["machine_seconds"].get<double>(),
        point["rmse"].get<double>());
}

}  // namespace

void mark_pareto(Json& points, const char* time, const char* mark, const char* by) {
    for (Json& point : points) {
        point[mark] = !point[time].is_null();
        point[by] = nullptr;
        for (const Json& other : points) {
            if (point[time].is_null() || other[time].is_null()) continue;
            const double t = other[time].get<double>() - point[time].get<double>();
            const double e = other["rmse"].get<double>() - point["rmse"].get<double>();
            if (t > 0 || e > 0 || (t == 0 && e == 0)) continue;
            point[mark] = false;
            if (point[by].is_null()) point[by] = other["settings"]["name"];
        }
    }
}

const Json* best_point(const Json& points, const char* least, const char* bounded, double bound) {
    const Json* found = nullptr;
    for (const Json& point : points) {
        if (point[least].is_null() || point[bounded].is_null()) continue;
        if (point[bounded].get<double>() > bound) continue;
        if (!found || point[least].get<double>() < (*found)[least].get<double>()) found = &point;
    }
    return found;
}

std::string advice_for(const Json& points) {
    const Json& base = points[0];
    const Json* most_exact = best_point(points, "rmse", "machine_seconds", INFINITY);
    if (!most_exact) return "for this scene: it does not fit the machine";
    const Json* as_good = best_point(points, "machine_seconds", "rmse", base["rmse"].get<double>());
    const double halfway =
        std::sqrt(base["rmse"].get<double>() * (*most_exact)["rmse"].get<double>());
    const Json* middle = best_point(points, "machine_seconds", "rmse", halfway);
    return fmt::format(
        "for this scene: as good as the default, fastest: {}; most of the way to the best: {}; the "
        "best: {}",
        spoken(as_good ? *as_good : base), spoken(middle ? *middle : *most_exact),
        spoken(*most_exact));
}

}  // namespace pxm::host
