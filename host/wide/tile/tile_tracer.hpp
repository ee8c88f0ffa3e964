// What is seen through the pixels of an 8x8 tile, with shadows, mirrors, planes and samples: as
// dsp_kernels/trace.hpp, but a step is done for a whole packet of rays before the next one. Cells
// are found by packet_search; planes and textures are the reference kernels' own. A pixel with a
// ray that the search gives up, or a hit that is not confirmed in float, is rendered by the
// reference kernels from its beginning.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "dsp_kernels/pixel_program.hpp"
#include "host/compiled/compiled_scene.hpp"
#include "host/engine/frame.hpp"
#include "host/engine/statistics.hpp"
#include "host/engine/tiles.hpp"
#include "host/node_program/native_node.hpp"
#include "host/wide/area/area_search.hpp"
#include "host/wide/shade/shade_hits.hpp"
#include "host/wide/tile/reference_fallback.hpp"

namespace pxm::host::wide {

/// Calls `each(bit)` for the bits that are set.
template <class Each>
void for_bits(std::uint64_t bits, const Each& each) {
    for (; bits != 0; bits &= bits - 1) each(std::countr_zero(bits));
}

/// One thread's tools.
class TileTracer {
  public:
    /// `block` is the scene block in double. All must outlive the tracer.
    TileTracer(const CompiledScene& scene, const WideScene& wide, const ReferenceFallback& rest,
               const std::vector<std::uint32_t>& block);

    /// Renders those of the tile's pixels that lie in the frame.
    void render(Frame& frame, long left, long top, const GoOn& go_on);

    /// What the rays added up to since this was last asked.
    [[nodiscard]] RayStatistics finish() { return std::exchange(rays_, {}); }

  private:
    using Node = NativeNode<double>;
    using ClearPixel = void (*)(Node&, kernels::FrameConstants<double>&, kernels::Heap<Node>&,
                                std::uint32_t, std::uint32_t, kernels::PixelResult<double>&);

    enum class Kind { first_sample, sample, mirror };

    /// A ray of the packet: where it adds to, and how much.
    struct Lane {
        int pixel;  // of the tile
        double share;
        long bounces_left;
        LoneRay ray;  // of eye rays: if there are planes, or a place is to be known
        kernels::PlaneHit<double> floor;
    };
    /// A surface that a lane sees, and what of the lights reaches it.
    struct LitPlace {
        int lane;
        ShadedHit seen;
        float diffuse;
        float reflect;
        glm::dvec3 point;
        double pixel;  // p there
    };
    struct PendingRay {
        int pixel;
        double share;
        long bounces_left;
        LoneRay ray;
    };
    /// What a pixel has got so far.
    struct PixelSum {
        std::array<double, 3> color;
        double opacity;
        std::uint32_t tested;
        std::uint32_t light_rays;
        std::uint32_t mirror_rays;
    };

    /// A part of a pixel, and what is seen there (local covers by area).
    struct AreaPlace {
        Lane lane;
        LitPlace lit;
    };

    void render_plainly();
    void see_nothing();
    void render_area();
    void prepare_places();
    void aim_beams();
    void aim_beam(int pixel);
    void see_sights(int pixel);
    void see_sight_along(int cell, const LoneRay& ray, LitPlace& lit);
    void see_behind(int pixel, double left, Kind kind);
    [[nodiscard]] std::array<float, 3> color_of_plane(const Lane& lane);
    [[nodiscard]] AreaPlace& next_area_place();
    void light_area();
    void forget_least_mirrors();
    void aim(std::size_t sample);
    [[nodiscard]] LoneRay eye_ray(int pixel) const;
    void look(Kind kind);
    void look_into_mirrors();
    void meet_planes();
    void see(Kind kind, int lane);
    void see_cells_of(std::uint64_t lanes);
    void see_cell_in(Kind kind, int lane);
    [[nodiscard]] bool see_rest(Kind kind, int lane);
    void see_plane(Kind kind, int lane);
    void record_cell(const ShadedHit& seen, double t, PixelRecord& pixel) const;
    void cast_shadows();
    [[nodiscard]] bool shadow_ray(const LitPlace& place, const CompiledLight& light, LoneRay& ray);
    [[nodiscard]] bool is_in_shadow_of_rest(const LoneRay& ray, int pixel);
    void search_shadows(std::size_t light);
    [[nodiscard]] std::array<float, 3> color_of(const LitPlace& place) const;
    void add_light(const LitPlace& place);
    void mirror(const Lane& lane, const LitPlace& place, double share);
    void store();
    void render_clearly(int pixel, std::uint32_t tested);

    [[nodiscard]] double length_at(int lane, double depth) const;
    [[nodiscard]] double depth_at(int lane, double length) const;
    [[nodiscard]] PixelRecord& pixel_at(int pixel) {
        return frame_->at(left_ + pixel % tile_side, top_ + pixel / tile_side);
    }
    void give_up(int pixel) { unclear_ |= std::uint64_t{1} << pixel; }

    RayStatistics rays_;
    const CompiledScene& scene_;
    const WideScene& wide_;
    const std::vector<std::uint32_t>& block_;
    Frame* frame_ = nullptr;  // of the tile
    Node node_;
    kernels::Heap<Node> heap_;
    kernels::FrameConstants<double> constants_;
    kernels::PixelResult<double> result_;
    ClearPixel clear_pixel_;
    bool needs_all_rays_;  // there are planes, or objects of the reference kernels
    bool needs_rays_;      // there are planes, shadows or mirrors
    bool is_plain_;        // render_plainly() will do
    std::optional<FallbackSearch> rest_;
    std::array<PixelRecord, packet_rays> nothing_seen_;  // of a tile
    Workspace work_;
    long left_ = 0;  // of the tile
    long top_ = 0;
    glm::dvec2 place_{0.5};  // of the present sample
    std::array<Lane, packet_rays> lanes_;
    std::array<ShadedHit, packet_rays> seen_;  // of each lane that has found a cell
    std::uint64_t confirmed_ = 0;              // they are right
    std::array<LitPlace, packet_rays> lit_;
    std::size_t lit_count_ = 0;
    std::array<PixelSum, packet_rays> sums_;
    std::uint64_t unclear_ = 0;  // pixels that the reference kernels are to render
    std::vector<PendingRay> pending_;
    std::vector<LoneRay> batch_;
    std::vector<std::pair<std::size_t, LoneRay>> shadows_;  // of a lit place
    std::unique_ptr<BeamWorkspace> beams_;                  // local covers by area
    std::vector<AreaPlace> area_;                           // of the tile
    std::size_t area_count_ = 0;
};

}  // namespace pxm::host::wide
