// How many pixels of two pictures a person would tell apart (H. Yee's measure, in OpenImageIO).
#pragma once

#include "host/render/frame.hpp"

namespace pxm::host {

/// A share of the pixels, 0..1. The frames are of one size.
[[nodiscard]] double perceived_difference(const Frame& a, const Frame& b);

}  // namespace pxm::host
