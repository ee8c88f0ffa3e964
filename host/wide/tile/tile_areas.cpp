// Local covers by area on a tile: what its pixels ask of the beams of
// host/wide/area/area_search.hpp, and the light of what shows in them. As look_over_area() of
// dsp_kernels/trace.hpp.
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/wide/tile/tile_tracer.hpp"
#include "host/wide/tile/to_node.hpp"

namespace pxm::host::wide {

namespace {

/// The picture of a tile whose first pixel is (left, top).
TileView view_of(const CompiledCamera& camera, long left, long top) {
    constexpr double half = tile_side / 2.0;
    const glm::dvec3 middle = camera.corner + camera.across * (static_cast<double>(left) + half) +
                              camera.down * (static_cast<double>(top) + half);
    TileView view{};
    view.perspective = camera.projection == kernels::Projection::perspective;
    const glm::dmat3 away = glm::transpose(glm::inverse(
        glm::dmat3{camera.across, camera.down, view.perspective ? middle : camera.forward}));
    view.x = away[0];
    view.y = away[1];
    if (view.perspective) {
        view.s = away[2];
        view.along = glm::normalize(middle);
        return view;
    }
    view.along = camera.forward;
    view.x0 = -glm::dot(view.x, middle);
    view.y0 = -glm::dot(view.y, middle);
    view.s0 = 1;
    view.along0 = -glm::dot(away[2], middle);
    view.along = away[2];
    return view;
}

/// As beam_frame() of dsp_kernels/beam_cell.hpp.
void frame_beam(PixelBeam& beam, const CompiledCamera& camera) {
    const glm::dvec3& along = beam.ray.direction;
    const glm::dvec3 x = camera.across - glm::dot(camera.across, along) * along;
    const glm::dvec3 y = camera.down - glm::dot(camera.down, along) * along;
    beam.across = glm::normalize(x);
    beam.down = glm::normalize(y - glm::dot(y, beam.across) * beam.across);
}

/// Where a place, given from the first one in pixels, is in the picture, from the first one too.
glm::dvec2 in_picture(const TileView& view, const PixelBeam& beam, double x, double y) {
    const glm::dvec3 aside = x * beam.across + y * beam.down;
    const glm::dvec2 at{glm::dot(view.x, aside), glm::dot(view.y, aside)};
    if (!view.perspective) return beam.ray.pixel_at_origin * at;
    const double nearer = glm::dot(view.s, aside);
    const double growth = beam.ray.pixel_growth;
    return growth / (glm::dot(view.s, beam.ray.direction) + growth * nearer) *
           (at - nearer * glm::dvec2{beam.column, beam.row});
}

/// Where a pixel's places are in the picture.
void spread_places(TileView& view, const BeamWorkspace& work, PixelBeam& beam,
                   const glm::dvec2& first) {
    constexpr double rounding = 1e-5;
    float low_x = 0, high_x = 0, low_y = 0, high_y = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(work.places); ++i) {
        const glm::vec2 at{in_picture(view, beam, work.place_x[i], work.place_y[i])};
        beam.columns[i] = at.x;
        beam.rows[i] = at.y;
        low_x = std::min(low_x, at.x);
        high_x = std::max(high_x, at.x);
        low_y = std::min(low_y, at.y);
        high_y = std::max(high_y, at.y);
    }
    view.low_x = std::min(view.low_x, first.x + static_cast<double>(low_x) - rounding);
    view.high_x = std::max(view.high_x, first.x + static_cast<double>(high_x) + rounding);
    view.low_y = std::min(view.low_y, first.y + static_cast<double>(low_y) - rounding);
    view.high_y = std::max(view.high_y, first.y + static_cast<double>(high_y) + rounding);
}

/// The ray through a place, given from the first one in pixels.
LoneRay ray_through(const PixelBeam& beam, double x, double y) {
    const glm::dvec3 aside = x * beam.across + y * beam.down;
    LoneRay ray = beam.ray;
    ray.origin += ray.pixel_at_origin * aside;
    ray.direction = glm::normalize(ray.direction + ray.pixel_growth * aside);
    return ray;
}

}  // namespace

