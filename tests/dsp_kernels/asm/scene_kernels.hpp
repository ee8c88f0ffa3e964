// Kernels in assembler that work on cells and on the scene block, beside their C++: both on the
// same words.
#pragma once

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "dsp_kernels/camera.hpp"
#include "dsp_kernels/descend.hpp"
#include "dsp_kernels/heap.hpp"
#include "dsp_kernels/lights.hpp"
#include "tests/dsp_kernels/asm/kernels.hpp"

namespace pxm::kernels {

inline void put_ray(Kernel& kernel, std::uint32_t place, const Ray<Float>& ray) {
    kernel.put(place, {ray.origin.x.word(), ray.origin.y.word(), ray.origin.z.word(),
                       ray.direction.x.word(), ray.direction.y.word(), ray.direction.z.word(),
                       ray.base.word()});
}
inline void expect_ray(Kernel& kernel, std::uint32_t place, const Ray<Float>& ray) {
    const Vec3<Float>&o = ray.origin, &d = ray.direction;
    for (const Float expected : {o.x, o.y, o.z, d.x, d.y, d.z, ray.base})
        EXPECT_EQ(kernel.at(place++), expected.word()) << "number " << place - 1;
}
inline void expect_vector(Kernel& kernel, std::uint32_t place, const Vec3<Float>& vector) {
    for (const Float expected : {vector.x, vector.y, vector.z})
        EXPECT_EQ(kernel.at(place++), expected.word()) << "number " << place - 1;
}

inline Cycles try_approach(std::uint64_t seed, int count) {
    Kernel kernel("approach", {"approach", "divide"});
    ProcessorNode node({}, 0);
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[10];
        for (std::uint32_t k = 0; k < 10; ++k) kernel.put(k, {in[k] = coordinate(words)});
        kernel.call({0, 7});
        expect_ray(kernel, 0, rebase(node, ray_of(in), vector_of(in + 7)));
    }
    return kernel.cycles;
}

inline Cycles try_child(std::uint64_t seed, int count) {
    Kernel kernel("child", {"scene_block", "child", "transform_ray"});
    using Map = MapRecord<1>;
    constexpr std::uint32_t object = Map::words;
    ShapedNode shaped(Map::words + ObjectRecord<1>::words);
    auto& [node, shape] = shaped;
    dsp32::RandomWords words(seed);
    Cell<Float> parent, child;
    parent.object = object;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[10];
        for (std::uint32_t k = 0; k < 10; ++k) kernel.put(k, {in[k] = coordinate(words)});
        for (std::uint32_t k = 3; k < Map::words; ++k) shape[k] = coordinate(words);
        for (std::uint32_t k = 0; k < Map::words; ++k) kernel.put(10 + k, {shape[k]});
        kernel.call({0, 10, 46});
        parent.ray = ray_of(in);
        parent.constant = Float::from_word(in[9]);
        child_cell(node, Search<Float>{}, parent, 0, child);
        expect_ray(kernel, 46, child.ray);
        EXPECT_EQ(kernel.at(55), child.constant.word());
    }
    return kernel.cycles;
}

inline Linear<Float> linear_of(const Word* words) {
    return {{vector_of(words), vector_of(words + 3), vector_of(words + 6)}};
}

inline Cycles try_compose(std::uint64_t seed, int count) {
    Kernel kernel("compose", {"compose"});
    ProcessorNode node({}, 0);
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[18];
        for (std::uint32_t k = 0; k < 18; ++k) kernel.put(k, {in[k] = coordinate(words)});
        const std::uint32_t to = i % 2 == 0 ? 18 : 0;  // elsewhere, or in place
        kernel.call({0, 9, to});
        const Linear<Float> product = compose(node, linear_of(in), linear_of(in + 9));
        for (std::uint32_t row = 0; row < 3; ++row)
            expect_vector(kernel, to + 3 * row, product.rows[row]);
    }
    return kernel.cycles;
}

