// glTF 2.0: a mesh with the places of its cells (EXT_mesh_gpu_instancing), or triangles. The buffer
// has the meshes' vertices and indices first, then each part's translations, rotations and scales.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "host/export/cell_stream.hpp"
#include "host/export/gltf_size.hpp"

namespace pxm::host {

namespace {

/// A place as glTF says it: moved, turned and scaled along the mesh's own axes.
struct Instance {
    glm::dvec3 translation;
    glm::dquat rotation;
    glm::dvec3 scale;
};

/// Precondition: the columns are perpendicular to one another, or zero.
Instance instance_of(const Affine& place) {
    glm::dmat3 axes = place.linear;
    glm::dvec3 scale{0.0};
    for (int i = 0; i < 3; ++i) scale[i] = glm::length(axes[i]);
    const auto any_across = [](const glm::dvec3& u) {
        const glm::dvec3 other = std::abs(u.x) < 0.5 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
        return glm::normalize(glm::cross(u, other));
    };
    for (int i = 0; i < 3; ++i)
        if (scale[i] > 0) axes[i] /= scale[i];
    for (int i = 0; i < 3; ++i) {  // an axis that a singular map took away may point anywhere
        if (scale[i] > 0) continue;
        const glm::dvec3 next = axes[(i + 1) % 3], last = axes[(i + 2) % 3];
        axes[i] = glm::length(next) > 0 && glm::length(last) > 0 ? glm::cross(next, last)
                  : glm::length(next) > 0                        ? any_across(next)
                  : glm::length(last) > 0                        ? any_across(last)
                                                                 : glm::dvec3{1, 0, 0};
    }
    if (glm::determinant(axes) < 0) {
        axes[0] = -axes[0];
        scale.x = -scale.x;
    }
    return {place.translation, glm::normalize(glm::quat_cast(axes)), scale};
}

/// Where bytes go: as they are, or as the text of a data URI.
class GltfBytes {
  public:
    GltfBytes(ByteStream& out, bool binary) : out_(out), binary_(binary) {}

    template <class Value>
    void put(const Value& value) {
        const std::string_view bytes{reinterpret_cast<const char*>(&value), sizeof value};
        if (binary_) return out_.put(bytes);
        for (const char byte : bytes) {
            three_[count_++] = static_cast<unsigned char>(byte);
            if (count_ == 3) put_three();
        }
    }
    void put_vector(const glm::dvec3& v) {
        for (int i = 0; i < 3; ++i) put(static_cast<float>(v[i]));
    }
    void finish() {
        if (count_ > 0) put_three();
    }

  private:
    void put_three() {
        constexpr std::string_view digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (std::size_t i = count_; i < 3; ++i) three_[i] = 0;
        const unsigned bits = three_[0] << 16U | three_[1] << 8U | three_[2];
        char text[4];
        for (unsigned i = 0; i < 4; ++i)
            text[i] = i > count_ ? '=' : digits[bits >> (18 - 6 * i) & 63U];
        out_.put({text, 4});
        count_ = 0;
    }

    ByteStream& out_;
    bool binary_;
    std::array<unsigned, 3> three_{};
    std::size_t count_ = 0;
};

void widen(GltfPart& part, const glm::dvec3& at) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = static_cast<float>(at[static_cast<int>(i)]);
        part.low[i] = std::min(part.low[i], value);
        part.high[i] = std::max(part.high[i], value);
    }
}

int passes_for(const std::vector<GltfPart>& parts) {
    const auto count = static_cast<int>(parts.size());
    return parts.front().instances > 0 ? 3 * count : 1 + 2 * count;
}

void put_meshes(const std::vector<GltfPart>& parts, GltfBytes& bytes) {
    for (const GltfPart& part : parts) {
        const Mesh& mesh = part.object->meshes[static_cast<std::size_t>(part.set)];
        for (const glm::dvec3& vertex : mesh.vertices) bytes.put_vector(vertex);
        for (const auto& triangle : mesh.triangles) bytes.put(triangle);
    }
}

void put_instances(const std::vector<GltfPart>& parts, CellPasses& passes, GltfBytes& bytes) {
    for (const GltfPart& part : parts) {
        const auto each = [&](const auto& put) {
            passes.go_through(
                [&](const ExportedObject& object, const Cell& cell, const Affine& place) {
                    if (&object == part.object && cell.set == part.set) put(instance_of(place));
                });
        };
        each([&](const Instance& one) { bytes.put_vector(one.translation); });
        each([&](const Instance& one) {
            bytes.put_vector({one.rotation.x, one.rotation.y, one.rotation.z});
            bytes.put(static_cast<float>(one.rotation.w));
        });
        each([&](const Instance& one) { bytes.put_vector(one.scale); });
    }
}

