#include "host/node_program/write_floor_block.hpp"

#include "dsp_kernels/floor_block.hpp"

namespace pxm::host {

namespace {

/// The sizes of an image, finest first; returns the address of the first.
template <class Real>
std::uint32_t write_levels(BlockWriter<Real>& block, const CompiledTexture& texture) {
    using Level = kernels::ImageLevelRecord<real_words<Real>>;
    const std::uint32_t first = block.grow(texture.levels.size() * Level::words);
    std::uint32_t address = first;
    for (const CompiledImageLevel& level : texture.levels) {
        block.integer(address + Level::width, level.width);
        block.integer(address + Level::height, level.height);
        block.integer(address + Level::texels, level.texels);
        address += Level::words;
    }
    return first;
}

/// A flat system; returns the address of its start set.
template <class Real>
std::uint32_t write_point_sets(BlockWriter<Real>& block, const CompiledTexture& texture) {
    using Set = kernels::PointSetRecord<real_words<Real>>;
    using Map = kernels::PointMapRecord<real_words<Real>>;
    const std::uint32_t maps = block.grow(texture.maps.size() * Map::words);
    std::vector<std::uint32_t> sets;
    for (const CompiledPointSet& set : texture.sets) {
        const std::uint32_t address = block.grow(Set::words + set.maps.size());
        sets.push_back(address);
        block.integer(address + Set::map_count, static_cast<std::uint32_t>(set.maps.size()));
        block.vector(address + Set::center, set.center);
        block.real(address + Set::radius, set.radius);
        std::uint32_t entry = address + Set::maps;
        for (const int map : set.maps) {
            block.integer(entry++, maps + static_cast<std::uint32_t>(map) * Map::words);
        }
    }
    std::uint32_t address = maps;
    for (const CompiledPointMap& map : texture.maps) {
        block.integer(address + Map::point_set, sets[static_cast<std::size_t>(map.set)]);
        block.vector(address + Map::linear, map.linear[0]);
        block.vector(address + Map::linear + 2 * real_words<Real>, map.linear[1]);
        block.vector(address + Map::offset, map.offset);
        address += Map::words;
    }
    return sets[static_cast<std::size_t>(texture.start)];
}

template <class Real>
std::uint32_t write_texture(BlockWriter<Real>& block, const CompiledTexture& texture) {
    using Texture = kernels::TextureRecord<real_words<Real>>;
    const std::uint32_t address = block.grow(Texture::words);
    block.integer(address + Texture::kind, static_cast<std::uint32_t>(texture.kind));
    block.vector(address + Texture::color, texture.color);
    block.vector(address + Texture::color2, texture.color2);
    block.vector(address + Texture::mean, texture.mean);
    switch (texture.kind) {
        case kernels::TextureKind::image:
            block.integer(address + Texture::level_count,
                          static_cast<std::uint32_t>(texture.levels.size()));
            block.integer(address + Texture::levels, write_levels(block, texture));
            block.real(address + Texture::unit, texture.unit);
            break;
        case kernels::TextureKind::wood:
            block.real(address + Texture::aspect, texture.aspect);
            break;
        case kernels::TextureKind::inclusion:
            block.integer(address + Texture::start_set, write_point_sets(block, texture));
            block.vector(address + Texture::corner, texture.corner);
            block.vector(address + Texture::step, texture.step);
            break;
    }
    return address;
}

template <class Real>
std::uint32_t write_layers(BlockWriter<Real>& block, const CompiledPlane& plane,
                           const std::vector<std::uint32_t>& textures) {
    using Layer = kernels::LayerRecord<real_words<Real>>;
    const std::uint32_t first = block.grow(plane.layers.size() * Layer::words);
    std::uint32_t address = first;
    for (const CompiledLayer& layer : plane.layers) {
        block.integer(address + Layer::texture, textures[static_cast<std::size_t>(layer.texture)]);
        block.integer(address + Layer::first_u, static_cast<std::uint32_t>(layer.first_u));
        block.integer(address + Layer::first_v, static_cast<std::uint32_t>(layer.first_v));
        block.vector(address + Layer::origin, layer.origin);
        block.vector(address + Layer::across, layer.across);
        block.vector(address + Layer::along, layer.along);
        address += Layer::words;
    }
    return first;
}

}  // namespace

template <class Real>
void write_floor(BlockWriter<Real>& block, const CompiledScene& scene) {
    using Header = kernels::HeaderRecord<real_words<Real>>;
    using Plane = kernels::PlaneRecord<real_words<Real>>;
    std::vector<std::uint32_t> textures;
    for (const CompiledTexture& texture : scene.textures) {
        textures.push_back(write_texture(block, texture));
    }
    std::uint32_t address = block.grow(scene.planes.size() * Plane::words);
    block.integer(Header::planes, address);
    block.integer(Header::plane_count, static_cast<std::uint32_t>(scene.planes.size()));
    for (const CompiledPlane& plane : scene.planes) {
        block.integer(address + Plane::layer_count,
                      static_cast<std::uint32_t>(plane.layers.size()));
        block.integer(address + Plane::layers, write_layers(block, plane, textures));
        block.vector(address + Plane::normal, plane.normal);
        block.real(address + Plane::offset, plane.offset);
        block.vector(address + Plane::color, plane.color);
        block.real(address + Plane::diffuse, plane.diffuse);
        block.real(address + Plane::reflect, plane.reflect);
        address += Plane::words;
    }
}

template void write_floor(BlockWriter<dsp32::Float>&, const CompiledScene&);
template void write_floor(BlockWriter<float>&, const CompiledScene&);
template void write_floor(BlockWriter<double>&, const CompiledScene&);
template void write_floor(BlockWriter<long double>&, const CompiledScene&);

}  // namespace pxm::host