inline Cycles try_pixel_size(std::uint64_t seed, int count) {
    Kernel kernel("pixel_size", {"pixel_size"});
    ProcessorNode node({}, 0);
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[4];
        for (std::uint32_t k = 0; k < 4; ++k) kernel.put(k, {in[k] = ordinary(words)});
        kernel.call({0, 2, 3, 4});
        const auto number = [&](int k) { return Float::from_word(in[k]); };
        const Float p = pixel_size(node, {number(0), number(1)}, number(2), number(3));
        EXPECT_EQ(kernel.at(4), p.word());
    }
    return kernel.cycles;
}

/// By product or by determinant: the method is in the constant.
inline Cycles try_diameter(Lipschitz method, std::uint64_t seed, int count) {
    Kernel kernel("diameter", {"diameter"});
    using Object = ObjectRecord<1>;
    using Set = FollowSetRecord<1>;
    ShapedNode shaped(Object::words + Set::words);
    auto& [node, shape] = shaped;
    shape[Object::lipschitz] = static_cast<Word>(method);
    Cell<Float> cell;
    cell.follow_set = Object::words;
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const Word constant = coordinate(words), diameter = coordinate(words);
        kernel.put(0, {constant, diameter});
        kernel.call({0, 1, 2});
        cell.constant = Float::from_word(constant);
        shape[Object::words + Set::diameter] = diameter;
        EXPECT_EQ(kernel.at(2), cell_diameter(node, cell).word());
    }
    return kernel.cycles;
}

/// Numbers as rays and balls of a scene have them, so that a good part of them meet.
inline Word near_one(std::mt19937_64& engine, double size) {
    return Float(size * (static_cast<double>(engine() % 2'000'001) * 1e-6 - 1)).word();
}

/// The kernel that meets cells with volumes of a kind, and what its C++ needs.
struct Meetings {
    explicit Meetings(Volume volume)
        : kernel("meet",
                 {"meet", "approach", "ball", "box", "slab", "divide", "reciprocal", "square_root"},
                 volume == Volume::sphere ? ".equ volume, ball\n.equ volume_at, 0\n"
                                          : ".equ volume, box\n.equ volume_at, 12\n"),
          shaped(FollowSetRecord<1>::words) {
        shaped.shape[FollowSetRecord<1>::volume] = static_cast<Word>(volume);
        search.detail = search.fade = Float(1);
    }
    Kernel kernel;
    ShapedNode shaped;
    Search<Float> search;
};

/// With the numbers of balls, or of boxes of any corners.
inline Cycles try_meet(Volume volume, std::uint64_t seed, int count) {
    using Set = FollowSetRecord<1>;
    Meetings meetings(volume);
    auto& [kernel, shaped, search] = meetings;
    auto& [node, shape] = shaped;
    std::mt19937_64 engine(seed);
    int met = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word ray[7];
        for (int k = 0; k < 7; ++k) ray[k] = near_one(engine, k < 3 ? 2 : 1);
        put_ray(kernel, 0, ray_of(ray));
        const auto numbers = shape.subspan(Set::center, 9);
        for (std::uint32_t k = 0; k < 9; ++k) {
            numbers[k] = near_one(engine, k < 3 ? 1 : 3);
            // Corners are in order, most of them.
            if (volume == Volume::box && k > 2 && i % 8 != 0) {
                const Float size = absolute(Float::from_word(numbers[k]));
                numbers[k] = (k < 6 ? Float(0) - size : size).word();
            }
            kernel.put(7 + k, {numbers[k]});
        }
        const Word from = near_one(engine, 4);
        const Word to =
            (Float::from_word(from) + absolute(Float::from_word(near_one(engine, 20)))).word();
        kernel.put(16, {from, to, 0x11, 0x22});
        kernel.call({0, 7, 16, 18});
        Cell<Float> cell;
        cell.ray = ray_of(ray);
        const bool meets = meet(node, search, cell, Float::from_word(from), Float::from_word(to));
        EXPECT_EQ(kernel.program.r(4), meets ? 1 : 0);
        expect_ray(kernel, 0, cell.ray);
        if (meets) {
            EXPECT_EQ(kernel.at(18), cell.key.word());
            EXPECT_EQ(kernel.at(19), cell.exit.word());
        }
        met += meets ? 1 : 0;
    }
    EXPECT_GT(met, count / 10);
    EXPECT_LT(met, count - count / 10);
    return kernel.cycles;
}

