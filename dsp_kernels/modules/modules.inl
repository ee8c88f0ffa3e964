// The modules of the node program, a section each: its heading, the headers that it is made of, and
// the functions that it holds, as explicit instantiations inside namespace pxm::kernels. So there
// is no second text of a kernel. tools/measure_modules compiles every section by itself and
// measures it; nothing of this is linked into pxm (docs/program-memory.md).

// Module "beam": local covers by area, one search for all places in a pixel.
#include "dsp_kernels/beam.hpp"
template void Beam<Node>::look(Heap<Node>&, SearchCounts&, SightList<float>&) noexcept;
template Ray<float> Beam<Node>::ray_through(const Vec3<float>&) noexcept;

// Module "box": bounding boxes along the axes.
#include "dsp_kernels/volume.hpp"
template std::optional<Interval<float>> intersect_box(Node&, const Ray<float>&,
                                                      std::uint32_t) noexcept;
template Vec3<float> box_normal(Node&, const Ray<float>&, Side, std::uint32_t) noexcept;

// Module "camera": eye rays of any projection.
#include "dsp_kernels/camera.hpp"
template Ray<float> eye_ray(Node&, std::uint32_t, std::uint32_t, std::uint32_t) noexcept;

// Module "cone": bounding cones.
#include "dsp_kernels/volume.hpp"
template std::optional<Interval<float>> intersect_cone(Node&, const Ray<float>&,
                                                       std::uint32_t) noexcept;
template Vec3<float> cone_normal(Node&, const Ray<float>&, Side, std::uint32_t) noexcept;

// Module "covers": local covers and translucent volumes (Ch. 18).
#include "dsp_kernels/trace.hpp"
template Ray<float> shrunk_for_covers(Node&, const Search<float>&, const Cell<float>&) noexcept;
template void covers_along(Node&, const Search<float>&, const Cell<float>*, Heap<Node>&,
                           SearchCounts&, const CollectCovers<Node>&) noexcept;
template void covers_along(Node&, const Search<float>&, const Cell<float>*, Heap<Node>&,
                           SearchCounts&, const DimLight<Node>&) noexcept;

// Module "cylinder": bounding cylinders.
#include "dsp_kernels/volume.hpp"
template std::optional<Interval<float>> intersect_cylinder(Node&, const Ray<float>&,
                                                           std::uint32_t) noexcept;
template Vec3<float> cylinder_normal(Node&, const Ray<float>&, Side, std::uint32_t) noexcept;

// Module "descend": from an object to its outermost cell, from a cell to those inside it.
#include "dsp_kernels/descend.hpp"
template void approach(Node&, Cell<float>&) noexcept;
template bool meet(Node&, const Search<float>&, Cell<float>&, float, float) noexcept;
template void outermost_cell(Node&, const Search<float>&, std::uint32_t, Cell<float>&) noexcept;
template void child_cell(Node&, const Search<float>&, const Cell<float>&, std::uint32_t,
                         Cell<float>&, Linear<float>*) noexcept;
template std::uint32_t map_from(Node&, std::uint32_t, std::uint32_t) noexcept;
template Ending ending(Node&, const Search<float>&, const Cell<float>&) noexcept;
template float pixel_at(Node&, const Search<float>&, std::uint32_t, float) noexcept;
template bool at_last_level(Node&, const Cell<float>&) noexcept;
template bool is_polar(Node&, std::uint32_t) noexcept;
template float cell_diameter(Node&, const Cell<float>&) noexcept;
template std::optional<Interval<float>> intersect_volume(Node&, const Ray<float>&,
                                                         std::uint32_t) noexcept;

// Module "flatness": flat cells inside lifted singular maps.
#include "dsp_kernels/flatness.hpp"
template void keep_thickness(Node&, const Search<float>&, const Cell<float>&, std::uint32_t,
                             Cell<float>&) noexcept;

// Module "heap": the bounded heap of cells (Def. 12.1).
#include "dsp_kernels/heap.hpp"
template bool before(Node&, const Cell<float>&, const Cell<float>&) noexcept;
template std::uint32_t cell_words(const Cell<float>&) noexcept;
template void copy_cell(Cell<float>&, const Cell<float>&) noexcept;
template void move_cell(Node&, Cell<float>&, const Cell<float>&) noexcept;
template Heap<Node>::Heap(Node&) noexcept;
template void Heap<Node>::push(const Cell<float>&) noexcept;
template void Heap<Node>::pop(Cell<float>&) noexcept;
template void Heap<Node>::keep(std::uint32_t, const Cell<float>&) noexcept;
template void Heap<Node>::fetch(std::uint32_t, Cell<float>&) noexcept;

// Module "hull": bounding polytopes.
#include "dsp_kernels/volume.hpp"
template std::optional<Interval<float>> intersect_hull(Node&, const Ray<float>&,
                                                       std::uint32_t) noexcept;
template Vec3<float> hull_normal(Node&, const Ray<float>&, Side, std::uint32_t) noexcept;

// Module "illuminate": Lambert's law (Eq. 17.1).
#include "dsp_kernels/lights.hpp"
template float facing(Node&, const Vec3<float>&, const Vec3<float>&) noexcept;

