#include "tests/support/held_out_systems.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>

#include "tests/support/figures.hpp"

namespace pxm::host::systems {

namespace {

using std::log;

/// Numbers that are the same with every standard library.
class Draw {
  public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  private:
    std::mt19937_64 random_;
};

struct Disk {
    glm::dvec3 center{0.0};
    double radius = 0;
};

/// Balls inside the unit ball of the first `dimension` axes that keep apart: similitudes that take
/// the unit ball to them have its inside as an open set.
std::vector<Disk> separate_balls(Draw& draw, int dimension, int count) {
    std::vector<Disk> balls;
    // The largest radius that is tried falls until there is room.
    for (double largest = 0.6; static_cast<int>(balls.size()) < count; largest *= 0.99) {
        Disk ball;
        for (int i = 0; i < dimension; ++i) ball.center[i] = draw.between(-1, 1);
        ball.radius = draw.between(0.13 * largest, largest);
        const auto meets = [&](const Disk& other) {
            return glm::distance(ball.center, other.center) < ball.radius + other.radius;
        };
        if (glm::length(ball.center) + ball.radius > 1) continue;
        if (std::ranges::any_of(balls, meets)) continue;
        balls.push_back(ball);
    }
    return balls;
}

KnownSystem separate_copies(int dimension, std::uint64_t seed) {
    Draw draw(seed);
    std::vector<Affine> maps;
    std::vector<double> ratios;
    for (const Disk& ball : separate_balls(draw, dimension, 2 + draw.below(5))) {
        std::vector<Affine> turns{scaling(glm::dvec3{ball.radius})};
        if (dimension == 1 && draw.below(2) == 0) turns.push_back(rotation(Axis::z, 180));
        if (dimension > 1) turns.push_back(rotation(Axis::z, draw.between(-180, 180)));
        if (dimension > 2) turns.push_back(rotation(Axis::x, draw.between(-180, 180)));
        turns.push_back(translation(ball.center));
        Affine all;
        for (const Affine& turn : turns) all = then(all, turn);
        maps.push_back(all);
        ratios.push_back(ball.radius);
    }
    return {"copies apart in " + std::to_string(dimension) + "-D, " + std::to_string(seed),
            complete(maps), moran(ratios)};
}

/// Some cells of a grid, each with the whole turned into it by quarters and mirrored.
KnownSystem turned_cells(int dimension, std::uint64_t seed) {
    Draw draw(seed);
    const int n = 2 + draw.below(dimension == 2 ? 5 : 3);
    std::vector<Affine> maps;
    const glm::dvec3 middle{0.5, 0.5, dimension == 2 ? 0.0 : 0.5};
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (int k = 0; k < (dimension == 2 ? 1 : n); ++k) {
                if (draw.below(3) == 0) continue;
                std::vector<Affine> steps{translation(-middle),
                                          rotation(Axis::z, 90 * draw.below(4))};
                if (dimension == 3) steps.push_back(rotation(Axis::x, 90 * draw.below(4)));
                if (draw.below(2) == 0) steps.push_back(scaling({-1, 1, 1}));
                steps.push_back(translation(middle));
                steps.push_back(scaling(glm::dvec3{1.0 / n}));
                steps.push_back(translation(glm::dvec3{i, j, k} / double(n)));
                Affine all;
                for (const Affine& step : steps) all = then(all, step);
                maps.push_back(all);
            }
        }
    }
    const double dim = log(static_cast<double>(maps.size())) / log(n);
    return {"turned cells of " + std::to_string(n) + ", " + std::to_string(seed), complete(maps),
            dim};
}

/// Rectangles of n columns and m < n rows, of which some are kept [BM84].
KnownSystem any_carpet(std::uint64_t seed) {
    Draw draw(seed);
    const int m = 2 + draw.below(3);
    const int n = m + 1 + draw.below(4);
    std::vector<std::pair<int, int>> kept;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) {
            if (draw.below(5) < 3) kept.emplace_back(i, j);
        }
    }
    if (kept.size() < 2) kept = {{0, 0}, {n - 1, m - 1}};
    return carpet(
        "carpet of " + std::to_string(n) + " by " + std::to_string(m) + ", " + std::to_string(seed),
        n, m, kept);
}

