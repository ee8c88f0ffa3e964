// More systems of whole numbers, and thousands of planted overlaps of similitudes that turn.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "tests/host/fractal/neighbours/certificates.hpp"

namespace pxm::test {
namespace {

TEST(Certificates, thousands_of_whole_systems_agree_with_integers) {
    constexpr unsigned seed = 19'501;
    constexpr int systems = 4'000, levels = 5;
    std::mt19937 random(seed);
    Certified sums;
    for (int i = 0; i < systems; ++i) expect_certificate(random_whole_system(random), levels, sums);
    EXPECT_GT(sums.holds, systems / 5);
    EXPECT_GT(sums.fails, systems / 50);
    RecordProperty("holds", sums.holds);
    RecordProperty("fails", sums.fails);
    RecordProperty("inside", sums.inside);
    RecordProperty("open", sums.open);
}

/// x -> turned by 60 degrees `turn` times, over `ratio`, moved by (a, b) / 97.
struct Turned {
    long ratio;
    long turn;
    long a;
    long b;
    [[nodiscard]] std::string text() const {
        return " scale: 1/" + std::to_string(ratio) + " rotate: z," + std::to_string(60 * turn) +
               " translate: " + std::to_string(a) + "/97," + std::to_string(b) + "/97,0";
    }
};

TEST(Certificates, thousands_of_planted_overlaps_are_found) {
    constexpr unsigned seed = 19'502;
    constexpr int systems = 5'000;
    constexpr host::NeighbourLimits limits{.types = 300, .steps = 300'000};
    std::mt19937 random(seed);
    const auto draw = [&](long low, long high) {
        return std::uniform_int_distribution<long>(low, high)(random);
    };
    int found = 0, none_where_moved = 0;
    for (int i = 0; i < systems; ++i) {
        std::vector<Turned> maps;
        for (int m = 0; m < 3; ++m)
            maps.push_back({draw(3, 5), draw(0, 5), draw(0, 96), draw(0, 96)});
        std::vector<std::string> texts;
        for (const Turned& map : maps) texts.push_back(map.text());
        // A product of two or three of them, innermost first, as one more map.
        std::string product;
        for (long length = draw(2, 3); length > 0; --length)
            product += maps[static_cast<std::size_t>(draw(0, 2))].text();
        texts.push_back(product);
        const auto planted = exact_of(system_of(texts), limits);
        EXPECT_EQ(planted.overlaps.value, true) << i << ":\n" << system_of(texts);
        found += planted.overlaps.value == true ? 1 : 0;
        texts.back() += " translate: 1/1000003,0,0";
        const auto moved = exact_of(system_of(texts), limits);
        EXPECT_NE(moved.overlaps.value, true) << i << ":\n" << system_of(texts);
        none_where_moved += moved.overlaps.value == false ? 1 : 0;
    }
    RecordProperty("found", found);
    RecordProperty("none_where_moved", none_where_moved);
}

}  // namespace
}  // namespace pxm::test
