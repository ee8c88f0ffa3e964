// The walk along a cell's word, in assembler with balls or boxes, beside its C++: both on the same
// scene blocks, rays and words.
#pragma once

#include "dsp_kernels/shade.hpp"
#include "tests/dsp_kernels/asm/scene_kernels.hpp"

namespace pxm::kernels {

/// A scene block of one object with four maps, of random numbers.
struct WalkScene {
    using Header = HeaderRecord<1>;
    using Object = ObjectRecord<1>;
    using Set = FollowSetRecord<1>;
    using Map = MapRecord<1>;
    static constexpr std::uint32_t map_count = 4;
    static constexpr std::uint32_t object = Header::words, set = object + Object::words,
                                   maps = set + Set::words + map_count,
                                   words = maps + map_count * Map::words;

    /// Maps shrink about to a half, so that their cells lie in or near those around them.
    void draw(std::span<Word> shape, std::mt19937_64& engine, Volume volume) const {
        for (std::uint32_t k = Header::words; k < words; ++k) shape[k] = near_one(engine, 0.3);
        shape[Header::objects] = object;
        for (std::uint32_t k = 0; k < 6; ++k) shape[object + k] = 0;
        shape[object + Object::start_set] = set;
        shape[object + Object::symbol_bits] = 8;
        for (std::uint32_t k = 0; k < 3; ++k)
            shape[object + Object::inverse + 4 * k] = one_and(engine, 1);
        shape[set + Set::volume] = static_cast<Word>(volume);
        shape[set + Set::map_count] = map_count;
        for (std::uint32_t k = 0; k < 6; ++k)
            shape[set + Set::low + k] = one_and(engine, k < 3 && volume == Volume::box ? -1 : 1);
        for (std::uint32_t m = 0; m < map_count; ++m) {
            const std::uint32_t map = maps + m * Map::words;
            shape[set + Set::maps + m] = map;
            shape[map + Map::follow_set] = set;
            shape[map + Map::symbol] = m;
            shape[map + Map::lost_axes] = 0;
            for (std::uint32_t k = 0; k < 3; ++k)
                shape[map + Map::inverse + 4 * k] = one_and(engine, 2);
        }
    }

  private:
    static Word one_and(std::mt19937_64& engine, double size) {
        return (Float(size) + Float::from_word(near_one(engine, 0.3))).word();
    }
};

/// How often a cell along the way gave a normal, and how often none did.
struct Walks {
    int met = 0, missed = 0;
};

/// A ray, in the program as well. Every second one leads through the middle, so that cells are met.
inline Ray<Float> draw_ray(dsp32::processor::Program& program, std::mt19937_64& engine,
                           bool to_middle) {
    Word ray[7];
    for (int k = 0; k < 7; ++k) ray[k] = near_one(engine, k < 3 ? 3 : 1);
    for (int k = 0; to_middle && k < 3; ++k)
        ray[3 + k] = (Float(0) - Float::from_word(ray[k])).word();
    if (engine() % 4 == 0) ray[3 + engine() % 3] = dsp32::zero;
    for (std::uint32_t k = 0; k < 7; ++k) program.word("search_ray", k) = ray[k];
    return ray_of(ray);
}

/// A cell of up to five maps, in the program as well.
inline Cell<Float> draw_cell(dsp32::processor::Program& program, std::mt19937_64& engine) {
    Cell<Float> cell;
    cell.object = WalkScene::object;
    cell.bits = 8;
    cell.level = static_cast<std::uint16_t>(engine() % 6);
    program.word("cell_level") = cell.level;
    for (std::uint32_t k = 0; k < 2; ++k) program.word("cell_word", k) = 0;
    for (std::uint32_t k = 0; k < cell.level; ++k) {
        const auto map = static_cast<std::uint32_t>(engine() % WalkScene::map_count);
        cell.word.set(k, cell.bits, map);
        program.word("cell_word", k / 4) |= map << (k ^ 1U) % 4 * 8;
    }
    return cell;
}

inline void expect_words(dsp32::processor::Program& program, const char* label,
                         const Vec3<Float>& vector) {
    EXPECT_EQ(program.word(label, 0), vector.x.word()) << label;
    EXPECT_EQ(program.word(label, 1), vector.y.word()) << label;
    EXPECT_EQ(program.word(label, 2), vector.z.word()) << label;
}

inline Walks try_walk(Volume volume, std::uint64_t seed, int count) {
    Kernel kernel("walk",
                  {"scene_block",
                   "scene",
                   "search",
                   "walk",
                   "child",
                   "compose",
                   "pixel_size",
                   "diameter",
                   "meet",
                   "approach",
                   "cell_heap",
                   "transform_ray",
                   "ball",
                   "box",
                   "slab",
                   "divide",
                   "square_root",
                   "normalize",
                   "reciprocal",
                   "reciprocal_square_root",
                   volume == Volume::sphere ? "volume_ball" : "volume_box"},
                  "cell_heap_full: goto cell_heap_full\nnop\n");
    dsp32::processor::Program& program = kernel.program;
    const WalkScene scene;
    ShapedNode shaped(WalkScene::words);
    auto& [node, shape] = shaped;
    std::mt19937_64 engine(seed);
    Walks walks;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        if (i % 16 == 0) {
            scene.draw(shape, engine, volume);
            shaped.copy_to(program.node);
            program.call(volume == Volume::sphere ? "read_scene" : "read_volume");
        }
        Search<Float> search{};
        search.ray = draw_ray(program, engine, i % 2 == 0);
        const Cell<Float> cell = draw_cell(program, engine);
        kernel.call({});
        const Surface<Float> surface =
            surface_at(node, Sighting<Float>{search, cell, 0}, ShadingMode::constant);
        expect_words(program, "walk_color", surface.color);
        expect_words(program, "walk_normal", surface.normal);
        ((program.word("walk_visited") & 0xFFFFU) != 0 ? walks.met : walks.missed) += 1;
    }
    EXPECT_GT(walks.met, count / 10);
    EXPECT_GT(walks.missed, count / 10);
    return walks;
}

}  // namespace pxm::kernels
