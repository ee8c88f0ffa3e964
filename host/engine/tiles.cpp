#include "host/engine/tiles.hpp"

#include <algorithm>

namespace pxm::host {

std::vector<TileBlock> blocks_of_tiles(const CropWindow& window, long part, long band_rows,
                                       long threads) {
    constexpr long most_side = 8 * tile_side, least_side = 2 * tile_side;
    constexpr long blocks_a_thread = 16;
    const long pixels = (window.x1 - window.x0) * (window.y1 - window.y0);
    const long part_rows = std::min(part, band_rows);
    long side = std::min(part_rows, most_side);
    while (side / 2 >= least_side && pixels < blocks_a_thread * threads * side * side) side /= 2;
    return blocks_of_side(window, part, part_rows, side / tile_side * tile_side);
}

std::vector<TileBlock> blocks_of_side(const CropWindow& window, long part, long part_rows,
                                      long side) {
    const auto first_tile = [](long pixel) { return pixel / tile_side * tile_side; };
    std::vector<TileBlock> blocks;
    for (long part_y = window.y0 / part_rows * part_rows; part_y < window.y1; part_y += part_rows) {
        for (long part_x = window.x0 / part * part; part_x < window.x1; part_x += part) {
            for (long y = part_y; y < part_y + part_rows; y += side) {
                for (long x = part_x; x < part_x + part; x += side) {
                    const TileBlock block{std::max(x, first_tile(window.x0)),
                                          std::max(y, first_tile(window.y0)),
                                          std::min({x + side, part_x + part, window.x1}),
                                          std::min({y + side, part_y + part_rows, window.y1})};
                    if (block.x0 < block.x1 && block.y0 < block.y1) blocks.push_back(block);
                }
            }
        }
    }
    return blocks;
}

}  // namespace pxm::host
