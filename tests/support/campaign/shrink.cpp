#include "tests/support/campaign/shrink.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pxm::test {

using namespace host;

namespace {

using Edit = std::function<void(Scene&)>;

/// The methods that a find needs: its own, and the one that it is compared with.
std::vector<std::string> methods_of(const Find& find) {
    if (find.method == "heap") return {"heap", "float"};
    if (find.method == "machine") return {"machine", "dsp32"};
    return {find.method};
}

void add_numbers(std::vector<double*>& numbers, glm::dvec3& v) {
    for (int i = 0; i < 3; ++i) numbers.push_back(&v[i]);
}
void add_numbers(std::vector<double*>& numbers, DecimalVec3& v) {
    for (Decimal& number : v) numbers.push_back(&number.value);
}
template <class Value>
void add_numbers(std::vector<double*>& numbers, std::optional<Value>& value) {
    if (!value) return;
    if constexpr (std::same_as<Value, double>) {
        numbers.push_back(&*value);
    } else {
        add_numbers(numbers, *value);
    }
}

struct NumbersOfCommand {
    std::vector<double*>& numbers;
    void operator()(ScaleCommand& c) const { add_numbers(numbers, c.factors); }
    void operator()(RotateCommand& c) const { numbers.push_back(&c.degrees); }
    void operator()(TranslateCommand& c) const { add_numbers(numbers, c.offset); }
    void operator()(MatrixCommand& c) const {
        for (int i = 0; i < 3; ++i) add_numbers(numbers, c.map.linear[i]);
        add_numbers(numbers, c.map.translation);
    }
    void operator()(TetrahedronCommand& c) const {
        for (glm::dvec3& point : c.from) add_numbers(numbers, point);
        for (glm::dvec3& point : c.to) add_numbers(numbers, point);
    }
    void operator()(BlendCommand&) const {}
};

/// Every number that may be made simpler.
std::vector<double*> numbers_of(Scene& scene) {
    std::vector<double*> numbers;
    const auto add_commands = [&](std::vector<Command>& commands) {
        for (Command& command : commands) std::visit(NumbersOfCommand{numbers}, command.kind);
    };
    for (IfsBlock& ifs : scene.ifs)
        for (MapBlock& map : ifs.maps) add_commands(map.commands);
    for (ObjectBlock& object : scene.objects) {
        add_commands(object.commands);
        add_numbers(numbers, object.diffuse);
    }
    for (LightBlock& light : scene.lights) {
        add_numbers(numbers, light.direction);
        add_numbers(numbers, light.location);
        add_numbers(numbers, light.color);
    }
    if (scene.camera) {
        add_numbers(numbers, scene.camera->eye);
        add_numbers(numbers, scene.camera->look);
        add_numbers(numbers, scene.camera->up);
        add_numbers(numbers, scene.camera->fov);
        add_numbers(numbers, scene.camera->orthographic);
        add_numbers(numbers, scene.camera->zoom);
    }
    if (scene.render) add_numbers(numbers, scene.render->detail);
    return numbers;
}

/// Leaves out a map and what refers to it by its name. References by number stay as they are, and
/// make another system.
void drop_map(IfsBlock& ifs, std::size_t index) {
    const std::string name = ifs.maps[index].name;
    const auto is_it = [&](const MapReference& reference) {
        const auto* word = std::get_if<std::string>(&reference.map);
        return word && *word == name;
    };
    ifs.maps.erase(ifs.maps.begin() + static_cast<std::ptrdiff_t>(index));
    std::erase_if(ifs.follow, [&](const FollowRule& rule) { return is_it(rule.map); });
    for (FollowRule& rule : ifs.follow) std::erase_if(rule.followers, is_it);
    std::erase_if(ifs.follow, [](const FollowRule& rule) { return rule.followers.empty(); });
    std::erase_if(ifs.start, is_it);
}

template <class List>
void add_drops(std::vector<Edit>& edits, const List& list, const std::function<List&(Scene&)>& of) {
    for (std::size_t i = list.size(); i-- > 0;)
        edits.push_back([=](Scene& s) { of(s).erase(of(s).begin() + std::ptrdiff_t(i)); });
}

void add_map_edits(std::vector<Edit>& edits, const Scene& scene) {
    for (std::size_t i = 0; i < scene.ifs.size(); ++i) {
        const IfsBlock& ifs = scene.ifs[i];
        for (std::size_t m = ifs.maps.size(); m-- > 0;)
            edits.push_back([=](Scene& s) { drop_map(s.ifs[i], m); });
        edits.push_back([=](Scene& s) { s.ifs[i].follow.clear(); });
        edits.push_back([=](Scene& s) { s.ifs[i].start.clear(); });
        for (std::size_t m = 0; m < ifs.maps.size(); ++m) {
            edits.push_back([=](Scene& s) { s.ifs[i].maps[m].color.reset(); });
            edits.push_back([=](Scene& s) { s.ifs[i].maps[m].weight.reset(); });
            add_drops<std::vector<Command>>(
                edits, ifs.maps[m].commands,
                [=](Scene& s) -> std::vector<Command>& { return s.ifs[i].maps[m].commands; });
        }
    }
}

void add_object_edits(std::vector<Edit>& edits, const Scene& scene) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        edits.push_back([=](Scene& s) {
            ObjectBlock plain;
            plain.name = s.objects[i].name;
            plain.ifs = s.objects[i].ifs;
            s.objects[i] = plain;
        });
        const auto reset = [&](auto member) {
            edits.push_back([=](Scene& s) { (s.objects[i].*member).reset(); });
        };
        reset(&ObjectBlock::volume);
        reset(&ObjectBlock::color);
        reset(&ObjectBlock::opacity);
        reset(&ObjectBlock::diffuse);
        reset(&ObjectBlock::reflect);
        reset(&ObjectBlock::levels);
        add_drops<std::vector<Command>>(
            edits, scene.objects[i].commands,
            [=](Scene& s) -> std::vector<Command>& { return s.objects[i].commands; });
    }
}

