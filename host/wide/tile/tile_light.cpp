// The light that the places a tile sees send back: shadow rays and mirror rays, in packets of those
// that go together.
#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <limits>

#include "host/wide/tile/tile_tracer.hpp"
#include "host/wide/tile/to_node.hpp"

namespace pxm::host::wide {

/// The ray that asks whether a light reaches a place (Sec. 15.2, as dsp_kernels/shadow.hpp). False
/// if a plane stands between them.
bool TileTracer::shadow_ray(const LitPlace& place, const CompiledLight& light, LoneRay& ray) {
    const double p = place.pixel;
    if (light.kind == kernels::LightKind::directional) {
        ray = {place.point, light.place, p, far_away, p, 0};  // Eq. 15.4
    } else {
        const glm::dvec3 way = place.point - light.place;
        const double distance = glm::length(way);
        const auto size = kernels::light_pixel_size(node_, p, distance);  // Eq. 15.3
        ray = {light.place, way / distance, 0, distance - p, size.at_origin, size.growth};
    }
    kernels::PlaneHit<double> floor;
    return scene_.planes.empty() ||
           !kernels::nearest_plane(node_, to_node(ray), ray.start, ray.end, floor);
}

/// Takes from the lit places the lights that do not reach them.
void TileTracer::cast_shadows() {
    for (std::size_t light = 0; light < scene_.lights.size(); ++light) {
        if (!scene_.lights[light].shadow) continue;
        shadows_.clear();
        for (std::size_t i = 0; i < lit_count_; ++i) {
            float& facing = lit_[i].seen.facing[light];
            if (!(0 < facing)) continue;
            const Lane& lane = lanes_[static_cast<std::size_t>(lit_[i].lane)];
            ++sums_[static_cast<std::size_t>(lane.pixel)].light_rays;
            LoneRay ray;
            if (shadow_ray(lit_[i], scene_.lights[light], ray)) {
                shadows_.emplace_back(i, ray);
            } else {
                facing = 0;
            }
        }
        while (!shadows_.empty()) search_shadows(light);
    }
}

/// Shadow rays that go together, as one packet.
void TileTracer::search_shadows(std::size_t light) {
    std::array<std::size_t, packet_rays> places;
    const LoneRay first = shadows_.front().second;
    batch_.clear();
    std::erase_if(shadows_, [&](const auto& shadow) {
        if (!batch_.empty() && !go_together(first, shadow.second)) return false;
        places[batch_.size()] = shadow.first;
        batch_.push_back(shadow.second);
        return true;
    });
    gather_rays(work_.packet, batch_);
    work_.packet.any_hit = true;
    if (scene_.lights[light].kind == kernels::LightKind::directional) {
        work_.packet.candidate_view = {CandidateViewOf::Kind::light, static_cast<long>(light), 0};
    }
    if (!search_packet(wide_, work_)) work_.clear_found();
    for (std::size_t i = 0; i < batch_.size(); ++i) {
        const Found& found = work_.found[i];
        LitPlace& place = lit_[places[i]];
        const int pixel = lanes_[static_cast<std::size_t>(place.lane)].pixel;
        sums_[static_cast<std::size_t>(pixel)].tested += found.tested;
        if (found.given_up) give_up(pixel);
        if (found.start >= 0 || (rest_ && is_in_shadow_of_rest(batch_[i], pixel))) {
            place.seen.facing[light] = 0;
        }
    }
}

bool TileTracer::is_in_shadow_of_rest(const LoneRay& ray, int pixel) {
    const bool met = rest_->meets(ray, ray.end);
    sums_[static_cast<std::size_t>(pixel)].tested += rest_->tested();
    if (rest_->was_given_up()) give_up(pixel);
    return met;
}

/// The light that a place sends back (Eq. 17.1).
std::array<float, 3> TileTracer::color_of(const LitPlace& place) const {
    std::array<float, 3> color = wide_.ambient;
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
        const float strength = place.diffuse * place.seen.facing[i];
        for (int k = 0; k < 3; ++k) {
            color[static_cast<std::size_t>(k)] +=
                strength * static_cast<float>(scene_.lights[i].color[k]);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) color[k] *= place.seen.color[k];
    return color;
}

/// Adds a place to its pixel, and asks for what it mirrors.
void TileTracer::add_light(const LitPlace& place) {
    const Lane& lane = lanes_[static_cast<std::size_t>(place.lane)];
    double share = lane.share;
    if (place.reflect > 0 && lane.bounces_left > 0) {
        const double mirror_share = share * static_cast<double>(place.reflect);
        share -= mirror_share;
        const double whole = scene_.area ? 1 : 1.0 / static_cast<double>(scene_.samples.size());
        if (mirror_share >= whole * kernels::least_share<double>) mirror(lane, place, mirror_share);
    }
    const std::array<float, 3> color = color_of(place);
    PixelSum& sum = sums_[static_cast<std::size_t>(lane.pixel)];
    for (std::size_t k = 0; k < 3; ++k) sum.color[k] += share * static_cast<double>(color[k]);
}

void TileTracer::mirror(const Lane& lane, const LitPlace& place, double share) {
    kernels::Search<double> search{};
    search.ray = to_node(lane.ray);
    search.pixel = {lane.ray.pixel_at_origin, lane.ray.pixel_growth};
    const auto mirror = kernels::mirrored(
        node_, search, to_node(place.point), place.pixel,
        to_node(glm::dvec3{place.seen.normal[0], place.seen.normal[1], place.seen.normal[2]}));
    const LoneRay ray{
        to_glm(mirror.ray.origin), to_glm(mirror.ray.direction), mirror.start, far_away,
        mirror.pixel.at_origin,    mirror.pixel.growth};
    pending_.push_back({lane.pixel, share, lane.bounces_left - 1, ray});
}

/// Mirror rays that go much the same way, as one packet.
void TileTracer::look_into_mirrors() {
    const LoneRay first = pending_.front().ray;
    batch_.clear();
    std::erase_if(pending_, [&](const PendingRay& pending) {
        if ((unclear_ >> pending.pixel & 1) != 0) return true;
        const bool full = batch_.size() == packet_rays;
        if (full || (!batch_.empty() && !go_together(first, pending.ray))) return false;
        lanes_[batch_.size()] = {
            pending.pixel, pending.share, pending.bounces_left, pending.ray, {}};
        batch_.push_back(pending.ray);
        ++sums_[static_cast<std::size_t>(pending.pixel)].mirror_rays;
        return true;
    });
    if (batch_.empty()) return;
    gather_rays(work_.packet, batch_);
    work_.packet.any_hit = false;
    look(Kind::mirror);
}

}  // namespace pxm::host::wide
