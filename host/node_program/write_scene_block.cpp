#include "host/node_program/write_scene_block.hpp"

#include <bit>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "dsp_kernels/flatness.hpp"
#include "dsp_kernels/floor_block.hpp"
#include "host/math/lipschitz.hpp"
#include "host/node_program/block_writer.hpp"
#include "host/node_program/steepness.hpp"
#include "host/node_program/write_floor_block.hpp"
#include "host/text/digest.hpp"
#include "pxm/real.hpp"

namespace pxm::host {

namespace {

template <class Real>
void write_header(BlockWriter<Real>& block, const CompiledScene& scene) {
    using Header = kernels::HeaderRecord<real_words<Real>>;
    block.integer(Header::width, static_cast<std::uint32_t>(scene.size.columns));
    block.integer(Header::height, static_cast<std::uint32_t>(scene.size.rows));
    block.integer(Header::crop, static_cast<std::uint32_t>(scene.crop.x0));
    block.integer(Header::crop + 1, static_cast<std::uint32_t>(scene.crop.y0));
    block.integer(Header::crop + 2, static_cast<std::uint32_t>(scene.crop.x1));
    block.integer(Header::crop + 3, static_cast<std::uint32_t>(scene.crop.y1));
    block.integer(Header::shading, static_cast<std::uint32_t>(scene.shading));
    block.integer(Header::projection, static_cast<std::uint32_t>(scene.camera.projection));
    block.integer(Header::cell_cap, scene.cell_cap);
    block.integer(Header::method, static_cast<std::uint32_t>(scene.method));
    block.vector(Header::eye, {0, 0, 0});
    block.vector(Header::corner, scene.camera.corner);
    block.vector(Header::across, scene.camera.across);
    block.vector(Header::down, scene.camera.down);
    block.vector(Header::forward, scene.camera.forward);
    block.real(Header::pixel_at_eye, scene.camera.pixel_at_eye);
    block.real(Header::pixel_growth, scene.camera.pixel_growth);
    block.real(Header::detail, scene.detail);
    block.real(Header::fade, scene.fade);
    block.integer(Header::bounces, static_cast<std::uint32_t>(scene.bounces));
    block.vector(Header::ambient, scene.ambient);
    block.vector(Header::background, scene.background);
}

/// The address with that index; 0 if there is none.
std::uint32_t at_or_none(const std::vector<std::uint32_t>& addresses, int index) {
    return index < 0 ? 0 : addresses[static_cast<std::size_t>(index)];
}

/// Bits that number `maps` maps, at least one.
std::uint32_t symbol_bits(std::size_t maps) {
    return maps < 3 ? 1 : static_cast<std::uint32_t>(std::bit_width(maps - 1));
}

/// Writes what the volume of the follow set at `address` is; may add a record of its own.
template <class Real>
void write_volume(BlockWriter<Real>& block, std::uint32_t address, const CompiledVolume& volume) {
    constexpr std::uint32_t R = real_words<Real>;
    using FollowSet = kernels::FollowSetRecord<R>;
    block.integer(address + FollowSet::volume, static_cast<std::uint32_t>(volume.kind));
    block.vector(address + FollowSet::center, volume.center);
    block.real(address + FollowSet::diameter, volume.diameter);
    switch (volume.kind) {
        case kernels::Volume::sphere:
        case kernels::Volume::cone:
        case kernels::Volume::cylinder:
            block.real(address + FollowSet::radius, volume.radius);
            return;
        case kernels::Volume::box:
            block.vector(address + FollowSet::low, volume.low);
            block.vector(address + FollowSet::high, volume.high);
            return;
        case kernels::Volume::oriented: {
            const std::uint32_t shape = block.grow(kernels::OrientedRecord<R>::words);
            block.integer(address + FollowSet::shape, shape);
            std::uint32_t axis = shape + kernels::OrientedRecord<R>::axes;
            for (const glm::dvec3& half : volume.half) {
                block.vector(axis, half / glm::dot(half, half));
                axis += 3 * R;
            }
            return;
        }
        case kernels::Volume::hull: {
            using HalfSpaceOf = kernels::HalfSpaceRecord<R>;
            const std::size_t count = volume.half_spaces.size();
            const std::uint32_t shape =
                block.grow(kernels::HullRecord<R>::words + count * HalfSpaceOf::words);
            block.integer(address + FollowSet::shape, shape);
            block.integer(shape + kernels::HullRecord<R>::count, static_cast<std::uint32_t>(count));
            std::uint32_t plane = shape + kernels::HullRecord<R>::half_spaces;
            for (const HalfSpace& side : volume.half_spaces) {
                block.vector(plane + HalfSpaceOf::normal, side.normal);
                block.real(plane + HalfSpaceOf::offset,
                           side.offset - glm::dot(side.normal, volume.center));
                plane += HalfSpaceOf::words;
            }
            return;
        }
    }
}

/// Writes the inverse of a map as 12 numbers.
template <class Real>
void write_inverse(BlockWriter<Real>& block, std::uint32_t address, const Affine& map) {
    block.affine(address, inverse(map));
}

/// In long double throughout, so that its nodes are told nothing of lower precision.
void write_inverse(BlockWriter<long double>& block, std::uint32_t address, const Affine& map) {
    using Vector = glm::vec<3, long double>;
    const auto back = glm::inverse(glm::mat<3, 3, long double>(map.linear));
    const auto write = [&](const Vector& v) {
        for (int i = 0; i < 3; ++i, address += real_words<long double>) block.number(address, v[i]);
    };
    for (int i = 0; i < 3; ++i) write(back[i]);
    write(-(back * Vector(map.translation)));
}

/// Writes the two parts of the inverse of a map that squashes much; of another, nothing.
template <class Real>
void write_steep(BlockWriter<Real>& block, std::uint32_t address, const CompiledMap& map) {
    using Steep = kernels::SteepRecord<real_words<Real>>;
    const SingularValues singular = singular_values(map.map.linear);
    const auto& values = singular.values;
    if (!map.lost.empty() || values[0] <= least_steep * values[2]) return;
    Affine across;
    across.linear = glm::outerProduct(singular.input[0], singular.output[0] / values[0]) +
                    glm::outerProduct(singular.input[1], singular.output[1] / values[1]);
    across.translation = -(across.linear * map.map.translation);
    const glm::dvec3 axis = singular.output[2] / values[2];
    block.affine(address + Steep::across, across);
    block.vector(address + Steep::axis, axis);
    block.real(address + Steep::height, -glm::dot(axis, map.map.translation));
    block.vector(address + Steep::up, singular.input[2]);
}

/// Writes a shape's maps and follow sets; returns the addresses of the sets.
template <class Real>
std::vector<std::uint32_t> write_shape(BlockWriter<Real>& block, const CompiledShape& shape,
                                       bool area, bool steep) {
    using Map = kernels::MapRecord<real_words<Real>>;
    using FollowSet = kernels::FollowSetRecord<real_words<Real>>;
    using Steep = kernels::SteepRecord<real_words<Real>>;
    const std::uint32_t map_words = Map::words + (steep ? Steep::words : 0);
    const std::uint32_t maps = block.grow(shape.maps.size() * map_words);
    std::vector<std::uint32_t> sets;
    for (const CompiledSet& set : shape.sets) {
        const std::uint32_t address =
            block.grow(FollowSet::words + set.maps.size() + (area ? real_words<Real> : 0));
        sets.push_back(address);
        block.integer(address + FollowSet::map_count, static_cast<std::uint32_t>(set.maps.size()));
        write_volume(block, address, set.volume);
        std::uint32_t entry = address + FollowSet::maps;
        for (const int map : set.maps) {
            block.integer(entry++, maps + static_cast<std::uint32_t>(map) * map_words);
        }
        if (area) block.real(entry, set.coverage);
    }
    for (std::size_t i = 0; i < shape.maps.size(); ++i) {
        const CompiledMap& map = shape.maps[i];
        const std::uint32_t address = maps + static_cast<std::uint32_t>(i) * map_words;
        block.integer(address + Map::follow_set, sets[static_cast<std::size_t>(map.follow_set)]);
        block.integer(address + Map::symbol, static_cast<std::uint32_t>(i));
        write_inverse(block, address + Map::inverse, map.map);
        block.linear(address + Map::linear, map.map.linear);
        block.real(address + Map::constant, map.constant);
        block.real(address + Map::least, map.least);
        std::uint32_t axes = 0;
        for (const glm::dvec3& axis : map.lost) {
            if (axes == kernels::most_lost_axes) break;
            block.vector(address + Map::lost + 3 * real_words<Real> * axes++, axis);
        }
        block.integer(address + Map::lost_axes, axes);
        block.vector(address + Map::color, glm::dvec3{map.color});
        block.real(address + Map::color + 3 * real_words<Real>, map.color.a);
        if (steep) write_steep(block, address + Map::words, map);
    }
    return sets;
}

template <class Real>
void write_object(BlockWriter<Real>& block, std::uint32_t address, const CompiledObject& object,
                  const CompiledShape& shape, std::uint32_t start_set, std::uint32_t enclosing) {
    using Object = kernels::ObjectRecord<real_words<Real>>;
    block.integer(address + Object::start_set, start_set);
    block.integer(address + Object::lipschitz, static_cast<std::uint32_t>(shape.lipschitz));
    block.integer(address + Object::levels, object.levels);
    block.integer(address + Object::symbol_bits, symbol_bits(shape.maps.size()));
    block.integer(address + Object::enclosing, enclosing);
    write_inverse(block, address + Object::inverse, object.instance);
    block.linear(address + Object::linear, object.instance.linear);
    block.real(address + Object::constant, object.constant);
    block.real(address + Object::smallest_pixel, smallest_pixel_share<Real>() * object.diameter);
    block.vector(address + Object::color, object.color);
    block.real(address + Object::diffuse, object.diffuse);
    block.real(address + Object::opacity, object.opacity);
    block.real(address + Object::reflect, object.reflect);
}

/// What rays need care of on the way into a shape's cells.
std::uint32_t squash_of(const CompiledShape& shape, bool steep) {
    return (shape.lifted ? kernels::squash_flat : 0U) | (steep ? kernels::squash_steep : 0U);
}

/// Writes cells that only shade, as objects that nothing is looked for in; returns where each is.
template <class Real>
std::vector<std::uint32_t> write_enclosures(BlockWriter<Real>& block,
                                            const std::vector<CompiledEnclosure>& cells) {
    using Object = kernels::ObjectRecord<real_words<Real>>;
    using FollowSet = kernels::FollowSetRecord<real_words<Real>>;
    std::vector<std::uint32_t> addresses;
    for (const CompiledEnclosure& cell : cells) {
        const std::uint32_t address = block.grow(Object::words);
        const std::uint32_t set = block.grow(FollowSet::words);
        write_volume(block, set, cell.volume);
        block.integer(address + Object::start_set, set);
        block.integer(address + Object::lipschitz,
                      static_cast<std::uint32_t>(kernels::Lipschitz::product));
        block.integer(address + Object::symbol_bits, 1);
        block.integer(address + Object::enclosing, at_or_none(addresses, cell.enclosing));
        block.affine(address + Object::inverse, cell.inverse);
        block.real(address + Object::constant, 1);
        addresses.push_back(address);
    }
    return addresses;
}

template <class Real>
void write_lights(BlockWriter<Real>& block, const CompiledScene& scene) {
    using Header = kernels::HeaderRecord<real_words<Real>>;
    using Light = kernels::LightRecord<real_words<Real>>;
    std::uint32_t address = block.grow(scene.lights.size() * Light::words);
    block.integer(Header::lights, address);
    block.integer(Header::light_count, static_cast<std::uint32_t>(scene.lights.size()));
    for (const CompiledLight& light : scene.lights) {
        block.integer(address + Light::kind, static_cast<std::uint32_t>(light.kind));
        block.integer(address + Light::shadow, light.shadow ? 1 : 0);
        block.vector(address + Light::place, light.place);
        block.vector(address + Light::color, light.color);
        address += Light::words;
    }
}

template <class Real>
void write_samples(BlockWriter<Real>& block, const CompiledScene& scene) {
    using Header = kernels::HeaderRecord<real_words<Real>>;
    const std::size_t count = scene.samples.size();
    std::uint32_t address = block.grow(2 * real_words<Real> * count);
    block.integer(Header::samples, address);
    block.integer(Header::sample_count, static_cast<std::uint32_t>(count));
    block.real(Header::sample_share, 1 / static_cast<double>(count));
    for (const glm::dvec2& place : scene.samples) {
        block.real(address, place.x);
        block.real(address + real_words<Real>, place.y);
        address += 2 * real_words<Real>;
    }
}

/// Which places are in the first 0, 1, ... count columns, or rows, of a pixel.
template <class Real>
void write_masks(BlockWriter<Real>& block, std::uint32_t address,
                 const std::vector<glm::dvec2>& places, int axis) {
    const auto count = static_cast<double>(places.size());
    for (std::size_t lines = 0; lines <= places.size(); ++lines) {
        std::uint32_t mask = 0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (places[i][axis] * count < static_cast<double>(lines)) mask |= 1U << i;
        }
        block.integer(address++, mask);
    }
}

/// The eye's ray is the first of the places; what a beam knows of all of them follows it.
template <class Real>
void write_beam(BlockWriter<Real>& block, const CompiledScene& scene) {
    constexpr std::uint32_t R = real_words<Real>;
    using Header = kernels::HeaderRecord<R>;
    using Beam = kernels::BeamRecord<R>;
    const std::vector<glm::dvec2>& places = scene.samples;
    const auto count = static_cast<std::uint32_t>(places.size());
    const std::uint32_t first = block.grow(2 * R + Beam::words + 2 * (count + 1) + 2 * R * count);
    block.integer(Header::samples, first);
    block.integer(Header::sample_count, 1);
    block.real(Header::sample_share, 1);
    block.real(first, places[0].x);
    block.real(first + R, places[0].y);
    const std::uint32_t beam = first + 2 * R;
    block.integer(beam + Beam::count, count);
    block.integer(beam + Beam::first_column, static_cast<std::uint32_t>(places[0].x * count));
    block.integer(beam + Beam::first_row, static_cast<std::uint32_t>(places[0].y * count));
    write_masks(block, beam + Beam::columns, places, 0);
    write_masks(block, beam + Beam::columns + count + 1, places, 1);
    std::uint32_t address = beam + Beam::columns + 2 * (count + 1);
    for (const glm::dvec2& place : places) {
        block.real(address, place.x);
        block.real(address + R, place.y);
        address += 2 * R;
    }
}

}  // namespace

