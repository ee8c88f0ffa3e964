#include "tests/support/oracle.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "tests/support/crossing.hpp"

namespace pxm::test {

using namespace host;

namespace {

constexpr std::size_t room = 400'000;  // cells that are kept from ray to ray
constexpr double infinity = std::numeric_limits<double>::infinity();

/// T as the thesis writes it: the rows of the matrix are Affine::linear's entries.
Eigen::Matrix3d matrix_of(const Affine& map) {
    Eigen::Matrix3d t;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) t(row, column) = map.linear[row][column];
    }
    return t;
}

Eigen::RowVector3d row(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
glm::dvec3 vector(const Eigen::RowVector3d& v) { return {v(0), v(1), v(2)}; }

double largest_singular_value(const Affine& map) {
    return Eigen::JacobiSVD<Eigen::Matrix3d>(matrix_of(map)).singularValues()(0);
}

/// The ray in the coordinates of a cell, against the volume there (Eq. 12.3).
std::optional<Crossing> cross(const Sight& ray, const Affine& place, const Eigen::Matrix3d& back,
                              const CompiledVolume& volume) {
    const glm::dvec3 o = vector(row(ray.origin - place.translation) * back);
    const glm::dvec3 d = vector(row(ray.direction) * back);
    return cross_volume(o, d, volume);
}

}  // namespace

bool comes_before(const TerminalCell& a, const TerminalCell& b) {
    return std::tie(a.key, a.object, a.word) < std::tie(b.key, b.object, b.word);
}

Oracle::Oracle(const CompiledScene& scene, double smallest_share, long patience)
    : scene_(scene), smallest_share_(smallest_share), patience_(patience) {
    for (const CompiledShape& shape : scene.shapes) {
        map_lips_.emplace_back();
        for (const CompiledMap& map : shape.maps) {
            map_lips_.back().push_back(largest_singular_value(map.map));
        }
    }
    for (int object = 0; object < static_cast<int>(scene.objects.size()); ++object) {
        cells_.push_back(outermost(object));
        const CompiledVolume& volume =
            shape_of(object).sets[static_cast<std::size_t>(cells_.back().set)].volume;
        object_sizes_.push_back(largest_singular_value(cells_.back().place) * volume.diameter);
    }
}

Sight Oracle::sight(long x, long y) const { return sight(x, y, glm::dvec2{0.0}); }

Sight Oracle::sight(long x, long y, const glm::dvec2& moved) const {
    const CompiledCamera& camera = scene_.camera;
    const glm::dvec2 place =
        moved + (scene_.samples.size() == 1 ? scene_.samples.front() : glm::dvec2{0.5, 0.5});
    const glm::dvec3 on_plane = camera.corner + (static_cast<double>(x) + place.x) * camera.across +
                                (static_cast<double>(y) + place.y) * camera.down;
    if (camera.projection == kernels::Projection::orthographic) return {on_plane, camera.forward};
    return {glm::dvec3{0.0}, glm::normalize(on_plane)};
}

std::vector<TerminalCell> Oracle::look(const Sight& ray) { return cells_before(ray, infinity); }

std::vector<TerminalCell> Oracle::look_near(const Sight& ray) { return cells_before(ray, 2); }

std::vector<TerminalCell> Oracle::cells_before(const Sight& ray, double behind) {
    std::vector<TerminalCell> found;
    forget_cells();
    visited_ = 0;
    behind_ = behind;
    nothing_beyond_ = infinity;
    for (int object = 0; object < static_cast<int>(scene_.objects.size()); ++object) {
        TerminalCell path;
        path.object = object;
        path.key = 0;
        path.exit = infinity;
        visit(ray, static_cast<std::size_t>(object), path, found);
    }
    std::erase_if(found, [&](const TerminalCell& cell) { return cell.key > nothing_beyond_; });
    std::ranges::sort(found, comes_before);
    return found;
}

double Oracle::pixel_size(int object, double key) const {
    const double p = scene_.camera.pixel_at_eye + scene_.camera.pixel_growth * key;  // Eq. 15.2
    return std::max(p, smallest_share_ * object_sizes_[static_cast<std::size_t>(object)]);
}