/// Rows of any heights, in each some rectangles less wide than high: with s the dimension of the
/// heights, the d with sum height^s width^(d - s) = 1 [LG92].
KnownSystem uneven_carpet(std::uint64_t seed) {
    Draw draw(seed);
    std::vector<Affine> maps;
    std::vector<double> heights;
    std::vector<glm::dvec2> sides;
    double y = 0;
    const int rows = 2 + draw.below(2);
    for (int row = 0; row < rows; ++row) {
        const double height = draw.between(0.6, 1) / rows;
        heights.push_back(height);
        double x = 0;
        for (;;) {
            const double width = draw.between(0.1, 0.8) * height;
            if (x + width > 1 || (x > 0 && draw.below(3) == 0)) break;
            maps.push_back(map({scaling({width, height, 0}), translation({x, y, 0})}));
            sides.emplace_back(width, height);
            x += width + draw.between(0, 0.2);
        }
        y += height;
    }
    const double s = moran(heights);
    double low = s;
    double high = 2;
    for (int n = 0; n < 100; ++n) {
        const double d = (low + high) / 2;
        double sum = 0;
        for (const auto& side : sides) sum += std::pow(side.y, s) * std::pow(side.x, d - s);
        (sum > 1 ? low : high) = d;
    }
    return {"uneven carpet, " + std::to_string(seed), complete(maps), low};
}

/// Blocks of l < m < n parts along the axes: the numbers of different projections on the first
/// axes, over the logarithms of the parts [KP96].
KnownSystem any_sponge(std::uint64_t seed) {
    Draw draw(seed);
    const std::array<int, 3> parts{2 + draw.below(2), 4, 5 + draw.below(2)};
    std::vector<Affine> maps;
    std::set<int> on_one;
    std::set<std::pair<int, int>> on_two;
    for (int i = 0; i < parts[0]; ++i) {
        for (int j = 0; j < parts[1]; ++j) {
            for (int k = 0; k < parts[2]; ++k) {
                if (draw.below(4) != 0) continue;
                const glm::dvec3 sides{1.0 / parts[0], 1.0 / parts[1], 1.0 / parts[2]};
                maps.push_back(map({scaling(sides), translation(glm::dvec3{i, j, k} * sides)}));
                on_one.insert(i);
                on_two.insert({i, j});
            }
        }
    }
    const double one = static_cast<double>(on_one.size());
    const double two = static_cast<double>(on_two.size());
    const double all = static_cast<double>(maps.size());
    return {
        "sponge, " + std::to_string(seed), complete(maps),
        log(one) / log(parts[0]) + log(two / one) / log(parts[1]) + log(all / two) / log(parts[2])};
}

/// The end parts of a segment with these ratios.
struct Cantor {
    double ratio = 0;
    [[nodiscard]] double dimension() const { return log(2) / -log(ratio); }
};

KnownSystem product(const std::string& name, const std::vector<Cantor>& factors) {
    std::vector<Affine> maps;
    double dimension = 0;
    for (const Cantor& factor : factors) dimension += factor.dimension();
    const int corners = 1 << factors.size();
    for (int corner = 0; corner < corners; ++corner) {
        glm::dvec3 sides{0.0};
        glm::dvec3 place{0.0};
        for (std::size_t i = 0; i < factors.size(); ++i) {
            sides[static_cast<int>(i)] = factors[i].ratio;
            if ((corner >> i & 1) != 0) place[static_cast<int>(i)] = 1 - factors[i].ratio;
        }
        maps.push_back(map({scaling(sides), translation(place)}));
    }
    return {name, complete(maps), dimension};
}

/// A Koch curve with other edges: base parts a, and two edges to a tip at height h. The triangle
/// over the base is an open set if the edges rise by at least twice its angle.
KnownSystem any_koch(std::uint64_t seed) {
    Draw draw(seed);
    const double h = draw.between(0.08, 0.28);
    const double angle = std::atan(2 * h);
    const double rise =
        draw.between(2 * angle, std::min(std::numbers::pi / 2, std::numbers::pi - 2 * angle));
    const double a = 0.5 - h / std::tan(rise);
    const Complex tip{0.5, h};
    const double b = std::abs(tip - a);
    return {"Koch curve, " + std::to_string(seed), path({0, a, tip, 1 - a, 1}),
            moran({a, b, b, a})};
}