template <class Real>
double smallest_pixel_share() {
    return real_words<Real> == 1 ? 0x1p-20 : 0x1p-48;
}

template <class Real>
std::vector<std::uint32_t> make_scene_block(const CompiledScene& scene) {
    using Header = kernels::HeaderRecord<real_words<Real>>;
    using Object = kernels::ObjectRecord<real_words<Real>>;
    BlockWriter<Real> block;
    block.grow(Header::words);
    write_header(block, scene);
    std::uint32_t object_address = block.grow(scene.objects.size() * Object::words);
    block.integer(Header::objects, object_address);
    block.integer(Header::object_count, static_cast<std::uint32_t>(scene.objects.size()));
    // Numbers of twice the length have the digits and the range that steep maps ask for.
    const std::vector<bool> steep =
        real_words<Real> == 1 ? steep_shapes(scene) : std::vector<bool>(scene.shapes.size(), false);
    std::vector<std::vector<std::uint32_t>> sets;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        sets.push_back(write_shape(block, scene.shapes[i], scene.area, steep[i]));
    }
    const std::vector<std::uint32_t> enclosures = write_enclosures(block, scene.enclosures);
    for (const CompiledObject& object : scene.objects) {
        const auto shape = static_cast<std::size_t>(object.shape);
        write_object(block, object_address, object, scene.shapes[shape],
                     sets[shape][static_cast<std::size_t>(object.start)],
                     at_or_none(enclosures, object.enclosing));
        block.integer(object_address + Object::squash,
                      squash_of(scene.shapes[shape], steep[shape]));
        object_address += Object::words;
    }
    write_lights(block, scene);
    write_floor(block, scene);
    if (scene.area) {
        write_beam(block, scene);
    } else {
        write_samples(block, scene);
    }
    return block.take();
}

