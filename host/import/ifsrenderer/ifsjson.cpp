#include "host/import/ifsrenderer/ifsjson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/error.hpp"
#include "host/import/chaos_order.hpp"
#include "host/import/entries.hpp"
#include "host/import/imported_scene.hpp"
#include "host/scene/check/limits.hpp"
#include "host/text/printable.hpp"

namespace pxm::host {
namespace {

constexpr std::size_t most_bytes = std::size_t{16} << 20U;
constexpr int deepest = 32;                    // brackets inside one another
constexpr std::size_t most_iterators = 1'000;  // the program itself takes 100
constexpr double color_steps = 10'000;         // four digits of a colour are enough

/// Of the file as a whole, and of an iterator, by its number from 1.
struct Reader {
    const SourceFile& source;

    [[noreturn]] void refuse(const std::string& message) const {
        throw Error(ErrorKind::scene, fmt::format("{}: {}", printable_path(source.name), message));
    }
    /// The number of that name; nothing if it is not there. What is no finite number is refused.
    [[nodiscard]] double number(const nlohmann::json& object, const char* name, double otherwise,
                                const std::string& what) const {
        const auto found = object.find(name);
        if (found == object.end() || found->is_null()) return otherwise;
        if (!found->is_number() || !std::isfinite(found->get<double>()))
            refuse(fmt::format("{}: {} is no number", what, name));
        return found->get<double>();
    }
    [[nodiscard]] glm::dvec3 vector(const nlohmann::json& object, const char* name,
                                    const glm::dvec3& otherwise, const std::string& what) const {
        const auto found = object.find(name);
        if (found == object.end() || found->is_null()) return otherwise;
        if (!found->is_object()) refuse(fmt::format("{}: {} is no vector", what, name));
        return {number(*found, "X", 0, what), number(*found, "Y", 0, what),
                number(*found, "Z", 0, what)};
    }
};

nlohmann::json parsed(const Reader& reader) {
    std::string_view text = reader.source.text;
    if (text.size() > most_bytes) reader.refuse(fmt::format("more than {} MB", most_bytes >> 20U));
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    bool too_deep = false;
    const auto bounded = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
        too_deep = too_deep || depth > deepest;
        return !too_deep;
    };
    try {
        nlohmann::json json = nlohmann::json::parse(text.begin(), text.end(), bounded);
        if (too_deep) reader.refuse(fmt::format("JSON of more than {} levels", deepest));
        if (!json.is_object() || !json.contains("Iterators") || !json["Iterators"].is_array())
            reader.refuse("no file of IFSRenderer: expected an object with \"Iterators\"");
        return json;
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t at = std::min(error.byte, text.size());
        const auto line = std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
        reader.refuse(fmt::format("line {}: JSON that cannot be read", line + 1));
    } catch (const nlohmann::json::exception&) {
        reader.refuse("JSON with a number that is too large");
    }
}

/// A turn about an axis as the program has it: GLSL's matrices are made of columns, and it writes
/// rows, so that this is the turn by minus the angle.
glm::dmat3 turn(int axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    glm::dmat3 matrix(1.0);
    matrix[next][next] = c;
    matrix[next][last] = -s;
    matrix[last][next] = s;
    matrix[last][last] = c;
    return matrix;
}

glm::dmat3 euler(const glm::dvec3& degrees) {
    return turn(0, degrees.x) * turn(1, degrees.y) * turn(2, degrees.z);
}

/// The transform of that name, if it is affine.
std::optional<Affine> affine(const std::string& name, const nlohmann::json& reals,
                             const nlohmann::json& vectors, const Reader& reader,
                             const std::string& what) {
    const auto vector = [&](const char* key, const glm::dvec3& otherwise) {
        return reader.vector(vectors, key, otherwise, what);
    };
    Affine map;
    if (name == "Affine") {
        const glm::dvec3 scale = vector("Scale", glm::dvec3(1.0));
        map.linear =
            scaling(scale).linear * glm::transpose(euler(vector("Rotate", glm::dvec3(0.0))));
        map.translation = vector("Translate", glm::dvec3(0.0));
    } else if (name == "Translate") {
        map.translation = vector("Translate", glm::dvec3(0.0));
    } else if (name == "Rotate Euler") {
        map.linear = euler(vector("EulerAngles", glm::dvec3(0.0)));
    } else if (name == "Scale Center") {
        const double scale = reader.number(reals, "Scale", 1, what);
        map.linear = glm::dmat3(scale);
        map.translation = vector("Center", glm::dvec3(0.0)) * (1 - scale);
    } else if (name == "Flatten") {
        map.linear = scaling({1, 1, 0}).linear;
    } else {
        return std::nullopt;
    }
    return map;
}

struct Iterator {
    Affine map;
    double weight = 1;
    double color_index = 0;
    double color_speed = 0.5;
    double opacity = 1;
};

/// The name of a transform: {"Item1": name, "Item2": version}, or older {"Name": ...}.
std::string transform_name(const nlohmann::json& iterator) {
    const auto transform = iterator.find("Transform");
    if (transform == iterator.end() || !transform->is_object()) return "";
    for (const char* key : {"Item1", "Name"})
        if (const auto name = transform->find(key); name != transform->end() && name->is_string())
            return name->get<std::string>();
    return "";
}

const nlohmann::json& part(const nlohmann::json& object, const char* name) {
    static const nlohmann::json nothing = nlohmann::json::object();
    const auto found = object.find(name);
    return found != object.end() && found->is_object() ? *found : nothing;
}

Iterator iterator_of(const nlohmann::json& json, std::size_t number, const Reader& reader) {
    const std::string what = fmt::format("iterator {}", number);
    if (!json.is_object()) reader.refuse(what + ": expected an object");
    const std::string name = transform_name(json);
    Iterator iterator;
    const auto map = affine(name, part(json, "RealParams"), part(json, "Vec3Params"), reader, what);
    if (!map)
        reader.refuse(
            fmt::format("{}: the transform \"{}\" is not affine, or not known (Affine, "
                        "Translate, Rotate Euler, Scale Center and Flatten are taken)",
                        what, printable(name)));
    // The result is mixed with the point that went in: p + mix (T(p) + add p - p).
    const double mix = reader.number(json, "Mix", 1, what);
    const double stays = 1 - mix + mix * reader.number(json, "Add", 0, what);
    iterator.map.linear = mix * map->linear + glm::dmat3(stays);
    iterator.map.translation = mix * map->translation;
    iterator.weight = reader.number(json, "BaseWeight", 1, what);
    if (iterator.weight < 0) reader.refuse(what + ": BaseWeight is negative");
    iterator.opacity = reader.number(json, "Opacity", 1, what);
    iterator.color_index = reader.number(json, "ColorIndex", 0, what);
    iterator.color_speed = std::clamp(reader.number(json, "ColorSpeed", 0.5, what), 0.0, 1.0);
    return iterator;
}

using Table = std::vector<std::vector<double>>;

/// "xaos": how likely each iterator is to come after each; all ones if it is not there.
Table table_of(const nlohmann::json& json, std::size_t count, const Reader& reader) {
    Table table(count, std::vector<double>(count, 1));
    const auto found = json.find("xaos");
    if (found == json.end() || found->is_null()) return table;
    if (!found->is_array() || found->size() != count)
        reader.refuse(fmt::format("xaos: expected {} rows", count));
    for (std::size_t i = 0; i < count; ++i) {
        const nlohmann::json& row = (*found)[i];
        if (!row.is_array() || row.size() != count)
            reader.refuse(fmt::format("xaos, row {}: expected {} numbers", i + 1, count));
        for (std::size_t j = 0; j < count; ++j) {
            if (!row[j].is_number() || !(row[j].get<double>() >= 0))
                reader.refuse(
                    fmt::format("xaos, row {}: number {} is none, or negative", i + 1, j + 1));
            table[i][j] = row[j].get<double>();
        }
    }
    return table;
}

/// The colour at a place of the palette, its colours lying evenly from 0 to 1.
std::optional<glm::dvec3> palette_color(const nlohmann::json& json, double place,
                                        const Reader& reader) {
    const auto colors = part(json, "Palette").find("Colors");
    if (colors == part(json, "Palette").end() || !colors->is_array() || colors->empty())
        return std::nullopt;
    const double at = std::clamp(place, 0.0, 1.0) * static_cast<double>(colors->size() - 1);
    const auto low = static_cast<std::size_t>(at);
    const std::size_t high = std::min(low + 1, colors->size() - 1);
    const auto color = [&](std::size_t i) {
        const nlohmann::json& c = (*colors)[i];
        if (!c.is_object()) reader.refuse("Palette: expected colours of X, Y and Z");
        const glm::dvec3 rgb{reader.number(c, "X", 0, "Palette"),
                             reader.number(c, "Y", 0, "Palette"),
                             reader.number(c, "Z", 0, "Palette")};
        return glm::dvec3{std::clamp(rgb.x, 0.0, 1.0), std::clamp(rgb.y, 0.0, 1.0),
                          std::clamp(rgb.z, 0.0, 1.0)};
    };
    const double share = at - static_cast<double>(low);
    const glm::dvec3 mixed = (1 - share) * color(low) + share * color(high);
    const auto linear = [](double v) {  // as a screen shows it: a power of 2.2 is near enough
        return std::round(std::pow(v, 2.2) * color_steps) / color_steps;
    };
    return glm::dvec3{linear(mixed.x), linear(mixed.y), linear(mixed.z)};
}

class SceneWriter {
  public:
    SceneWriter(const nlohmann::json& json, const Reader& reader) : json_(json), reader_(reader) {}