void add_setting_edits(std::vector<Edit>& edits, const Scene& scene) {
    edits.push_back([](Scene& s) { s.camera.reset(); });
    edits.push_back([](Scene& s) { s.render.reset(); });
    const auto reset_camera = [&](auto member) {
        if (scene.camera) edits.push_back([=](Scene& s) { ((*s.camera).*member).reset(); });
    };
    reset_camera(&CameraBlock::zoom);
    reset_camera(&CameraBlock::up);
    reset_camera(&CameraBlock::fov);
    reset_camera(&CameraBlock::orthographic);
    const auto reset_render = [&](auto member) {
        if (scene.render) edits.push_back([=](Scene& s) { ((*s.render).*member).reset(); });
    };
    reset_render(&RenderBlock::ambient);
    reset_render(&RenderBlock::background);
    reset_render(&RenderBlock::shading);
    reset_render(&RenderBlock::covers);
    reset_render(&RenderBlock::samples);
    reset_render(&RenderBlock::intersect);
    reset_render(&RenderBlock::numeric);
    reset_render(&RenderBlock::detail);
    reset_render(&RenderBlock::lipschitz);
    reset_render(&RenderBlock::volume);
    reset_render(&RenderBlock::heap);
    reset_render(&RenderBlock::bounces);
}

/// What may be left out, the largest parts first.
std::vector<Edit> omissions(const Scene& scene) {
    std::vector<Edit> edits;
    edits.push_back([](Scene& s) { s.objects.clear(); });
    add_drops<std::vector<ObjectBlock>>(
        edits, scene.objects, [](Scene& s) -> std::vector<ObjectBlock>& { return s.objects; });
    edits.push_back([](Scene& s) { s.lights.clear(); });
    edits.push_back([](Scene& s) {
        s.planes.clear();
        s.textures.clear();
    });
    edits.push_back([](Scene& s) { s.animation.reset(); });
    if (scene.ifs.size() > 1) {
        add_drops<std::vector<IfsBlock>>(edits, scene.ifs,
                                         [](Scene& s) -> std::vector<IfsBlock>& { return s.ifs; });
    }
    add_map_edits(edits, scene);
    add_setting_edits(edits, scene);
    add_object_edits(edits, scene);
    add_drops<std::vector<LightBlock>>(
        edits, scene.lights, [](Scene& s) -> std::vector<LightBlock>& { return s.lights; });
    return edits;
}

