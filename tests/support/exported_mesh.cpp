#include "tests/support/exported_mesh.hpp"

#include <cstdint>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace pxm::test {
namespace {

using Json = nlohmann::json;

template <class Value>
Value value_at(const std::string& bytes, std::size_t& at) {
    Value value{};
    if (at + sizeof value > bytes.size()) throw std::runtime_error("cut short");
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}

glm::dvec3 floats_at(const std::string& bytes, std::size_t at) {
    const auto x = value_at<float>(bytes, at);
    const auto y = value_at<float>(bytes, at);
    const auto z = value_at<float>(bytes, at);
    return {x, y, z};
}

std::size_t count_behind(const std::string& text, const std::string& word) {
    return std::stoul(text.substr(text.find(word) + word.size()));
}

/// v' = v + 2 q x (q x v + w v)
glm::dvec3 turned(const std::array<double, 4>& q, const glm::dvec3& v) {
    const glm::dvec3 axis{q[0], q[1], q[2]};
    return v + 2.0 * glm::cross(axis, glm::cross(axis, v) + q[3] * v);
}

class Gltf {
  public:
    Gltf(Json json, std::string data) : json_(std::move(json)), data_(std::move(data)) {}

    Triangles triangles() const {
        if (json_["buffers"][0]["byteLength"] != data_.size())
            throw std::runtime_error("the buffer has another length");
        Triangles all;
        for (const Json& number : json_["scenes"][0]["nodes"])
            add_node(json_["nodes"][number.get<int>()], all);
        return all;
    }

  private:
    [[nodiscard]] std::size_t place(const Json& accessor) const {
        const Json& view = json_["bufferViews"][accessor["bufferView"].get<int>()];
        return view["byteOffset"].get<std::size_t>();
    }
    [[nodiscard]] const Json& accessor(const Json& number) const {
        return json_["accessors"][number.get<int>()];
    }

    Triangles mesh(const Json& mesh) const {
        const Json& primitive = mesh["primitives"][0];
        const Json& positions = accessor(primitive["attributes"]["POSITION"]);
        const Json& indices = accessor(primitive["indices"]);
        Triangles triangles;
        std::size_t at = place(indices);
        for (std::size_t i = 0; i < indices["count"].get<std::size_t>() / 3; ++i) {
            Triangle triangle;
            for (glm::dvec3& corner : triangle) {
                const auto number = value_at<std::uint32_t>(data_, at);
                if (number >= positions["count"].get<std::size_t>())
                    throw std::runtime_error("an index beyond the vertices");
                corner = floats_at(data_, place(positions) + 12 * std::size_t{number});
                for (int k = 0; k < 3; ++k)
                    if (corner[k] < positions["min"][k].get<double>() ||
                        corner[k] > positions["max"][k].get<double>())
                        throw std::runtime_error("a vertex beyond min and max");
            }
            triangles.push_back(triangle);
        }
        return triangles;
    }

    void add_node(const Json& node, Triangles& all) const {
        const Triangles shape = mesh(json_["meshes"][node["mesh"].get<int>()]);
        if (!node.contains("extensions")) {
            all.insert(all.end(), shape.begin(), shape.end());
            return;
        }
        const Json& attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
        const Json& places = accessor(attributes["TRANSLATION"]);
        const std::size_t scales = place(accessor(attributes["SCALE"]));
        for (std::size_t i = 0; i < places["count"].get<std::size_t>(); ++i) {
            std::array<double, 4> q{0, 0, 0, 1};
            if (attributes.contains("ROTATION")) {
                std::size_t at = place(accessor(attributes["ROTATION"])) + 16 * i;
                for (double& part : q) part = value_at<float>(data_, at);
            }
            const glm::dvec3 scale = floats_at(data_, scales + 12 * i);
            for (Triangle triangle : shape) {
                for (glm::dvec3& v : triangle)
                    v = turned(q, scale * v) + floats_at(data_, place(places) + 12 * i);
                if (scale.x * scale.y * scale.z < 0) std::swap(triangle[1], triangle[2]);
                all.push_back(triangle);
            }
        }
    }

    Json json_;
    std::string data_;
};

}  // namespace

