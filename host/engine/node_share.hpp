// Which pixels of a window a node of the machine owns.
#pragma once

namespace pxm::host {

/// The first coordinate at or after `from` that is congruent to `place` modulo `stride`.
[[nodiscard]] constexpr long first_owned(long from, long place, long stride) {
    const long behind = (from - place) % stride;
    return behind > 0 ? from + stride - behind : behind < 0 ? from - behind : from;
}

}  // namespace pxm::host
