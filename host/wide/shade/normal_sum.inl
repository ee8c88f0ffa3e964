// What adds up along a path of cells (Ch. 17): weights, normals, and how much they face a light. As
// dsp_kernels/shade.hpp and lights.hpp.
#if defined(PXM_HOST_WIDE_SHADE_NORMAL_SUM_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PXM_HOST_WIDE_SHADE_NORMAL_SUM_INL
#undef PXM_HOST_WIDE_SHADE_NORMAL_SUM_INL
#else
#define PXM_HOST_WIDE_SHADE_NORMAL_SUM_INL
#endif

#include <hwy/highway.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "host/wide/shade/path.inl"

HWY_BEFORE_NAMESPACE();
namespace pxm::host::wide::HWY_NAMESPACE {

/// How cells are weighted along a path (Eqs. 17.4 to 17.6).
struct PathWeights {
    kernels::ShadingMode mode;
    float outermost;  // diameter

    [[nodiscard]] float of(float diameter) const {
        if (mode == kernels::ShadingMode::low_pass) return diameter;               // Eq. 17.5
        if (mode == kernels::ShadingMode::high_pass) return outermost - diameter;  // Eq. 17.6
        return 1;                                                                  // Eq. 17.4
    }
};

/// The total normal of one ray, level by level.
struct PathWalk {
    glm::vec3 weighted{0};  // sum of the normals, by their weights
    glm::vec3 plain{0};     // the same, each counted once
    float total = 0;        // of the weights

    void add(const glm::vec3& normal, float weight) {
        weighted += weight * normal;
        plain += normal;
        total += weight;
    }
    /// Eq. 17.3. When all weights vanish, they are all 1 (Erratum 18).
    [[nodiscard]] glm::vec3 normal() const {
        const glm::vec3 sum = total > 0 ? weighted : plain;
        return sum / std::sqrt(glm::dot(sum, sum));
    }
};

/// How much a place faces a point light: the weighted mean over the cells of its path, each by
/// itself (Eq. 17.3 in full, as dsp_kernels/lights.hpp). `light` in the packet's frame.
class PointLightSum {
  public:
    PointLightSum(const RayPacket& packet, int ray, const glm::dvec3& light)
        : packet_(packet), ray_(ray), light_(light) {}
    /// A cell that the ray enters at depth z.
    void add(const glm::vec3& normal, double z, float weight) {
        const auto at = [&](const float* constant, const float* growing) {
            return static_cast<double>(constant[ray_]) + static_cast<double>(growing[ray_]) * z;
        };
        const glm::dvec3 point{at(packet_.u0, packet_.u1), at(packet_.v0, packet_.v1), z};
        const glm::vec3 toward{glm::normalize(light_ - point)};
        const float cosine = std::max(0.0F, glm::dot(normal, toward));
        weighted_ += weight * cosine;
        plain_ += cosine;
        total_ += weight;
        ++count_;
    }
    [[nodiscard]] float mean() const {
        return total_ > 0 ? weighted_ / total_ : plain_ / static_cast<float>(count_);
    }

  private:
    const RayPacket& packet_;
    int ray_;
    glm::dvec3 light_;
    float weighted_ = 0;
    float plain_ = 0;
    float total_ = 0;
    int count_ = 0;
};

/// How much a place faces the lights (Eq. 17.1); `lamp` says it of a point light.
template <class Lamp>
inline void face_lights(const WideScene& scene, const glm::vec3& normal, ShadedHit& seen,
                        const Lamp& lamp) {
    seen.facing.resize(scene.lights.size());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const CompiledLight& light = scene.lights[i];
        seen.facing[i] = light.kind == kernels::LightKind::directional
                             ? std::max(0.0F, glm::dot(normal, glm::vec3{light.place}))
                             : lamp(light);
    }
}

/// The packet's frame to scene units.
inline glm::vec3 to_scene(const RayPacket& packet, const glm::vec3& v) {
    return glm::vec3{packet.axis[0]} * v.x + glm::vec3{packet.axis[1]} * v.y +
           glm::vec3{packet.axis[2]} * v.z;
}

inline glm::dvec3 to_frame(const RayPacket& packet, const glm::dvec3& v) {
    return {glm::dot(v, packet.axis[0]), glm::dot(v, packet.axis[1]), glm::dot(v, packet.axis[2])};
}

}  // namespace pxm::host::wide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