void TileTracer::prepare_places() {
    beams_->places = static_cast<int>(scene_.samples.size());
    for (std::size_t i = 0; i < scene_.samples.size(); ++i) {
        const glm::dvec2 place = scene_.samples[i] - scene_.samples[0];
        beams_->place_x[i] = place.x;
        beams_->place_y[i] = place.y;
    }
    prepare_beams(wide_, *beams_);
}

void TileTracer::render_area() {
    sums_.fill(PixelSum{});
    aim_beams();
    search_beams(wide_, *beams_);
    area_count_ = 0;
    const std::uint64_t inside = work_.packet.inside;  // shadows are a packet of their own
    if (beams_->given_up) {
        unclear_ = inside;
    } else {
        for (std::uint64_t rest = inside; rest != 0; rest &= rest - 1) {
            see_sights(std::countr_zero(rest));
        }
        light_area();
    }
    forget_least_mirrors();
    while (!pending_.empty()) look_into_mirrors();
    store();
}

void TileTracer::aim_beams() {
    place_ = scene_.samples[0];
    aim_at_tile(work_.packet, scene_.camera, frame_->crop, {left_, top_}, place_);
    TileView& view = beams_->view = view_of(scene_.camera, left_, top_);
    view.low_x = view.low_y = std::numeric_limits<double>::infinity();
    view.high_x = view.high_y = -view.low_x;
    beams_->open = work_.packet.inside;
    for (int i = 0; i < packet_rays; ++i) aim_beam(i);
}

void TileTracer::aim_beam(int i) {
    constexpr int half = tile_side / 2;
    TileView& view = beams_->view;
    PixelBeam& beam = beams_->pixels[static_cast<std::size_t>(i)];
    beam.ray = eye_ray(i);
    frame_beam(beam, scene_.camera);
    beam.column = i % tile_side - half + place_.x;
    beam.row = i / tile_side - half + place_.y;
    beam.end = far_away;
    beam.open = ~std::uint32_t{0} >> (most_places - beams_->places);
    beam.tested = 0;
    beam.sight_count = 0;
    std::fill_n(beam.left.begin(), beams_->places, 1.0);
    spread_places(view, *beams_, beam, place_);
    Lane& lane = lanes_[static_cast<std::size_t>(i)];
    lane = {i, 1, scene_.bounces, beam.ray, {}};
    if (!scene_.planes.empty() && kernels::nearest_plane(node_, to_node(lane.ray), lane.ray.start,
                                                         lane.ray.end, lane.floor)) {
        beam.end = lane.floor.t;
    }
}

/// Looks at what shows in a pixel: cells, and behind them a plane or the background.
void TileTracer::see_sights(int pixel) {
    const PixelBeam& beam = beams_->pixels[static_cast<std::size_t>(pixel)];
    PixelSum& sum = sums_[static_cast<std::size_t>(pixel)];
    sum.tested = static_cast<std::uint32_t>(wide_.objects.size()) + beam.tested;
    double most = 0;
    for (int k = 0; k < beam.sight_count; ++k) {
        const BeamSight& sight = beam.sights[static_cast<std::size_t>(k)];
        AreaPlace& place = next_area_place();
        place.lane = lanes_[static_cast<std::size_t>(pixel)];
        place.lane.share = sight.share;
        place.lane.ray = ray_through(beam, sight.x, sight.y);
        see_sight_along(sight.cell, place.lane.ray, place.lit);
        sum.opacity += sight.share;
        if (!(most < sight.share)) continue;
        most = sight.share;
        place.lit.seen.word = beam_word(wide_, *beams_, sight.cell);
        record_cell(place.lit.seen, place.lit.seen.depth, pixel_at(pixel));
    }
    double left = 0;
    for (int k = 0; k < beams_->places; ++k) left += beam.left[static_cast<std::size_t>(k)];
    left /= beams_->places;
    if (0 < left) see_behind(pixel, left, most < left ? Kind::first_sample : Kind::sample);
}

