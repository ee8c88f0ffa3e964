#include "tests/support/campaign/random_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "host/math/lipschitz.hpp"
#include "tests/support/campaign/draw.hpp"

namespace pxm::test {

using namespace host;

namespace {

/// What the maps of a system are like.
enum class Kind { homotheties, similarities, affine, grid, kinds };

class System {
  public:
    explicit System(Draw& draw) : draw_(draw), kind_(static_cast<Kind>(draw.below(4))) {}

    IfsBlock block() {
        IfsBlock ifs;
        ifs.name = "fractal";
        if (kind_ == Kind::grid) {
            ifs.maps = grid_maps();
        } else {
            for (const double ratio : ratios()) ifs.maps.push_back(map(ratio));
        }
        for (std::size_t i = 0; i < ifs.maps.size(); ++i) {
            ifs.maps[i].name = fmt::format("m{}", i + 1);
            if (draw_.one_in(4)) ifs.maps[i].color = glm::dvec4{draw_.rgb(), draw_.between(0, 1)};
        }
        if (draw_.one_in(3)) add_graph(ifs);
        return ifs;
    }

  private:
    int map_count() { return draw_.one_in(8) ? 2 + draw_.below(39) : 2 + draw_.below(7); }

    /// Ratios whose D-th powers add up to 1 for a dimension D that is drawn: more would lie over
    /// each other so much that no search ends. Every eighth system has a map that barely contracts.
    std::vector<double> ratios() {
        const int count = map_count();
        if (draw_.one_in(8)) {
            std::vector<double> ratios{1 - draw_.power(-3, -1)};
            while (static_cast<int>(ratios.size()) < std::min(count, 5))
                ratios.push_back(draw_.between(0.05, 0.3));
            return ratios;
        }
        const double dimension = draw_.between(0.7, 2.7);
        std::vector<double> parts;
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            parts.push_back(draw_.between(0.2, 1));
            sum += std::pow(parts.back(), dimension);
        }
        for (double& part : parts) part = std::min(0.9, part * std::pow(sum, -1 / dimension));
        return parts;
    }

    /// Squashed in one or two directions, to 10^-4, or flat.
    glm::dvec3 stretches(double ratio) {
        glm::dvec3 factors{ratio};
        if (kind_ == Kind::affine) {
            const double most = draw_.one_in(3) ? -4 : -1;
            factors.y *= draw_.power(most, 0);
            if (draw_.one_in(2)) factors.z *= draw_.power(most, 0);
            if (draw_.one_in(24)) factors.y = 0;
        }
        for (int i = 0; i < 3; ++i) {
            if (kind_ != Kind::homotheties && draw_.one_in(6)) factors[i] = -factors[i];
        }
        return factors;
    }

    /// A map with its fixed point in the cube from -1 to 1.
    MapBlock map(double ratio) {
        MapBlock map;
        if (kind_ == Kind::affine) turn(map);
        map.commands.push_back({ScaleCommand{stretches(ratio)}, {}});
        if (kind_ != Kind::homotheties) turn(map);
        const glm::dvec3 fixed = draw_.point();
        const Affine linear = compose(map.commands);
        map.commands.push_back({TranslateCommand{fixed - linear.point(fixed)}, {}});
        return map;
    }

    void turn(MapBlock& map) {
        for (int i = draw_.below(3); i > 0; --i) {
            const double degrees =
                draw_.one_in(3) ? 30 * (draw_.below(13) - 6.) : draw_.between(-180, 180);
            map.commands.push_back({RotateCommand{static_cast<Axis>(draw_.below(3)), degrees}, {}});
        }
    }

    /// Some cells of a grid, each with the whole in it, turned by quarters and mirrored.
    std::vector<MapBlock> grid_maps() {
        const int n = 2 + draw_.below(2);
        const int deep = draw_.one_in(3) ? 1 : n;
        std::vector<MapBlock> maps;
        while (maps.size() < 2) {
            maps.clear();
            for (int i = 0; i < n * n * deep; ++i) {
                if (draw_.one_in(3)) continue;
                maps.push_back(cell({i % n, i / n % n, i / n / n}, n, deep));
            }
        }
        return maps;
    }
    MapBlock cell(const glm::ivec3& at, int n, int deep) {
        MapBlock map;
        glm::dvec3 factors{1.0 / n};
        if (draw_.one_in(4)) factors.x = -factors.x;
        map.commands.push_back({ScaleCommand{factors}, {}});
        if (draw_.one_in(2)) {
            const auto axis = deep == 1 ? Axis::z : static_cast<Axis>(draw_.below(3));
            map.commands.push_back({RotateCommand{axis, 90. * draw_.below(4)}, {}});
        }
        const glm::dvec3 middle = (glm::dvec3(at) * 2. + 1. - double(n)) / double(n);
        map.commands.push_back(
            {TranslateCommand{{middle.x, middle.y, deep == 1 ? 0 : middle.z}}, {}});
        return map;
    }

    void add_graph(IfsBlock& ifs) {
        const int count = static_cast<int>(ifs.maps.size());
        const int sparseness = 1 + draw_.below(4);
        const auto name = [&](int i) { return ifs.maps[static_cast<std::size_t>(i)].name; };
        for (int i = 0; i < count; ++i) {
            FollowRule rule{{name(i), {}}, {}};
            for (int j = 0; j < count; ++j)
                if (draw_.one_in(sparseness)) rule.followers.push_back({name(j), {}});
            if (rule.followers.empty()) rule.followers.push_back({name(draw_.below(count)), {}});
            ifs.follow.push_back(rule);
        }
        if (draw_.one_in(2)) ifs.start.push_back({name(draw_.below(count)), {}});
    }

