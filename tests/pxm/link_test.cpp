// Laws of pxm/link, and of the token program that uses it.
#include "pxm/link.hpp"

#include <gtest/gtest.h>

#include "dsp_kernels/token_program.hpp"

namespace pxm {
namespace {

TEST(Fifo, words_come_out_in_the_order_they_went_in) {
    Fifo fifo;
    std::uint32_t next_in = 0;
    std::uint32_t next_out = 0;
    for (int round = 0; round < 50; ++round) {
        for (int i = 0; i < 1 + round % 5; ++i) {
            if (fifo.put(next_in)) ++next_in;
        }
        for (int i = 0; i < 1 + round % 3; ++i) {
            if (const auto word = fifo.take()) {
                EXPECT_EQ(*word, next_out++);
            }
        }
    }
    EXPECT_GT(next_out, 50U);
}

TEST(Fifo, full_and_empty_are_values) {
    Fifo fifo;
    EXPECT_EQ(fifo.take(), std::nullopt);
    for (std::uint32_t i = 0; i < Fifo::capacity; ++i) EXPECT_TRUE(fifo.put(i));
    EXPECT_TRUE(fifo.full());
    EXPECT_FALSE(fifo.put(99));
    for (std::uint32_t i = 0; i < Fifo::capacity; ++i) EXPECT_EQ(fifo.take(), i);
    EXPECT_EQ(fifo.take(), std::nullopt);
}

TEST(Torus, the_way_back_leads_back_and_the_way_round_is_an_axis_long) {
    for (const Model& model : models()) {
        const Torus torus(model);
        for (int node = 0; node < torus.nodes(); ++node) {
            for (const Direction direction : all_directions) {
                const int next = torus.neighbour(node, direction);
                EXPECT_NE(next, node);
                EXPECT_EQ(torus.neighbour(next, opposite(direction)), node);
                const bool across = direction == Direction::east || direction == Direction::west;
                int at = node;
                for (int i = 0; i < (across ? model.columns : model.rows); ++i) {
                    at = torus.neighbour(at, direction);
                }
                EXPECT_EQ(at, node);
            }
        }
    }
}

TEST(Torus, a_word_arrives_at_the_neighbour_from_the_opposite_side_after_delivery) {
    Torus torus(*find_model("920"));
    for (const Direction direction : all_directions) {
        const int next = torus.neighbour(7, direction);
        EXPECT_TRUE(torus.ports(7).send(direction, 42));
        EXPECT_EQ(torus.ports(next).receive(opposite(direction)), std::nullopt);
        torus.deliver();
        EXPECT_EQ(torus.ports(next).receive(opposite(direction)), 42U);
        EXPECT_FALSE(torus.carries_words());
    }
}

TEST(Torus, a_neighbour_that_does_not_read_stops_the_sender_and_no_word_is_lost) {
    Torus torus(*find_model("916"));
    std::uint32_t sent = 0;
    for (int step = 0; step < 100; ++step) {
        while (torus.ports(0).send(Direction::east, sent)) ++sent;
        torus.deliver();
    }
    EXPECT_EQ(sent, 2 * Fifo::capacity);
    std::uint32_t received = 0;
    for (int step = 0; step < 3; ++step) {
        while (const auto word = torus.ports(1).receive(Direction::west)) {
            EXPECT_EQ(*word, received++);
        }
        torus.deliver();
    }
    EXPECT_EQ(received, sent);
    EXPECT_FALSE(torus.carries_words());
}

TEST(Torus, a_program_that_never_finishes_is_ended) {
    Torus torus(*find_model("916"));
    const auto steps = run_supersteps(
        torus, [](int, Ports&) { return Progress::working; }, 2, 10);
    EXPECT_EQ(steps, std::nullopt);
}

TEST(Token, visits_every_node_once_and_comes_home_on_any_number_of_threads) {
    for (const Model& model : models()) {
        std::optional<int> first_steps;
        for (const int threads : {1, 3}) {
            std::vector<kernels::TokenNode> nodes;
            for (int i = 0; i < model.nodes(); ++i) {
                nodes.emplace_back(i % model.columns, i / model.columns, model.columns, model.rows);
            }
            Torus torus(model);
            const auto steps = run_supersteps(
                torus,
                [&](int node, Ports& ports) {
                    return nodes[static_cast<std::size_t>(node)].step(ports);
                },
                threads, 4 * model.nodes());
            ASSERT_TRUE(steps) << model.name;
            if (!first_steps) first_steps = steps;
            EXPECT_EQ(steps, first_steps);
            for (const kernels::TokenNode& node : nodes) EXPECT_EQ(node.visits(), 1);
            const auto home = nodes.front().home();
            ASSERT_TRUE(home) << model.name;
            EXPECT_EQ(home->visited, static_cast<std::uint32_t>(model.nodes()));
            EXPECT_EQ(static_cast<int>(home->hops) + 1, *steps);  // one link a superstep
        }
    }
}

}  // namespace
}  // namespace pxm
