// What bench_describe says of a scene, read back: maps, volumes, instances and the view in plain
// double, lengths in scene units (the eye at the origin). For the baseline and the peers: they
// share this text with pxm and no code.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace bench {

using Vec3 = std::array<double, 3>;

inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }

/// x' = x T + a with row vectors; row[3] is a.
struct Affine {
    std::array<Vec3, 4> row{};
};

inline Vec3 transform_direction(const Vec3& d, const Affine& m) {
    return d[0] * m.row[0] + d[1] * m.row[1] + d[2] * m.row[2];
}
inline Vec3 transform_point(const Vec3& p, const Affine& m) {
    return transform_direction(p, m) + m.row[3];
}
/// First a, then b.
inline Affine compose(const Affine& a, const Affine& b) {
    return {{transform_direction(a.row[0], b), transform_direction(a.row[1], b),
             transform_direction(a.row[2], b), transform_point(a.row[3], b)}};
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Affine inverse(const Affine& m) {
    const Vec3 c[3] = {cross(m.row[1], m.row[2]), cross(m.row[2], m.row[0]),
                       cross(m.row[0], m.row[1])};
    const double scale = 1 / dot(m.row[0], c[0]);
    Affine result;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) result.row[i][j] = scale * c[j][i];
    }
    result.row[3] = -1 * transform_direction(m.row[3], result);
    return result;
}

struct Map {
    Affine map;
    Affine back;          // its inverse
    double constant = 0;  // Lip
    int follow = 0;       // set of the maps that may come next
};

/// What may stand inside a map: its ball, and the maps that may come next.
struct FollowSet {
    Vec3 center{};
    double radius = 0;
    double diameter = 0;
    std::vector<int> maps;
};

struct Shape {
    bool similar = true;  // products of constants are exact
    int start = 0;
    std::vector<Map> maps;
    std::vector<FollowSet> sets;
};

struct Object {
    int shape = 0;
    Affine instance;
    Affine back;
    double constant = 0;
    double diameter = 0;
    long levels = 0;  // at most
};

struct Scene {
    int columns = 0;
    int rows = 0;
    double unit = 1;  // world length of a scene unit
    double detail = 1;
    bool parallel = false;  // rays
    Vec3 corner{}, across{}, down{}, forward{};
    double pixel_at_eye = 0;  // p(t) = pixel_at_eye + pixel_growth t
    double pixel_growth = 0;
    std::vector<Shape> shapes;
    std::vector<Object> objects;
};

/// Reads `word value value ...` and stops the program at anything unexpected.
class Reader {
  public:
    explicit Reader(const std::string& path) : in_(path) {}

    void expect(const char* word) {
        std::string found;
        in_ >> found;
        if (found == word) return;
        std::fprintf(stderr, "expected %s, found '%s'\n", word, found.c_str());
        std::exit(4);
    }
    double number() {
        std::string text;
        in_ >> text;
        return std::strtod(text.c_str(), nullptr);
    }
    int integer() { return static_cast<int>(number()); }
    Vec3 vector() {
        Vec3 v{};
        for (double& x : v) x = number();
        return v;
    }
    Affine affine() {
        Affine m;
        for (Vec3& row : m.row) row = vector();
        return m;
    }

  private:
    std::ifstream in_;
};

inline Shape read_shape(Reader& in) {
    Shape shape;
    in.expect("shape");
    shape.similar = in.integer() != 0;
    shape.start = in.integer();
    shape.maps.resize(static_cast<std::size_t>(in.integer()));
    shape.sets.resize(static_cast<std::size_t>(in.integer()));
    for (Map& map : shape.maps) {
        in.expect("map");
        map.map = in.affine();
        map.back = inverse(map.map);
        map.constant = in.number();
        map.follow = in.integer();
    }
    for (FollowSet& set : shape.sets) {
        in.expect("set");
        set.center = in.vector();
        set.radius = in.number();
        set.diameter = in.number();
        set.maps.resize(static_cast<std::size_t>(in.integer()));
        for (int& map : set.maps) map = in.integer();
    }
    return shape;
}

inline Scene read_scene(const std::string& path) {
    Reader in(path);
    Scene scene;
    in.expect("picture");
    scene.columns = in.integer();
    scene.rows = in.integer();
    scene.unit = in.number();
    scene.detail = in.number();
    in.expect("camera");
    scene.parallel = in.integer() != 0;
    scene.corner = in.vector();
    scene.across = in.vector();
    scene.down = in.vector();
    scene.forward = in.vector();
    scene.pixel_at_eye = in.number();
    scene.pixel_growth = in.number();
    in.expect("shapes");
    const int shapes = in.integer();
    for (int i = 0; i < shapes; ++i) scene.shapes.push_back(read_shape(in));
    in.expect("objects");
    scene.objects.resize(static_cast<std::size_t>(in.integer()));
    for (Object& object : scene.objects) {
        in.expect("object");
        object.shape = in.integer();
        object.instance = in.affine();
        object.back = inverse(object.instance);
        object.constant = in.number();
        object.diameter = in.number();
        object.levels = static_cast<long>(in.number());
    }
    return scene;
}

/// The eye's ray through the centre of a pixel; a unit vector.
struct Ray {
    Vec3 origin{};
    Vec3 direction{};
};

inline Ray eye_ray(const Scene& scene, int x, int y) {
    const Vec3 on_plane = scene.corner + (x + 0.5) * scene.across + (y + 0.5) * scene.down;
    if (scene.parallel) return {on_plane, scene.forward};
    return {{}, (1 / __builtin_sqrt(dot(on_plane, on_plane))) * on_plane};
}

}  // namespace bench
