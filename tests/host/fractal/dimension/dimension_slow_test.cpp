// Dimensions against closed forms of the literature (docs/references.md), and their laws.
#include "host/fractal/dimension/dimension.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/fractal/dimension/similarity.hpp"
#include "host/fractal/system/graph_facts.hpp"
#include "host/fractal/system/word_sums.hpp"
#include "host/math/lipschitz.hpp"
#include "tests/host/fractal/systems.hpp"

namespace pxm::host {
namespace {

using systems::complete;
using systems::homotheties;
using systems::map;
using systems::with_graph;

double similarity(const Rifs& rifs) { return similarity_dimension(rifs).value().middle(); }

Rifs equal_maps(double ratio, int count) {
    return complete(homotheties(ratio, std::vector<glm::dvec3>(count, glm::dvec3{0.0})));
}

struct Known {
    const char* name;
    Rifs rifs;
    double dimension;
};

std::vector<Known> known_dimensions() {
    const double phi = std::numbers::phi;
    const auto log_ratio = [](double n, double r) { return std::log(n) / std::log(r); };
    const auto turned = [](double ratio, double first, double second) {
        return complete(
            {map({scaling(glm::dvec3{ratio}), rotation(Axis::z, first)}),
             map({scaling(glm::dvec3{ratio}), rotation(Axis::z, second), translation({1, 0, 0})})});
    };
    const double root = std::sqrt(0.5);
    return {
        {"tetra (Sec. 5.4)", systems::tetra(), 2},
        {"octo (Sec. 5.4)", systems::octo(), log_ratio(6, 2)},
        {"Menger sponge [Mandelbrot82]", systems::menger(1.0 / 3, 0.385), log_ratio(20, 3)},
        {"Menger as printed (Erratum 12)", systems::menger(), std::log(20) / -std::log(0.333)},
        {"3-D pound sign (Sec. 4.6)", systems::pound_sign(), log_ratio(7, 2)},
        {"Cantor set [Falconer90]", equal_maps(1.0 / 3, 2), log_ratio(2, 3)},
        {"Cantor dust in the plane, a product [Falconer90]", equal_maps(1.0 / 3, 4),
         2 * log_ratio(2, 3)},
        {"Cantor dust in space, a product [Falconer90]", equal_maps(1.0 / 3, 8),
         3 * log_ratio(2, 3)},
        {"Sierpinski gasket [Falconer90]", equal_maps(0.5, 3), log_ratio(3, 2)},
        {"Sierpinski carpet [Mandelbrot82]", equal_maps(1.0 / 3, 8), log_ratio(8, 3)},
        {"von Koch curve [Falconer90]", equal_maps(1.0 / 3, 4), log_ratio(4, 3)},
        {"quadratic Koch curve [Mandelbrot82]", equal_maps(0.25, 8), 1.5},
        {"Vicsek cross [Vicsek83]", equal_maps(1.0 / 3, 5), log_ratio(5, 3)},
        {"Durer's pentagons [Mandelbrot82]", equal_maps(1 / (phi * phi), 5),
         log_ratio(5, phi * phi)},
        {"Levy dragon [Mandelbrot82]", turned(root, 45, -45), 2},
        {"Heighway dragon [Mandelbrot82]", turned(root, 45, 135), 2},
        {"twindragon (Sec. 5.6.4, Erratum 9)", turned(root, 45, 45), 2},
        {"ratios 1/2 and 1/4: x + x^2 = 1 [Falconer90]",
         complete({scaling(glm::dvec3{0.5}), scaling(glm::dvec3{0.25})}), log_ratio(phi, 2)},
        {"golden mean graph [LM95] [MW88]",
         with_graph({scaling(glm::dvec3{0.5}), scaling(glm::dvec3{0.5})}, {{0, 1}, {0}}),
         log_ratio(phi, 2)},
        {"2-D pound sign (Sec. 4.6)",
         with_graph(homotheties(0.5, std::vector<glm::dvec3>(4, glm::dvec3{0.0})),
                    {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}),
         log_ratio(3, 2)},
        {"a single map", equal_maps(0.7, 1), 0},
        {"a cycle of maps without a choice",
         with_graph(homotheties(0.5, {{0, 0, 0}, {1, 0, 0}}), {{1}, {0}}), 0},
    };
}

TEST(Dimension, known_similarity_dimensions_are_met) {
    for (const Known& known : known_dimensions()) {
        EXPECT_NEAR(similarity(known.rifs), known.dimension, 1e-9) << known.name;
    }
}

TEST(Dimension, affinity_equals_similarity_for_similitudes) {
    for (const Known& known : known_dimensions()) {
        const Affinity affinity = affinity_dimension(known.rifs);
        EXPECT_TRUE(affinity.exact) << known.name;
        EXPECT_NEAR(affinity.value, known.dimension, 1e-9) << known.name;
        EXPECT_GE(affinity.upper, known.dimension) << known.name;
    }
}

/// Of n columns and m < n rows, the rectangles (column, row) are kept.
Rifs carpet(int n, int m, const std::vector<std::pair<int, int>>& kept) {
    std::vector<Affine> maps;
    for (const auto& [column, row] : kept) {
        maps.push_back(map({scaling({1.0 / n, 1.0 / m, 0}),
                            translation({double(column) / n, double(row) / m, 0})}));
    }
    return complete(maps);
}

TEST(Dimension, affinity_of_a_carpet_is_the_diagonal_formula_and_may_exceed_its_box_dimension) {
    // [BM84]: all rows used, so the box dimension is the affinity dimension, 1 + log(3/2)/log 3.
    const Affinity full = affinity_dimension(carpet(3, 2, {{0, 0}, {2, 0}, {1, 1}}));
    EXPECT_TRUE(full.exact);
    EXPECT_NEAR(full.value, 1 + std::log(1.5) / std::log(3), 1e-9);
    // Two of three rows: box dimension log 2/log 3 + log(4/2)/log 4 = 1.1309, affinity 1.2075.
    const Rifs rifs = carpet(4, 3, {{0, 0}, {2, 0}, {1, 2}, {3, 2}});
    EXPECT_NEAR(affinity_dimension(rifs).value, 1 + std::log(4.0 / 3) / std::log(4), 1e-9);
    const BoxCounting boxes = count_boxes(rifs, bound(rifs, prove_contraction(rifs)));
    EXPECT_NEAR(boxes.dimension.value(), 1.1309, 2 * boxes.error);
}

TEST(Dimension, the_graph_of_the_cantor_function_has_dimension_1) {
    const double third = 1.0 / 3;  // Ex. 5.3
    const Rifs rifs =
        complete({scaling({third, 0.5, third}),
                  map({scaling({third, 0, third}), translation({third, 0.5, 0})}),
                  map({scaling({third, 0.5, third}), translation({2 * third, 0.5, 0})})});
    const Affinity found = affinity_dimension(rifs);
    EXPECT_TRUE(found.exact);
    EXPECT_NEAR(found.value, 1, 1e-9);
}

TEST(Dimension, triangular_systems_are_exact_by_their_diagonals) {
    const Affine a{{{0.5, 0, 0}, {0.2, 0.3, 0}, {0.1, -0.1, 0.2}}, {0, 0, 0}};
    const Affine b{{{0.4, 0, 0}, {-0.3, 0.6, 0}, {0.2, 0.3, 0.1}}, {1, 0, 0}};
    const Affinity sheared = affinity_dimension(complete({a, b}));
    const Affinity diagonal =
        affinity_dimension(complete({scaling({0.5, 0.3, 0.2}), scaling({0.4, 0.6, 0.1})}));
    EXPECT_TRUE(sheared.exact);  // [FM07]
    EXPECT_DOUBLE_EQ(sheared.value, diagonal.value);
}

/// The same system in other coordinates.
Rifs conjugated(const Rifs& rifs, const Affine& change) {
    Rifs result = rifs;
    for (Affine& m : result.maps) m = then(then(inverse(change), m), change);
    return result;
}

TEST(Dimension, estimate_and_upper_bound_meet_the_exact_value_in_other_coordinates) {
    const Rifs rifs =
        complete({scaling({0.5, 0.3, 0.1}), scaling({0.2, 0.6, 0.3}), scaling({0.4, 0.1, 0.35})});
    const double exact = affinity_dimension(rifs).value;
    const Affine turn = map({rotation(Axis::x, 30), rotation(Axis::y, 50)});
    const Affinity turned = affinity_dimension(conjugated(rifs, turn));
    EXPECT_FALSE(turned.exact);
    EXPECT_NEAR(turned.value, exact, 0.02);
    EXPECT_GE(turned.upper, exact);
    EXPECT_LE(turned.upper, exact + 0.3);
    const Affine shear{{{1, 0.5, 0}, {0.3, 1, 0.2}, {0, 0.4, 1}}, {0, 0, 0}};
    const Affinity sheared = affinity_dimension(conjugated(rifs, shear));
    EXPECT_NEAR(sheared.value, exact, 0.05);
    EXPECT_GE(sheared.upper, exact);
}

TEST(Dimension, singular_value_function_takes_the_largest_first) {  // Erratum 7
    const LogStretch stretch = log_stretch(scaling({0.25, 0.5, 0.125}));
    const auto phi = [&](double d) { return std::exp(log_singular_value_function(stretch, d)); };
    EXPECT_NEAR(phi(1), 0.5, 1e-12);
    EXPECT_NEAR(phi(1.5), 0.5 * 0.5, 1e-12);
    EXPECT_NEAR(phi(2), 0.125, 1e-12);
    EXPECT_NEAR(phi(3), 1.0 / 64, 1e-12);
    EXPECT_NEAR(phi(6), 1.0 / 4096, 1e-12);
}

Affine random_similitude(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    return map({rotation(Axis::x, 180 * unit(random)), rotation(Axis::y, 180 * unit(random)),
                scaling(glm::dvec3{0.5 + 0.45 * unit(random)}),
                translation({unit(random), unit(random), unit(random)})});
}

TEST(Dimension, adding_a_map_never_lowers_the_similarity_dimension) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        std::mt19937_64 random(seed);
        std::vector<Affine> maps{random_similitude(random)};
        double before = 0;
        for (int n = 0; n < 8; ++n) {
            const double now = similarity(complete(maps));
            EXPECT_GE(now, before - 1e-12) << "seed " << seed;
            before = now;
            maps.push_back(random_similitude(random));
        }
    }
}

TEST(Dimension, the_estimate_is_never_above_the_upper_bound) {
    for (unsigned seed = 0; seed < 4; ++seed) {
        const Affinity found =
            affinity_dimension(reachable_part(systems::random_system(seed, 0.7)));
        EXPECT_LE(found.value, found.upper) << "seed " << seed;
        EXPECT_GE(found.value, 0) << "seed " << seed;
    }
}

}  // namespace
}  // namespace pxm::host
