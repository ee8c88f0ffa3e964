// Laws of sharing pixels out among nodes.
#include "host/study/partition.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "pxm/model.hpp"
#include "tests/support/render_text.hpp"

namespace pxm::host {
namespace {

constexpr HandOutCosts nothing{0, 0, 8};

Work random_work(long columns, long rows, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint64_t> cycles(static_cast<std::size_t>(columns * rows));
    for (std::uint64_t& c : cycles) c = 100 + random() % 10'000;
    return {columns, rows, cycles};
}

Work even_work(long columns, long rows) {
    return {columns, rows, std::vector<std::uint64_t>(static_cast<std::size_t>(columns * rows), 7)};
}

std::uint64_t sum(const std::vector<std::uint64_t>& values) {
    return std::accumulate(values.begin(), values.end(), std::uint64_t{0});
}

TEST(Partition, every_pixel_is_computed_once) {
    const Work work = random_work(37, 29, 1);
    for (const Partition partition : all_partitions) {
        for (const long nodes : {1L, 2L, 64L, 4096L}) {
            const Share share = share_out(work, array_of(nodes), partition);
            EXPECT_EQ(share.useful, sum(work.cycles)) << name_of(partition) << nodes;
            EXPECT_EQ(sum(share.cycles), share.useful + share.overhead) << name_of(partition);
            EXPECT_EQ(share.slowest, *std::ranges::max_element(share.cycles));
        }
    }
}

TEST(Partition, interleaved_is_what_the_machine_counted) {
    const RenderResult result =
        test::render_text(test::tetra_text, test::on_machine("920", 43, 31));
    std::vector<std::uint64_t> cycles;
    for (const PixelRecord& pixel : result.frame.pixels) cycles.push_back(pixel.cycles);
    const Share share = share_out({43, 31, cycles}, {5, 4}, Partition::interleaved);
    const std::vector<NodeStatistics>& nodes = result.statistics.machine->nodes;
    ASSERT_EQ(share.cycles.size(), nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(share.cycles[i], nodes[i].cycles);
    EXPECT_EQ(share.overhead, 0U);
}

TEST(Partition, efficiency_is_the_mean_over_the_largest_and_speed_up_the_sum_over_it) {
    const Share share = share_out(Work(4, 1, {1, 2, 3, 10}), {4, 1}, Partition::interleaved);
    EXPECT_DOUBLE_EQ(share.efficiency(), 0.4);
    EXPECT_DOUBLE_EQ(share.speed_up(), 1.6);
    EXPECT_EQ(share.slowest, 10U);
}

TEST(Partition, even_work_is_shared_evenly) {
    const Work work = even_work(64, 64);
    for (const Partition partition : all_partitions)
        EXPECT_EQ(share_out(work, {8, 8}, partition, nothing).efficiency(), 1)
            << name_of(partition);
}

TEST(Partition, work_that_repeats_with_the_array_defeats_the_interleave) {
    std::vector<std::uint64_t> cycles(64 * 64, 1);
    for (std::size_t x = 0; x < 64; x += 8)
        for (std::size_t y = 0; y < 64; y += 8) cycles[y * 64 + x] = 1000;
    const Work work(64, 64, cycles);
    EXPECT_NEAR(share_out(work, {8, 8}, Partition::interleaved).speed_up(), 1, 0.1);
    EXPECT_GT(share_out(work, {8, 8}, Partition::blocks, nothing).efficiency(), 0.9);
    EXPECT_GT(share_out(work, {5, 3}, Partition::interleaved).efficiency(), 0.7);
    EXPECT_GT(share_out(work, {8, 8}, Partition::random, nothing).efficiency(), 0.2);
}

TEST(Partition, one_node_pays_for_nothing_but_being_handed_out) {
    const Work work = random_work(40, 16, 2);
    for (const Partition partition : all_partitions) {
        const Share share = share_out(work, {1, 1}, partition);
        EXPECT_EQ(share.overhead, partition == Partition::dynamic ? 200U * 5 * 2 : 0U);
    }
}

TEST(Partition, handing_out_ends_within_a_tile_of_the_best) {
    const Work work = random_work(120, 100, 3);
    const Share share = share_out(work, {8, 8}, Partition::dynamic, nothing);
    std::uint64_t dearest = 0;
    for (long top = 0; top < 100; top += 8) {
        for (long left = 0; left < 120; left += 8) {
            std::uint64_t tile = 0;
            for (long y = top; y < std::min(100L, top + 8); ++y)
                for (long x = left; x < std::min(120L, left + 8); ++x) tile += work.at(x, y);
            dearest = std::max(dearest, tile);
        }
    }
    EXPECT_LE(share.slowest, share.useful / 64 + dearest);  // Graham's bound for lists
}

TEST(Partition, a_pixel_that_another_node_holds_costs_its_sending) {
    const Work work = even_work(16, 8);
    const Share share = share_out(work, {2, 1}, Partition::columns, {20, 0, 8});
    EXPECT_EQ(share.overhead, 20U * 64) << "half of the pixels are held by the other node";
}

TEST(Partition, arrays_are_as_square_as_can_be) {
    for (const auto& [nodes, columns, rows] :
         {std::tuple{1, 1, 1}, {2, 2, 1}, {32, 8, 4}, {64, 8, 8}, {65'536, 256, 256}}) {
        const NodeArray array = array_of(nodes);
        EXPECT_EQ(array.columns, columns);
        EXPECT_EQ(array.rows, rows);
    }
}

}  // namespace
}  // namespace pxm::host
