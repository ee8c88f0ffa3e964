#include <nlohmann/json.hpp>

#include "host/export/cell_stream.hpp"
#include "host/export/gltf_size.hpp"
#include "host/text/json_text.hpp"

namespace pxm::host {

namespace {

using Json = nlohmann::ordered_json;

constexpr int of_floats = 5126, of_indices = 5125;       // component types
constexpr int of_vertices = 34962, of_elements = 34963;  // a buffer view's target
constexpr const char* extension = "EXT_mesh_gpu_instancing";

class Description {
  public:
    Json parts_json(const std::vector<GltfPart>& parts) {
        Json nodes = Json::array();
        Json children = Json::array();
        Json meshes = Json::array(), materials = Json::array();
        nodes.push_back(nullptr);  // the root, which all the others are children of
        for (const GltfPart& part : parts) {
            children.push_back(nodes.size());
            nodes.push_back(node(part, meshes.size()));
            meshes.push_back(mesh(part, materials.size()));
            materials.push_back(material(*part.object));
        }
        nodes[0] = {{"name", "pxm"}, {"children", children}};
        return {{"nodes", nodes}, {"meshes", meshes}, {"materials", materials}};
    }

  private:
    Json mesh(const GltfPart& part, std::size_t material) {
        Json positions = accessor("VEC3", of_floats, part.vertices, 12, of_vertices);
        accessors_.back()["min"] = part.low;
        accessors_.back()["max"] = part.high;
        Json indices = accessor("SCALAR", of_indices, 3 * part.triangles, 4, of_elements);
        return {{"name", part.object->name},
                {"primitives", Json::array({{{"attributes", {{"POSITION", positions}}},
                                             {"indices", indices},
                                             {"material", material}}})}};
    }

    static Json node(const GltfPart& part, std::size_t mesh) {
        return {{"name", part.object->name}, {"mesh", mesh}};
    }

    static Json material(const ExportedObject& object) {
        return {{"pbrMetallicRoughness",
                 {{"baseColorFactor", {object.color.r, object.color.g, object.color.b, 1}},
                  {"metallicFactor", 0},
                  {"roughnessFactor", 1}}}};
    }

    Json accessor(const char* type, int component, std::uint64_t count, std::uint64_t bytes,
                  int target) {
        Json view{{"buffer", 0}, {"byteOffset", end_}, {"byteLength", count * bytes}};
        if (target != 0) view["target"] = target;
        end_ += count * bytes;
        views_.push_back(view);
        accessors_.push_back({{"bufferView", views_.size() - 1},
                              {"componentType", component},
                              {"count", count},
                              {"type", type}});
        return accessors_.size() - 1;
    }

  public:
    /// The attributes of the instances, which follow all meshes' numbers.
    void add_instances(Json& nodes, const std::vector<GltfPart>& parts) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i].instances == 0) continue;
            Json& attributes = nodes[i + 1]["extensions"][extension]["attributes"];
            const std::uint64_t count = parts[i].instances;
            attributes = Json::object();
            attributes["TRANSLATION"] = accessor("VEC3", of_floats, count, 12, 0);
            attributes["ROTATION"] = accessor("VEC4", of_floats, count, 16, 0);
            attributes["SCALE"] = accessor("VEC3", of_floats, count, 12, 0);
        }
    }
    [[nodiscard]] const Json& accessors() const { return accessors_; }
    [[nodiscard]] const Json& views() const { return views_; }

  private:
    Json accessors_ = Json::array();
    Json views_ = Json::array();
    std::uint64_t end_ = 0;
};

}  // namespace

std::string gltf_json(const std::vector<GltfPart>& parts, const CellFile& cells,
                      const std::string& buffer) {
    Description description;
    Json all = description.parts_json(parts);
    description.add_instances(all["nodes"], parts);
    all["accessors"] = description.accessors();
    all["bufferViews"] = description.views();
    const glm::dvec3 origin = file_coordinates(cells).direction(cells.offset);
    if (cells.offset != glm::dvec3{0.0})
        all["nodes"][0]["translation"] = {origin.x, origin.y, origin.z};
    Json file{{"asset", {{"version", "2.0"}, {"generator", cells.title}}}};
    const bool instances =
        std::ranges::any_of(parts, [](const GltfPart& part) { return part.instances > 0; });
    if (instances) file["extensionsUsed"] = file["extensionsRequired"] = {extension};
    file["scene"] = 0;
    file["scenes"] = Json::array({{{"nodes", {0}}}});
    file.update(all);
    Json bytes{{"byteLength", gltf_buffer_bytes(parts)}};
    if (!buffer.empty()) bytes["uri"] = buffer + gltf_buffer_mark;
    file["buffers"] = Json::array({bytes});
    return json_text(file);
}

}  // namespace pxm::host
