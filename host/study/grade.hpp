// How a render of the stability study did.
#pragma once

#include <cstddef>
#include <vector>

#include "host/render/alarms.hpp"
#include "host/study/deviation.hpp"

namespace pxm::host {

inline constexpr double right_share = 0.001;    // of wrong pixels: design decision 4
inline constexpr double degraded_share = 0.02;  // more is a failure

/// The deviation's wrong pixels, and those whose reference was given up: nobody knows what they
/// show.
[[nodiscard]] std::vector<char> wrong_pixels(const Deviation& deviation,
                                             const RenderResult& reference);
/// How many of the pixels are marked.
[[nodiscard]] double share_of(const std::vector<char>& marks);
/// Of all pixels, those that are wrong and have no alarm of their own.
[[nodiscard]] double missed_share(const RenderResult& picture, std::vector<char> wrong);
/// Of an alarm of pixels: how many have it, and how many of those are wrong.
struct AlarmedPixels {
    std::size_t pixels = 0;
    std::size_t wrong = 0;
};
[[nodiscard]] AlarmedPixels alarmed_pixels(const RenderResult& picture,
                                           const std::vector<char>& wrong, PixelAlarm alarm);
/// `right`, `degraded`, `reported` or `silent`.
[[nodiscard]] const char* grade_of(double wrong_share, bool alarmed);

}  // namespace pxm::host