/// `path` comes with the word of the cell and the interval of its parent, and is left with the word
/// it came with.
void Oracle::visit(const Sight& ray, std::size_t cell, TerminalCell& path,
                   std::vector<TerminalCell>& found) {
    const CompiledShape& shape = shape_of(path.object);
    const CompiledSet& set = shape.sets[static_cast<std::size_t>(cells_[cell].set)];
    const auto crossing = cross(ray, cells_[cell].place, cells_[cell].back, set.volume);
    if (!crossing) return;
    const double key = std::max(path.key, crossing->entry);  // Erratum 3
    const double exit = std::min(path.exit, crossing->exit);
    if (exit < key || key > nothing_beyond_) return;
    if (++visited_ > patience_) throw std::runtime_error("a ray meets too many cells");
    const bool last_level =
        path.word.size() == scene_.objects[static_cast<std::size_t>(path.object)].levels;
    const double diameter = cells_[cell].diameter;
    if (last_level || diameter <= scene_.detail * pixel_size(path.object, key)) {
        found.push_back({key, path.object, path.word, exit, diameter});
        nothing_beyond_ = std::min(nothing_beyond_, key + behind_ * pixel_size(path.object, key));
        return;
    }
    const double outer_key = path.key;
    const double outer_exit = path.exit;
    open(path.object, cell);
    for (std::size_t i = 0; i < set.maps.size(); ++i) {
        path.key = key;
        path.exit = exit;
        path.word.push_back(set.maps[i]);
        visit(ray, cells_[cell].children + i, path, found);
        path.word.pop_back();
    }
    path.key = outer_key;
    path.exit = outer_exit;
}

const CompiledShape& Oracle::shape_of(int object) const {
    const CompiledObject& instance = scene_.objects[static_cast<std::size_t>(object)];
    return scene_.shapes[static_cast<std::size_t>(instance.shape)];
}

Oracle::Cell Oracle::make_cell(int object, const Affine& place, double product, int set) const {
    Cell cell;
    cell.place = place;
    cell.back = matrix_of(place).inverse();
    cell.product = product;
    cell.set = set;
    double lip = product;
    const CompiledShape& shape = shape_of(object);
    if (shape.lipschitz == kernels::Lipschitz::determinant) {
        lip = std::cbrt(std::abs(matrix_of(place).determinant()));  // Eq. 16.3
    } else if (shape.lipschitz == kernels::Lipschitz::polar) {
        lip = largest_singular_value(place);  // Sec. 16.2
    }
    cell.diameter = lip * shape.sets[static_cast<std::size_t>(set)].volume.diameter;
    return cell;
}

Oracle::Cell Oracle::outermost(int object) const {
    const CompiledObject& whole = scene_.objects[static_cast<std::size_t>(object)];
    return make_cell(object, whole.instance, largest_singular_value(whole.instance), whole.start);
}

Oracle::Cell Oracle::inside(int object, const Cell& cell, int map) const {
    const auto m = static_cast<std::size_t>(map);
    const CompiledMap& next = shape_of(object).maps[m];
    const auto shape =
        static_cast<std::size_t>(scene_.objects[static_cast<std::size_t>(object)].shape);
    return make_cell(object, then(next.map, cell.place), cell.product * map_lips_[shape][m],
                     next.follow_set);
}

void Oracle::open(int object, std::size_t cell) {
    if (cells_[cell].children != 0) return;
    cells_[cell].children = cells_.size();
    const auto set = static_cast<std::size_t>(cells_[cell].set);
    for (const int map : shape_of(object).sets[set].maps) {
        cells_.push_back(inside(object, cells_[cell], map));
    }
}

void Oracle::forget_cells() {
    if (cells_.size() < room) return;
    cells_.resize(scene_.objects.size());
    for (Cell& cell : cells_) cell.children = 0;
}

std::vector<Oracle::PathNormal> Oracle::enclosing_normals(const Sight& ray, int object) const {
    std::vector<PathNormal> normals;
    int index = scene_.objects[static_cast<std::size_t>(object)].enclosing;
    while (index >= 0) {
        const CompiledEnclosure& cell = scene_.enclosures[static_cast<std::size_t>(index)];
        const Eigen::Matrix3d back = matrix_of(cell.inverse);
        const glm::dvec3 o = cell.inverse.point(ray.origin);
        CompiledVolume volume = cell.volume;
        if (volume.kind == kernels::Volume::box) volume.center = (volume.low + volume.high) / 2.0;
        const auto crossing = cross_volume(o, vector(row(ray.direction) * back), volume);
        if (crossing && crossing->entry > 0) {
            normals.push_back(
                {0, glm::normalize(vector(row(crossing->entry_normal) * back.transpose())),
                 cell.volume.diameter, crossing->entry});
        }
        index = cell.enclosing;
    }
    return normals;
}