/// Cells whose intervals are a point, or nearly: rounding decides (the end of meet()).
inline void try_flat_meetings(std::uint64_t seed, int count) {
    using Set = FollowSetRecord<1>;
    Meetings meetings(Volume::sphere);
    auto& [kernel, shaped, search] = meetings;
    auto& [node, shape] = shaped;
    std::mt19937_64 engine(seed);
    int point = 0, missed = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[11];
        for (int k = 0; k < 7; ++k) in[k] = near_one(engine, 1);
        for (int k = 7; k < 10; ++k) in[k] = in[k - 7];  // the ray starts at the centre
        in[10] = Float(1.5).word();
        in[6] = Float(4).word();
        for (std::uint32_t k = 0; k < 4; ++k) shape[Set::center + k] = in[7 + k];
        Cell<Float> cell;
        cell.ray = ray_of(in);
        ASSERT_TRUE(meet(node, search, cell, Float(0), far_away<Float>));
        // From a little behind its exit on.
        const Word from = cell.exit.word() + (static_cast<Word>(engine() % 24) << 8U);
        for (std::uint32_t k = 0; k < 11; ++k) kernel.put(k, {in[k]});
        kernel.put(11, {from, far_away<Float>.word(), 0x11, 0x22});
        kernel.call({0, 7, 11, 13});
        cell.ray = ray_of(in);
        const bool meets = meet(node, search, cell, Float::from_word(from), far_away<Float>);
        EXPECT_EQ(kernel.program.r(4), meets ? 1 : 0);
        if (meets) {
            EXPECT_EQ(kernel.at(14), cell.exit.word());
        }
        (meets ? point : missed) += 1;
    }
    EXPECT_GT(point, count / 10);
    EXPECT_GT(missed, count / 10);
}

inline Cycles try_eye_ray(std::uint64_t seed, int count) {
    Kernel kernel("eye_ray",
                  {"scene_block", "eye_ray", "normalize", "reciprocal", "reciprocal_square_root"});
    using Header = HeaderRecord<1>;
    ShapedNode shaped(Header::words + 2);
    auto& [node, shape] = shaped;
    shape[Header::projection] = static_cast<Word>(Projection::perspective);
    shape[Header::samples] = Header::words;
    std::mt19937_64 engine(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        for (std::uint32_t k = 0; k < 12; ++k) shape[Header::eye + k] = near_one(engine, 1);
        for (std::uint32_t k = 0; k < 2; ++k)
            shape[Header::words + k] = absolute(Float::from_word(near_one(engine, 1))).word();
        shaped.copy_to(kernel.program.node);
        const auto x = static_cast<Word>(engine() % 1280), y = static_cast<Word>(engine() % 1024);
        kernel.put(0, {x | y << 16U, shape[Header::words], shape[Header::words + 1]});
        kernel.call({0, 1, 3});
        expect_ray(kernel, 3, eye_ray(node, x, y, 0));
    }
    return kernel.cycles;
}

