#include "host/study/study_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "host/output/image.hpp"
#include "host/scene/print/print.hpp"
#include "host/study/page/plot.hpp"
#include "host/text/digest.hpp"

namespace pxm::host {

namespace {

float linear_from_byte(int byte) {
    const double s = byte / 255.0;
    return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

}  // namespace

std::string stem_of(const std::string& scene) {
    return std::filesystem::path(scene).stem().string();
}

std::vector<std::string> file_names_of(const std::vector<std::string>& scenes) {
    std::vector<std::string> names;
    for (const std::string& scene : scenes) {
        std::string name = stem_of(scene);
        for (int n = 2; std::ranges::find(names, name) != names.end(); ++n)
            name = fmt::format("{}-{}", stem_of(scene), n);
        names.push_back(name);
    }
    return names;
}

std::string fingerprint_of(const std::string& scene, const Settings& settings,
                           const std::vector<std::string>& allowed) {
    Diagnostics diagnostics;
    const Scene parsed = parse_scene(scene, settings, diagnostics, allowed);
    diagnostics.throw_if_errors(parsed.files);
    Digest digest;
    for (const char c : print_scene(parsed)) digest.add(static_cast<unsigned char>(c));
    return fmt::format("{:016x}", digest.value());
}

RenderResult render_unit(const RenderRequest& request, const UnitControl& control) {
    RenderResult result = render(request, control.run);
    if (result.stopped) throw StudyStopped{};
    return result;
}

void write_value_picture(const std::string& path, const Frame& shape,
                         const std::vector<double>& values, double low, double high) {
    Frame picture(shape.size, shape.crop);
    const double span = high > low ? high - low : 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const ScaleColor c = scale_color((values[i] - low) / span);
        picture.pixels[i].color[0] = linear_from_byte(c.red);
        picture.pixels[i].color[1] = linear_from_byte(c.green);
        picture.pixels[i].color[2] = linear_from_byte(c.blue);
    }
    write_image(path, picture, {}, {});
}

CoarseGrid coarse_grid(const Frame& shape, const std::vector<double>& values, long most) {
    CoarseGrid grid{std::min(most, shape.columns()), std::min(most, shape.rows()), {}};
    std::vector<double> counts(static_cast<std::size_t>(grid.columns * grid.rows));
    grid.values.resize(counts.size());
    for (long y = 0; y < shape.rows(); ++y) {
        for (long x = 0; x < shape.columns(); ++x) {
            const auto cell = static_cast<std::size_t>(y * grid.rows / shape.rows() * grid.columns +
                                                       x * grid.columns / shape.columns());
            grid.values[cell] += values[static_cast<std::size_t>(y * shape.columns() + x)];
            ++counts[cell];
        }
    }
    for (std::size_t i = 0; i < counts.size(); ++i) grid.values[i] /= counts[i];
    return grid;
}

Json json_of(const CoarseGrid& grid) {
    Json values = Json::array();
    for (const double value : grid.values) values.push_back(std::round(value));
    return {{"columns", grid.columns}, {"rows", grid.rows}, {"values", values}};
}

CoarseGrid grid_of(const Json& json) {
    return {json["columns"].get<long>(), json["rows"].get<long>(),
            json["values"].get<std::vector<double>>()};
}

}  // namespace pxm::host
