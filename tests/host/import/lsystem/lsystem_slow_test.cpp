// The system of an L-system's limit against the turtle's own drawing of a high level.
#include "host/import/lsystem/lsystem.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "host/error.hpp"
#include "host/scene/parse/parser.hpp"
#include "tests/host/import/turtle.hpp"
#include "tests/support/paths.hpp"

namespace pxm::host {
namespace {

using test::Complex;
using test::draw;
using test::word_of_level;

std::vector<FractintL> classics() {
    Diagnostics diagnostics;
    return parse_fractint_l(read_file(pxm::test::source_dir + "/tests/data/import/classic.l"),
                            diagnostics);
}

FractintL classic(const std::string& name) {
    for (FractintL& l : classics())
        if (l.entry.name == name) return l;
    ADD_FAILURE() << name;
    return {};
}

FractintL entry(const std::string& body) {
    Diagnostics diagnostics;
    auto list = parse_fractint_l("test {\n" + body + "\n}", diagnostics);
    return list.at(0);
}

EdgeSystem system_of(FractintL l) {
    const Lsystem lsystem = lsystem_of(l);
    EXPECT_FALSE(l.entry.diagnostics.has_errors());
    return edge_system(lsystem);
}

std::string refusal(FractintL l) {
    try {
        const EdgeSystem system = system_of(std::move(l));
        return "a system of " + std::to_string(system.kinds.size()) + " kinds";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        return error.what();
    }
}

/// One point of every cell no larger than `size` times what stands in it.
void enumerate(const EdgeSystem& system, const Similarity& map, int kind, double size,
               std::vector<Complex>& points) {
    if (std::abs(map.linear) <= size) {
        points.push_back(map.offset);
        return;
    }
    for (const EdgeMap& next : system.kinds[static_cast<std::size_t>(kind)].maps)
        enumerate(system, then(next.map, map), next.inside, size, points);
}

double one_sided(const std::vector<Complex>& from, const std::vector<Complex>& to) {
    double farthest = 0;
    for (const Complex& a : from) {
        double nearest = 1e300;
        for (const Complex& b : to) nearest = std::min(nearest, std::norm(a - b));
        farthest = std::max(farthest, nearest);
    }
    return std::sqrt(farthest);
}

struct Case {
    const char* name;
    int level;              // drawn by the turtle
    double size;            // of the cells enumerated
    double apart;           // allowed between the two, in steps of the turtle
    const char* edge = "";  // the symbol whose edge has length 1; else the first kind's
};

class LsystemClassics : public testing::TestWithParam<Case> {};

TEST_P(LsystemClassics, the_limit_is_what_the_turtle_draws) {
    const Case& c = GetParam();
    const FractintL l = classic(c.name);
    const EdgeSystem system = system_of(l);
    // The first edge that anything comes after has length 1, or runs from 0 to 1 if directions
    // change with the level.
    std::string first = c.edge;
    if (first.empty()) first.push_back(lower(system.kinds[0].name[0]));
    const Complex edge = draw(l, word_of_level(l, first, c.level), 1).end;
    const bool turns = system.growth.imag() != 0;
    const double step = 1 / std::abs(edge);
    const test::Drawing drawing =
        draw(l, word_of_level(l, l.axiom->text, c.level), std::max(0.5, c.size / step));
    std::vector<Complex> drawn;
    for (const Complex& p : drawing.points) drawn.push_back(turns ? p / edge : p * step);
    std::vector<Complex> enumerated;
    for (const EdgeMap& map : system.start)
        enumerate(system, map.map, map.inside, c.size, enumerated);
    EXPECT_LT(one_sided(drawn, enumerated), c.apart * std::max(step, c.size));
    EXPECT_LT(one_sided(enumerated, drawn), c.apart * std::max(step, c.size));
}

INSTANTIATE_TEST_SUITE_P(Systems, LsystemClassics,
                         testing::Values(Case{"Koch", 5, 0.005, 2}, Case{"Snowflake", 4, 0.014, 2},
                                         Case{"Dragon", 10, 0.033, 2},
                                         Case{"Arrowhead", 6, 0.02, 3}, Case{"Levy", 10, 0.033, 3},
                                         Case{"Hilbert", 5, 0.04, 3}, Case{"Terdragon", 6, 0.04, 2},
                                         Case{"Cantor", 6, 0.002, 2}, Case{"Bush", 4, 0.07, 5},
                                         Case{"Plant", 6, 0.05, 3, "f"}, Case{"Tree", 9, 0.03, 2},
                                         Case{"FlowSnake", 4, 0.06, 3},
                                         Case{"Mirrored", 10, 0.033, 3},
                                         Case{"Degrees", 5, 0.005, 2}, Case{"Spin", 6, 0.06, 5}),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Lsystem, koch_is_four_thirds_of_exact_similitudes) {
    const EdgeSystem system = system_of(classic("Koch"));
    ASSERT_EQ(system.kinds.size(), 1U);
    double sum = 0;  // Moran's equation at log 4 / log 3
    for (const EdgeMap& map : system.kinds[0].maps)
        sum += std::pow(std::abs(map.map.linear), std::log(4.0) / std::log(3.0));
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_EQ(system.kinds[0].maps.size(), 4U);
    EXPECT_NEAR(std::abs(system.kinds[0].maps[2].map.point(1.0) - Complex(2.0 / 3, 0)), 0, 1e-15);
}

TEST(Lsystem, every_map_of_the_dragon_is_one_over_root_two) {
    const EdgeSystem system = system_of(classic("Dragon"));
    EXPECT_EQ(system.kinds.size(), 2U);
    for (const EdgeKind& kind : system.kinds)
        for (const EdgeMap& map : kind.maps)
            EXPECT_NEAR(std::abs(map.map.linear), std::sqrt(0.5), 1e-15);
}

TEST(Lsystem, the_snowflake_starts_with_three_edges) {
    const EdgeSystem system = system_of(classic("Snowflake"));
    ASSERT_EQ(system.start.size(), 3U);
    EXPECT_NEAR(std::abs(system.start[2].map.point(1.0)), 0, 1e-14);  // it closes
    const IfsBlock block = lsystem_maps(system);
    EXPECT_EQ(block.start.size(), 3U);
    EXPECT_EQ(block.maps.size(), 7U);
}

TEST(Lsystem, gasket_of_the_thesis) {
    // Eqs. 7.4, 7.5: A -> BcAcB, B -> AdBdA, where c and d draw and turn by 60 degrees (Sec. 7.3).
    const EdgeSystem thesis = system_of(entry("Angle 6\nAxiom A\nA=BF+AF+B\nB=AF-BF-A"));
    for (const EdgeKind& kind : thesis.kinds) {
        EXPECT_EQ(kind.maps.size(), 3U);
        for (const EdgeMap& map : kind.maps) EXPECT_NEAR(std::abs(map.map.linear), 0.5, 1e-15);
    }
    EXPECT_EQ(thesis.kinds.size(), 4U);  // A and B at even and at odd levels
}

TEST(Lsystem, lengths_of_different_edges_are_solved_for) {
    // Fibonacci: A is phi times as long as B, and both shrink by phi a level.
    const EdgeSystem system = system_of(entry("Angle 4\nAxiom F\nF=FD\nD=F"));
    const double phi = (1 + std::sqrt(5.0)) / 2;
    EXPECT_NEAR(system.growth.real(), phi, 1e-14);
    ASSERT_EQ(system.kinds[0].maps.size(), 2U);
    EXPECT_NEAR(system.kinds[0].maps[1].map.offset.real(), 1 / phi, 1e-14);
}

TEST(Lsystem, a_gap_draws_nothing_and_keeps_its_place) {
    const EdgeSystem system = system_of(classic("Cantor"));
    ASSERT_EQ(system.kinds[0].maps.size(), 2U);
    EXPECT_NEAR(system.kinds[0].maps[1].map.offset.real(), 2.0 / 3, 1e-15);
}

TEST(Lsystem, what_has_no_limit_is_refused_with_the_reason) {
    EXPECT_EQ(
        refusal(classic("Closed")),
        "L-system \"Closed\" has no exact linear fractal: its edges are replaced by paths that "
        "end where they begin, or vanish");
    EXPECT_THAT(refusal(entry("Angle 4\nAxiom X\nX=XF\nF=F")),
                testing::HasSubstr("do not settle to a common growth"));
    EXPECT_THAT(refusal(entry("Angle 4\nAxiom F\nF=@.5FF")),
                testing::HasSubstr("differently at every level"));
    EXPECT_THAT(refusal(entry("Axiom F\nF=F\\37.123FF")),
                testing::HasSubstr("differently at every level"));
    EXPECT_THAT(refusal(entry("Angle 4\nAxiom G\nG=GG")),
                testing::HasSubstr("what it draws does not grow"));
    for (const std::string axiom : {"-", "+-|", "[]", "-[+]", "@.5", "!"})
        EXPECT_THAT(refusal(entry("Angle 4\nAxiom " + axiom + "\nF=FGF")),
                    testing::HasSubstr("its axiom turns the turtle and draws nothing"))
            << axiom;
}

/// The similarity dimension of a system of one kind whose maps have one ratio.
double dimension_of_equal_maps(const EdgeSystem& system) {
    const std::vector<EdgeMap>& maps = system.kinds.at(0).maps;
    return std::log(static_cast<double>(maps.size())) / -std::log(std::abs(maps[0].map.linear));
}

// Two symbols that do the same begin alike, and stay alike; what would tell them apart grows by
// sqrt 7 and comes from rounding alone.
TEST(Lsystem, lengths_grow_as_the_strokes_do_and_not_as_rounding) {
    const std::string one = "Angle 9\nAxiom X\nX=XFXF+++XF---\nF=";
    const std::string two = "Angle 9\nAxiom X\nX=XFXF+++YF---\nY=YF+++XF---YF\nF=";
    EXPECT_NEAR(std::abs(system_of(entry(one)).growth), std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(std::abs(system_of(entry(two)).growth), std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(dimension_of_equal_maps(system_of(entry(one))), 2, 1e-13);
    EXPECT_NEAR(dimension_of_equal_maps(system_of(entry(two))), 2, 1e-13);
}

// Seventh parts of a turn are no doubles: summed as such, a closed path of seven strokes is not.
TEST(Lsystem, paths_that_close_are_zero_however_the_turns_are_written) {
    const std::string closed = "its edges are replaced by paths that end where they begin";
    EXPECT_THAT(refusal(entry("Angle 6\nAxiom F\nF=FF--F-F-F")), testing::HasSubstr(closed));
    EXPECT_THAT(refusal(entry("Angle 7\nAxiom F\nF=F+F+F+F+F+F+F")), testing::HasSubstr(closed));
    EXPECT_THAT(refusal(entry("Axiom F\nF=F\\51.2F/51.2F\\180FF\\51.2F")),
                testing::HasSubstr(closed));
    EXPECT_THAT(refusal(entry("Angle 2\nAxiom F\nF=@.6F@I.6+@.36F@I.6F@Q.36-")),
                testing::HasSubstr("no exact linear fractal"));
}

// A dragon of unequal legs whose longer one waits for the shorter: every edge is one step long at
// every level, as far as the decimals stand for a cosine and a sine. What they are off by begins
// another growth, of 1.09 a level, that no level which anyone draws would show.
TEST(Lsystem, what_decimals_are_off_by_is_no_growth) {
    EXPECT_THAT(refusal(entry("Angle 12\nAxiom x\nx=\\66@.40674da@i.40674/90@.91355dy@i.91355\\24\n"
                              "y=/24@.91355dx@i.91355\\90@.40674dp@i.40674/66\n"
                              "a=db\nb=de\ne=dh\nh=dj\nj=dk\nk=dl\nl=dn\nn=dx\n"
                              "p=dq\nq=dr\nr=ds\ns=dt\nt=du\nu=dv\nv=dw\nw=dy\nd=")),
                testing::HasSubstr("only by what the decimals"));
}

TEST(Lsystem, a_stroke_that_only_grows_with_the_drawing_stays_a_segment) {
    const EdgeSystem itself =
        system_of(entry("Angle 8\nAxiom x\nx=F[+y]Fx\ny=F[-y]F\nF=@1.25F@i1.25"));
    const EdgeSystem by_another =
        system_of(entry("Angle 8\nAxiom x\nx=F[+y]Fx\ny=F[-y]F\nF=@1.25D@i1.25\nD=@1.25F@i1.25"));
    for (const EdgeSystem& system : {itself, by_another}) {
        int segments = 0;
        for (std::size_t k = 0; k < system.kinds.size(); ++k) {
            const std::vector<EdgeMap>& maps = system.kinds[k].maps;
            if (system.kinds[k].name[0] == 'X' || system.kinds[k].name[0] == 'Y') continue;
            ++segments;
            ASSERT_EQ(maps.size(), 2U);
            EXPECT_EQ(maps[0].inside, static_cast<int>(k));
            EXPECT_NEAR(std::abs(maps[1].map.linear - 0.5), 0, 1e-15);
        }
        EXPECT_GT(segments, 0);
        EXPECT_NEAR(system.growth.real(), 1.25, 1e-12);
    }
}

TEST(Lsystem, a_start_that_nothing_comes_after_is_measured_by_an_edge_that_grows) {
    const EdgeSystem system = system_of(entry("Angle 4\nAxiom p\np=fx\nx=x+y\ny=x-yf"));
    EXPECT_NEAR(std::abs(system.growth), std::sqrt(2.0), 1e-12);
    for (const EdgeKind& kind : system.kinds)
        for (const EdgeMap& map : kind.maps) EXPECT_LT(std::abs(map.map.offset), 10);
}

TEST(Lsystem, long_rules_are_taken_or_refused_in_time) {
    std::string rule = "F";
    for (int i = 0; i < 4'000; ++i) rule += "+F-F";
    const EdgeSystem system = system_of(entry("Angle 4\nAxiom F\nF=" + rule));
    EXPECT_EQ(lsystem_maps(system).maps.size(), 8'001U);
    EXPECT_TRUE(lsystem_maps(system).follow.empty());
    const std::string longer = rule + rule + rule;
    EXPECT_THAT(refusal(entry("Angle 4\nAxiom F\nF=G" + longer + "\nG=" + longer)),
                testing::HasSubstr("more than 65536 commands"));
}

}  // namespace
}  // namespace pxm::host
