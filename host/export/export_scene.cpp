#include "host/export/export_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>
#include <map>
#include <utility>

#include "host/compile/lifted_fractal.hpp"
#include "host/compile/method.hpp"
#include "host/compile/placed.hpp"
#include "host/compile/volumes.hpp"
#include "host/error.hpp"
#include "host/fractal/bounds/bounds.hpp"
#include "host/scene/default_objects.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr glm::dvec3 base_color{0.9};    // as in host/compile/compile.cpp
constexpr double largest_length = 1e30;  // what floats of files hold, with room

glm::dmat3 axes_of(FileAxes axes) {
    switch (axes) {
        case FileAxes::of_scene:
            break;
        case FileAxes::z_to_viewer:
            return {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
        case FileAxes::z_up:
            return {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    }
    return glm::dmat3{1.0};
}

bool is_similar(const Affine& map) {
    const MapKind kind = classify(map);
    return kind == MapKind::homothety || kind == MapKind::similitude;
}

class Builder {
  public:
    Builder(const Scene& scene, const ExportRequest& request, FileAxes axes,
            Diagnostics& diagnostics)
        : scene_(scene),
          request_(request),
          axes_{axes_of(axes), glm::dvec3{0.0}},
          blocks_(objects_of(scene)),
          diagnostics_(diagnostics) {}

    ExportScene run() {
        for (const ObjectBlock& block : blocks_) add(block);
        if (blocks_.empty()) diagnostics_.error({}, "the scene has no object to export");
        diagnostics_.throw_if_errors(scene_.files);
        ExportScene result;
        const ImageBlock image = scene_.image.value_or(ImageBlock{});
        result.view = make_view(scene_.camera.value_or(CameraBlock{}),
                                image.size.value_or(PixelSize{}), ball_around(placed_), 1);
        result.voxels = request_.voxels;
        result.scale = request_.scale;
        result.geometry = request_.geometry;
        result.most_cells = request_.most_cells;
        result.scene = &scene_;
        result.systems = std::move(systems_);
        return result;
    }

  private:
    /// The same map in the axes of the file. The axes' own map is its inverse.
    [[nodiscard]] Affine turned(const Affine& map) const { return then(then(axes_, map), axes_); }

    Fractal* fractal_of(const ObjectBlock& block) {
        if (!block.ifs) return nullptr;
        if (const auto made = fractals_.find(*block.ifs); made != fractals_.end())
            return &made->second;
        const auto ifs = std::ranges::find(scene_.ifs, *block.ifs, &IfsBlock::name);
        auto fractal = make_fractal(*ifs, diagnostics_);
        if (!fractal) return nullptr;
        fractal->bounds = bound(fractal->rifs, fractal->contraction);
        return &fractals_.emplace(*block.ifs, std::move(*fractal)).first->second;
    }

    void add(const ObjectBlock& block) {
        Fractal* fractal = fractal_of(block);
        if (block.ifs && fractal == nullptr) return;
        const Placed placed{&block, fractal, compose(block.commands)};
        const Ball ball = placed.world_ball();
        const double reach = (glm::length(ball.center) + ball.radius) * request_.scale;
        if (!(reach <= largest_length))
            return diagnostics_.error(block.position,
                                      fmt::format("object \"{}\" is too large to export: it "
                                                  "reaches beyond {:g}",
                                                  block.name, largest_length));
        placed_.push_back(placed);
        ExportSystem system;
        system.name = block.name;
        system.place = turned(placed.instance);
        system.place.linear *= request_.scale;
        system.place.translation *= request_.scale;
        const glm::dvec4 paint = block.color.value_or(glm::dvec4{0.0});
        system.color = base_color * (1 - paint.a) + glm::dvec3{paint} * paint.a;
        if (fractal == nullptr)
            system.sets.push_back(set_of({}, primitive_volume(*block.volume)));
        else
            add_maps(block, *fractal, system);
        set_ends(block, system);
        systems_.push_back(std::move(system));
    }

    void add_maps(const ObjectBlock& block, const Fractal& fractal, ExportSystem& system) {
        const VolumeKind asked = request_.shape.kind;
        const RenderBlock render = scene_.render.value_or(RenderBlock{});
        const VolumeKind kind = asked == VolumeKind::automatic ? volume_kind(render, block) : asked;
        const Rifs& rifs = fractal.rifs;
        const auto volumes = choose_volumes(block, kind, rifs, fractal.bounds, diagnostics_);
        for (std::size_t s = 0; s < rifs.follow_sets.size(); ++s)
            system.sets.push_back(set_of(rifs.follow_sets[s].maps, volumes[s]));
        const auto ifs = std::ranges::find(scene_.ifs, *block.ifs, &IfsBlock::name);
        for (std::size_t i = 0; i < rifs.maps.size(); ++i) {
            SystemMap map{turned(rifs.maps[i]), ifs->maps[i].color.value_or(glm::dvec4{0.0}),
                          rifs.follow_of[i], lipschitz_constant(rifs.maps[i])};
            system.similar = system.similar && is_similar(map.map);
            system.colored = system.colored || map.color.a > 0;
            system.maps.push_back(map);
        }
        system.similar = system.similar && is_similar(system.place);
        system.start = rifs.start;
    }

    [[nodiscard]] SystemSet set_of(const std::vector<int>& maps, const CompiledVolume& volume) {
        const Mesh shape = request_.shape.mesh ? *request_.shape.mesh : mesh_of(volume);
        return {maps, turned(volume), image_of(shape, axes_)};
    }

    /// The same volume in the axes of the file, which only exchange axes and turn them over; cones
    /// and cylinders have no place of their own.
    [[nodiscard]] CompiledVolume turned(CompiledVolume volume) const {
        volume.center = axes_.point(volume.center);
        for (glm::dvec3& half : volume.half) half = axes_.direction(half);
        for (HalfSpace& side : volume.half_spaces) side.normal = axes_.direction(side.normal);
        const glm::dvec3 a = axes_.point(volume.low), b = axes_.point(volume.high);
        volume.low = glm::min(a, b);
        volume.high = glm::max(a, b);
        return volume;
    }

    void set_ends(const ObjectBlock& block, ExportSystem& system) {
        constexpr auto unlimited = std::numeric_limits<std::uint32_t>::max();
        const std::optional<long> levels = request_.levels ? request_.levels : block.levels;
        const long most = static_cast<long>(longest_word);
        system.levels = levels ? static_cast<std::uint32_t>(std::min(*levels, most)) : unlimited;
        if (request_.detail) system.detail = *request_.detail * request_.scale;
        if (system.maps.empty() || levels || request_.detail) return;
        throw Error(ErrorKind::setting,
                    fmt::format("object \"{}\" does not say where it ends: --levels N or --detail "
                                "LENGTH does",
                                printable(block.name)));
    }

    const Scene& scene_;
    const ExportRequest& request_;
    Affine axes_;
    std::vector<ObjectBlock> blocks_;
    Diagnostics& diagnostics_;
    std::map<std::string, Fractal> fractals_;
    std::vector<Placed> placed_;
    std::vector<ExportSystem> systems_;
};

}  // namespace

ExportScene export_scene(const Scene& scene, const ExportRequest& request, FileAxes axes,
                         Diagnostics& diagnostics) {
    return Builder(scene, request, axes, diagnostics).run();
}

}  // namespace pxm::host
