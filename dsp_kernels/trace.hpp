// What is seen along an eye ray: cells, or local covers, shaded and shadowed, and what mirrors
// show. A mirror adds a ray to a short list instead of a call inside the call: the stack of a node
// has a bound. Node code: no allocation, no exceptions.
#pragma once

#include <type_traits>

#include "dsp_kernels/beam.hpp"
#include "dsp_kernels/cover_list.hpp"
#include "dsp_kernels/first_cell.hpp"
#include "dsp_kernels/lights.hpp"
#include "dsp_kernels/pending_rays.hpp"
#include "dsp_kernels/pixel_result.hpp"
#include "dsp_kernels/reflection.hpp"
#include "dsp_kernels/shadow.hpp"

namespace pxm::kernels {

/// A member that only some tracers have.
struct Nothing {};
/// `Member`, or nothing that takes room.
template <bool wanted, class Member>
using OnlyIf = std::conditional_t<wanted, Member, Nothing>;

/// Traces one eye ray and what follows from it.
template <Features features, NodeLike Node>
class Tracer {
  public:
    using Real = typename Node::Real;  // of the node

    /// Adds to `result`; all must outlive it.
    Tracer(Node& node, const FrameConstants<Real>& frame, Heap<Node>& heap,
           PixelResult<Real>& result) noexcept
        : node_(node), frame_(frame), heap_(heap), result_(result) {}

    /// Adds `share` of what is seen along the ray to the result.
    void trace(const Search<Real>& eye, Real share, Sample sample) noexcept {
        sample_ = sample;
        node_.tally(Operation::multiply_add, 1);
        least_ = share * least_share<Real>;
        PendingRay<Real> ray{eye, share, frame_.bounces};
        look_along(ray, RayKind::eye);
        if constexpr (features.mirrors) {
            while (!pending_.empty()) {
                node_.tally(Operation::loop_turn, 1);
                ++result_.rays.reflect;
                ray = pending_.pop();
                look_along(ray, RayKind::mirror);
            }
        }
    }

  private:
    /// Front to back (Eqs. 18.5, 18.6): `share` is the part of the ray still unaccounted for.
    void look_along(PendingRay<Real>& ray, RayKind kind) noexcept {
        watch_ray(node_, kind, ray.search);
        kind_ = kind;
        most_ = Real(0);
        PlaneHit<Real> floor;
        if (meets_plane(ray.search, floor)) ray.search.end = floor.t;
        if constexpr (features.covers) {
            look_through_covers(ray);
        } else if constexpr (features.area) {
            if (kind == RayKind::eye) {
                look_over_area(ray);
            } else {
                look_at_first(ray);
            }
        } else {
            look_at_first(ray);
        }
        if (!(Real(0) < ray.share)) return;
        if (floor.plane != 0) return show_plane(ray, floor);
        result_.color = add_scaled(node_, result_.color, ray.share, frame_.background);
    }

    /// Whether there is a plane in the part of the ray that counts; if so, `hit` is the nearest.
    [[nodiscard]] bool meets_plane(const Search<Real>& search, PlaneHit<Real>& hit) noexcept {
        node_.tally(Operation::integer, 1);
        return frame_.planes > 0 && nearest_plane(node_, search.ray, search.start, search.end, hit);
    }

    void look_at_first(PendingRay<Real>& ray) noexcept {
        const SearchResult<Real> found = first_cell(node_, ray.search, heap_, result_.counts);
        if (found.outcome == Outcome::miss) return;
        show(ray, found.cell, found.shown, found.outcome);
        ray.share = Real(0);
    }

