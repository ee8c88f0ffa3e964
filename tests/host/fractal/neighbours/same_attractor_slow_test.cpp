// One attractor written in several ways: by words in place of maps, turned and moved, with a map
// more that changes nothing, as a graph. What is decided of one is not contradicted by another.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>

#include "tests/host/fractal/neighbours/findings_of.hpp"

namespace pxm::test {
namespace {

using host::ExactFindings;

/// (x, y) -> (a x + b y + c, d x + e y + f), with numbers over one denominator.
struct PlaneMap {
    std::array<long, 6> over{};
    long under = 1;

    [[nodiscard]] std::string text() const {
        const auto number = [&](std::size_t i) {
            return "(" + std::to_string(over[i]) + ")/" + std::to_string(under);
        };
        // z shrinks by the root of the area's ratio, so that the map of space is a similitude.
        return "matrix: " + number(0) + "," + number(3) + ",0, " + number(1) + "," + number(4) +
               ",0, 0,0,1/2, " + number(2) + "," + number(5) + ",0";
    }
};

PlaneMap after(const PlaneMap& outer, const PlaneMap& inner) {
    const auto& p = outer.over;
    const auto& q = inner.over;
    return {{p[0] * q[0] + p[1] * q[3], p[0] * q[1] + p[1] * q[4],
             p[0] * q[2] + p[1] * q[5] + p[2] * inner.under, p[3] * q[0] + p[4] * q[3],
             p[3] * q[1] + p[4] * q[4], p[3] * q[2] + p[4] * q[5] + p[5] * inner.under},
            outer.under * inner.under};
}

using PlaneSystem = std::vector<PlaneMap>;

std::string text_of(const PlaneSystem& system, const std::string& more = "") {
    std::vector<std::string> maps;
    for (std::size_t m = 0; m < system.size(); ++m)
        maps.push_back("m" + std::to_string(m) + " " + system[m].text());
    return system_of(maps, more);
}

class Drawn {
  public:
    explicit Drawn(unsigned seed) : random_(seed) {}
    long between(long low, long high) {
        return std::uniform_int_distribution<long>(low, high)(random_);
    }
    /// Cells of a square grid, each with the whole turned by quarters and mirrored.
    PlaneSystem system() {
        const long base = between(2, 3);
        const bool turned = between(0, 1) == 1;
        std::set<std::array<long, 2>> digits;
        const auto count = static_cast<std::size_t>(between(2, 4));
        while (digits.size() < count) digits.insert({between(0, 3), between(0, 3)});
        PlaneSystem maps;
        for (const auto& [x, y] : digits) {
            long c = 1, s = 0;
            for (long quarter = turned ? between(0, 3) : 0; quarter > 0; --quarter) {
                const long before = c;
                c = -s;
                s = before;
            }
            const long mirror = turned && between(0, 1) == 1 ? -1 : 1;
            maps.push_back({{c, -s * mirror, x, s, c * mirror, y}, base});
        }
        return maps;
    }

  private:
    std::mt19937 random_;
};

PlaneSystem of_pairs(const PlaneSystem& system) {
    PlaneSystem words;
    for (const PlaneMap& outer : system)
        for (const PlaneMap& inner : system) words.push_back(after(outer, inner));
    return words;
}

/// By g x = (3 x - 4 y + 5, 4 x + 3 y - 7) / 5.
PlaneSystem turned(const PlaneSystem& system) {
    const PlaneMap g{{3, -4, 5, 4, 3, -7}, 5};
    const PlaneMap back{{15, 20, 13, -20, 15, 41}, 25};
    EXPECT_EQ(after(g, back).text(), (PlaneMap{{125, 0, 0, 0, 125, 0}, 125}).text());
    PlaneSystem maps;
    for (const PlaneMap& map : system) maps.push_back(after(after(g, map), back));
    return maps;
}

PlaneSystem with_a_word(const PlaneSystem& system) {
    PlaneSystem maps = system;
    maps.push_back(after(system.front(), system.back()));
    return maps;
}

class Comparison {
  public:
    Comparison(ExactFindings one, ExactFindings other, std::string what)
        : one_(std::move(one)), other_(std::move(other)), what_(std::move(what)) {}

    void same_set() {
        agree("connected", one_.connected, other_.connected);
        agree("totally disconnected", one_.totally_disconnected, other_.totally_disconnected);
        agree("interior", one_.interior, other_.interior);
        agree("Hausdorff", one_.hausdorff, other_.hausdorff);
        agree("boundary", one_.boundary, other_.boundary);
        agree("volume", one_.volume, other_.volume);
    }
    void same_words() {
        agree("overlaps", one_.overlaps, other_.overlaps);
        agree("open set", one_.open_set, other_.open_set);
    }

  private:
    template <class Value>
    void agree(const char* key, const host::Decided<Value>& a, const host::Decided<Value>& b) {
        if (!a.value || !b.value) return;
        EXPECT_NEAR(static_cast<double>(*a.value), static_cast<double>(*b.value), 1e-7)
            << key << ": " << a.why << "; " << b.why << "\n"
            << what_;
    }
    ExactFindings one_;
    ExactFindings other_;
    std::string what_;
};

TEST(SameAttractor, no_two_ways_to_write_it_contradict_each_other) {
    constexpr int systems = 60;
    constexpr host::NeighbourLimits limits{.types = 2'000, .steps = 2'000'000};
    Drawn draw(19'190);
    int decided = 0;
    for (int i = 0; i < systems; ++i) {
        const PlaneSystem system = draw.system();
        const std::string text = text_of(system);
        const ExactFindings found = exact_of(text, limits);
        decided += found.open_set.value.has_value();
        Comparison pairs(found, exact_of(text_of(of_pairs(system)), limits), text);
        pairs.same_set();
        pairs.same_words();
        Comparison moved(found, exact_of(text_of(turned(system)), limits), text);
        moved.same_set();
        moved.same_words();
        const ExactFindings more = exact_of(text_of(with_a_word(system)), limits);
        Comparison(found, more, text).same_set();
        EXPECT_EQ(more.overlaps.value, true) << text;
        // The same as a graph whose maps may be followed by all.
        std::string follow, all;
        for (std::size_t m = 0; m < system.size(); ++m)
            all += (m > 0 ? ",m" : "m") + std::to_string(m);
        for (std::size_t m = 0; m < system.size(); ++m)
            follow += "follow: m" + std::to_string(m) + " -> " + all + "\n";
        Comparison graph(found, exact_of(text_of(system, follow), limits), text);
        graph.same_set();
        graph.same_words();
    }
    EXPECT_GT(decided, systems / 2);
    RecordProperty("decided", decided);
}

}  // namespace
}  // namespace pxm::test