template <class Real>
std::uint32_t object_index(const std::vector<std::uint32_t>& block, std::uint32_t address) {
    using Header = kernels::HeaderRecord<real_words<Real>>;
    using Object = kernels::ObjectRecord<real_words<Real>>;
    return (address - block[Header::objects]) / Object::words;
}

template <class Real>
std::uint32_t plane_index(const std::vector<std::uint32_t>& block, std::uint32_t address) {
    using Header = kernels::HeaderRecord<real_words<Real>>;
    using Plane = kernels::PlaneRecord<real_words<Real>>;
    return (address - block[Header::planes]) / Plane::words;
}

std::uint64_t block_hash(const std::vector<std::uint32_t>& block) {
    Digest digest;
    for (const std::uint32_t word : block) {
        for (int shift = 0; shift < 32; shift += 8) digest.add(word >> shift & 0xFF);
    }
    return digest.value();
}

template double smallest_pixel_share<dsp32::Float>();
template double smallest_pixel_share<float>();
template double smallest_pixel_share<double>();
template double smallest_pixel_share<long double>();
template std::vector<std::uint32_t> make_scene_block<dsp32::Float>(const CompiledScene&);
template std::vector<std::uint32_t> make_scene_block<float>(const CompiledScene&);
template std::vector<std::uint32_t> make_scene_block<double>(const CompiledScene&);
template std::vector<std::uint32_t> make_scene_block<long double>(const CompiledScene&);
template std::uint32_t object_index<dsp32::Float>(const std::vector<std::uint32_t>&, std::uint32_t);
template std::uint32_t object_index<float>(const std::vector<std::uint32_t>&, std::uint32_t);
template std::uint32_t object_index<double>(const std::vector<std::uint32_t>&, std::uint32_t);
template std::uint32_t object_index<long double>(const std::vector<std::uint32_t>&, std::uint32_t);
template std::uint32_t plane_index<dsp32::Float>(const std::vector<std::uint32_t>&, std::uint32_t);
template std::uint32_t plane_index<float>(const std::vector<std::uint32_t>&, std::uint32_t);
template std::uint32_t plane_index<double>(const std::vector<std::uint32_t>&, std::uint32_t);
template std::uint32_t plane_index<long double>(const std::vector<std::uint32_t>&, std::uint32_t);

}  // namespace pxm::host