    Draw& draw_;
    Kind kind_;
};

std::optional<DeclaredVolume> declared(Draw& draw) {
    switch (draw.below(6)) {
        case 0:
            return SphereVolume{0.2 * draw.point(), draw.between(1, 3)};
        case 1:
            return BoxVolume{-glm::dvec3{draw.between(1, 2)}, glm::dvec3{draw.between(1, 2)}};
        case 2:
            return HullVolume{};
        default:
            return std::nullopt;
    }
}

ObjectBlock object(Draw& draw, int number) {
    ObjectBlock object;
    object.name = fmt::format("o{}", number);
    object.ifs = "fractal";
    object.volume = declared(draw);
    if (draw.one_in(2)) {
        const double size = draw.power(-1, 1);
        const glm::dvec3 uneven{draw.between(0.3, 1), draw.between(0.3, 1), draw.between(0.3, 1)};
        object.commands.push_back(
            {ScaleCommand{draw.one_in(2) ? glm::dvec3{size} : size * uneven}, {}});
        object.commands.push_back(
            {RotateCommand{static_cast<Axis>(draw.below(3)), draw.between(-180, 180)}, {}});
    }
    if (number > 0) object.commands.push_back({TranslateCommand{2. * draw.point()}, {}});
    if (draw.one_in(2)) object.color = glm::dvec4{draw.rgb(), draw.between(0, 1)};
    if (draw.one_in(6)) object.levels = draw.below(7);
    if (draw.one_in(3)) object.diffuse = draw.between(0, 1);
    if (draw.one_in(16)) object.reflect = draw.between(0, 1);
    if (draw.one_in(24)) object.opacity = draw.between(0.1, 1);
    return object;
}

DecimalVec3 decimals(const glm::dvec3& v) { return {{{v.x, ""}, {v.y, ""}, {v.z, ""}}}; }

/// The fixed point of a map: on the attractor, if every map may follow itself.
glm::dvec3 fixed_point(const MapBlock& map) {
    const Affine affine = compose(map.commands);
    return glm::inverse(glm::dmat3{1.0} - affine.linear) * affine.translation;
}

/// An eye anywhere, inside of the attractor as well; it looks at a point of it more often than not.
CameraBlock camera(Draw& draw, const IfsBlock& ifs) {
    CameraBlock camera;
    const auto at = static_cast<std::size_t>(draw.below(static_cast<int>(ifs.maps.size())));
    const glm::dvec3 look = draw.one_in(3) ? 0.5 * draw.point() : fixed_point(ifs.maps[at]);
    const double distance = draw.one_in(3) ? draw.power(-3, 1.5) : draw.between(1.5, 6);
    camera.look = decimals(look);
    camera.eye = decimals(look + distance * draw.direction());
    if (draw.one_in(4)) camera.up = draw.direction();
    if (draw.one_in(3)) camera.fov = draw.between(5, 120);
    if (draw.one_in(4)) camera.orthographic = distance * draw.between(0.1, 2);
    if (draw.one_in(4)) camera.zoom = draw.power(0, 12);
    return camera;
}

LightBlock light(Draw& draw) {
    LightBlock light;
    (draw.one_in(2) ? light.direction : light.location) = 4. * draw.direction();
    if (draw.one_in(3)) light.color = draw.rgb();
    if (draw.one_in(6)) light.shadow = true;
    return light;
}

RenderBlock render_block(Draw& draw) {
    RenderBlock render;
    if (draw.one_in(2)) render.volume = static_cast<VolumeKind>(draw.below(5));
    if (draw.one_in(2)) render.lipschitz = static_cast<LipschitzMethod>(draw.below(4));
    if (draw.one_in(2)) render.shading = static_cast<Shading>(draw.below(4));
    if (draw.one_in(4)) render.detail = draw.power(-0.5, 0.7);
    if (draw.one_in(5)) render.heap = 1 + draw.below(64);
    if (draw.one_in(24)) render.covers = CoversChoice{Covers{}};
    if (draw.one_in(24)) render.covers = CoversChoice{AreaCovers{}};
    return render;
}

/// Where Ch. 13 applies, it is tried now and then.
void try_fast(Draw& draw, Scene& scene) {
    const auto is_homothety = [](const MapBlock& map) {
        return classify(compose(map.commands)) == MapKind::homothety;
    };
    if (!std::ranges::all_of(scene.ifs.front().maps, is_homothety) || !draw.one_in(3)) return;
    scene.render->intersect = IntersectMethod::fast;
    scene.render->volume = VolumeKind::sphere;
    scene.render->covers.reset();
    for (ObjectBlock& object : scene.objects) object.opacity.reset();
}

}  // namespace

Scene random_system(std::uint64_t seed) {
    Draw draw(seed);
    Scene scene;
    scene.ifs.push_back(System(draw).block());
    for (int i = draw.one_in(2) ? 1 + draw.below(3) : 0; i > 0; --i)
        scene.objects.push_back(object(draw, static_cast<int>(scene.objects.size())));
    for (int i = draw.below(3); i > 0; --i) scene.lights.push_back(light(draw));
    if (!draw.one_in(5)) scene.camera = camera(draw, scene.ifs.front());
    scene.image = ImageBlock{};
    scene.image->size = PixelSize{8 + draw.below(57), 8 + draw.below(41)};
    scene.render = render_block(draw);
    try_fast(draw, scene);
    return scene;
}

}  // namespace pxm::test
