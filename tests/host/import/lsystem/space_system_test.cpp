// L-systems of a turtle in space: what their systems are, held against a turtle that walks.
#include "host/import/lsystem/space_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "host/error.hpp"
#include "host/import/import.hpp"
#include "host/scene/scene.hpp"

namespace pxm::host {
namespace {

using Points = std::vector<glm::dvec3>;

constexpr double golden = 1.6180339887498949;

std::string entry(const std::string& body) { return "t (3D) {\n" + body + "\n}\n"; }

Imported imported(const std::string& body) {
    return import_fractint({"t.l", entry(body)}, FractintFormat::l, std::nullopt);
}

std::string refusal(const std::string& body) {
    try {
        (void)imported(body);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::scene);
        const std::string text = error.what();
        return text.substr(0, text.find('\n'));
    }
    return "";
}

/// A word as the rules make it, level by level.
std::string word(std::string text, const std::function<std::string(char)>& rule, int levels) {
    for (int level = 0; level < levels; ++level) {
        std::string next;
        for (const char c : text) next += rule(c);
        text = next;
    }
    return text;
}

/// Where a turtle in a scene's space begins its strokes, and where it ends: up is y, its left is
/// -x, above it is -z.
Points walked(const std::string& text, double degrees, double step) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    glm::dvec3 place{0.0}, h{0, 1, 0}, l{-1, 0, 0}, u{0, 0, -1};
    Points points{place};
    const auto turn = [&](glm::dvec3& a, glm::dvec3& b, double sine) {
        const glm::dvec3 before = a;  // towards b
        a = c * a + sine * b;
        b = c * b - sine * before;
    };
    for (const char command : text) {
        if (command == 'F') {
            place += step * h;
            points.push_back(place);
        }
        if (command == '+') turn(h, l, s);
        if (command == '-') turn(h, l, -s);
        if (command == '&') turn(h, u, -s);
        if (command == '^') turn(h, u, s);
        if (command == '\\') turn(l, u, s);
        if (command == '/') turn(l, u, -s);
        if (command == '|') h = -h, l = -l;
    }
    return points;
}

/// Where the edges of so many levels begin.
void add_begins(const std::vector<MapBlock>& maps, int levels, const Affine& at, Points& points) {
    if (levels == 0) {
        points.push_back(at.translation);
        return;
    }
    for (const MapBlock& map : maps)
        add_begins(maps, levels - 1, then(compose(map.commands), at), points);
}

TEST(SpaceLsystem, edges_stand_where_a_turtle_draws_them) {
    const std::string generator = "F&F^^F&F+F--F+F/\\F";
    const Scene scene = imported("Degrees 60\nAxiom F\nF=" + generator).scene;
    ASSERT_EQ(scene.ifs.size(), 1U);
    ASSERT_EQ(scene.ifs[0].maps.size(), 8U);
    for (const MapBlock& map : scene.ifs[0].maps)
        EXPECT_NEAR(glm::length(compose(map.commands).linear[0]), 1 / 6.0, 1e-14);
    const std::string text = word(
        "F", [&](char c) { return c == 'F' ? generator : std::string(1, c); }, 3);
    const Points drawn = walked(text, 60, 1 / 216.0);
    Points begins;
    add_begins(scene.ifs[0].maps, 3, {}, begins);
    ASSERT_EQ(begins.size() + 1, drawn.size());
    for (std::size_t i = 0; i < begins.size(); ++i)
        EXPECT_LT(glm::distance(begins[i], drawn[i]), 1e-12) << i;
}

TEST(SpaceLsystem, turns_are_those_of_the_turtle) {
    for (const std::string turns : {"+", "-", "&", "^", "\\", "/", "+&", "&\\+", "/^-|", "|&"}) {
        const std::string generator = "F[" + turns + "F]F";
        const Scene scene = imported("Degrees 37.25\nAxiom F\nF=" + generator).scene;
        const Affine map = compose(scene.ifs[0].maps.at(1).commands);
        const Points drawn = walked("F" + turns + "F", 37.25, 0.5);
        EXPECT_LT(glm::distance(map.translation, drawn[1]), 1e-12) << turns;
        EXPECT_LT(glm::distance(map.point({0, 1, 0}), drawn[2]), 1e-12) << turns;
        // The turn about the stroke shows in what is to the left of it.
        const Points rolled = walked("F" + turns + "+F", 37.25, 0.5);
        const Points plain = walked("+F", 37.25, 1);
        EXPECT_LT(glm::distance(map.point(plain[1]), rolled[2]), 1e-12) << turns;
    }
}

TEST(SpaceLsystem, degrees_in_parentheses_are_taken_as_written) {
    const Scene scene = imported("Axiom F\nF=F[&(30)F][^(-30)F]F").scene;
    const Affine a = compose(scene.ifs[0].maps.at(1).commands);
    const Affine b = compose(scene.ifs[0].maps.at(2).commands);
    EXPECT_LT(glm::distance(a.linear[1], b.linear[1]), 1e-14);
    EXPECT_NEAR(a.linear[1].y, std::sqrt(3.0) / 4, 1e-14);
    EXPECT_NEAR(a.linear[1].z, 0.25, 1e-14) << "down is away from the viewer";
}

