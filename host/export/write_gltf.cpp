// The buffer of a glTF, and a .glb around it. Cells of many kinds come mixed, each with several
// numbers that lie apart: every kind of number has a stream of its own into the file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/export/gltf_layout.hpp"
#include "host/export/turn_of.hpp"
#include "host/export/writers.hpp"

namespace pxm::host {
namespace {

class Stream {
  public:
    Stream(CheckedFile& file, std::uint64_t at) : file_(&file), at_(at) {}

    template <class Value>
    void put(const Value& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
        if (bytes_.size() >= piece) flush();
    }
    void put_floats(const glm::dvec3& v) {
        put(std::array{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
    }
    void flush() {
        (void)file_->write_at(static_cast<std::int64_t>(at_), bytes_.data(), bytes_.size());
        file_->require();
        at_ += bytes_.size();
        bytes_.clear();
    }

  private:
    static constexpr std::size_t piece = std::size_t{1} << 14U;
    CheckedFile* file_;
    std::uint64_t at_;
    std::string bytes_;
};

/// Writes one group's cells.
class GroupWriter {
  public:
    GroupWriter(const GltfGroup& group, const ExportSystem& system, CheckedFile& file,
                std::uint64_t start)
        : group_(group),
          shape_(system.sets[group.set].shape),
          triangles_(triangles_of(shape_)),
          positions_(file, start + group.positions_at),
          indices_(file, start + group.indices_at),
          translations_(file, start + group.translations_at),
          rotations_(file, start + group.rotations_at),
          scales_(file, start + group.scales_at),
          colors_(file, start + group.colors_at) {
        if (group_.instanced) put_shape(Cell{});
    }

    void add(const Cell& cell) {
        if (!group_.instanced) return put_shape(cell);
        const bool plain = group_.rotations_at == GltfGroup::none;
        translations_.put_floats(cell.place.translation);
        if (plain) {
            const glm::dmat3& m = cell.place.linear;
            scales_.put_floats({m[0][0], m[1][1], m[2][2]});
        } else {
            const TurnAndStretch parts = turn_and_stretch(cell.place.linear);
            const glm::dvec4& q = parts.quaternion;
            rotations_.put(std::array{static_cast<float>(q.x), static_cast<float>(q.y),
                                      static_cast<float>(q.z), static_cast<float>(q.w)});
            scales_.put_floats(parts.stretch);
        }
        if (group_.colors_at != GltfGroup::none) colors_.put_floats(cell.color);
    }

    void finish() {
        for (Stream* stream :
             {&positions_, &indices_, &translations_, &rotations_, &scales_, &colors_})
            stream->flush();
    }

  private:
    void put_shape(const Cell& cell) {
        const auto byte = [](double v) {
            return static_cast<unsigned char>(std::lround(255 * std::clamp(v, 0.0, 1.0)));
        };
        const bool colored = !group_.instanced && group_.colors_at != GltfGroup::none;
        const std::array color{byte(cell.color.r), byte(cell.color.g), byte(cell.color.b),
                               static_cast<unsigned char>(255)};
        for (const glm::dvec3& v : shape_.vertices) {
            positions_.put_floats(cell.place.point(v));
            if (colored) colors_.put(color);
        }
        const bool mirrored = determinant(cell.place) < 0;
        for (const auto& [a, b, c] : triangles_)
            indices_.put(
                std::array{base_ + a, base_ + (mirrored ? c : b), base_ + (mirrored ? b : c)});
        base_ += static_cast<std::uint32_t>(shape_.vertices.size());
    }

    const GltfGroup& group_;
    const Mesh& shape_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::uint32_t base_ = 0;
    Stream positions_, indices_, translations_, rotations_, scales_, colors_;
};

void write_data(const ExportJob& job, CheckedFile& file, std::uint64_t start) {
    const GltfLayout layout = gltf_layout(job.scene, job.tally);
    std::vector<GroupWriter> writers;
    writers.reserve(layout.groups.size());
    std::vector<std::vector<GroupWriter*>> of_set;
    for (const ExportSystem& system : job.scene.systems)
        of_set.emplace_back(system.sets.size(), nullptr);
    for (const GltfGroup& group : layout.groups) {
        writers.emplace_back(group, job.scene.systems[group.system], file, start);
        of_set[group.system][group.set] = &writers.back();
    }
    for_each_cell(job.scene, job.watch, [&](const ExportSystem& system, const Cell& cell) {
        const auto i = static_cast<std::size_t>(&system - job.scene.systems.data());
        of_set[i][static_cast<std::size_t>(cell.set)]->add(cell);
    });
    for (GroupWriter& writer : writers) writer.finish();
}

constexpr std::uint32_t glb_magic = 0x46546C67;  // glTF 2.0, Sec. 4.4
constexpr std::uint32_t json_chunk = 0x4E4F534A;
constexpr std::uint32_t binary_chunk = 0x004E4942;
constexpr std::uint64_t glb_heads = 12 + 8 + 8;  // bytes

std::string padded_json(const ExportJob& job) {
    std::string json = gltf_json(job, "");
    while (json.size() % 4 != 0) json += ' ';
    return json;
}

}  // namespace

void require_instances(const CellTally& tally) {
    constexpr std::uint64_t least_bytes = 24;  // a translation and a scale
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (tally.cells > most / least_bytes)
        throw Error(ErrorKind::setting,
                    "too many cells: a .glb holds 4 GiB at most; --format gltf holds more");
}

void require_gltf(const ExportScene& scene, const CellTally& tally, bool is_glb) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    constexpr std::uint64_t room = 16'000'000;  // for the JSON
    const GltfLayout layout = gltf_layout(scene, tally);
    for (const GltfGroup& group : layout.groups)
        if (!group.instanced && group.vertices >= most)
            throw Error(ErrorKind::setting,
                        fmt::format("{} vertices: those of a glTF mesh end at {}; fewer --levels",
                                    group.vertices, most - 1));
    if (is_glb && layout.bytes > most - room)
        throw Error(ErrorKind::setting,
                    fmt::format("{} bytes: a .glb holds 4 GiB at most; --format gltf holds more",
                                layout.bytes));
    if (tally.number == CoordinateNumber::double_)
        throw Error(ErrorKind::setting,
                    "the cells are too small, or too far from the origin, for the floats of glTF");
}

void write_gltf_data(const ExportJob& job, CheckedFile& file) { write_data(job, file, 0); }

void write_glb(const ExportJob& job, CheckedFile& file) {
    const std::string json = padded_json(job);
    const std::uint64_t bytes = gltf_layout(job.scene, job.tally).bytes;  // a multiple of 4
    const std::uint64_t whole = glb_heads + json.size() + bytes;
    std::string head;
    const auto put = [&](std::uint64_t value) {
        const auto word = static_cast<std::uint32_t>(value);
        head.append(reinterpret_cast<const char*>(&word), sizeof word);
    };
    for (const std::uint64_t word : {std::uint64_t{glb_magic}, std::uint64_t{2}, whole,
                                     std::uint64_t{json.size()}, std::uint64_t{json_chunk}})
        put(word);
    head += json;
    put(bytes);
    put(binary_chunk);
    (void)file.write_at(0, head.data(), head.size());
    file.require();
    write_data(job, file, head.size());
}

}  // namespace pxm::host
