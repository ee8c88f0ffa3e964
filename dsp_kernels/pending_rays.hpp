// The rays that mirrors add to an eye ray, a short list instead of a call inside the call.
// Node code: no allocation, no exceptions.
#pragma once

#include "dsp_kernels/search.hpp"

namespace pxm::kernels {

/// A share of an eye ray below this adds nothing that a picture could show; it is left to what is
/// in front.
template <class Real>
inline constexpr Real least_share = from_double<Real>(0x1p-9);

/// A ray still to be traced, and the share of it in the pixel.
template <class Real>
struct PendingRay {
    Search<Real> search;         // with the ray
    Real share;                  // of the pixel, 0 to 1
    std::uint32_t bounces_left;  // mirrors that it may still meet
};

/// The rays still to be traced. When there are too many, those that matter least are given up.
template <class Real>
class PendingRays {
  public:
    static constexpr std::uint32_t capacity = 8;                      // rays
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }  // whether no ray is left
    /// The last one that was pushed; Precondition: there is one.
    [[nodiscard]] PendingRay<Real> pop() noexcept { return rays_[--size_]; }
    /// Adds a ray unless its share is too small.
    template <NodeLike Node>
    void push(Node& node, const PendingRay<Real>& ray, Real least_share_of_ray) noexcept {
        node.tally(Operation::compare_branch, 1);
        if (ray.share < least_share_of_ray) return;
        if (size_ < capacity) {
            rays_[size_++] = ray;
            return;
        }
        std::uint32_t least = 0;
        for (std::uint32_t i = 1; i < capacity; ++i) {
            node.tally(Operation::loop_turn, 1);
            node.tally(Operation::compare_branch, 1);
            if (rays_[i].share < rays_[least].share) least = i;
        }
        if (rays_[least].share < ray.share) rays_[least] = ray;
    }

  private:
    PendingRay<Real> rays_[capacity];
    std::uint32_t size_ = 0;
};

}  // namespace pxm::kernels
