#include "host/compile/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "host/compile/area_covers.hpp"
#include "host/compile/compile_floor.hpp"
#include "host/compile/compile_lights.hpp"
#include "host/compile/lifted_fractal.hpp"
#include "host/compile/method.hpp"
#include "host/compile/placed.hpp"
#include "host/compile/reroot.hpp"
#include "host/compile/samples.hpp"
#include "host/compile/shape.hpp"
#include "host/compile/view.hpp"
#include "host/compile/volumes.hpp"
#include "host/compiled/bounding_volume.hpp"
#include "host/fractal/bounds/filled.hpp"
#include "host/math/lipschitz.hpp"
#include "host/node_program/crowded.hpp"
#include "host/scene/default_objects.hpp"

namespace pxm::host {

namespace {

constexpr double largest_length = 1e100;  // world units: the square of more is no double
constexpr glm::dvec3 base_color{0.9, 0.9, 0.9};

kernels::ShadingMode shading_mode(Shading shading) {
    switch (shading) {
        case Shading::constant:
            return kernels::ShadingMode::constant;
        case Shading::low_pass:
            return kernels::ShadingMode::low_pass;
        case Shading::high_pass:
            return kernels::ShadingMode::high_pass;
        case Shading::facet:
            return kernels::ShadingMode::facet;
    }
    return kernels::ShadingMode::constant;
}

/// Does the work of compile() once every ifs block is known to be right.
class Compiler {
  public:
    Compiler(const Scene& scene, double zoom, Diagnostics& diagnostics, NearCells near_cells)
        : scene_(scene),
          render_(scene.render.value_or(RenderBlock{})),
          zoom_(zoom),
          diagnostics_(diagnostics),
          near_cells_(near_cells) {}

    CompiledScene run() {
        make_fractals();
        if (diagnostics_.has_errors()) return {};
        const std::vector<ObjectBlock> blocks = objects_of(scene_);
        std::vector<Placed> objects = place(blocks);
        if (diagnostics_.has_errors()) return {};
        set_view(ball_around(objects));
        if (diagnostics_.has_errors()) return {};
        lift_to_pixels(objects);
        out_.method = chosen_method(render_);
        out_.shading = shading_mode(render_.shading.value_or(Shading::constant));
        set_sampling();
        for (const Placed& object : objects) add_object(object);
        if (covers_by_area()) {
            cover_by_area(render_, filled_, out_, diagnostics_);
        } else if (has_faces_askew()) {
            leave_faces(out_.samples);
        }
        if (near_cells_ == NearCells::replaced) reroot(roots_, view_, rays(), out_);
        compile_floor(scene_, view_, fractals_, out_, diagnostics_);
        out_.lights = compile_lights(scene_, view_.eye, out_.unit);
        if (out_.method == kernels::Method::fast) require_solid(render_, out_, diagnostics_);
        out_.heap = render_.heap.value_or(out_.heap);
        out_.ambient = render_.ambient.value_or(out_.ambient);
        out_.background = render_.background.value_or(out_.background);
        return std::move(out_);
    }

    CameraBlock camera() {
        make_fractals();
        const CameraBlock camera = scene_.camera.value_or(CameraBlock{});
        if (diagnostics_.has_errors() || (camera.eye && camera.look)) return camera;
        const std::vector<ObjectBlock> blocks = objects_of(scene_);
        const ImageBlock image = scene_.image.value_or(ImageBlock{});
        return with_places(camera, image.size.value_or(PixelSize{}), ball_around(place(blocks)));
    }

  private:
    void make_fractals() {
        for (const IfsBlock& block : scene_.ifs) {
            if (auto fractal = make_fractal(block, diagnostics_)) {
                if (chosen_method(render_) == kernels::Method::fast) {
                    require_homotheties(block, fractal->exact, diagnostics_);
                }
                fractals_.emplace(block.name, std::move(*fractal));
            }
        }
    }

    /// The bounded fractal that an object shows; none if a volume is the object.
    Fractal* fractal_of(const ObjectBlock& block) {
        if (!block.ifs) return nullptr;
        Fractal& fractal = fractals_.at(*block.ifs);
        if (fractal.bounds.empty()) fractal.bounds = bound(fractal.rifs, fractal.contraction);
        return &fractal;
    }

    std::vector<Placed> place(const std::vector<ObjectBlock>& blocks) {
        std::vector<Placed> objects;
        for (const ObjectBlock& block : blocks) {
            objects.push_back({&block, fractal_of(block), compose(block.commands)});
            const Ball ball = objects.back().world_ball();
            if (!(glm::length(ball.center) <= largest_length && ball.radius <= largest_length)) {
                diagnostics_.error(block.position,
                                   fmt::format("object \"{}\" is too large or too far away: it "
                                               "reaches beyond {:g}",
                                               block.name, largest_length));
            }
        }
        return objects;
    }

