// The module that is linked to OpenVDB, for level sets: it brings TBB, Blosc and Boost with it.
#include <openvdb/io/Archive.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/FastSweeping.h>
#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

#include "host/export/vdb_library.hpp"

namespace pxm::host {

namespace {

using openvdb::Coord;
using openvdb::FloatGrid;
using Leaf = openvdb::FloatTree::LeafNodeType;

constexpr std::size_t identifier_at = 21;  // bytes, behind the magic number, versions and a flag
constexpr std::string_view identifier_form = "xxxxxxxx-xxxx-4xxx-8xxx-xxxxxxxxxxxx";  // RFC 4122

std::uint64_t hash_of(std::string_view bytes, std::uint64_t start) {
    constexpr std::uint64_t prime = 1'099'511'628'211;  // FNV-1a, of 64 bits
    for (const char byte : bytes) start = (start ^ static_cast<unsigned char>(byte)) * prime;
    return start;
}

/// OpenVDB draws lots for a file's identifier: two runs would make two files. It is made of the
/// contents instead, which serves as well.
void identify_by_contents(std::string& bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    constexpr std::uint64_t basis = 14'695'981'039'346'656'037U;  // FNV-1a
    constexpr std::size_t digits_a_hash = 16;
    const std::size_t end = identifier_at + identifier_form.size();
    if (bytes.size() < end || bytes[identifier_at + 8] != '-' || bytes[end - 13] != '-') return;
    const std::string_view contents = std::string_view(bytes).substr(end);
    std::uint64_t hash = hash_of(contents, basis);
    std::size_t used = 0;
    for (std::size_t i = 0; i < identifier_form.size(); ++i) {
        char& c = bytes[identifier_at + i];
        c = identifier_form[i];
        if (c != 'x') continue;
        if (used == digits_a_hash) hash = hash_of(contents, hash);
        used = used % digits_a_hash + 1;
        c = digits[hash & 0xfU];
        hash >>= 4U;
    }
}

/// What OpenVDB would write to a path, in memory.
class Archive : public openvdb::io::Archive {
  public:
    Ptr copy() const override { return std::make_shared<Archive>(*this); }
    [[nodiscard]] std::string bytes_of(const FloatGrid::Ptr& grid) const {
        std::ostringstream out(std::ios::binary);
        write(out, openvdb::GridCPtrVec{grid}, true);
        std::string bytes = std::move(out).str();
        identify_by_contents(bytes);
        return bytes;
    }

  private:
    using openvdb::io::Archive::write;
};

Coord coord(const glm::ivec3& v) { return {v.x, v.y, v.z}; }

class Grid final : public LevelSet {
  public:
    explicit Grid(const SampleGrid& samples)
        : voxel_(samples.voxel),
          band_(static_cast<float>(level_set_band * samples.voxel)),
          grid_(FloatGrid::create(band_)),
          accessor_(grid_->getAccessor()) {
        const glm::dvec3& first = samples.first;
        auto transform = openvdb::math::Transform::createLinearTransform(voxel_);
        transform->postTranslate({first.x, first.y, first.z});
        grid_->setTransform(transform);
        grid_->setGridClass(openvdb::GRID_LEVEL_SET);
        grid_->setName("surface");  // as other programs call it
        grid_->setCreator("pxm " PXM_VERSION);
    }

    void lower(const glm::ivec3& low, const glm::ivec3& size, const float* distances) override {
        Leaf* leaf = accessor_.probeLeaf(coord(low));
        if (leaf == nullptr) {
            if (accessor_.getValue(coord(low)) < 0) return;  // deep inside another cell
            leaf = accessor_.touchLeaf(coord(low));
            ++leaves_;
        }
        for (int x = 0; x < size.x; ++x)
            for (int y = 0; y < size.y; ++y)
                for (int z = 0; z < size.z; ++z)
                    lower(*leaf, low + glm::ivec3{x, y, z}, *distances++);
    }

    void fill(const glm::ivec3& low, int edge) override {
        const Coord first = coord(low);
        grid_->tree().fill({first, first.offsetBy(edge - 1)}, -band_, false);
        accessor_.clear();
    }

    std::uint64_t samples() override { return leaves_ * Leaf::SIZE; }

    std::string file(const std::string& title) override {
        deepen();
        openvdb::tools::pruneLevelSet(grid_->tree());
        grid_->insertMeta("title", openvdb::StringMetadata(title));
        return Archive().bytes_of(grid_);
    }

  private:
    void lower(Leaf& leaf, const glm::ivec3& sample, float distance) const {
        const openvdb::Index at = Leaf::coordToOffset(coord(sample));
        const float length = static_cast<float>(distance * voxel_);
        if (!(length < leaf.getValue(at))) return;
        if (length > -band_)
            leaf.setValueOn(at, length);
        else
            leaf.setValueOff(at, -band_);
    }

    /// Inside, distances are those to the nearest face of a cell, which may lie within the union. A
    /// sweep from where the sign changes tells the distance to the union's surface, to first order.
    void deepen() {
        if (grid_->activeVoxelCount() == 0) return;
        const FloatGrid::Ptr swept = openvdb::tools::sdfToSdf(*grid_);
        auto deeper = swept->getConstAccessor();
        for (auto value = grid_->beginValueOn(); value; ++value) {
            if (*value >= 0) continue;
            const float depth = std::min(*value, deeper.getValue(value.getCoord()));
            value.setValue(std::max(depth, -band_));
            if (depth <= -band_) value.setValueOff();
        }
    }

    double voxel_;
    float band_;
    FloatGrid::Ptr grid_;
    FloatGrid::Accessor accessor_;
    std::uint64_t leaves_ = 0;
};

class Library final : public VdbLibrary {
  public:
    Library() { openvdb::initialize(); }
    std::unique_ptr<LevelSet> level_set(const SampleGrid& grid) const override {
        return std::make_unique<Grid>(grid);
    }
};

}  // namespace

}  // namespace pxm::host

extern "C" __attribute__((visibility("default"))) const pxm::host::VdbLibrary* pxm_vdb_library() {
    static const pxm::host::Library library;
    return &library;
}