// Module "intersect": the search for the first cell along a ray (Alg. 12.4).
#include "dsp_kernels/first_cell.hpp"
template void push_objects(Node&, const Search<float>&, Heap<Node>&, SearchCounts&) noexcept;
template void count_heap(const Heap<Node>&, SearchCounts&) noexcept;
template void push_children(Node&, const Search<float>&, const Cell<float>&, Heap<Node>&,
                            SearchCounts&) noexcept;
template SearchResult<float> intersect(Node&, const Search<float>&, Heap<Node>&,
                                       SearchCounts&) noexcept;

template SearchResult<float> first_cell(Node&, const Search<float>&, Heap<Node>&,
                                        SearchCounts&) noexcept;

// Module "intersect_fast": the search for systems of homotheties (Ch. 13).
#include "dsp_kernels/intersect_fast.hpp"
template ProjectedRay<float> project_ray(Node&, const Search<float>&, std::uint32_t,
                                         ProjectedCell<float>&) noexcept;
template bool include_point(Node&, ProjectedCell<float>&, float, float) noexcept;
template void project_child(Node&, const ProjectedRay<float>&, const ProjectedCell<float>&,
                            const Vec3<float>&, std::uint32_t, ProjectedCell<float>&) noexcept;
template Ending ending(Node&, const Search<float>&, const ProjectedRay<float>&,
                       const ProjectedCell<float>&) noexcept;
template void as_cell(Node&, const ProjectedRay<float>&, const ProjectedCell<float>&,
                      const CellWord&, Cell<float>&) noexcept;
template bool push_projected(Node&, const ProjectedRay<float>&, const ProjectedCell<float>&,
                             const CellWord&, ProjectedStack<Node>&, SearchCounts&) noexcept;
template FastEnd search_object(Node&, const Search<float>&, std::uint32_t, std::uint64_t,
                               SearchResult<float>&, SearchCounts&) noexcept;
template SearchResult<float> intersect_fast(Node&, const Search<float>&, Heap<Node>&,
                                            SearchCounts&) noexcept;

// Module "mirror": mirror rays (Sec. 15.3).
#include "dsp_kernels/reflection.hpp"
template Search<float> mirrored(Node&, const Search<float>&, const Vec3<float>&, float,
                                const Vec3<float>&) noexcept;

// Module "next_after": the search that finishes the rays whose heap overflowed.
#include "dsp_kernels/next_after.hpp"
template void next_after(Node&, const Search<float>&, Heap<Node>&, const Sought<float, SolidRule>&,
                         SearchResult<float>&, SearchCounts&) noexcept;
template bool CellPath<Node>::start(std::uint32_t) noexcept;
template bool CellPath<Node>::down(std::uint32_t) noexcept;
template std::uint32_t CellPath<Node>::up() noexcept;

// Module "oriented": bounding boxes in axes of their own.
#include "dsp_kernels/volume.hpp"
template std::optional<Interval<float>> intersect_oriented(Node&, const Ray<float>&,
                                                           std::uint32_t) noexcept;
template Vec3<float> oriented_normal(Node&, const Ray<float>&, Side, std::uint32_t) noexcept;

// Module "orthographic": eye rays of an orthographic view.
#include "dsp_kernels/camera.hpp"
template Ray<float> orthographic_ray(Node&, const Vec3<float>&, const Vec3<float>&) noexcept;

// Module "perspective": eye rays of a perspective view.
#include "dsp_kernels/camera.hpp"
template Ray<float> perspective_ray(Node&, const Vec3<float>&, const Vec3<float>&) noexcept;

// Module "pixel_program": what is the same for all pixels.
#include "dsp_kernels/pixel_program.hpp"
template FrameConstants<float> read_frame_constants(Node&) noexcept;

// Module "plane": planes: where a ray meets the nearest, and what it looks like.
#include "dsp_kernels/plane.hpp"
template bool nearest_plane(Node&, const Ray<float>&, float, float, PlaneHit<float>&) noexcept;
template Surface<float> plane_surface(Node&, const Ray<float>&, float,
                                      const PlaneHit<float>&) noexcept;

// Module "point_light": point lights on the cells of a path (Sec. 17.3).
#include "dsp_kernels/lights.hpp"
template Vec3<float> direction_to_point_light(Node&, const Vec3<float>&,
                                              const Vec3<float>&) noexcept;
template float facing_point_light(Node&, const LitPlace<float>&, const Vec3<float>&,
                                  ShadingMode) noexcept;

// Module "polar": Lipschitz constants by polar decomposition (Sec. 16.2).
#include "dsp_kernels/descend.hpp"
template float largest_singular_value(Node&, const Linear<float>&) noexcept;
template void complete_child(Node&, const Cell<float>&, std::uint32_t, Cell<float>&) noexcept;

