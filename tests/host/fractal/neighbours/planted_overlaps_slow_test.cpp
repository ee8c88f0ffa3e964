// Exact overlaps in systems that were made to have one, and in whole-number systems whose cells a
// few lines of integers can count.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

constexpr unsigned seed = 20'190;

/// x -> x / ratio + (a, b) / 97.
struct Homothety {
    long ratio;
    long a;
    long b;
    [[nodiscard]] std::string text() const {
        return "scale: 1/" + std::to_string(ratio) + " translate: " + std::to_string(a) + "/97," +
               std::to_string(b) + "/97,0";
    }
};

/// f g, moved by `slip`: x / (r s) + (slip + c_g / r + c_f) / 97.
std::string product(const Homothety& f, const Homothety& g, const std::string& slip) {
    const auto coordinate = [&](long of_f, long of_g) {
        return "(" + slip + "+" + std::to_string(of_g) + "/" + std::to_string(f.ratio) + "+" +
               std::to_string(of_f) + ")/97";
    };
    return "scale: 1/" + std::to_string(f.ratio * g.ratio) + " translate: " + coordinate(f.a, g.a) +
           "," + coordinate(f.b, g.b) + ",0";
}

TEST(PlantedOverlaps, each_is_found_and_none_where_it_was_moved_away) {
    constexpr int systems = 1'000;
    constexpr host::NeighbourLimits limits{.types = 300};
    std::mt19937 random(seed);
    const auto draw = [&](long low, long high) {
        return std::uniform_int_distribution<long>(low, high)(random);
    };
    for (int i = 0; i < systems; ++i) {
        std::vector<Homothety> maps;
        for (int m = 0; m < 3; ++m) maps.push_back({draw(3, 5), draw(0, 96), draw(0, 96)});
        std::vector<std::string> texts;
        for (const Homothety& map : maps) texts.push_back(map.text());
        const Homothety& f = maps[static_cast<std::size_t>(draw(0, 2))];
        const Homothety& g = maps[static_cast<std::size_t>(draw(0, 2))];
        texts.push_back(product(f, g, "0"));
        const ExactFindings planted = exact_of(system_of(texts), limits);
        EXPECT_EQ(planted.overlaps.value, true) << i << ":\n" << system_of(texts);
        EXPECT_EQ(planted.open_set.value, false) << i;
        texts.back() = product(f, g, "1/1000003");
        EXPECT_NE(exact_of(system_of(texts), limits).overlaps.value, true) << i << ":\n"
                                                                           << system_of(texts);
    }
}

/// (x + d) / base for digits d of the plane.
struct WholeSystem {
    long base = 2;
    std::vector<std::array<long, 2>> digits;

    [[nodiscard]] std::string text() const {
        std::vector<std::string> maps;
        for (const auto& [x, y] : digits)
            maps.push_back("scale: 1/" + std::to_string(base) + " translate: " + std::to_string(x) +
                           "/" + std::to_string(base) + "," + std::to_string(y) + "/" +
                           std::to_string(base) + ",0");
        return system_of(maps);
    }
    /// base^length times where the word's map takes 0.
    [[nodiscard]] std::array<long, 2> place(const std::vector<int>& word) const {
        std::array<long, 2> sum{};
        for (const int m : word)
            for (std::size_t i = 0; i < 2; ++i)
                sum[i] = base * sum[i] + digits[static_cast<std::size_t>(m)][i];
        return sum;
    }
    /// Whether all words of that length are different maps.
    [[nodiscard]] bool all_different(int length) const {
        std::vector<std::array<long, 2>> places{{0, 0}};
        for (int level = 0; level < length; ++level) {
            std::vector<std::array<long, 2>> next;
            for (const auto& p : places)
                for (const auto& d : digits)
                    next.push_back({base * p[0] + d[0], base * p[1] + d[1]});
            places = next;
        }
        return std::set(places.begin(), places.end()).size() == places.size();
    }
};

TEST(PlantedOverlaps, whole_number_systems_agree_with_integers) {
    constexpr int systems = 500, levels = 5;
    std::mt19937 random(seed);
    const auto draw = [&](long low, long high) {
        return std::uniform_int_distribution<long>(low, high)(random);
    };
    int holds = 0, fails = 0;
    for (int i = 0; i < systems; ++i) {
        WholeSystem system;
        system.base = draw(2, 3);
        std::set<std::array<long, 2>> digits;
        while (digits.size() < 4) digits.insert({draw(0, 4), draw(0, 4)});
        system.digits.assign(digits.begin(), digits.end());
        const ExactFindings found = exact_of(system.text());
        ASSERT_EQ(found.finite.value, true) << found.finite.why << "\n" << system.text();
        ASSERT_TRUE(found.open_set.value) << system.text();
        if (*found.open_set.value) {
            ++holds;
            EXPECT_TRUE(system.all_different(levels)) << system.text();
        } else {
            ++fails;
            const auto& [u, v] = found.overlapping_words;
            EXPECT_NE(u, v);
            EXPECT_EQ(u.size(), v.size());
            EXPECT_EQ(system.place(u), system.place(v)) << system.text();
        }
    }
    EXPECT_GT(holds, systems / 10);
    EXPECT_GT(fails, systems / 10);
}

}  // namespace
}  // namespace pxm::test
