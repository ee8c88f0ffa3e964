// The JSON of a glTF: which numbers of the buffer are what.
#include <algorithm>
#include <glm/common.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "host/export/gltf_layout.hpp"
#include "host/export/writers.hpp"
#include "host/text/json_text.hpp"

namespace pxm::host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int float_type = 5126;  // glTF 2.0, accessor.componentType
constexpr int uint_type = 5125;
constexpr int byte_type = 5121;
constexpr int vertex_target = 34962;
constexpr int index_target = 34963;

/// As the buffer has them.
Json floats(const glm::dvec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

class Writer {
  public:
    Writer(const ExportJob& job, const GltfLayout& layout) : job_(job), layout_(layout) {}

    std::string text(const std::string& data) {
        for (const GltfGroup& group : layout_.groups) add(group);
        const bool instanced = std::ranges::any_of(layout_.groups, &GltfGroup::instanced);
        Json json;
        json["asset"] = {{"version", "2.0"}, {"generator", job_.title}};
        if (instanced) {
            json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
            json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
        }
        json["scene"] = 0;
        Json all = Json::array();
        for (std::size_t i = 0; i < nodes_.size(); ++i) all.push_back(i);
        json["scenes"] = {{{"nodes", all}}};
        json["nodes"] = nodes_;
        json["meshes"] = meshes_;
        json["materials"] = materials_;
        json["accessors"] = accessors_;
        json["bufferViews"] = views_;
        Json buffer{{"byteLength", layout_.bytes}};
        if (!data.empty()) buffer["uri"] = data;
        json["buffers"] = Json::array({buffer});
        return json_text(json);
    }

  private:
    std::size_t accessor(std::uint64_t at, std::uint64_t bytes, std::uint64_t count, int component,
                         const char* type, int target) {
        Json view{{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes}};
        if (target != 0) view["target"] = target;
        views_.push_back(view);
        accessors_.push_back({{"bufferView", views_.size() - 1},
                              {"componentType", component},
                              {"count", count},
                              {"type", type}});
        return accessors_.size() - 1;
    }

    void add(const GltfGroup& group) {
        const ExportSystem& system = job_.scene.systems[group.system];
        const SetTally& cells = job_.tally.systems[group.system][group.set];
        const Mesh& shape = system.sets[group.set].shape;
        const std::size_t positions = accessor(group.positions_at, group.vertices * 12,
                                               group.vertices, float_type, "VEC3", vertex_target);
        glm::dvec3 low = cells.low, high = cells.high;
        if (group.instanced) {
            low = high = shape.vertices.front();
            for (const glm::dvec3& v : shape.vertices) {
                low = glm::min(low, v);
                high = glm::max(high, v);
            }
        }
        accessors_.back()["min"] = floats(low);
        accessors_.back()["max"] = floats(high);
        const std::size_t indices = accessor(group.indices_at, group.indices * 4, group.indices,
                                             uint_type, "SCALAR", index_target);
        Json attributes{{"POSITION", positions}};
        if (!group.instanced && system.colored) {
            attributes["COLOR_0"] = accessor(group.colors_at, group.vertices * 4, group.vertices,
                                             byte_type, "VEC4", vertex_target);
            accessors_.back()["normalized"] = true;
        }
        add_material(system, cells);
        meshes_.push_back({{"name", system.name},
                           {"primitives", Json::array({{{"attributes", attributes},
                                                        {"indices", indices},
                                                        {"material", materials_.size() - 1}}})}});
        Json node{{"name", system.name}, {"mesh", meshes_.size() - 1}};
        if (group.instanced)
            node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = instances(group);
        nodes_.push_back(node);
    }

    Json instances(const GltfGroup& group) {
        const auto vec3 = [&](std::uint64_t at) {
            return accessor(at, group.cells * 12, group.cells, float_type, "VEC3", 0);
        };
        Json attributes{{"TRANSLATION", vec3(group.translations_at)}};
        if (group.rotations_at != GltfGroup::none)
            attributes["ROTATION"] =
                accessor(group.rotations_at, group.cells * 16, group.cells, float_type, "VEC4", 0);
        attributes["SCALE"] = vec3(group.scales_at);
        if (group.colors_at != GltfGroup::none) attributes["_COLOR_0"] = vec3(group.colors_at);
        return attributes;
    }

    void add_material(const ExportSystem& system, const SetTally& cells) {
        const glm::dvec3 color = system.colored ? glm::dvec3{1.0} : glm::min(system.color, 1.0);
        Json material{{"name", system.name},
                      {"pbrMetallicRoughness",
                       {{"baseColorFactor", {color.r, color.g, color.b, 1}},
                        {"metallicFactor", 0},
                        {"roughnessFactor", 1}}}};
        // Programs differ in whether an instance that mirrors turns its faces over
        // (findings/three_mirrored_instance.sh).
        if (cells.mirrored) material["doubleSided"] = true;
        materials_.push_back(material);
    }

    const ExportJob& job_;
    const GltfLayout& layout_;
    Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array();
    Json accessors_ = Json::array(), views_ = Json::array();
};

}  // namespace

std::string gltf_json(const ExportJob& job, const std::string& data) {
    const GltfLayout layout = gltf_layout(job.scene, job.tally);
    return Writer(job, layout).text(data);
}

}  // namespace pxm::host