/// The largest ratio at which copies towards the corners of a polygon only touch.
double polygon_ratio(int n) {
    double sum = 0;
    for (int k = 0; 4 * k <= n; ++k) sum += std::cos(2 * std::numbers::pi * k / n);
    return 1 / (2 * sum);
}

/// Cubes in the corners and smaller ones between them.
void add_jerusalem(std::vector<KnownSystem>& known) {
    const double k = std::sqrt(2) - 1;
    std::vector<Affine> cross;
    std::vector<Affine> cube;
    for (const double x : {-1, 1}) {
        for (const double y : {-1, 1}) {
            cross.push_back(
                map({scaling(glm::dvec3{k}), translation(glm::dvec3{x, y, 0} * (1 - k))}));
            for (const double z : {-1, 1}) {
                cube.push_back(
                    map({scaling(glm::dvec3{k}), translation(glm::dvec3{x, y, z} * (1 - k))}));
            }
        }
        for (int axis = 0; axis < 2; ++axis) {
            glm::dvec3 side{0.0};
            side[axis] = x * (1 - k * k);
            cross.push_back(map({scaling(glm::dvec3{k * k}), translation(side)}));
        }
        for (int axis = 0; axis < 3; ++axis) {
            for (const double y : {-1, 1}) {
                glm::dvec3 edge{0.0};
                edge[(axis + 1) % 3] = x * (1 - k * k);
                edge[(axis + 2) % 3] = y * (1 - k * k);
                cube.push_back(map({scaling(glm::dvec3{k * k}), translation(edge)}));
            }
        }
    }
    known.push_back(
        {"Jerusalem cross", complete(cross), moran({k, k, k, k, k * k, k * k, k * k, k * k})});
    std::vector<double> ratios(8, k);
    ratios.insert(ratios.end(), 12, k * k);
    known.push_back({"Jerusalem cube", complete(cube), moran(ratios)});
}

void add_classics(std::vector<KnownSystem>& known) {
    for (const int n : {7, 8, 9, 10, 12}) {
        const double ratio = polygon_ratio(n);
        known.push_back({"figure of " + std::to_string(n) + " corners", towards(ratio, polygon(n)),
                         log(n) / -log(ratio)});
    }
    for (const int angle : {20, 45, 70}) {
        const double radians = angle * std::numbers::pi / 180;
        const double edge = 1 / (2 + 2 * std::cos(radians));
        known.push_back({"Cesaro's curve of " + std::to_string(angle) + " degrees",
                         path({0, edge, edge + std::polar(edge, radians), 1 - edge, 1}),
                         log(4) / -log(edge)});
    }
    add_jerusalem(known);
    known.push_back({"greater carpet", cells(5, [](int i, int j) { return i != 2 || j != 2; }),
                     log(24) / log(5)});
    known.push_back({"carpet with a hole of 2",
                     cells(4, [](int i, int j) { return i == 0 || i == 3 || j == 0 || j == 3; }),
                     log(12) / log(4)});
    known.push_back({"frames",
                     cells(5, [](int i, int j) { return i == 0 || i == 4 || j == 0 || j == 4; }),
                     log(16) / log(5)});
    known.push_back({"tetrix of 4", cells_3d(3, [](int i, int j, int l) { return i + j + l < 3; }),
                     log(10) / log(3)});
    known.push_back(
        {"odd digits in base 8", digits(8, [](int i) { return i % 2 == 1; }), log(4) / log(8)});
    known.push_back(
        {"no 9 in base 10", digits(10, [](int i) { return i != 9; }), log(9) / log(10)});
    const double third = 1.0 / 3;
    const Complex i{0, 1};
    known.push_back({"quadratic curve of 5 edges, both sides",
                     path({0, third, third - third * i, 2 * third - third * i, 2 * third, 1}),
                     log(5) / log(3)});
}