void put_triangles(const std::vector<GltfPart>& parts, CellPasses& passes, GltfBytes& bytes) {
    // Part by part: vertices, then indices.
    for (const GltfPart& part : parts) {
        passes.go_through([&](const ExportedObject& object, const Cell& cell, const Affine& place) {
            if (&object != part.object) return;
            for (const glm::dvec3& vertex : mesh_of(object, cell).vertices)
                bytes.put_vector(place.point(vertex));
        });
        std::uint32_t first = 0;
        passes.go_through([&](const ExportedObject& object, const Cell& cell, const Affine& place) {
            if (&object != part.object) return;
            const Mesh& mesh = mesh_of(object, cell);
            const bool mirrored = is_mirrored(place);
            for (const auto& triangle : mesh.triangles) {
                auto corners = outward(triangle, mirrored);
                for (std::uint32_t& corner : corners) corner += first;
                bytes.put(corners);
            }
            first += static_cast<std::uint32_t>(mesh.vertices.size());
        });
    }
}

}  // namespace

std::vector<GltfPart> gltf_parts(const CellFile& cells) {
    const bool instances = has_instances(cells, CellFormat::glb);
    constexpr float far = std::numeric_limits<float>::infinity();
    std::vector<GltfPart> parts;
    for (const ExportedObject& object : cells.objects) {
        GltfPart all{&object, -1, 0, 0, 0, {far, far, far}, {-far, -far, -far}};
        for (std::size_t set = 0; set < object.counts.size(); ++set) {
            const Mesh& mesh = object.meshes[set];
            GltfPart part = all;
            part.set = static_cast<int>(set);
            part.vertices = mesh.vertices.size();
            part.triangles = mesh.triangles.size();
            part.instances = object.counts[set];
            for (const glm::dvec3& vertex : mesh.vertices) widen(part, vertex);
            if (instances && part.instances > 0) parts.push_back(part);
            all.vertices += part.instances * part.vertices;
            all.triangles += part.instances * part.triangles;
        }
        if (!instances && all.vertices > 0) parts.push_back(all);
    }
    return parts;
}

std::uint64_t gltf_buffer_bytes(const std::vector<GltfPart>& parts) {
    std::uint64_t bytes = 0;
    for (const GltfPart& part : parts)
        bytes += 12 * (part.vertices + part.triangles) + 40 * part.instances;
    return bytes;
}

std::uint64_t gltf_bytes(const CellFile& cells) {
    constexpr std::uint64_t description = 4096;  // of a part
    const std::vector<GltfPart> parts = gltf_parts(cells);
    return gltf_buffer_bytes(parts) + description * (parts.size() + 1);
}

void write_gltf(const CellFile& cells, bool binary, CheckedFile& file) {
    std::vector<GltfPart> parts = gltf_parts(cells);
    const bool instances = parts.front().instances > 0;
    CellPasses passes(cells, passes_for(parts));
    if (!instances) {  // the description says how far the vertices reach
        passes.go_through([&](const ExportedObject& object, const Cell& cell, const Affine& place) {
            for (GltfPart& part : parts) {
                if (part.object != &object) continue;
                for (const glm::dvec3& vertex : mesh_of(object, cell).vertices)
                    widen(part, place.point(vertex));
            }
        });
    }
    ByteStream out(file);
    GltfBytes bytes(out, binary);
    std::string json =
        gltf_json(parts, cells, binary ? "" : "data:application/octet-stream;base64,");
    std::string rest;
    if (binary) {
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const auto length = static_cast<std::uint32_t>(gltf_buffer_bytes(parts));
        const auto words = static_cast<std::uint32_t>(json.size());
        for (const std::uint32_t word :
             {0x4654'6c67U, 2U, 28 + words + length, words, 0x4e4f'534aU})
            out.put_value(word);
        out.put(json);
        for (const std::uint32_t word : {length, 0x004e'4942U}) out.put_value(word);
    } else {
        const std::size_t mark = json.rfind(gltf_buffer_mark);
        rest = json.substr(mark + 1);
        out.put(json.substr(0, mark));
    }
    if (instances) {
        put_meshes(parts, bytes);
        put_instances(parts, passes, bytes);
    } else {
        put_triangles(parts, passes, bytes);
    }
    bytes.finish();
    out.put(rest);
    if (!binary) out.put("\n");
    out.flush();
}

}  // namespace pxm::host