Triangles triangles_of_ply(const std::string& bytes) {
    const std::string end = "end_header\n";
    std::size_t at = bytes.find(end) + end.size();
    const std::string head = bytes.substr(0, at);
    const bool doubles = head.find("property double x") != std::string::npos;
    std::vector<glm::dvec3> vertices(count_behind(head, "element vertex "));
    for (glm::dvec3& v : vertices) {
        for (int k = 0; k < 3; ++k)
            v[k] = doubles ? value_at<double>(bytes, at) : value_at<float>(bytes, at);
        at += 3;
    }
    Triangles triangles;
    for (std::size_t i = count_behind(head, "element face "); i > 0; --i) {
        std::vector<std::uint32_t> face(value_at<std::uint8_t>(bytes, at));
        for (std::uint32_t& corner : face) corner = value_at<std::uint32_t>(bytes, at);
        for (std::size_t k = 2; k < face.size(); ++k)
            triangles.push_back(
                {vertices.at(face[0]), vertices.at(face[k - 1]), vertices.at(face[k])});
    }
    if (at != bytes.size()) throw std::runtime_error("more than the header says");
    return triangles;
}

Triangles triangles_of_obj(const std::string& text) {
    std::istringstream lines(text);
    std::vector<glm::dvec3> vertices;
    Triangles triangles;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            glm::dvec3 v;
            words >> v.x >> v.y >> v.z;
            vertices.push_back(v);
        } else if (kind == "f") {
            std::vector<std::size_t> face;
            for (std::size_t corner = 0; words >> corner;) face.push_back(corner - 1);
            for (std::size_t k = 2; k < face.size(); ++k)
                triangles.push_back(
                    {vertices.at(face[0]), vertices.at(face[k - 1]), vertices.at(face[k])});
        }
    }
    return triangles;
}

Triangles triangles_of_stl(const std::string& bytes) {
    std::size_t at = 80;
    Triangles triangles(value_at<std::uint32_t>(bytes, at));
    for (Triangle& triangle : triangles) {
        const glm::dvec3 normal = floats_at(bytes, at);
        for (int k = 0; k < 3; ++k) triangle[k] = floats_at(bytes, at + 12 * (k + 1));
        at += 50;
        const glm::dvec3 across = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
        if (!(glm::dot(normal, across) > 0.99 * glm::length(across)))
            throw std::runtime_error("a normal that is not that of its triangle");
    }
    if (at != bytes.size()) throw std::runtime_error("another count of triangles");
    return triangles;
}

Triangles triangles_of_gltf(const std::string& bytes, const std::string& data) {
    if (!data.empty()) return Gltf(Json::parse(bytes), data).triangles();
    std::size_t at = 0;
    if (value_at<std::uint32_t>(bytes, at) != 0x46546C67U ||
        value_at<std::uint32_t>(bytes, at) != 2 ||
        value_at<std::uint32_t>(bytes, at) != bytes.size())
        throw std::runtime_error("no GLB");
    const auto json_bytes = value_at<std::uint32_t>(bytes, at);
    at += 4;
    const Json json = Json::parse(bytes.substr(at, json_bytes));
    at += json_bytes;
    const auto data_bytes = value_at<std::uint32_t>(bytes, at);
    at += 4;
    if (at + data_bytes != bytes.size()) throw std::runtime_error("chunks of another length");
    return Gltf(json, bytes.substr(at)).triangles();
}

double inside_of(const Triangles& triangles) {
    double volume = 0;
    for (const auto& [a, b, c] : triangles) volume += glm::dot(a, glm::cross(b, c)) / 6;
    return volume;
}

bool has_no_rim(const Triangles& triangles) {
    using Corner = std::array<double, 3>;
    std::map<std::pair<Corner, Corner>, int> passed;
    const auto corner = [](const glm::dvec3& v) { return Corner{v.x + 0.0, v.y + 0.0, v.z + 0.0}; };
    for (const Triangle& triangle : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Corner a = corner(triangle[i]), b = corner(triangle[(i + 1) % 3]);
            passed[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    for (const auto& [edge, balance] : passed)
        if (balance != 0) return false;
    return !passed.empty();
}

Extent extent_of(const Triangles& triangles) {
    Extent extent{triangles.at(0)[0], triangles.at(0)[0]};
    for (const Triangle& triangle : triangles)
        for (const glm::dvec3& v : triangle) {
            extent.low = glm::min(extent.low, v);
            extent.high = glm::max(extent.high, v);
        }
    return extent;
}

}  // namespace pxm::test