std::vector<Oracle::PathNormal> Oracle::normals_on_path(const Sight& ray,
                                                        const TerminalCell& seen) const {
    std::vector<PathNormal> normals = enclosing_normals(ray, seen.object);
    Cell cell = cells_[static_cast<std::size_t>(seen.object)];
    for (std::size_t level = 0;; ++level) {  // the cells that contain the hit, Erratum 13
        const auto set = static_cast<std::size_t>(cell.set);
        const auto crossing =
            cross(ray, cell.place, cell.back, shape_of(seen.object).sets[set].volume);
        const auto to_world = [&](const glm::dvec3& normal) {
            return glm::normalize(vector(row(normal) * cell.back.transpose()));
        };
        if (crossing && crossing->entry > 0) {  // a cell around the eye gives no normal
            normals.push_back(
                {level, to_world(crossing->entry_normal), cell.diameter, crossing->entry});
        }
        if (level == seen.word.size()) {
            const bool facet = scene_.shading == kernels::ShadingMode::facet;
            if (facet && !normals.empty() && normals.back().level != level) normals.clear();
            if (crossing && normals.empty()) {
                normals.push_back(
                    {level, to_world(crossing->exit_normal), cell.diameter, crossing->exit});
            }
            if (facet && !normals.empty()) return {normals.back()};
            return normals;
        }
        cell = inside(seen.object, cell, seen.word[level]);
    }
}

double Oracle::outermost_size(int object) const {
    double size = cells_[static_cast<std::size_t>(object)].diameter;
    int index = scene_.objects[static_cast<std::size_t>(object)].enclosing;
    while (index >= 0) {
        size = scene_.enclosures[static_cast<std::size_t>(index)].volume.diameter;
        index = scene_.enclosures[static_cast<std::size_t>(index)].enclosing;
    }
    return size;
}

double Oracle::weight(const TerminalCell& seen, double diameter) const {
    const double outermost_diameter = outermost_size(seen.object);
    if (scene_.shading == kernels::ShadingMode::low_pass) return diameter;  // Eq. 17.5
    if (scene_.shading == kernels::ShadingMode::high_pass) {
        return outermost_diameter - diameter;  // Eq. 17.6
    }
    return 1.0;  // Eq. 17.4
}

glm::dvec3 Oracle::total_normal(const TerminalCell& seen,
                                const std::vector<PathNormal>& path) const {
    glm::dvec3 weighted{0.0};
    glm::dvec3 unweighted{0.0};
    double weights = 0;
    for (const PathNormal& one : path) {
        weighted += weight(seen, one.diameter) * one.normal;
        unweighted += one.normal;
        weights += weight(seen, one.diameter);
    }
    return glm::normalize(weights > 0 ? weighted : unweighted);  // Erratum 18
}

double Oracle::facing_point_light(const Sight& ray, const TerminalCell& seen,
                                  const std::vector<PathNormal>& path,
                                  const glm::dvec3& place) const {
    double weighted = 0;
    double unweighted = 0;
    double weights = 0;
    for (const PathNormal& one : path) {  // Eq. 17.3 in full
        const glm::dvec3 toward = glm::normalize(place - (ray.origin + one.t * ray.direction));
        const double cosine = std::max(0.0, glm::dot(one.normal, toward));
        weighted += weight(seen, one.diameter) * cosine;
        unweighted += cosine;
        weights += weight(seen, one.diameter);
    }
    return weights > 0 ? weighted / weights : unweighted / static_cast<double>(path.size());
}

glm::dvec3 Oracle::surface_color(const TerminalCell& seen) const {
    glm::dvec3 color = scene_.objects[static_cast<std::size_t>(seen.object)].color;
    for (const int map : seen.word) {
        const glm::dvec4 paint = shape_of(seen.object).maps[static_cast<std::size_t>(map)].color;
        color = (1 - paint.a) * color + paint.a * glm::dvec3{paint};
    }
    return color;
}

Appearance Oracle::appearance(const Sight& ray, const TerminalCell& seen) const {
    const double diffuse = scene_.objects[static_cast<std::size_t>(seen.object)].diffuse;
    const std::vector<PathNormal> path = normals_on_path(ray, seen);
    Appearance result;
    result.normal = total_normal(seen, path);
    glm::dvec3 light_sum = scene_.ambient;
    for (const CompiledLight& light : scene_.lights) {
        const double cosine = light.kind == kernels::LightKind::directional
                                  ? std::max(0.0, glm::dot(result.normal, light.place))
                                  : facing_point_light(ray, seen, path, light.place);
        light_sum += diffuse * cosine * light.color;
    }
    result.color = light_sum * surface_color(seen);  // Eq. 17.1
    return result;
}

}  // namespace pxm::test
