#include "host/study/error_settings.hpp"

#include <fmt/format.h>

#include "host/render/render_options.hpp"

namespace pxm::host {

namespace {

constexpr long no_heap_limit = 65'536;

ErrorSetting changed(const ErrorSetting& from, const std::string& name,
                     const std::function<void(SceneOverrides&)>& change) {
    ErrorSetting setting = from;
    setting.name = from.name.empty() ? name : fmt::format("{} {}", from.name, name);
    change(setting.overrides);
    return setting;
}

}  // namespace

std::vector<ErrorSetting> error_settings() {
    ErrorSetting base;
    base.overrides.numeric = Numeric::dsp32;
    base.overrides.samples = 1;
    base.overrides.intersect = IntersectMethod::heap;
    std::vector<ErrorSetting> list{{"default", base.overrides}};
    const auto axis = [&](const char* option, std::initializer_list<const char*> values,
                          const auto& change) {
        for (const char* value : values)
            list.push_back(changed(base, fmt::format("{} {}", option, value),
                                   [&](SceneOverrides& o) { change(o, std::string(value)); }));
    };
    axis("--numeric", {"float", "double"},
         [](SceneOverrides& o, const std::string& v) { o.numeric = parse_numeric(v); });
    axis("--detail", {"4", "2", "0.5", "0.25"},
         [](SceneOverrides& o, const std::string& v) { o.detail = std::stod(v); });
    axis("--lipschitz", {"product", "determinant", "polar"},
         [](SceneOverrides& o, const std::string& v) { o.lipschitz = parse_lipschitz(v); });
    axis("--volume", {"sphere", "box", "oriented", "hull"},
         [](SceneOverrides& o, const std::string& v) { o.volume = parse_volume(v); });
    list.push_back(changed(base, "--volume sphere --intersect fast", [](SceneOverrides& o) {
        o.volume = VolumeKind::sphere;
        o.intersect = IntersectMethod::fast;
    }));
    list.push_back(changed(base, "--numeric float --intersect wide", [](SceneOverrides& o) {
        o.numeric = Numeric::single;
        o.intersect = IntersectMethod::wide;
    }));
    list.back().native_only = true;
    axis("--heap", {"1", "4", "16", "64"},
         [](SceneOverrides& o, const std::string& v) { o.heap = std::stol(v); });
    axis("--levels", {"3", "6"},
         [](SceneOverrides& o, const std::string& v) { o.levels = std::stol(v); });
    axis("--covers", {"on"},
         [](SceneOverrides& o, const std::string& v) { o.covers = parse_covers(v); });
    axis("--samples", {"2", "4", "16"},
         [](SceneOverrides& o, const std::string& v) { o.samples = std::stol(v); });
    for (const long samples : {4L, 16L}) {
        for (const double detail : {2.0, 0.5}) {
            list.push_back(changed(base, fmt::format("--samples {} --detail {}", samples, detail),
                                   [&](SceneOverrides& o) {
                                       o.samples = samples;
                                       o.detail = detail;
                                   }));
        }
    }
    return list;
}

SceneOverrides color_reference() {
    SceneOverrides overrides = depth_reference();
    overrides.samples = 64;
    return overrides;
}

SceneOverrides depth_reference() {
    SceneOverrides overrides;
    overrides.numeric = Numeric::double_;
    overrides.samples = 1;
    overrides.covers = CoversOff{};
    overrides.detail = 0.1;
    overrides.heap = no_heap_limit;
    return overrides;
}

}  // namespace pxm::host