    Scene scene(const std::string& name) {
        const nlohmann::json& list = json_["Iterators"];
        if (list.size() > most_iterators)
            reader_.refuse(fmt::format("more than {} iterators", most_iterators));
        for (std::size_t i = 0; i < list.size(); ++i) {
            iterators_.push_back(iterator_of(list[i], i + 1, reader_));
            if (iterators_.back().weight > 0) live_.push_back(i);
        }
        table_ = table_of(json_, iterators_.size(), reader_);
        live_ = lasting_maps(
            live_, [&](std::size_t before, std::size_t next) { return table_[before][next] > 0; });
        if (live_.empty()) reader_.refuse("no iterator comes again and again");
        Scene scene = imported_scene(block(), name, Space::solid, reader_.source);
        write_view(scene);
        return scene;
    }

  private:
    [[nodiscard]] bool all_follow() const {
        return std::ranges::all_of(live_, [&](std::size_t i) {
            return std::ranges::all_of(live_, [&](std::size_t j) { return table_[i][j] > 0; });
        });
    }

    static MapReference reference(std::size_t i) { return {fmt::format("iterator_{}", i + 1), {}}; }

    [[nodiscard]] IfsBlock block() const {
        IfsBlock block;
        std::vector<MapReference> shown;
        for (const std::size_t i : live_) {
            const Iterator& iterator = iterators_[i];
            MapBlock map;
            map.name = fmt::format("iterator_{}", i + 1);
            map.commands = {{MatrixCommand{iterator.map}, {}}};
            map.weight = iterator.weight;
            if (const auto rgb = palette_color(json_, iterator.color_index, reader_);
                rgb && iterator.color_speed > 0)
                map.color = {rgb->x, rgb->y, rgb->z,
                             std::round(iterator.color_speed * color_steps) / color_steps};
            block.maps.push_back(std::move(map));
            if (iterator.opacity > 0) shown.push_back(reference(i));
        }
        if (shown.empty()) reader_.refuse("no iterator has opacity");
        if (!all_follow()) write_follow(block);
        if (!all_follow() || shown.size() < live_.size()) block.start = std::move(shown);
        return block;
    }

