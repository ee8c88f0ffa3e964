// Kernels in assembler beside their C++: both on the same words.
#pragma once

#include <random>
#include <set>

#include "dsp_kernels/heap.hpp"
#include "dsp_kernels/volume_box.hpp"
#include "dsp_kernels/volume_slab.hpp"
#include "dsp_kernels/volume_sphere.hpp"
#include "tests/dsp_kernels/asm/kernel.hpp"

namespace pxm::kernels {

// Each returns after `count` calls that agreed, or one that did not.
inline Cycles try_reciprocal(std::uint64_t seed, int count) {
    Kernel kernel("reciprocal", {"reciprocal"});
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const Word y = words();
        kernel.put(0, {y});
        kernel.call({0, 1});
        EXPECT_EQ(kernel.at(1), dsp32::routines::reciprocal(y)) << std::hex << y;
    }
    return kernel.cycles;
}

inline Cycles try_divide(std::uint64_t seed, int count) {
    Kernel kernel("divide", {"divide"});
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const Word x = words(), y = words();
        kernel.put(0, {x, y});
        kernel.call({0, 1, 2});
        EXPECT_EQ(kernel.at(2), dsp32::routines::divide(x, y)) << std::hex << x << " / " << y;
    }
    return kernel.cycles;
}

inline Cycles try_square_root(std::uint64_t seed, int count) {
    Kernel kernel("square_root", {"square_root"});
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const Word x = coordinate(words);
        kernel.put(0, {x});
        kernel.call({0, 1});
        EXPECT_EQ(kernel.at(1), dsp32::routines::square_root(x)) << std::hex << x;
    }
    return kernel.cycles;
}

inline Vec3<Float> vector_of(const Word* words) {
    return {Float::from_word(words[0]), Float::from_word(words[1]), Float::from_word(words[2])};
}
inline Ray<Float> ray_of(const Word* words) {
    return {vector_of(words), vector_of(words + 3), Float::from_word(words[6])};
}

inline Cycles try_transform_ray(std::uint64_t seed, int count) {
    Kernel kernel("transform_ray", {"transform_ray"});
    ProcessorNode node({}, 0);
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[19];
        for (std::uint32_t k = 0; k < 19; ++k) kernel.put(k, {in[k] = coordinate(words)});
        kernel.call({0, 7, 19});
        const AffineMap<Float> inverse{
            {{vector_of(in + 7), vector_of(in + 10), vector_of(in + 13)}}, vector_of(in + 16)};
        const Ray<Float> ray = transform_ray(node, ray_of(in), inverse);
        const Vec3<Float>&o = ray.origin, &d = ray.direction;
        std::uint32_t k = 19;
        for (const Float expected : {o.x, o.y, o.z, d.x, d.y, d.z, ray.base})
            EXPECT_EQ(kernel.at(k++), expected.word()) << "number " << k - 20;
    }
    return kernel.cycles;
}

inline Cycles try_ball(std::uint64_t seed, int count) {
    Kernel kernel("ball", {"ball", "divide", "square_root"});
    using Record = FollowSetRecord<1>;
    ShapedNode shaped(Record::words);
    auto& [node, shape] = shaped;
    dsp32::RandomWords words(seed);
    int met = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[11];
        for (Word& word : in) word = coordinate(words);
        // Half of the rays pass close to the centre, so that balls are met.
        if (i % 2 == 0)
            for (int k = 0; k < 3; ++k) in[7 + k] = in[k] ^ 0xFFU << 8U;
        for (std::uint32_t k = 0; k < 11; ++k) kernel.put(k, {in[k]});
        for (std::uint32_t k = 0; k < 4; ++k) shape[Record::center + k] = in[7 + k];
        kernel.put(11, {0x11, 0x22});
        kernel.call({0, 7, 11});
        const auto interval = intersect_sphere(node, ray_of(in), 0);
        EXPECT_EQ(kernel.program.r(4), interval ? 1 : 0);
        EXPECT_EQ(kernel.at(11), interval ? interval->entry.word() : 0x11U);
        EXPECT_EQ(kernel.at(12), interval ? interval->exit.word() : 0x22U);
        met += interval ? 1 : 0;
    }
    EXPECT_GT(met, count / 5);
    EXPECT_LT(met, count - count / 5);
    return kernel.cycles;
}

inline Cycles try_slab(std::uint64_t seed, int count) {
    Kernel kernel("slab", {"slab", "reciprocal"});
    ProcessorNode node({}, 0);
    dsp32::RandomWords words(seed);
    int met = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[6];
        for (Word& word : in) word = ordinary(words);
        if (i % 16 == 0) in[1] = dsp32::zero;
        for (std::uint32_t k = 0; k < 6; ++k) kernel.put(k, {in[k]});
        kernel.call({0, 2, 4});
        const auto number = [&](int k) { return Float::from_word(in[k]); };
        Interval<Float> interval{number(4), number(5)};
        const bool left = clip_to_slab(node, number(0), number(1), number(2), number(3), interval);
        EXPECT_EQ(kernel.program.r(4), left ? 1 : 0);
        EXPECT_EQ(kernel.at(4), interval.entry.word());
        EXPECT_EQ(kernel.at(5), interval.exit.word());
        met += left ? 1 : 0;
    }
    EXPECT_GT(met, count / 10);
    EXPECT_LT(met, count - count / 10);
    return kernel.cycles;
}