TEST(SpaceLsystem, the_hilbert_curve_fills_a_cube) {
    const Scene scene = imported(
                            "Degrees 90\nAxiom A\n"
                            "A=B-F+CFC+F-D&F^D-F+&&CFC+F+B//\n"
                            "B=A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//\n"
                            "C=|D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//\n"
                            "D=|CFB-F+B|FA&F^A&&FB-F+B|FC//\n")
                            .scene;
    ASSERT_EQ(scene.ifs.size(), 1U);
    const IfsBlock& block = scene.ifs[0];
    std::map<std::string, Affine> maps;
    for (const MapBlock& map : block.maps) maps[map.name] = compose(map.commands);
    // Eight halves inside each map: the volume stays the same.
    Points points;
    std::function<void(const std::vector<MapReference>&, int, const Affine&)> walk =
        [&](const std::vector<MapReference>& names, int levels, const Affine& at) {
            if (levels == 0) return points.push_back(at.translation);
            EXPECT_EQ(names.size(), 8U);
            for (const MapReference& name : names) {
                const std::string& map = std::get<std::string>(name.map);
                const auto rule = std::ranges::find_if(block.follow, [&](const FollowRule& follow) {
                    return std::get<std::string>(follow.map.map) == map;
                });
                ASSERT_NE(rule, block.follow.end());
                EXPECT_NEAR(glm::length(maps[map].linear[0]), 0.5, 1e-14);
                walk(rule->followers, levels - 1, then(maps[map], at));
            }
        };
    walk(block.start, 4, {});
    ASSERT_EQ(points.size(), 4096U);
    // They are the corners of 4096 cubes, each once, in a cube.
    glm::dvec3 low = points[0], high = points[0];
    for (const glm::dvec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
    const glm::dvec3 size = high - low;
    EXPECT_NEAR(size.x, size.y, 0.15 * size.x);
    EXPECT_NEAR(size.x, size.z, 0.15 * size.x);
}

TEST(SpaceLsystem, a_bush_grows_by_the_golden_section) {
    const Imported bush = imported(
        "Degrees 22.5\nAxiom A\n"
        "A=[&FL!A]/////'[&FL!A]///////'[&FL!A]\n"
        "F=S/////F\nS=FL\n");
    EXPECT_NE(bush.text.find("lengths grow by 1.61803 a level"), std::string::npos)
        << bush.text.substr(0, 300);
    int branches = 0;
    for (const MapBlock& map : bush.scene.ifs.at(0).maps)
        if (std::abs(glm::length(compose(map.commands).linear[0]) - 1 / golden) < 1e-12) ++branches;
    EXPECT_GT(branches, 3 * 24);
}

TEST(SpaceLsystem, what_has_no_exact_system_is_refused) {
    const std::string none = "t.l:1:1: error: L-system \"t\" has no exact linear fractal: ";
    EXPECT_EQ(refusal("Degrees 90\nAxiom F\nF=F&F&F&F"),
              none + "its edges are replaced by paths that end where they begin, or vanish");
    EXPECT_EQ(refusal("Degrees 20\nAxiom F\nF=F+F&F"),
              none +
                  "what comes after its symbols turns, or changes its step, differently at every "
                  "level (tried periods up to 24 levels)");
    EXPECT_EQ(refusal("Degrees 20\nAxiom F\nF=F[+F]F$F"),
              "t.l:4:9: error: '$' turns the turtle to the horizon, wherever it is: such an "
              "L-system has no exact linear fractal");
    EXPECT_EQ(refusal("Degrees 20\nAxiom F\nF=F%F"),
              "t.l:4:4: error: '%' cuts off what comes after it: such an L-system has no exact "
              "linear fractal");
    EXPECT_EQ(refusal("Degrees 20\nAxiom F\nF=F(2)F"),
              "t.l:4:4: error: parameters: only turns take a number in parentheses");
    EXPECT_EQ(refusal("Degrees 20\nAxiom F\nF=F+(20F"),
              "t.l:4:4: error: '+(' needs a number of degrees and ')'");
    EXPECT_EQ(refusal("Degrees 20\nAxiom F\nF=FF\n&=F"),
              "t.l:5:1: error: '&' moves the turtle: a rule cannot replace it");
    EXPECT_EQ(refusal("Degrees 400\nAxiom F\nF=FF"),
              "t.l:2:9: error: 'Degrees' takes a number above 0 and up to 360, not '400'");
    EXPECT_EQ(refusal("Axiom F\nF=F+F"),
              "t.l:3:4: error: a turn, but the entry has neither 'Degrees' nor 'Angle'");
}

}  // namespace
}  // namespace pxm::host