    void set_view(const Ball& ball) {
        const ImageBlock image = scene_.image.value_or(ImageBlock{});
        out_.size = image.size.value_or(PixelSize{});
        out_.crop = image.crop.value_or(CropWindow{0, 0, out_.size.columns, out_.size.rows});
        const CameraBlock camera = scene_.camera.value_or(CameraBlock{});
        view_ = make_view(camera, out_.size, ball, zoom_);
        const double reach = glm::length(view_.eye) + view_.half_width;
        if (!(reach <= largest_length && glm::length(view_.right) > 0.5)) {
            diagnostics_.error(camera.position,
                               "the camera's numbers are too large to compute with");
        }
        out_.unit = power_of_two_near(ball.radius);
        out_.camera = compile_view(view_, out_.size, out_.unit);
    }

    /// Whether rays go on from what the eye sees.
    [[nodiscard]] Rays rays() const {
        const bool shadows = std::ranges::any_of(
            scene_.lights, [](const LightBlock& light) { return light.shadow.value_or(false); });
        const bool mirrors =
            std::ranges::any_of(scene_.planes, [](const PlaneBlock& p) { return p.reflect > 0; }) ||
            needs_mirrors(out_);
        return shadows || mirrors ? Rays::from_everywhere : Rays::from_the_eye;
    }

    [[nodiscard]] bool covers_by_area() const {
        return render_.covers && std::holds_alternative<AreaCovers>(*render_.covers);
    }

    [[nodiscard]] bool has_faces_askew() const {
        const auto askew = [](const CompiledSet& set) {
            return set.volume.kind == kernels::Volume::hull ||
                   set.volume.kind == kernels::Volume::oriented;
        };
        return std::ranges::any_of(out_.shapes, [&](const CompiledShape& shape) {
            return std::ranges::any_of(shape.sets, askew);
        });
    }

    void set_sampling() {
        out_.detail = render_.detail.value_or(out_.detail);
        out_.fade = out_.detail;
        if (const auto* covers = render_.covers ? std::get_if<Covers>(&*render_.covers) : nullptr) {
            out_.fade = out_.detail * covers->tau_max;
            out_.detail *= covers->tau_min;
            out_.covers = true;
        }
        out_.bounces = render_.bounces.value_or(out_.bounces);
        if (covers_by_area()) return;  // once the objects are there
        out_.samples = sample_places(render_.samples.value_or(1));
        const double finer = std::sqrt(static_cast<double>(out_.samples.size()));
        out_.camera.pixel_at_eye /= finer;
        out_.camera.pixel_growth /= finer;
    }

    /// Gives flat images the thickness of a pixel, as seen at the nearest object of the ifs: a ray
    /// a pixel does not miss them edge on.
    void lift_to_pixels(const std::vector<Placed>& objects) {
        std::map<Fractal*, double> thickness;
        for (const Placed& object : objects) {
            if (object.fractal == nullptr || !object.fractal->lifted) continue;
            const double distance = glm::distance(view_.eye, object.world_ball().center);
            const double p = pixel_size(view_, out_.size, distance);
            const double extent =
                lipschitz_constant(object.instance) * squashed_extent(*object.fractal);
            const double share = extent > 0 && std::isfinite(extent) ? p / extent : first_lift;
            const auto [found, added] = thickness.emplace(object.fractal, share);
            if (!added) found->second = std::min(found->second, share);
        }
        for (const auto& [fractal, share] : thickness) {
            lift_again(*fractal, share);
        }
    }

    void add_object(const Placed& object) {
        const ShapeFrame frame = frame_around(object.own_ball());
        CompiledObject result;
        result.name = object.block->name;
        result.origin = static_cast<int>(out_.objects.size());
        result.shape = object.fractal == nullptr ? shape_of_volume(*object.block, frame)
                                                 : shape_of_fractal(object, frame);
        const CompiledShape& shape = out_.shapes[static_cast<std::size_t>(result.shape)];
        if (out_.method == kernels::Method::fast) {
            require_spheres(*object.block, shape, diagnostics_);
        }
        const bool stays = object.fractal == nullptr || object.fractal->lifted;
        roots_.push_back({stays ? nullptr : &object.fractal->rifs, frame, object.instance});
        result.start = shape.start;
        result.instance.linear = object.instance.linear * (frame.scale / out_.unit);
        result.instance.translation = (object.instance.point(frame.center) - view_.eye) / out_.unit;
        result.constant = constant_by(shape.lipschitz, result.instance);
        result.diameter = lipschitz_constant(result.instance) *
                          shape.sets[static_cast<std::size_t>(shape.start)].volume.diameter;
        const glm::dvec4 paint = object.block->color.value_or(glm::dvec4{0.0});
        result.color = base_color * (1 - paint.a) + glm::dvec3{paint} * paint.a;
        result.diffuse = object.block->diffuse.value_or(0.8);
        result.opacity = object.block->opacity.value_or(1);
        result.reflect = object.block->reflect.value_or(0);
        if (object.fractal == nullptr) {
            result.levels = 0;  // its outermost cell is all there is
        } else if (object.block->levels) {
            result.levels = static_cast<std::uint32_t>(
                std::min<long>(*object.block->levels, kernels::unlimited_levels - 1));
        }
        out_.objects.push_back(result);
    }