void TileTracer::see_sight_along(int cell, const LoneRay& ray, LitPlace& lit) {
    see_sight(wide_, *beams_, cell, ray, lit.seen);
    const double key = lit.seen.depth;
    const WideObject& object = wide_.objects[static_cast<std::size_t>(lit.seen.object)];
    lit.seen.object = object.index;
    lit.diffuse = object.diffuse;
    lit.reflect = object.reflect;
    lit.point = ray.origin + key * ray.direction;
    lit.pixel = std::max(ray.pixel_at_origin + ray.pixel_growth * key, object.smallest_pixel);
}

/// What of a pixel no cell covers.
void TileTracer::see_behind(int pixel, double left, Kind kind) {
    Lane& lane = lanes_[static_cast<std::size_t>(pixel)];
    PixelSum& sum = sums_[static_cast<std::size_t>(pixel)];
    if (lane.floor.plane == 0) {
        for (std::size_t k = 0; k < 3; ++k) {
            sum.color[k] += left * static_cast<double>(wide_.background[k]);
        }
        return;
    }
    lane.share = left;
    lit_count_ = 0;
    see_plane(kind, pixel);
    AreaPlace& place = next_area_place();
    place.lane = lane;
    std::swap(place.lit, lit_[0]);
    place.lit.seen.color = color_of_plane(lane);
}

/// As plane_color() of dsp_kernels/trace.hpp.
std::array<float, 3> TileTracer::color_of_plane(const Lane& lane) {
    kernels::Search<double> search = constants_.search;
    search.ray = to_node(lane.ray);
    search.start = lane.ray.start;
    kernels::Beam<Node> beam(node_, search);
    const double finer = std::sqrt(beam.share_of_place());
    glm::dvec3 color{0.0};
    double places = 0;
    for (std::uint32_t i = 0; i < beam.places(); ++i) {
        const kernels::Ray<double> ray = beam.ray_through(beam.place(i));
        kernels::PlaneHit<double> hit;
        if (!kernels::nearest_plane(node_, ray, search.start, kernels::far_away<double>, hit) ||
            hit.plane != lane.floor.plane) {
            continue;
        }
        const double p = finer * kernels::pixel_on_plane(node_, search.pixel, hit.t);
        color += to_glm(kernels::plane_surface(node_, ray, p, hit).color);
        places += 1;
    }
    return to_floats(to_node(color / places));
}

TileTracer::AreaPlace& TileTracer::next_area_place() {
    if (area_.size() == area_count_) area_.emplace_back();
    return area_[area_count_++];
}

/// What a pixel shows in mirrors is no more than the reference kernels have room for
/// (dsp_kernels/pending_rays.hpp): of more rays those that matter least are given up.
void TileTracer::forget_least_mirrors() {
    constexpr int most = kernels::PendingRays<double>::capacity;
    std::array<int, packet_rays> waiting{};
    for (const PendingRay& ray : pending_) ++waiting[static_cast<std::size_t>(ray.pixel)];
    for (int pixel = 0; pixel < packet_rays; ++pixel) {
        for (int& left = waiting[static_cast<std::size_t>(pixel)]; left > most; --left) {
            const auto share = [&](const PendingRay& ray) {
                return ray.pixel == pixel ? ray.share : std::numeric_limits<double>::infinity();
            };
            pending_.erase(std::ranges::min_element(pending_, {}, share));
        }
    }
}

/// Lights all that shows in the tile, one packet of shadow rays after another.
void TileTracer::light_area() {
    constexpr std::size_t most = packet_rays;
    for (std::size_t first = 0; first < area_count_; first += most) {
        lit_count_ = std::min(most, area_count_ - first);
        for (std::size_t i = 0; i < lit_count_; ++i) {
            lanes_[i] = area_[first + i].lane;
            std::swap(lit_[i], area_[first + i].lit);
            lit_[i].lane = static_cast<int>(i);
        }
        if (needs_shadows(scene_)) cast_shadows();
        for (std::size_t i = 0; i < lit_count_; ++i) add_light(lit_[i]);
    }
}

}  // namespace pxm::host::wide
