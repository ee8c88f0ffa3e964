// Systems whose maps stretch along the axes, each of them least along the same axis and most along
// the same other one: carpets and sponges [BM84] [LG92] [KP96]. A box that a long thin cell crosses
// sees the maps' images along the longer axes alone, so that boxes hold equal shares of a measure
// only if its probabilities are those of images along fewer axes, the thinner a cell is.
#pragma once

#include <optional>
#include <vector>

#include "host/fractal/bounds/bounds.hpp"
#include "host/fractal/system/rifs.hpp"

namespace pxm::host {

struct Layers {
    std::vector<int> axes;  // along which the attractor extends, the one of the longest sides first
    /// By how many of these a cell is long, less one: the maps' probabilities.
    std::vector<std::vector<double>> choice;
};

/// Nothing where maps turn, or are similitudes, or their order of axes differs.
[[nodiscard]] std::optional<Layers> layers_of(const Rifs& rifs, const std::vector<Bounds>& bounds);

}  // namespace pxm::host
