// Tiles of scenes with one ray a pixel, cells and lights alone: nothing is to be added up.
#include <algorithm>
#include <bit>

#include "host/node_program/instances.hpp"
#include "host/wide/tile/tile_tracer.hpp"

namespace pxm::host::wide {

void TileTracer::render_plainly() {
    place_ = scene_.samples[0];
    aim_at_tile(work_.packet, scene_.camera, frame_->crop, {left_, top_}, place_);
    const std::uint64_t inside = work_.packet.inside;  // shadows are a packet of their own
    const auto objects = static_cast<std::uint32_t>(wide_.objects.size());
    if (!search_packet(wide_, work_)) {
        if (inside == ~std::uint64_t{0}) return see_nothing();
        work_.clear_found();
    }
    lit_count_ = 0;
    std::uint64_t tested = 0;
    see_cells_of(inside);
    for_bits(inside, [&](int i) {
        const Found& found = work_.found[static_cast<std::size_t>(i)];
        PixelRecord& pixel = pixel_at(i);
        pixel.node = static_cast<std::uint16_t>(i);
        pixel.volumes = objects + found.tested;
        tested += pixel.volumes;
        if (found.given_up) {
            give_up(i);
        } else if (found.start < 0) {
            std::ranges::copy(wide_.background, pixel.color);
        } else {
            lanes_[static_cast<std::size_t>(i)].pixel = i;
            lanes_[static_cast<std::size_t>(i)].share = 1;
            sums_[static_cast<std::size_t>(i)] = {};
            see_cell_in(Kind::first_sample, i);
        }
    });
    if (needs_shadows(scene_)) cast_shadows();
    for (std::size_t k = 0; k < lit_count_; ++k) {
        PixelRecord& pixel = pixel_at(lit_[k].lane);
        const PixelSum& sum = sums_[static_cast<std::size_t>(lit_[k].lane)];
        std::ranges::copy(color_of(lit_[k]), pixel.color);
        pixel.alpha = 1;
        pixel.volumes += sum.tested;
        tested += sum.tested;
        if ((unclear_ >> lit_[k].lane & 1) != 0) continue;  // gather_pixel() counts them
        rays_.light_rays += sum.light_rays;
        ++rays_.hits;
    }
    const auto pixels = static_cast<std::uint64_t>(std::popcount(inside & ~unclear_));
    rays_.pixels += pixels;
    rays_.eye_rays += pixels;
    rays_.volumes_tested += tested;
    for_bits(inside & unclear_, [&](int i) {
        rays_.volumes_tested -= pixel_at(i).volumes;
        render_clearly(i, pixel_at(i).volumes - objects);
    });
}

/// A whole tile of background.
void TileTracer::see_nothing() {
    for (int row = 0; row < tile_side; ++row) {
        std::copy_n(&nothing_seen_[static_cast<std::size_t>(row * tile_side)], tile_side,
                    &frame_->at(left_, top_ + row));
    }
    rays_.pixels += packet_rays;
    rays_.eye_rays += packet_rays;
    rays_.volumes_tested += packet_rays * wide_.objects.size();
}

}  // namespace pxm::host::wide
