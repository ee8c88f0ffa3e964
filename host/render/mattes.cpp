#include "host/render/mattes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <variant>

#include "host/compile/compile.hpp"
#include "host/error.hpp"
#include "host/render/exposure.hpp"
#include "host/scene/default_objects.hpp"

namespace pxm::host {

namespace {

/// A scene whose objects are told apart by PixelRecord::object, and what each stands for.
struct NamedScene {
    Scene scene;
    std::vector<std::string> names;  // of the objects, then of the planes
};

/// Adds a name that the list has not yet.
void add_name(const std::string& wanted, std::vector<std::string>& names) {
    std::string name = wanted;
    for (int i = 2; std::ranges::count(names, name) > 0; ++i)
        name = fmt::format("{} {}", wanted, i);
    names.push_back(name);
}

std::string name_of(const ObjectBlock& object) {
    if (!object.name.empty()) return object.name;
    return object.ifs ? *object.ifs : "object";
}

void add_planes(const Scene& scene, std::vector<std::string>& names) {
    for (const PlaneBlock& plane : scene.planes)
        add_name(plane.name.empty() ? "plane" : plane.name, names);
}

NamedScene named_objects(const Scene& scene) {
    NamedScene named{scene, {}};
    for (const ObjectBlock& object : objects_of(scene)) add_name(name_of(object), named.names);
    add_planes(scene, named.names);
    return named;
}

std::string map_name(const IfsBlock& block, std::size_t map) {
    const std::string& name = block.maps[map].name;
    return name.empty() ? fmt::format("{}", map + 1) : name;
}

/// The maps that may be the outermost.
std::vector<std::size_t> starts_of(const IfsBlock& block) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < block.maps.size(); ++i) {
        const bool is_start = std::ranges::any_of(block.start, [&](const MapReference& reference) {
            if (const long* number = std::get_if<long>(&reference.map))
                return static_cast<std::size_t>(*number) == i + 1;
            return std::get<std::string>(reference.map) == block.maps[i].name;
        });
        if (is_start || block.start.empty()) starts.push_back(i);
    }
    return starts;
}

/// Each object as one for each of its outermost maps, from where it was looked at as a whole.
NamedScene named_maps(const Scene& scene, double zoom) {
    NamedScene named{scene, {}};
    named.scene.ifs.clear();
    named.scene.objects.clear();
    Diagnostics diagnostics;
    named.scene.camera = placed_camera(scene, zoom, diagnostics);
    diagnostics.throw_if_errors(scene.files);
    for (const ObjectBlock& object : objects_of(scene)) {
        const bool is_volume = !object.ifs || object.levels == 0L;
        if (is_volume) {
            add_name(name_of(object), named.names);
            named.scene.objects.push_back(object);
        }
        if (!object.ifs) continue;
        const IfsBlock& whole = *std::ranges::find(scene.ifs, *object.ifs, &IfsBlock::name);
        if (is_volume) {
            if (std::ranges::count(named.scene.ifs, whole.name, &IfsBlock::name) == 0)
                named.scene.ifs.push_back(whole);
            continue;
        }
        for (const std::size_t map : starts_of(whole)) {
            if (named.names.size() >= matte_maps)
                throw Error(ErrorKind::setting,
                            fmt::format("--cryptomatte map: the objects have more than {} maps",
                                        matte_maps));
            add_name(fmt::format("{}/{}", name_of(object), map_name(whole, map)), named.names);
            IfsBlock part = whole;
            part.name = fmt::format("{}/{}", named.names.size(), whole.name);
            part.start = {{static_cast<long>(map) + 1, {}}};
            ObjectBlock shown = object;
            shown.name = named.names.back();
            shown.ifs = part.name;
            named.scene.ifs.push_back(std::move(part));
            named.scene.objects.push_back(std::move(shown));
        }
    }
    add_planes(scene, named.names);
    return named;
}

/// Adds what a frame shows.
class ShareTaker : public PictureTaker {
  public:
    ShareTaker(MatteShares& shares, std::size_t names, float weight)
        : shares_(shares), names_(names), weight_(weight) {}

    void begin(const RenderResult& /*known*/) override {}
    void take(const Frame& part) override {
        for (long y = part.crop.y0; y < part.crop.y1; ++y) {
            for (long x = part.crop.x0; x < part.crop.x1; ++x) {
                const PixelRecord& pixel = part.at(x, y);
                const auto name = static_cast<std::size_t>(pixel.object);
                if (pixel.object >= 0 && name < names_)
                    shares_.add(x, y, name, pixel.alpha * weight_);
            }
        }
    }

  private:
    MatteShares& shares_;
    std::size_t names_;
    float weight_;
};

/// The samples of a pixel that are rays of their own.
long samples_of(const Scene& scene) {
    const RenderBlock render = scene.render.value_or(RenderBlock{});
    const bool by_area = render.covers && std::holds_alternative<AreaCovers>(*render.covers);
    return by_area ? 1 : render.samples.value_or(1);
}

CropWindow window_of(const Scene& scene) {
    const ImageBlock image = scene.image.value_or(ImageBlock{});
    const PixelSize size = image.size.value_or(PixelSize{});
    return image.crop.value_or(CropWindow{0, 0, size.columns, size.rows});
}

}  // namespace

std::vector<MatteLayer> render_mattes(const RenderRequest& request,
                                      const std::vector<MatteKind>& kinds,
                                      const RunControl& control) {
    const Scene scene = scene_of(request);
    if (has_exposure(request, scene))
        throw Error(ErrorKind::setting,
                    "--cryptomatte: not of a frame with an open shutter (--set "
                    "animation.shutter=0)");
    const CropWindow window = window_of(scene);
    if ((window.x1 - window.x0) * (window.y1 - window.y0) > matte_pixels)
        throw Error(ErrorKind::setting,
                    fmt::format("--cryptomatte: more than {} pixels at a time; render several "
                                "windows (--crop)",
                                matte_pixels));
    const long samples = samples_of(scene);
    std::vector<MatteLayer> layers;
    for (const MatteKind kind : kinds) {
        const bool by_map = kind == MatteKind::map;
        NamedScene named =
            by_map ? named_maps(scene, request.overrides.zoom) : named_objects(scene);
        if (named.names.size() > matte_names)
            throw Error(ErrorKind::setting,
                        fmt::format("--cryptomatte: more than {} objects", matte_names));
        MatteLayer layer{by_map ? "CryptoMap" : "CryptoObject", std::move(named.names),
                         MatteShares(window)};
        ShareTaker taker(layer.shares, layer.names.size(), 1 / static_cast<float>(samples));
        RenderRequest pass = request;
        pass.scene = std::move(named.scene);
        pass.settings.clear();  // the scene has them
        pass.overrides.levels.reset();
        pass.outputs.clear();
        RunControl quiet;
        quiet.stop = control.stop;
        for (long i = 0; i < samples; ++i) {
            if (samples > 1) pass.only_sample = i;
            if (render(pass, quiet, &taker).stopped) return {};
        }
        layers.push_back(std::move(layer));
    }
    return layers;
}

}  // namespace pxm::host