inline Cycles try_reciprocal_square_root(std::uint64_t seed, int count) {
    Kernel kernel("reciprocal_square_root", {"reciprocal_square_root"});
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const Word x = coordinate(words);
        kernel.put(0, {x});
        kernel.call({0, 1});
        EXPECT_EQ(kernel.at(1), dsp32::routines::reciprocal_square_root(x)) << std::hex << x;
    }
    return kernel.cycles;
}

inline Cycles try_normalize(std::uint64_t seed, int count) {
    Kernel kernel("normalize", {"normalize", "reciprocal", "reciprocal_square_root"});
    ProcessorNode node({}, 0);
    dsp32::RandomWords words(seed);
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[3];
        for (Word& word : in) word = i % 50 == 0 ? dsp32::zero : ordinary(words);
        kernel.put(0, {in[0], in[1], in[2]});
        kernel.call({0, 3});
        const Vec3<Float> unit = normalize(node, vector_of(in));
        EXPECT_EQ(kernel.at(3), unit.x.word());
        EXPECT_EQ(kernel.at(4), unit.y.word());
        EXPECT_EQ(kernel.at(5), unit.z.word());
    }
    return kernel.cycles;
}

inline Cycles try_box(std::uint64_t seed, int count) {
    Kernel kernel("box", {"box", "slab", "reciprocal"});
    using Record = FollowSetRecord<1>;
    ShapedNode shaped(Record::words);
    auto& [node, shape] = shaped;
    dsp32::RandomWords words(seed);
    int met = 0;
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        Word in[13];
        for (Word& word : in) word = ordinary(words);
        // Half of the rays start in the box, where its corners are in order.
        for (int k = 0; i % 2 == 0 && k < 3; ++k) {
            const Float o = Float::from_word(in[k]), size = absolute(Float::from_word(in[7 + k]));
            in[7 + k] = (o - size).word();
            in[10 + k] = (o + size).word();
        }
        for (std::uint32_t k = 0; k < 13; ++k) kernel.put(k, {in[k]});
        for (std::uint32_t k = 0; k < 6; ++k) shape[Record::low + k] = in[7 + k];
        kernel.put(13, {0x11, 0x22});
        kernel.call({0, 7, 13});
        const auto interval = intersect_box(node, ray_of(in), 0);
        EXPECT_EQ(kernel.program.r(4), interval ? 1 : 0);
        EXPECT_EQ(kernel.at(13), interval ? interval->entry.word() : 0x11U);
        EXPECT_EQ(kernel.at(14), interval ? interval->exit.word() : 0x22U);
        met += interval ? 1 : 0;
    }
    EXPECT_GT(met, count / 10);
    EXPECT_LT(met, count - count / 10);
    return kernel.cycles;
}

struct HeapCycles {
    Cycles push, pop;
};

/// Fills and empties both heaps at random; after each step they have the same order.
inline HeapCycles try_heap(std::uint64_t seed, int count) {
    constexpr int capacity = 256;
    using Entry = Cell<Float>;
    Kernel kernel("heap_push", {"heap"});
    EXPECT_TRUE(kernel.program.node.zbuffer().reserve(capacity * 4));
    kernel.program.call("heap_clear");
    ProcessorNode node({}, 0);
    EXPECT_FALSE(node.load_program(0, 0));
    EXPECT_FALSE(node.reserve_heap(capacity, sizeof(Entry)));
    Heap<ProcessorNode> heap(node);
    heap.clear();
    std::mt19937_64 engine(seed);
    Cycles pop;
    const std::uint32_t order = kernel.program.at("heap_order");
    std::set<Word> keys;  // in use: equal ones are ordered by more than their keys
    for (int i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const bool filling = engine() % 16 < (i / 600 % 2 == 0 ? 11U : 5U);
        if (keys.size() < capacity && (keys.empty() || filling)) {
            Entry cell;
            do {
                cell.key = Float(1e-3 * static_cast<double>(engine() % 1'000'000));
            } while (!keys.insert(cell.key.word()).second);
            heap.push(cell);
            kernel.put(0, {cell.key.word()});
            kernel.call({0});
        } else {
            Entry cell;
            heap.pop(cell);
            keys.erase(cell.key.word());
            kernel.call_label("heap_pop", pop);
            const Word* slots = kernel.program.node.zbuffer().words().data();
            EXPECT_EQ(slots[kernel.program.r(4)], cell.key.word());
        }
        bool same_order = true;
        for (std::uint32_t k = 0; k < capacity; ++k) {
            const Word pair = kernel.program.processor.fast_word(order + k / 2 * 4);
            same_order &= (k % 2 == 0 ? pair & 0xFFFFU : pair >> 16U) == node.heap_order()[k];
        }
        EXPECT_TRUE(same_order) << "step " << i;
    }
    return {kernel.cycles, pop};
}

}  // namespace pxm::kernels