double rounded_to(double value, int digits) {
    if (value == 0 || !std::isfinite(value)) return value;
    return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

/// Every number simpler: 0, 1, of one digit, two, three, six.
std::vector<Edit> simplifications(const Scene& scene) {
    std::vector<Edit> edits;
    Scene copy = scene;
    const std::vector<double*> numbers = numbers_of(copy);
    for (const int digits : {2, 3, 6}) {
        edits.push_back([=](Scene& s) {
            for (double* number : numbers_of(s)) *number = rounded_to(*number, digits);
        });
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const double value = *numbers[i];
        if (value == 0) continue;
        const auto set = [&](double to) {
            if (to != value) edits.push_back([=](Scene& s) { *numbers_of(s)[i] = to; });
        };
        set(0);
        if (value == 1) continue;
        set(1);
        for (const int digits : {1, 2, 3, 6}) set(rounded_to(value, digits));
    }
    return edits;
}

class Shrinking {
  public:
    Shrinking(const Scene& scene, const Find& find, const TrialSettings& settings, double seconds)
        : settings_(settings),
          end_(std::chrono::steady_clock::now() +
               std::chrono::milliseconds(static_cast<long>(1000 * seconds))),
          best_{scene, find, 0} {
        settings_.only = methods_of(find);
        settings_.by_definition = std::numeric_limits<int>::max();
    }

    Shrunk run() {
        if (best_.find.x >= 0 && !crop_to_pixel()) return best_;
        bool smaller = true;
        while (smaller) {
            smaller = accept_any(omissions);
            smaller = accept_any(simplifications) || smaller;
        }
        return best_;
    }

  private:
    [[nodiscard]] bool is_over() const {
        return std::chrono::steady_clock::now() > end_ || (settings_.stop && *settings_.stop);
    }

    /// To the pixel, else to the tile that it lies in, else whole.
    bool crop_to_pixel() {
        const PixelSize size = best_.scene.image->size.value_or(PixelSize{});
        const long x = best_.find.x, y = best_.find.y;
        const long x0 = x / tile_side * tile_side, y0 = y / tile_side * tile_side;
        const CropWindow windows[] = {
            {x, y, x + 1, y + 1},
            {x0, y0, std::min(x0 + tile_side, size.columns), std::min(y0 + tile_side, size.rows)},
            {0, 0, size.columns, size.rows}};
        return std::ranges::any_of(windows, [&](const CropWindow& window) {
            return accept([&](Scene& scene) { scene.image->crop = window; });
        });
    }

    /// Tries one edit after the other. What was left out changes what may be left out, so the edits
    /// are made anew after each that is kept.
    bool accept_any(std::vector<Edit> (*edits_of)(const Scene&)) {
        bool any = false;
        std::vector<Edit> edits = edits_of(best_.scene);
        for (std::size_t i = 0; i < edits.size() && !is_over();) {
            if (accept(edits[i])) {
                any = true;
                edits = edits_of(best_.scene);
            } else {
                ++i;
            }
        }
        return any && !is_over();
    }

    bool accept(const Edit& edit) {
        Scene scene = best_.scene;
        edit(scene);
        if (scene == best_.scene) return false;
        ++best_.tried;
        try {
            const Trial trial = try_scene(scene, settings_);
            for (const Find& find : trial.finds) {
                if (find.method != best_.find.method) continue;
                best_.scene = std::move(scene);
                best_.find = find;
                return true;
            }
        } catch (const std::exception&) {  // another way to be wrong than the one looked for
        }
        return false;
    }

    TrialSettings settings_;
    std::chrono::steady_clock::time_point end_;
    Shrunk best_;
};

}  // namespace

Shrunk shrink(const Scene& scene, const Find& find, const TrialSettings& settings, double seconds) {
    Scene with_image = scene;
    if (!with_image.image) with_image.image = ImageBlock{};
    return Shrinking(with_image, find, settings, seconds).run();
}

}  // namespace pxm::test