    void write_follow(IfsBlock& block) const {
        for (const std::size_t next : live_) {
            FollowRule rule{reference(next), {}};
            for (const std::size_t before : live_)
                if (table_[before][next] > 0) rule.followers.push_back(reference(before));
            block.follow.push_back(std::move(rule));
        }
    }

    /// The camera stands at its position and looks along z, turned by the quaternion; its angle is
    /// that across the picture. Its axes are a scene's: x to the right, y up, z away.
    void write_view(Scene& scene) const {
        const nlohmann::json& camera = part(json_, "Camera");
        if (camera.empty()) return;
        const nlohmann::json& q = part(camera, "Orientation");
        const auto component = [&](const char* key, double otherwise) {
            return reader_.number(q, key, otherwise, "Orientation");
        };
        const glm::dvec3 v{component("X", 0), component("Y", 0), component("Z", 0)};
        const double w = component("W", 1);
        const double length = std::sqrt(glm::dot(v, v) + w * w);
        if (!(length > 1e-6)) return;
        const auto turned = [&](const glm::dvec3& p) {
            const glm::dvec3 t = 2.0 * glm::cross(v / length, p);
            return p + (w / length) * t + glm::cross(v / length, t);
        };
        const glm::dvec3 eye = reader_.vector(camera, "Position", {0, 0, -10}, "Camera");
        const glm::dvec3 look = eye + turned({0, 0, 1});
        const glm::dvec3 up = turned({0, 1, 0});
        const auto at = [](const glm::dvec3& p) {
            return DecimalVec3{Decimal{p.x + 0.0, {}}, Decimal{p.y + 0.0, {}},
                               Decimal{p.z + 0.0, {}}};
        };
        CameraBlock block;
        block.eye = at(eye);
        block.look = at(look);
        block.up = up;
        block.fov = 1 + std::fmod(reader_.number(camera, "FieldOfView", 60, "Camera"), 179);
        if (!(*block.fov > 0 && *block.fov < 180)) block.fov.reset();
        scene.camera = block;
        write_size(scene);
    }

    /// "ImageResolution": "1920, 1080".
    void write_size(Scene& scene) const {
        const auto found = json_.find("ImageResolution");
        if (found == json_.end() || !found->is_string()) return;
        long columns = 0;
        long rows = 0;
        char rest = 0;
        const std::string text = found->get<std::string>();
        if (std::sscanf(text.c_str(), "%6ld , %6ld%c", &columns, &rows, &rest) != 2) return;
        if (std::min(columns, rows) < 1 || std::max(columns, rows) > image_side_pixels) return;
        ImageBlock image;
        image.size = PixelSize{columns, rows};
        scene.image = image;
    }

    const nlohmann::json& json_;
    const Reader& reader_;
    std::vector<Iterator> iterators_;
    Table table_;
    std::vector<std::size_t> live_;
};

}  // namespace

Imported import_ifsjson(const SourceFile& source) {
    const Reader reader{source};
    const nlohmann::json json = parsed(reader);
    std::string name = bare_name(source.name);
    if (const auto title = json.find("Title");
        title != json.end() && title->is_string() && !title->get<std::string>().empty())
        name = title->get<std::string>();
    Scene scene = SceneWriter(json, reader).scene(name);
    return finished(std::move(scene),
                    fmt::format("{}: \"{}\" of {} (IFSRenderer)", scene_name(name),
                                printable(name, 200), file_name(source.name)));
}

}  // namespace pxm::host
