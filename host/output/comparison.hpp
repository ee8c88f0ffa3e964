// How much two renders of the same picture differ (`pxm compare`).
#pragma once

#include <string>

#include "host/output/image.hpp"

namespace pxm::host {

/// Shares are of all pixels, 0..1. What a file has no channel for is -1.
struct Comparison {
    double hits = -1;         // one hits, the other does not (Z)
    double words = -1;        // both hit, different cells (object, word)
    double depths = -1;       // both hit, more than one pixel apart (Z)
    double worst_depth = -1;  // largest distance, in pixels
    double colors = 0;        // a channel differs by more than 1/255; with words: of equal cells
    double rmse = 0;          // of colour, over R, G, B
    double different = 0;     // hits, depths or colours differ: what --tolerance is held against
};

/// Throws Error(ExitCode::file) when the sizes or colour channels do not match.
[[nodiscard]] Comparison compare_images(const LoadedImage& a, const LoadedImage& b);

}  // namespace pxm::host