    int shape_of_fractal(const Placed& object, const ShapeFrame& frame) {
        const Fractal& fractal = *object.fractal;
        const std::string& name = *object.block->ifs;
        const auto& volumes = volumes_of(object);
        const auto method =
            choose_lipschitz(render_.lipschitz.value_or(LipschitzMethod::automatic), fractal.exact);
        if (const auto made = shape_with(name, volumes, frame)) return *made;
        const auto block = std::ranges::find(scene_.ifs, name, &IfsBlock::name);
        CompiledShape shape = make_shape(fractal.rifs, volumes, frame, method);
        shape.lifted = fractal.lifted;
        for (std::size_t i = 0; i < shape.maps.size(); ++i) {
            shape.maps[i].color = block->maps[i].color.value_or(glm::dvec4{0.0});
            shape.maps[i].lost = lost_axes(fractal.exact.maps[i]);
        }
        shape.crowded = is_crowded(shape);
        const bool filled = covers_by_area() && find_filling(fractal.rifs).filling != Filling::none;
        return add_shape(std::move(shape), filled);
    }

    int shape_of_volume(const ObjectBlock& block, const ShapeFrame& frame) {
        const CompiledVolume volume = primitive_volume(*block.volume);
        if (const auto made = shape_with("", {volume}, frame)) return *made;
        CompiledShape shape;
        shape.sets.push_back({in_frame(volume, frame.center, frame.scale), {}});
        return add_shape(std::move(shape), true);
    }

    /// The volumes for an object: those chosen for another one that is declared alike.
    const std::vector<CompiledVolume>& volumes_of(const Placed& object) {
        const ObjectBlock& block = *object.block;
        for (const ChosenVolumes& chosen : chosen_) {
            if (chosen.fractal == object.fractal && chosen.block->volume == block.volume &&
                chosen.block->levels == block.levels) {
                return chosen.volumes;
            }
        }
        chosen_.push_back({object.fractal, &block,
                           choose_volumes(block, volume_kind(render_, block), object.fractal->rifs,
                                          object.fractal->bounds, diagnostics_)});
        return chosen_.back().volumes;
    }

    /// The number of the shape of an ifs with those volumes, if it was made before.
    std::optional<int> shape_with(const std::string& ifs,
                                  const std::vector<CompiledVolume>& volumes,
                                  const ShapeFrame& frame) {
        const auto same = [&](const CompiledShape& shape) {
            return shape.ifs == ifs &&
                   std::ranges::equal(shape.sets, volumes,
                                      [&](const CompiledSet& set, const CompiledVolume& volume) {
                                          return set.volume ==
                                                 in_frame(volume, frame.center, frame.scale);
                                      });
        };
        const auto found = std::ranges::find_if(out_.shapes, same);
        if (found == out_.shapes.end()) return std::nullopt;
        return static_cast<int>(found - out_.shapes.begin());
    }

    int add_shape(CompiledShape shape, bool filled) {
        filled_.push_back(filled);
        out_.shapes.push_back(std::move(shape));
        return static_cast<int>(out_.shapes.size()) - 1;
    }

    /// What was chosen for the first of the objects that are declared alike.
    struct ChosenVolumes {
        const Fractal* fractal;
        const ObjectBlock* block;
        std::vector<CompiledVolume> volumes;
    };

    const Scene& scene_;
    RenderBlock render_;
    double zoom_;
    Diagnostics& diagnostics_;
    NearCells near_cells_;
    std::map<std::string, Fractal> fractals_;
    std::vector<ChosenVolumes> chosen_;
    std::vector<Root> roots_;   // of the objects
    std::vector<bool> filled_;  // shapes; known where local covers are by area
    View view_;
    CompiledScene out_;
};

}  // namespace

CompiledScene compile(const Scene& scene, double zoom, Diagnostics& diagnostics,
                      NearCells near_cells) {
    return Compiler(scene, zoom, diagnostics, near_cells).run();
}

CameraBlock placed_camera(const Scene& scene, double zoom, Diagnostics& diagnostics) {
    return Compiler(scene, zoom, diagnostics, NearCells::kept).camera();
}

}  // namespace pxm::host