/// Under one to four lights.
inline Cycles try_lambert(std::uint64_t seed, int count) {
    Kernel kernel("lambert", {"scene_block", "lambert"});
    using Header = HeaderRecord<1>;
    using Light = LightRecord<1>;
    constexpr std::uint32_t most_lights = 4;
    ShapedNode shaped(Header::words + most_lights * Light::words);
    auto& [node, shape] = shaped;
    shape[Header::lights] = Header::words;
    std::mt19937_64 engine(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        shape[Header::light_count] = static_cast<Word>(engine() % most_lights + 1);
        for (std::uint32_t k = 0; k < 3; ++k) shape[Header::ambient + k] = near_one(engine, 1);
        for (std::uint32_t light = 0; light < most_lights; ++light)
            for (std::uint32_t k = 2; k < Light::words; ++k)
                shape[Header::words + light * Light::words + k] = near_one(engine, 1);
        shaped.copy_to(kernel.program.node);
        Word in[7];
        for (std::uint32_t k = 0; k < 7; ++k) kernel.put(k, {in[k] = near_one(engine, 1)});
        kernel.call({0, 3, 6, 7});
        LitPlace<Float> lit;
        lit.surface.normal = vector_of(in);
        lit.surface.color = vector_of(in + 3);
        lit.surface.diffuse = Float::from_word(in[6]);
        lit.sighting = nullptr;
        expect_vector(kernel, 7, illuminate(node, lit, ShadingMode::constant, [](std::uint32_t) {
                          return Float(1);
                      }));
    }
    return kernel.cycles;
}

/// Fills and empties both heaps at random with cells of few keys, so that words decide; each cell
/// comes out of both, whole.
inline HeapCycles try_cell_heap(std::uint64_t seed, int count) {
    constexpr int capacity = 256;
    using Entry = Cell<Float>;
    Kernel kernel("cell_heap_put", {"cell_heap"}, "cell_heap_full: goto cell_heap_full\nnop\n");
    dsp32::processor::Program& program = kernel.program;
    EXPECT_TRUE(program.node.zbuffer().reserve(17 * 4096));
    program.call("cell_heap_start");
    ProcessorNode node({}, 0);
    EXPECT_FALSE(node.load_program(0, 0));
    EXPECT_FALSE(node.reserve_heap(capacity, sizeof(Entry)));
    Heap<ProcessorNode> heap(node);
    heap.clear();
    std::mt19937_64 engine(seed);
    Cycles take;
    int held = 0;
    std::set<std::vector<std::uint32_t>> in_use;  // no two cells have the same word
    const auto byte = [&](std::uint32_t i) -> Word& { return program.word("cell_word", i / 4); };
    const auto shift = [](std::uint32_t i) { return (i ^ 1U) % 4 * 8; };
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const bool filling = engine() % 16 < (i / 600 % 2 == 0 ? 11U : 5U);
        Entry cell;
        cell.bits = 8;
        if (held < capacity && (held == 0 || filling)) {
            std::vector<std::uint32_t> word;
            do {
                word.resize(engine() % 12);
                for (std::uint32_t& symbol : word) symbol = engine() % 3 == 0 ? 200 : engine() % 2;
            } while (!in_use.insert(word).second);
            cell.key = Float(static_cast<double>(engine() % 6));
            cell.constant = Float(static_cast<double>(i));
            cell.level = static_cast<std::uint16_t>(word.size());
            for (std::uint32_t k = 0; k < 3; ++k) byte(4 * k) = 0;
            for (std::uint32_t k = 0; k < word.size(); ++k) {
                cell.word.set(k, 8, word[k]);
                byte(k) |= word[k] << shift(k);
            }
            heap.push(cell);
            program.word("cell_heap_new", 7) = cell.key.word();
            program.word("cell_heap_new", 9) = cell.constant.word();
            program.word("cell_heap_new_level") = cell.level;
            kernel.call({});
            ++held;
        } else {
            heap.pop(cell);
            kernel.call_label("cell_heap_take", take);
            EXPECT_EQ(program.word("cell_heap_top", 7), cell.key.word());
            EXPECT_EQ(program.word("cell_heap_top", 9), cell.constant.word());
            EXPECT_EQ(program.word("cell_level") & 0xFFFFU, cell.level);
            std::vector<std::uint32_t> word;
            for (std::uint32_t k = 0; k < cell.level; ++k) {
                EXPECT_EQ(byte(k) >> shift(k) & 0xFFU, cell.word.get(k, 8));
                word.push_back(cell.word.get(k, 8));
            }
            in_use.erase(word);
            --held;
        }
    }
    return {kernel.cycles, take};
}

}  // namespace pxm::kernels
