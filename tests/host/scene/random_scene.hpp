// Random scenes with every block, directive and form of value, for laws about printing and parsing.
#pragma once

#include <cmath>
#include <random>
#include <string>

#include "host/scene/scene.hpp"

namespace pxm::test {

class RandomScene {
  public:
    explicit RandomScene(unsigned seed) : random_(seed) {}

    host::Scene scene() {
        host::Scene scene;
        for (int i = count(3); i >= 0; --i) scene.ifs.push_back(ifs());
        for (int i = count(3); i > 0; --i) scene.objects.push_back(object());
        for (int i = count(2); i > 0; --i) scene.planes.push_back(plane());
        for (int i = count(2); i > 0; --i) scene.textures.push_back(texture());
        for (int i = count(2); i > 0; --i) scene.lights.push_back(light());
        maybe(scene.camera, [&] { return camera(); });
        maybe(scene.image, [&] { return image(); });
        maybe(scene.render, [&] { return render(); });
        return scene;
    }

  private:
    int count(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
    bool coin() { return count(1) == 1; }
    template <class Value, class Make>
    void maybe(std::optional<Value>& value, Make make) {
        if (coin()) value = make();
    }
    /// Numbers of all magnitudes, and often simple ones.
    double number() {
        if (coin()) return count(8) - 4;
        const double mantissa = std::uniform_real_distribution<double>(-1, 1)(random_);
        return std::ldexp(mantissa, count(2) == 0 ? count(1900) - 950 : count(8) - 4);
    }
    long whole() { return count(1'000'000); }
    glm::dvec2 vec2() { return {number(), number()}; }
    glm::dvec3 vec3() { return {number(), number(), number()}; }
    glm::dvec4 vec4() { return {number(), number(), number(), number()}; }
    std::string name() {
        static constexpr const char* stems[] = {"a", "_", "Fern", "x", "on", "stem_2", "heaps"};
        return stems[count(6)] + std::to_string(count(99));
    }
    template <class Choice>
    Choice choice(int last) {
        return static_cast<Choice>(count(last));
    }

    host::Command command(bool in_map) {
        host::TetrahedronCommand corners;
        switch (count(in_map ? 4 : 3)) {
            case 0:
                return {host::ScaleCommand{vec3()}, {}};
            case 1:
                return {host::RotateCommand{choice<host::Axis>(2), number()}, {}};
            case 2:
                return {host::TranslateCommand{vec3()}, {}};
            case 3:
                return {host::MatrixCommand{{{vec3(), vec3(), vec3()}, vec3()}}, {}};
            default:
                for (auto& point : corners.from) point = vec3();
                for (auto& point : corners.to) point = vec3();
                return {corners, {}};
        }
    }
    host::MapReference reference() {
        if (coin()) return {name(), {}};
        return {static_cast<long>(1 + count(20)), {}};
    }
    std::vector<host::MapReference> references() {
        std::vector<host::MapReference> list;
        for (int i = count(3); i >= 0; --i) list.push_back(reference());
        return list;
    }
    host::MapBlock map() {
        host::MapBlock map;
        if (coin()) map.name = name();
        for (int i = count(4); i > 0; --i) map.commands.push_back(command(true));
        maybe(map.color, [&] { return vec4(); });
        maybe(map.weight, [&] { return number(); });
        return map;
    }
    host::IfsBlock ifs() {
        host::IfsBlock ifs;
        ifs.name = name();
        for (int i = count(5); i > 0; --i) ifs.maps.push_back(map());
        for (int i = count(2); i > 0; --i) ifs.follow.push_back({reference(), references()});
        if (coin()) ifs.start = references();
        return ifs;
    }
    host::DeclaredVolume volume() {
        switch (count(5)) {
            case 0:
                return host::AutoVolume{};
            case 1:
                return host::SphereVolume{vec3(), number()};
            case 2:
                return host::BoxVolume{vec3(), vec3()};
            case 3:
                return host::ConeVolume{};
            case 4:
                return host::CylinderVolume{};
            default:
                return host::HullVolume{};
        }
    }
    host::ObjectBlock object() {
        host::ObjectBlock object;
        if (coin()) object.name = name();
        maybe(object.ifs, [&] { return name(); });
        maybe(object.volume, [&] { return volume(); });
        for (int i = count(3); i > 0; --i) object.commands.push_back(command(false));
        maybe(object.color, [&] { return vec4(); });
        maybe(object.opacity, [&] { return number(); });
        maybe(object.diffuse, [&] { return number(); });
        maybe(object.reflect, [&] { return number(); });
        maybe(object.levels, [&] { return whole(); });
        return object;
    }
    host::PlaneBlock plane() {
        host::PlaneBlock plane;
        if (coin()) plane.name = name();
        maybe(plane.point, [&] { return vec3(); });
        maybe(plane.normal, [&] { return vec3(); });
        maybe(plane.color, [&] { return vec3(); });
        for (int i = count(2); i > 0; --i) plane.textures.push_back({name(), {}});
        maybe(plane.reflect, [&] { return number(); });
        return plane;
    }
    host::TextureBlock texture() {
        host::TextureBlock texture;
        texture.name = name();
        const int kind = count(3);
        if (kind == 1) texture.source = host::FileTexture{"dir name/#" + name() + ".png"};
        if (kind == 2) texture.source = host::IfsTexture{name()};
        if (kind == 3) texture.source = host::WoodTexture{};
        maybe(texture.size, [&] { return vec2(); });
        maybe(texture.color, [&] { return vec3(); });
        maybe(texture.color2, [&] { return vec3(); });
        return texture;
    }
    host::LightBlock light() {
        host::LightBlock light;
        if (coin()) light.name = name();
        maybe(light.direction, [&] { return vec3(); });
        maybe(light.location, [&] { return vec3(); });
        maybe(light.color, [&] { return vec3(); });
        maybe(light.shadow, [&] { return coin(); });
        return light;
    }
    host::DecimalVec3 decimals() {
        host::DecimalVec3 v;
        for (host::Decimal& component : v) component.value = number();
        if (coin()) v[0] = {-0.1, "-0.1000000000000000000000000000001"};
        return v;
    }
    host::CameraBlock camera() {
        host::CameraBlock camera;
        if (coin()) camera.name = name();
        maybe(camera.eye, [&] { return decimals(); });
        maybe(camera.look, [&] { return decimals(); });
        maybe(camera.up, [&] { return vec3(); });
        maybe(camera.fov, [&] { return number(); });
        maybe(camera.orthographic, [&] { return number(); });
        return camera;
    }
    host::ImageBlock image() {
        host::ImageBlock image;
        maybe(image.size, [&] { return host::PixelSize{whole(), whole()}; });
        maybe(image.crop, [&] { return host::CropWindow{whole(), whole(), whole(), whole()}; });
        return image;
    }
    host::RenderBlock render() {
        host::RenderBlock render;
        maybe(render.ambient, [&] { return vec3(); });
        maybe(render.background, [&] { return vec3(); });
        maybe(render.shading, [&] { return choice<host::Shading>(3); });
        if (coin()) render.covers = host::CoversOff{};
        if (coin()) render.covers = host::Covers{number(), number()};
        maybe(render.samples, [&] { return whole(); });
        maybe(render.intersect, [&] { return choice<host::IntersectMethod>(3); });
        maybe(render.numeric, [&] { return choice<host::Numeric>(2); });
        maybe(render.detail, [&] { return number(); });
        maybe(render.lipschitz, [&] { return choice<host::LipschitzMethod>(3); });
        maybe(render.volume, [&] { return choice<host::VolumeKind>(4); });
        maybe(render.heap, [&] { return whole(); });
        maybe(render.bounces, [&] { return whole(); });
        return render;
    }

    std::mt19937 random_;
};

}  // namespace pxm::test
