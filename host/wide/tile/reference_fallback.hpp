// The objects that the wide engine leaves to the reference kernels, in a scene that has others:
// each ray looks for their first cell no farther than for what it has found already.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "dsp_kernels/pixel_program.hpp"
#include "host/compiled/compiled_scene.hpp"
#include "host/node_program/native_node.hpp"
#include "host/wide/packet/ray_packet.hpp"
#include "host/wide/shade/hit.hpp"
#include "host/wide/tables/wide_scene.hpp"

namespace pxm::host::wide {

/// The scene of these objects; one for all threads.
struct ReferenceFallback {
    ReferenceFallback(const CompiledScene& whole, const WideScene& wide);

    CompiledScene scene;
    std::vector<std::uint32_t> block;  // in double; empty if there are no such objects
    std::vector<int> indices;          // of the objects, in the whole scene
};

/// What a ray sees of one of these objects, besides what it sees of other cells.
struct FallbackHit {
    double t;  // along the ray
    float diffuse;
    float reflect;
    double pixel;  // p there
};

/// One thread's searches.
class FallbackSearch {
  public:
    explicit FallbackSearch(const ReferenceFallback& rest);

    /// Whether the ray meets a cell between its start and `end`.
    [[nodiscard]] bool meets(const LoneRay& ray, double end);
    /// What was met; the cell's depth is left as it is. Precondition: meets() was true.
    [[nodiscard]] FallbackHit see(ShadedHit& seen);
    /// Volumes that the last call of meets() tested.
    [[nodiscard]] std::uint32_t tested() const {
        return static_cast<std::uint32_t>(counts_.volumes_tested);
    }
    [[nodiscard]] bool was_given_up() const { return counts_.capped > 0; }

  private:
    using Node = NativeNode<double>;

    const ReferenceFallback& rest_;
    Node node_;
    kernels::Heap<Node> heap_;
    kernels::FrameConstants<double> constants_;
    kernels::SearchResult<double> result_;
    kernels::SearchCounts counts_;
};

}  // namespace pxm::host::wide