// Module "shade": hierarchical shading (Ch. 17).
#include "dsp_kernels/shade.hpp"
template Surface<float> surface_at(Node&, const Sighting<float>&, ShadingMode) noexcept;
template Vec3<float> volume_normal(Node&, const Ray<float>&, float, Side, std::uint32_t) noexcept;
template float outermost_diameter(Node&, const Search<float>&, std::uint32_t) noexcept;
template void PathSum<Node>::add(Node&, const Vec3<float>&, float) noexcept;
template Vec3<float> blend(Node&, const Vec3<float>&, std::uint32_t) noexcept;
template Vec3<float> cell_normal(Node&, const Cell<float>&, float, Side,
                                 const Linear<float>&) noexcept;

// Module "shadow": shadow rays (Sec. 15.2).
#include "dsp_kernels/shadow.hpp"
template Search<float> search_to_light(Node&, const Search<float>&, const Vec3<float>&, float,
                                       const Vec3<float>&) noexcept;

// Module "shadow_point": shadow rays from point lights (Sec. 15.2).
#include "dsp_kernels/shadow.hpp"
template Search<float> search_from_light(Node&, const Search<float>&, const Vec3<float>&, float,
                                         const Vec3<float>&) noexcept;

// Module "sphere": bounding spheres.
#include "dsp_kernels/volume.hpp"
template std::optional<Interval<float>> intersect_sphere(Node&, const Ray<float>&,
                                                         std::uint32_t) noexcept;
template Vec3<float> sphere_normal(Node&, const Ray<float>&, float, std::uint32_t) noexcept;

// Module "steepness": rays on their way into cells of maps that squash much.
#include "dsp_kernels/steepness.hpp"
template void enter_steep(Node&, const Cell<float>&, std::uint32_t, Cell<float>&,
                          Linear<float>*) noexcept;

// Module "texture": the textures of a plane, in spots along a pixel's footprint.
#include "dsp_kernels/texture.hpp"
template Footprint<float> footprint(Node&, const Vec3<float>&, const Vec3<float>&, float) noexcept;
template Place<float> place_of(Node&, float) noexcept;
template Vec3<float> texture_color(Node&, std::uint32_t, const Spot<float>&) noexcept;
template Vec3<float> layer_color(Node&, std::uint32_t, const Vec3<float>&,
                                 const Footprint<float>&) noexcept;

// Module "texture_image": pictures as textures.
#include "dsp_kernels/texture_image.hpp"
template Vec3<float> texel(Node&, std::uint32_t) noexcept;
template Vec3<float> image_level(Node&, std::uint32_t, float, float) noexcept;
template Vec3<float> image_color(Node&, std::uint32_t, const Spot<float>&) noexcept;

// Module "texture_inclusion": flat attractors as textures (Alg. 7.2).
#include "dsp_kernels/texture_inclusion.hpp"
template Vec2<float> times(Node&, const Vec2<float>&, const Vec2<float>*) noexcept;
template float largest_stretch(Node&, const PointCell<float>&) noexcept;
template bool outermost_point_cell(Node&, std::uint32_t, const Spot<float>&, PointCell<float>&,
                                   ToSpot<float>&) noexcept;
template Vec3<float> inclusion_color(Node&, std::uint32_t, const Spot<float>&) noexcept;

// Module "texture_wood": woodgrain, and the noise it is made of.
#include "dsp_kernels/texture_wood.hpp"
template std::uint32_t scramble(Node&, std::uint32_t, std::uint32_t, std::uint32_t) noexcept;
template float noise(Node&, float, float, std::uint32_t) noexcept;
template float share_in_stripes(Node&, float, float, float) noexcept;
template float ring_darkness(Node&, float, float) noexcept;
template float board_darkness(Node&, const BoardSpot<float>&) noexcept;
template Vec3<float> wood_color(Node&, std::uint32_t, std::uint32_t, std::uint32_t,
                                const Spot<float>&) noexcept;

// Module "trace": the loop over pixels and the first cell of each eye ray.
#include "dsp_kernels/modules/pixel_store.hpp"
template void pixel_program<plain_features>(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel<plain_features>(Node&, FrameConstants<float>&, Heap<Node>&,
                                           std::uint32_t, std::uint32_t,
                                           PixelResult<float>&) noexcept;

// Module "trace_all": the same with local covers, shadows and mirrors.
#include "dsp_kernels/modules/pixel_store.hpp"
template void pixel_program<all_features>(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel<all_features>(Node&, FrameConstants<float>&, Heap<Node>&, std::uint32_t,
                                         std::uint32_t, PixelResult<float>&) noexcept;

// Module "trace_area": the same with local covers by area, shadows and mirrors.
#include "dsp_kernels/modules/pixel_store.hpp"
template void pixel_program<area_features>(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel<area_features>(Node&, FrameConstants<float>&, Heap<Node>&, std::uint32_t,
                                          std::uint32_t, PixelResult<float>&) noexcept;

// Module "trace_rays": the same with shadows and mirrors.
#include "dsp_kernels/modules/pixel_store.hpp"
template void pixel_program<ray_features>(Node&, const PixelShare&, const PixelStore&) noexcept;
template void render_pixel<ray_features>(Node&, FrameConstants<float>&, Heap<Node>&, std::uint32_t,
                                         std::uint32_t, PixelResult<float>&) noexcept;

// Module "vectors": vectors, affine maps and rays, which every other module calls.
#include "dsp_kernels/ray.hpp"
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
