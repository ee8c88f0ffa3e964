#include "host/wide/tile/tile_tracer.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "host/engine/gather.hpp"
#include "host/engine/overflow.hpp"
#include "host/node_program/crowded.hpp"
#include "host/node_program/instances.hpp"
#include "host/wide/tile/to_node.hpp"

namespace pxm::host::wide {

TileTracer::TileTracer(const CompiledScene& scene, const WideScene& wide,
                       const ReferenceFallback& rest, const std::vector<std::uint32_t>& block)
    : scene_(scene),
      wide_(wide),
      block_(block),
      node_(make_native_node<Node>(scene, block)),
      heap_(node_),
      constants_(kernels::read_frame_constants(node_)),
      clear_pixel_(with_needed_features(scene,
                                        []<kernels::Features features>() -> ClearPixel {
                                            return &kernels::render_pixel<features, Node>;
                                        })),
      needs_all_rays_(!scene.planes.empty() || !rest.block.empty()),
      needs_rays_(needs_all_rays_ || !needs_plain_features(scene)),
      is_plain_(!needs_all_rays_ && !needs_mirrors(scene) && scene.samples.size() == 1) {
    if (!rest.block.empty()) rest_.emplace(rest);
    int widest = table_step;
    for (const WideSet& set : wide.sets) widest = std::max(widest, set.stride);
    work_.scratch = hwy::AllocateAligned<double>(static_cast<std::size_t>(widest) * 32);
    for (std::size_t i = 0; i < nothing_seen_.size(); ++i) {
        PixelRecord& pixel = nothing_seen_[i];
        std::ranges::copy(wide.background, pixel.color);
        pixel.node = static_cast<std::uint16_t>(i);
        pixel.volumes = static_cast<std::uint32_t>(wide.objects.size());
    }
    if (!scene.area) return;
    beams_ = std::make_unique<BeamWorkspace>();
    prepare_places();
}

void TileTracer::render(Frame& frame, long left, long top, const GoOn& go_on) {
    frame_ = &frame;
    left_ = left;
    top_ = top;
    unclear_ = 0;
    if (beams_) return render_area();
    if (is_plain_) return render_plainly();
    sums_.fill(PixelSum{});
    for (std::size_t sample = 0; sample < scene_.samples.size(); ++sample) {
        if (!go_on()) return;
        aim(sample);
        look(sample == 0 ? Kind::first_sample : Kind::sample);
        while (!pending_.empty()) look_into_mirrors();
    }
    store();
}

void TileTracer::aim(std::size_t sample) {
    place_ = scene_.samples[sample];
    aim_at_tile(work_.packet, scene_.camera, frame_->crop, {left_, top_}, place_);
    work_.packet.inside &= ~unclear_;
    const double share = 1.0 / static_cast<double>(scene_.samples.size());
    for_bits(work_.packet.inside, [&](int pixel) {
        Lane& lane = lanes_[static_cast<std::size_t>(pixel)];
        lane.pixel = pixel;
        lane.share = share;
        lane.bounces_left = scene_.bounces;
        lane.floor.plane = 0;
        if (needs_all_rays_) lane.ray = eye_ray(pixel);
    });
}

/// As eye_ray() of dsp_kernels/camera.hpp, through the present sample's place in a pixel.
LoneRay TileTracer::eye_ray(int pixel) const {
    const CompiledCamera& camera = scene_.camera;
    const double column = static_cast<double>(left_ + pixel % tile_side) + place_.x;
    const double row = static_cast<double>(top_ + pixel / tile_side) + place_.y;
    const glm::dvec3 on_plane = camera.corner + camera.across * column + camera.down * row;
    const bool perspective = camera.projection == kernels::Projection::perspective;
    return {perspective ? glm::dvec3{0.0} : on_plane,
            perspective ? glm::normalize(on_plane) : camera.forward,
            0,
            far_away,
            camera.pixel_at_eye,
            camera.pixel_growth};
}

double TileTracer::length_at(int lane, double depth) const {
    if (!needs_rays_) return depth * static_cast<double>(work_.packet.stretch[lane]);
    const LoneRay& ray = lanes_[static_cast<std::size_t>(lane)].ray;
    const glm::dvec3& axis = work_.packet.axis[2];
    return (depth - glm::dot(ray.origin - work_.packet.origin, axis)) /
           glm::dot(ray.direction, axis);
}

double TileTracer::depth_at(int lane, double length) const {
    const LoneRay& ray = lanes_[static_cast<std::size_t>(lane)].ray;
    return glm::dot(ray.origin + length * ray.direction - work_.packet.origin,
                    work_.packet.axis[2]);
}

/// What the lanes of the packet see, front to back: cells, planes, the background.
void TileTracer::look(Kind kind) {
    lit_count_ = 0;
    if (!scene_.planes.empty()) meet_planes();
    if (!search_packet(wide_, work_)) work_.clear_found();
    see_cells_of(work_.packet.inside);
    for_bits(work_.packet.inside, [&](int lane) { see(kind, lane); });
    if (needs_shadows(scene_)) cast_shadows();
    for (std::size_t i = 0; i < lit_count_; ++i) add_light(lit_[i]);
}

void TileTracer::meet_planes() {
    for_bits(work_.packet.inside, [&](int i) {
        Lane& lane = lanes_[static_cast<std::size_t>(i)];
        lane.floor.plane = 0;
        if (kernels::nearest_plane(node_, to_node(lane.ray), lane.ray.start, lane.ray.end,
                                   lane.floor)) {
            work_.packet.end[static_cast<std::size_t>(i)] = depth_at(i, lane.floor.t);
        }
    });
}

void TileTracer::see(Kind kind, int i) {
    const Lane& lane = lanes_[static_cast<std::size_t>(i)];
    const Found& found = work_.found[static_cast<std::size_t>(i)];
    PixelSum& sum = sums_[static_cast<std::size_t>(lane.pixel)];
    sum.tested += static_cast<std::uint32_t>(wide_.objects.size()) + found.tested;
    if (found.given_up) {
        give_up(lane.pixel);
    } else if (rest_ && see_rest(kind, i)) {
        return;
    } else if (found.start >= 0) {
        see_cell_in(kind, i);
    } else if (lane.floor.plane != 0) {
        see_plane(kind, i);
    } else {
        for (std::size_t k = 0; k < 3; ++k) {
            sum.color[k] += lane.share * static_cast<double>(wide_.background[k]);
        }
    }
}

void TileTracer::see_cells_of(std::uint64_t lanes) {
    std::uint64_t hit = 0;
    std::array<ShadedHit*, packet_rays> seen;
    for_bits(lanes, [&](int i) {
        const auto at = static_cast<std::size_t>(i);
        const Found& found = work_.found[at];
        if (found.start < 0 || found.given_up) return;
        hit |= std::uint64_t{1} << i;
        seen[at] = &seen_[at];
    });
    confirmed_ = shade_hits(wide_, work_, hit, seen.data());
}

void TileTracer::see_cell_in(Kind kind, int i) {
    Lane& lane = lanes_[static_cast<std::size_t>(i)];
    if ((confirmed_ >> i & 1) == 0) return give_up(lane.pixel);
    LitPlace& place = lit_[lit_count_++];
    std::swap(place.seen, seen_[static_cast<std::size_t>(i)]);
    const bool wants_ray = needs_rays_ && !needs_all_rays_ && kind != Kind::mirror;
    if (wants_ray) lane.ray = eye_ray(lane.pixel);
    const WideObject& object = wide_.objects[static_cast<std::size_t>(place.seen.object)];
    const double t = length_at(i, place.seen.depth);
    place.lane = i;
    place.diffuse = object.diffuse;
    place.reflect = object.reflect;
    place.seen.object = object.index;
    if (needs_rays_) {
        place.point = lane.ray.origin + t * lane.ray.direction;
        place.pixel =
            std::max(lane.ray.pixel_at_origin + lane.ray.pixel_growth * t, object.smallest_pixel);
    }
    if (kind != Kind::mirror) sums_[static_cast<std::size_t>(lane.pixel)].opacity += lane.share;
    if (kind == Kind::first_sample) record_cell(place.seen, t, pixel_at(lane.pixel));
}

/// Looks for an object of the reference kernels in front of all else. False if there is none.
bool TileTracer::see_rest(Kind kind, int i) {
    const Lane& lane = lanes_[static_cast<std::size_t>(i)];
    const Found& found = work_.found[static_cast<std::size_t>(i)];
    PixelSum& sum = sums_[static_cast<std::size_t>(lane.pixel)];
    double end = lane.floor.plane != 0 ? lane.floor.t : lane.ray.end;
    if (found.start >= 0) end = std::min(end, length_at(i, found.depth));
    const bool met = rest_->meets(lane.ray, end);
    sum.tested += rest_->tested();
    if (rest_->was_given_up()) {
        give_up(lane.pixel);
        return true;
    }
    if (!met) return false;
    LitPlace& place = lit_[lit_count_++];
    const FallbackHit clear = rest_->see(place.seen);
    place.lane = i;
    place.diffuse = clear.diffuse;
    place.reflect = clear.reflect;
    place.point = lane.ray.origin + clear.t * lane.ray.direction;
    place.pixel = clear.pixel;
    if (kind != Kind::mirror) sum.opacity += lane.share;
    if (kind == Kind::first_sample) record_cell(place.seen, clear.t, pixel_at(lane.pixel));
    return true;
}

/// What is known of a pixel is of its first sample.
void TileTracer::record_cell(const ShadedHit& seen, double t, PixelRecord& pixel) const {
    pixel.z = static_cast<float>(t * scene_.unit);
    std::ranges::copy(seen.normal, pixel.normal);
    const CompiledObject& object = scene_.objects[static_cast<std::size_t>(seen.object)];
    pixel.object = object.origin;
    pixel.level = static_cast<std::int32_t>(object.prefix.size()) + seen.level;
    pixel.word = seen.word;
}

void TileTracer::see_plane(Kind kind, int i) {
    const Lane& lane = lanes_[static_cast<std::size_t>(i)];
    const double t = lane.floor.t;
    LitPlace& place = lit_[lit_count_++];
    const kernels::PixelSize<double> pixel{lane.ray.pixel_at_origin, lane.ray.pixel_growth};
    place.lane = i;
    place.pixel = kernels::pixel_on_plane(node_, pixel, t);
    place.point = lane.ray.origin + t * lane.ray.direction;
    const auto surface = kernels::plane_surface(node_, to_node(lane.ray), place.pixel, lane.floor);
    place.seen.color = to_floats(surface.color);
    place.seen.normal = to_floats(surface.normal);
    place.diffuse = static_cast<float>(surface.diffuse);
    place.reflect = static_cast<float>(surface.reflect);
    place.seen.facing.resize(scene_.lights.size());
    for (std::size_t k = 0; k < scene_.lights.size(); ++k) {
        const CompiledLight& light = scene_.lights[k];
        const glm::dvec3 to_light = light.kind == kernels::LightKind::directional
                                        ? light.place
                                        : glm::normalize(light.place - place.point);
        place.seen.facing[k] =
            static_cast<float>(kernels::facing(node_, surface.normal, to_node(to_light)));
    }
    if (kind != Kind::mirror) sums_[static_cast<std::size_t>(lane.pixel)].opacity += lane.share;
    if (kind != Kind::first_sample) return;
    PixelRecord& pixel_record = pixel_at(lane.pixel);
    pixel_record.z = static_cast<float>(t * scene_.unit);
    std::ranges::copy(place.seen.normal, pixel_record.normal);
    pixel_record.object = static_cast<std::int32_t>(object_count(scene_) +
                                                    plane_index<double>(block_, lane.floor.plane));
    pixel_record.level = 0;
}

void TileTracer::store() {
    aim_at_tile(work_.packet, scene_.camera, frame_->crop, {left_, top_}, scene_.samples[0]);
    for_bits(work_.packet.inside, [&](int i) {
        const PixelSum& sum = sums_[static_cast<std::size_t>(i)];
        if ((unclear_ >> i & 1) != 0) return render_clearly(i, sum.tested);
        PixelRecord& pixel = pixel_at(i);
        for (std::size_t k = 0; k < 3; ++k) pixel.color[k] = static_cast<float>(sum.color[k]);
        pixel.alpha = std::min(static_cast<float>(sum.opacity), 1.0F);
        pixel.volumes = sum.tested;
        pixel.node = static_cast<std::uint16_t>(i);
        ++rays_.pixels;
        rays_.hits += pixel.object >= 0 ? 1 : 0;
        rays_.eye_rays += scene_.samples.size();
        rays_.light_rays += sum.light_rays;
        rays_.reflect_rays += sum.mirror_rays;
        rays_.volumes_tested += sum.tested;
    });
}

/// Lets the reference kernels have a pixel after `tested` volumes.
void TileTracer::render_clearly(int i, std::uint32_t tested) {
    const auto x = static_cast<std::uint32_t>(left_ + i % tile_side);
    const auto y = static_cast<std::uint32_t>(top_ + i / tile_side);
    clear_overflow();  // lanes without a child divide by zero
    clear_pixel_(node_, constants_, heap_, x, y, result_);
    result_.counts.volumes_tested += tested;
    PixelRecord& pixel = pixel_at(i);
    pixel = PixelRecord{};
    gather_pixel(scene_, block_, result_, pixel, rays_);
    pixel.node = static_cast<std::uint16_t>(i);
}

}  // namespace pxm::host::wide
