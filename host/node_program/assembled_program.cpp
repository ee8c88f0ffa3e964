#include "host/node_program/assembled_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "host/node_program/steepness.hpp"
#include "pxm/dsp32/assembler/assembler.hpp"

namespace pxm::host {

namespace {

constexpr std::size_t window_words = 1024;  // of the back buffer, as dsp_kernels/asm sees it
constexpr std::size_t most_maps = 256;      // a byte a map
constexpr long heap_entries = 256;
constexpr std::uint32_t most_cells = 0x7FFF'FFFF;  // tested for a ray: counted with a sign
constexpr long most_pixels = 32'767;               // along an axis: a number of 16 bits

std::string beyond_in_shape(const CompiledShape& shape, bool steep) {
    if (shape.ifs.empty()) return "an object that is a volume";
    if (shape.sets.size() != 1) return "a graph that is not complete";
    const kernels::Volume kind = shape.sets.front().volume.kind;
    if (kind != kernels::Volume::sphere && kind != kernels::Volume::box)
        return "a bounding volume that is no ball and no box in axes (--volume sphere, or box)";
    if (shape.maps.size() > most_maps) return "more than 256 maps";
    if (shape.lipschitz == kernels::Lipschitz::polar)
        return "Lipschitz constants by polar decomposition (--lipschitz product, or determinant)";
    if (shape.lifted) return "singular maps";
    if (steep) return "maps that squash very much";
    return {};
}

std::string beyond_in_light(const CompiledScene& scene) {
    for (const CompiledLight& light : scene.lights) {
        if (light.kind != kernels::LightKind::directional) return "a point light";
        if (light.shadow) return "a light that casts shadows";
    }
    if (scene.shading != kernels::ShadingMode::constant)
        return "weights of the normals (--shading constant)";
    return {};
}

std::string beyond_in_image(const CompiledScene& scene, Numeric numeric) {
    if (numeric != Numeric::dsp32) return "numbers that are not a DSP32's (--numeric dsp32)";
    if (scene.camera.projection != kernels::Projection::perspective)
        return "an orthographic camera";
    if (scene.size.columns > most_pixels || scene.size.rows > most_pixels)
        return "more than 32767 pixels in a row or column";
    if (scene.cell_cap > most_cells) return "a cap of more than 2147483647 cells";
    if (scene.heap != heap_entries) return "a heap that has not 256 entries (--heap 256)";
    return {};
}

/// Those that are not of the other kind of volume.
std::vector<AssemblerSource> sources_for(kernels::Volume volume) {
    constexpr std::array of_balls{"ball", "square_root", "volume_ball"};
    constexpr std::array of_boxes{"box", "slab", "volume_box"};
    const auto& others = volume == kernels::Volume::box ? of_balls : of_boxes;
    std::vector<AssemblerSource> sources;
    for (const AssemblerSource& source : assembler_sources())
        if (std::ranges::find(others, source.name) == others.end()) sources.push_back(source);
    return sources;
}

bool has_boxes(const CompiledScene& scene) {
    if (scene.objects.empty()) return false;
    const auto shape = static_cast<std::size_t>(scene.objects.front().shape);
    const std::vector<CompiledSet>& sets = scene.shapes[shape].sets;
    return !sets.empty() && sets.front().volume.kind == kernels::Volume::box;
}

}  // namespace

AssembledProgram::AssembledProgram(kernels::Volume volume) {
    const std::vector<AssemblerSource> sources = sources_for(volume);
    std::string text;
    for (const AssemblerSource& source : sources) text += source.text;
    const auto assembly = dsp32::assembler::assemble(text, dsp32::isa::Dialect::dsp32);
    assert(assembly.mistakes.empty() && !assembly.too_large());
    object_ = assembly.object;
    words_ = object_.text;
    words_.insert(words_.end(), object_.data.begin(), object_.data.end());
    int first_line = 1;
    for (const AssemblerSource& source : sources) {
        const int end = first_line + static_cast<int>(std::ranges::count(source.text, '\n'));
        add_source(source.name, assembly.placed, first_line, end);
        first_line = end;
    }
}

/// What lines of the text took: instructions lie from address 0 on, source after source.
void AssembledProgram::add_source(std::string_view name,
                                  std::span<const dsp32::assembler::Placed> placed, int first_line,
                                  int end_line) {
    const std::size_t text_bytes = object_.text.size() * sizeof(dsp32::Word);
    std::int64_t bytes = 0;
    std::uint32_t end = ends_.empty() ? 0 : ends_.back().address;
    for (const dsp32::assembler::Placed& piece : placed) {
        if (piece.line < first_line || piece.line >= end_line) continue;
        bytes += piece.bytes;
        if (piece.address < text_bytes) end = piece.address + piece.bytes;
    }
    ends_.push_back({end, name});
    if (bytes > 0)
        sizes_.modules.push_back({std::string(name), "the program in DSP32 code", bytes});
}

std::string_view AssembledProgram::source_of(std::uint32_t address) const {
    const auto end = std::ranges::upper_bound(ends_, address, {}, &End::address);
    return end == ends_.end() ? std::string_view() : end->source;
}

std::uint32_t AssembledProgram::address_of(std::string_view label) const {
    const auto address = object_.address_of(label);
    assert(address);
    return *address;
}

const AssembledProgram& assembled_program(const CompiledScene& scene) {
    if (has_boxes(scene)) {
        static const AssembledProgram boxes(kernels::Volume::box);
        return boxes;
    }
    static const AssembledProgram balls(kernels::Volume::sphere);
    return balls;
}

std::string beyond_assembled_program(const CompiledScene& scene, Numeric numeric,
                                     std::size_t block_words) {
    if (auto image = beyond_in_image(scene, numeric); !image.empty()) return image;
    if (scene.objects.size() != 1)
        return fmt::format("{} objects (it knows one)", scene.objects.size());
    if (!scene.planes.empty()) return "a plane";
    if (scene.area || needs_covers(scene))
        return "local covers, or a translucent object (--covers off)";
    if (needs_mirrors(scene)) return "a surface that reflects";
    if (auto light = beyond_in_light(scene); !light.empty()) return light;
    if (scene.method != kernels::Method::heap) return "the method of Chapter 13 (--intersect heap)";
    const auto shape = static_cast<std::size_t>(scene.objects.front().shape);
    const bool steep = steep_shapes(scene)[shape];
    if (auto own = beyond_in_shape(scene.shapes[shape], steep); !own.empty()) return own;
    if (scene.objects.front().enclosing >= 0) return "cells around the eye that are objects";
    if (block_words > window_words)
        return fmt::format("a scene block of {} words (its window shows {})", block_words,
                           window_words);
    return {};
}

}  // namespace pxm::host