/// Digits of base n of which some may not follow others: the matrix's radius in place of how many
/// there are [MW88].
KnownSystem forbidden_pairs(int dimension, std::uint64_t seed) {
    Draw draw(seed);
    const int n = dimension == 1 ? 3 + draw.below(4) : 2 + draw.below(2);
    const int digits = dimension == 1 ? n : n * n;
    std::vector<glm::dvec3> corners;
    for (int digit = 0; digit < digits; ++digit) {
        corners.push_back(glm::dvec3{digit % n, digit / n, 0} / double(n));
    }
    std::vector<std::vector<int>> follow(corners.size());
    for (int a = 0; a < digits; ++a) {
        for (int b = 0; b < digits; ++b) {
            // One after the other always: so all of them recur.
            if (b == (a + 1) % digits || draw.below(2) == 0)
                follow[static_cast<std::size_t>(a)].push_back(b);
        }
    }
    std::vector<double> x(corners.size(), 1);
    double radius = 0;
    for (int round = 0; round < 2000; ++round) {
        std::vector<double> y(x.size(), 0);
        double sum = 0;
        for (std::size_t a = 0; a < x.size(); ++a) {
            for (const int b : follow[a]) y[a] += x[static_cast<std::size_t>(b)];
            sum += y[a];
        }
        double before = 0;
        for (const double value : x) before += value;
        radius = sum / before;
        for (std::size_t a = 0; a < x.size(); ++a) x[a] = (x[a] / before + y[a] / sum) / 2;
    }
    return {"digits with forbidden pairs in " + std::to_string(dimension) + "-D, " +
                std::to_string(seed),
            with_graph(homotheties(1.0 / n, corners), follow), log(radius) / log(n)};
}

/// Digits beyond the base, so that copies overlap and words agree. Sums of digits that differ are a
/// whole number apart, so only how many there are counts: their growth over the base's logarithm
/// [NW01].
KnownSystem overlapping_digits(int dimension, std::uint64_t seed) {
    Draw draw(seed);
    const int base = 3 + draw.below(dimension == 1 ? 4 : 2);
    const int count = 3 + draw.below(dimension == 1 ? base - 2 : 4);
    using Sum = std::pair<std::int64_t, std::int64_t>;
    std::set<Sum> digits{{0, 0}, {1, 0}, {base, 0}};  // the words (1, 0) and (0, base) agree
    while (static_cast<int>(digits.size()) < count) {
        digits.emplace(draw.below(2 * base), dimension == 1 ? 0 : draw.below(2 * base));
    }
    std::vector<glm::dvec3> places;
    for (const auto& [x, y] : digits) places.push_back(glm::dvec3{x, y, 0} / double(base));
    std::vector<double> sizes;
    std::set<Sum> sums{{0, 0}};
    constexpr std::size_t enough = 200'000;
    while (sums.size() < enough) {
        std::set<Sum> longer;
        for (const auto& [x, y] : sums) {
            for (const auto& [i, j] : digits) longer.emplace(base * x + i, base * y + j);
        }
        sums = std::move(longer);
        sizes.push_back(static_cast<double>(sums.size()));
    }
    const double growth = sizes.back() / sizes[sizes.size() - 2];
    return {"overlapping digits in " + std::to_string(dimension) + "-D, " + std::to_string(seed),
            complete(homotheties(1.0 / base, places)), log(growth) / log(base)};
}

}  // namespace

std::vector<KnownSystem> held_out_systems(std::uint64_t of_a_kind) {
    std::vector<KnownSystem> known;
    for (std::uint64_t seed = 0; seed < of_a_kind; ++seed) {
        for (const int dimension : {1, 2, 3}) known.push_back(separate_copies(dimension, seed));
        for (const int dimension : {2, 3}) known.push_back(turned_cells(dimension, seed));
        known.push_back(any_carpet(seed));
        known.push_back(uneven_carpet(seed));
        known.push_back(any_sponge(seed));
        known.push_back(any_koch(seed));
        for (const int dimension : {1, 2}) known.push_back(forbidden_pairs(dimension, seed));
        for (const int dimension : {1, 2}) known.push_back(overlapping_digits(dimension, seed));
    }
    known.push_back(product("product of 1/3 and 1/4", {{1.0 / 3}, {0.25}}));
    known.push_back(product("product of 0.45 and 0.2", {{0.45}, {0.2}}));
    known.push_back(product("product of 1/2 and 1/3", {{0.5}, {1.0 / 3}}));
    known.push_back(product("product of 1/2, 1/3 and 1/4", {{0.5}, {1.0 / 3}, {0.25}}));
    known.push_back(product("product of 0.4, 0.3 and 0.2", {{0.4}, {0.3}, {0.2}}));
    add_classics(known);
    return known;
}

}  // namespace pxm::host::systems
