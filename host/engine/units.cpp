#include "host/engine/units.hpp"

#include <algorithm>

#include "host/engine/node_share.hpp"
#include "host/engine/tiles.hpp"

namespace pxm::host {

UnitGrid grid_of_tiles(const CropWindow& window, long part_side) {
    constexpr long most_side = 8 * tile_side;
    constexpr long wanted_units = 4096;
    const long pixels = (window.x1 - window.x0) * (window.y1 - window.y0);
    long side = most_side;
    while (side > tile_side && pixels < wanted_units * side * side) side /= 2;
    return {window, part_side, side, 0, 0};
}

std::vector<UnitPixels> units_of(const UnitGrid& grid) {
    std::vector<UnitPixels> units;
    const CropWindow& window = grid.window;
    if (grid.of_nodes()) {
        for (long row = 0; row < grid.node_rows; ++row)
            for (long column = 0; column < grid.node_columns; ++column)
                units.push_back({first_owned(window.x0, column, grid.node_columns),
                                 first_owned(window.y0, row, grid.node_rows), window.x1, window.y1,
                                 grid.node_columns, grid.node_rows});
        return units;
    }
    for (const TileBlock& block : blocks_of_side(window, grid.part_side, grid.part_side, grid.side))
        units.push_back(
            {std::max(block.x0, window.x0), std::max(block.y0, window.y0), block.x1, block.y1});
    return units;
}

}  // namespace pxm::host
