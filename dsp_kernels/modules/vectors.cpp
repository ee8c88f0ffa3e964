// Module "vectors" of the node program: vectors, affine maps and rays, which every other module
// calls. Measured by tools/measure_modules, never linked into pxm (docs/program-memory.md).
#include "dsp_kernels/modules/measured_node.hpp"
#include "dsp_kernels/ray.hpp"

namespace pxm::kernels {

template float dot(Node&, const Vec3<float>&, const Vec3<float>&) noexcept;
template Vec3<float> subtract(Node&, const Vec3<float>&, const Vec3<float>&) noexcept;
template Vec3<float> add_scaled(Node&, const Vec3<float>&, float, const Vec3<float>&) noexcept;
template Vec3<float> scale(Node&, float, const Vec3<float>&) noexcept;
template Vec3<float> normalize(Node&, const Vec3<float>&) noexcept;
template Vec3<float> read_vector(Node&, std::uint32_t) noexcept;
template Vec3<float> transform_point(Node&, const Vec3<float>&, const AffineMap<float>&) noexcept;
template Vec3<float> transform_direction(Node&, const Vec3<float>&, const Linear<float>&) noexcept;
template Vec3<float> transform_normal(Node&, const Vec3<float>&, const Linear<float>&) noexcept;
template Linear<float> compose(Node&, const Linear<float>&, const Linear<float>&) noexcept;
template Linear<float> read_linear(Node&, std::uint32_t) noexcept;
template AffineMap<float> read_affine(Node&, std::uint32_t) noexcept;
template Ray<float> transform_ray(Node&, const Ray<float>&, const AffineMap<float>&) noexcept;
template Vec3<float> point_at(Node&, const Ray<float>&, float) noexcept;
template Ray<float> rebase(Node&, const Ray<float>&, const Vec3<float>&) noexcept;

}  // namespace pxm::kernels
