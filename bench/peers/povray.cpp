// A peer: POV-Ray. Writes the scene for it: the hulls of the cells of k levels as one mesh, which
// POV-Ray shares between instances, at the places of the upper cells in view. Flat colour, no
// light, no shadow: finding the hit is all it has to do.
//
//   bench_povray DESCRIPTION K > scene.pov
#include <stdexcept>

#include "bench/peers/cells.hpp"

namespace {

using namespace bench;

constexpr std::size_t most = 400'000;  // triangles, and instances

void print(const Vec3& v) { std::printf("<%.9g,%.9g,%.9g>", v[0], v[1], v[2]); }

void print_camera(const Scene& scene) {
    const Vec3 right = scene.columns * scene.across;
    const Vec3 down = scene.rows * scene.down;
    std::printf(
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\ncamera { location 0 direction ");
    print(scene.corner + 0.5 * right + 0.5 * down);
    std::printf(" right ");
    print(right);
    std::printf(" up ");
    print(-1 * down);
    std::printf(" }\n");
}

void print_mesh(const Shape& shape, int levels) {
    const std::vector<Triangle> faces = hull_faces(shape);
    if (std::pow(shape.maps.size(), levels) * static_cast<double>(faces.size()) > most) {
        throw std::runtime_error("too many triangles");
    }
    std::printf("#declare Cells = mesh {\n");
    const Affine here{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}}};
    for (const Affine& cell : cells_of_level(shape, here, levels)) {
        for (const Triangle& face : faces) {
            std::printf("triangle{");
            for (std::size_t i = 0; i < 3; ++i) {
                if (i > 0) std::printf(",");
                print(transform_point(face[i], cell));
            }
            std::printf("}\n");
        }
    }
    std::printf("pigment { rgb 1 } finish { ambient 1 diffuse 0 } }\n");
}

void print_instances(const Scene& scene, int levels) {
    for (const Affine& cell : UpperCells(scene, levels, most).take()) {
        std::printf("object{Cells matrix<");
        for (std::size_t i = 0; i < 12; ++i) {
            std::printf("%s%.9g", i > 0 ? "," : "", cell.row[i / 3][i % 3]);
        }
        std::printf(">}\n");
    }
}

}  // namespace

int main(int count, char** values) {
    if (count != 3) {
        std::fprintf(stderr, "usage: bench_povray DESCRIPTION K\n");
        return 2;
    }
    try {
        const Scene scene = read_scene(values[1]);
        const int levels = std::atoi(values[2]);
        print_camera(scene);
        print_mesh(only_shape(scene), levels);
        print_instances(scene, levels);
    } catch (const std::runtime_error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