    void look_over_area(PendingRay<Real>& ray) noexcept {
        Beam<Node> beam(node_, ray.search);
        sights_.size = 0;
        beam.look(heap_, result_.counts, sights_);
        const bool complete = beam.is_complete();
        count_heap(heap_, result_.counts);
        const Real whole = ray.share;
        ray.share = complete ? whole * beam.left() : Real(0);
        for (std::uint32_t i = 0; i < sights_.size; ++i) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::multiply_add, 1);
            const Sight<Real>& sight = sights_.sights[i];
            PendingRay<Real> part = ray;
            part.share = whole * sight.share;
            part.search.ray = beam.ray_through(sight.place);
            show(part, sight.cell, {Real(1), 0}, Outcome::hit);
        }
        if (!complete) look_one_by_one(ray, beam, whole);
    }

    /// What one search did not reach: the places that are still open, each by a ray of its own.
    void look_one_by_one(PendingRay<Real>& ray, Beam<Node>& beam, Real whole) noexcept {
        ++result_.counts.restarts;
        for (std::uint32_t i = 0; i < beam.places(); ++i) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::compare_branch, 1);
            if (!(Real(0) < beam.left(i))) continue;
            node_.tally(Operation::multiply_add, 2);
            PendingRay<Real> one = ray;
            one.share = whole * beam.left(i) * beam.share_of_place();
            one.search.ray = beam.ray_through(beam.place(i));
            look_at_first(one);
            ray.share = ray.share + one.share;
        }
    }

    void look_through_covers(PendingRay<Real>& ray) noexcept {
        Cell<Real> last;
        bool more = true;
        for (const Cell<Real>* after = nullptr; more; after = &last) {
            node_.tally(Operation::loop_turn, 1);
            more = collect(ray, after);
            for (std::uint32_t i = 0; i < covers_.size; ++i) {
                node_.tally(Operation::loop_turn, 1);
                show_cover(ray, covers_.entries[i], !more && i + 1 == covers_.size);
            }
            if (more) move_cell(node_, last, covers_.entries[covers_.size - 1].cell);
        }
    }

    /// The next covers in order. False if there is nothing behind them to be seen.
    [[nodiscard]] bool collect(const PendingRay<Real>& ray, const Cell<Real>* after) noexcept {
        Real left = ray.share;
        covers_.size = 0;
        covers_along(node_, ray.search, after, heap_, result_.counts,
                     CollectCovers<Node>{node_, covers_, left, least_});
        opaque_ = left < least_;
        return !opaque_ && covers_.size == CoverList<Real>::capacity;
    }

    void show_cover(PendingRay<Real>& ray, const typename CoverList<Real>::Entry& cover,
                    bool last) noexcept {
        node_.tally(Operation::multiply_add, 2);
        PendingRay<Real> part = ray;
        part.share = last && opaque_ ? ray.share : ray.share * cover.shown.opacity;
        show(part, cover.cell, cover.shown, Outcome::hit);
        ray.share = ray.share - part.share;
    }

    /// Adds `ray.share` of a cell.
    void show(const PendingRay<Real>& ray, const Cell<Real>& cell, const Shown<Real>& shown,
              Outcome outcome) noexcept {
        const Sighting<Real> sighting{ray.search, cell, shown.map};
        LitPlace<Real> lit;
        lit.surface = surface_at(node_, sighting, frame_.shading);
        lit.point = point_at(node_, ray.search.ray, cell.key);
        lit.pixel = pixel_at(node_, ray.search, cell.object, cell.key);
        lit.sighting = &sighting;
        shade(ray, lit);
        if (!is_most(ray)) return;
        result_.found.outcome = outcome;
        result_.normal = lit.surface.normal;
        move_cell(node_, result_.found.cell, cell);
    }

    /// Adds `ray.share` of a plane, behind all else that shows.
    void show_plane(const PendingRay<Real>& ray, const PlaneHit<Real>& hit) noexcept {
        LitPlace<Real> lit;
        lit.pixel = pixel_on_plane(node_, ray.search.pixel, hit.t);
        lit.surface = plane_surface(node_, ray.search.ray, lit.pixel, hit);
        lit.point = point_at(node_, ray.search.ray, hit.t);
        lit.sighting = nullptr;
        if constexpr (features.area) {
            if (kind_ == RayKind::eye) lit.surface.color = plane_color(ray.search, hit);
        }
        shade(ray, lit);
        if (!is_most(ray)) return;
        result_.found.outcome = Outcome::miss;
        result_.floor = hit;
        result_.normal = lit.surface.normal;
    }

    /// The mean colour of the plane at the places of a pixel, each as fine as a sample's.
    [[nodiscard]] Vec3<Real> plane_color(const Search<Real>& search,
                                         const PlaneHit<Real>& hit) noexcept {
        Beam<Node> beam(node_, search);
        node_.tally(Operation::square_root, 1);
        const Real finer = square_root(beam.share_of_place());
        Vec3<Real> color{};
        Real places = Real(0);
        for (std::uint32_t i = 0; i < beam.places(); ++i) {
            node_.tally(Operation::loop_turn, 1);
            node_.tally(Operation::multiply_add, 2);
            const Ray<Real> ray = beam.ray_through(beam.place(i));
            PlaneHit<Real> there;
            const bool meets = nearest_plane(node_, ray, search.start, far_away<Real>, there);
            if (!meets || there.plane != hit.plane) continue;
            const Real pixel = finer * pixel_on_plane(node_, search.pixel, there.t);
            color =
                add_scaled(node_, color, Real(1), plane_surface(node_, ray, pixel, there).color);
            places = places + Real(1);
        }
        node_.tally(Operation::reciprocal, 1);
        return scale(node_, reciprocal(places), color);
    }

    /// Counts what was added along an eye ray; whether it is the largest share of the first one.
    [[nodiscard]] bool is_most(const PendingRay<Real>& ray) noexcept {
        if (kind_ != RayKind::eye) return false;
        result_.opacity = result_.opacity + ray.share;
        node_.tally(Operation::compare_branch, 1);
        if (sample_ != Sample::first || !(most_ < ray.share)) return false;
        most_ = ray.share;
        return true;
    }

    /// Adds a surface with its light, and asks for what it mirrors.
    void shade(const PendingRay<Real>& ray, const LitPlace<Real>& lit) noexcept {
        Real share = ray.share;
        if constexpr (features.mirrors) {
            node_.tally(Operation::compare_branch, 2);
            if (Real(0) < lit.surface.reflect && ray.bounces_left > 0) {
                node_.tally(Operation::multiply_add, 2);
                const Real mirror_share = share * lit.surface.reflect;
                share = share - mirror_share;
                pending_.push(
                    node_,
                    {mirrored(node_, ray.search, lit.point, lit.pixel, lit.surface.normal),
                     mirror_share, ray.bounces_left - 1},
                    least_);
            }
        }
        const Vec3<Real> color = illuminate(node_, lit, frame_.shading, [&](std::uint32_t light) {
            return light_share(ray.search, lit, light);
        });
        result_.color = add_scaled(node_, result_.color, share, color);
    }

    /// The share of a light that reaches a place.
    [[nodiscard]] Real light_share(const Search<Real>& eye, const LitPlace<Real>& lit,
                                   std::uint32_t light) noexcept {
        if constexpr (!features.shadows) return Real(1);
        using Light = LightRecord<real_words<Real>>;
        node_.tally(Operation::integer, 2);
        if (node_.shape_word(light + Light::shadow) == 0) return Real(1);
        ++result_.rays.light;
        const Vec3<Real> place = read_vector(node_, light + Light::place);
        const auto kind = static_cast<LightKind>(node_.shape_word(light + Light::kind));
        const Search<Real> search =
            kind == LightKind::directional
                ? search_to_light(node_, eye, lit.point, lit.pixel, place)
                : search_from_light(node_, eye, lit.point, lit.pixel, place);
        watch_ray(node_, RayKind::light, search);
        return transparency(search);
    }

    /// The share of a light that passes everything along a shadow ray.
    [[nodiscard]] Real transparency(const Search<Real>& search) noexcept {
        PlaneHit<Real> floor;
        if (meets_plane(search, floor)) return Real(0);
        if constexpr (features.covers) {
            Real left = Real(1);
            const Cell<Real>* from_start = nullptr;
            covers_along(node_, search, from_start, heap_, result_.counts,
                         DimLight<Node>{node_, left});
            return left < least_share<Real> ? Real(0) : left;
        } else {
            const auto found = first_cell(node_, search, heap_, result_.counts);
            return found.outcome == Outcome::miss ? Real(1) : Real(0);
        }
    }

    Node& node_;
    const FrameConstants<Real>& frame_;
    Heap<Node>& heap_;
    PixelResult<Real>& result_;
    [[no_unique_address]] OnlyIf<features.mirrors, PendingRays<Real>> pending_;
    [[no_unique_address]] OnlyIf<features.covers, CoverList<Real>> covers_;
    [[no_unique_address]] OnlyIf<features.area, SightList<Real>> sights_;
    bool opaque_ = false;  // nothing shows behind the covers in the list
    Sample sample_ = Sample::first;
    Real least_{};  // a share below it is not traced
    RayKind kind_ = RayKind::eye;
    Real most_{};  // the largest share of a cell on the eye ray
};

}  // namespace pxm::kernels
