// The systems of the thesis and random ones, built in code: Appendix B as printed.
#pragma once

#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "host/fractal/system/rifs.hpp"

namespace pxm::host::systems {

inline Affine map(std::initializer_list<Affine> commands) {
    Affine result;
    for (const Affine& command : commands) result = then(result, command);
    return result;
}

/// Any map may follow any other.
inline Rifs complete(const std::vector<Affine>& maps) {
    Rifs rifs;
    rifs.maps = maps;
    rifs.follow_sets.emplace_back();
    for (std::size_t m = 0; m < maps.size(); ++m) {
        rifs.map_names.push_back(std::to_string(m + 1));
        rifs.follow_sets[0].maps.push_back(static_cast<int>(m));
        rifs.follow_of.push_back(0);
    }
    return rifs;
}

/// Map m may be followed by follow[m]; every map may come first. Sets are not shared.
inline Rifs with_graph(const std::vector<Affine>& maps,
                       const std::vector<std::vector<int>>& follow) {
    Rifs rifs = complete(maps);
    for (std::size_t m = 0; m < maps.size(); ++m) {
        rifs.follow_of[m] = static_cast<int>(rifs.follow_sets.size());
        rifs.follow_sets.push_back({follow[m]});
    }
    return rifs;
}

/// Homotheties of one ratio.
inline std::vector<Affine> homotheties(double ratio, const std::vector<glm::dvec3>& offsets) {
    std::vector<Affine> maps;
    for (const glm::dvec3& offset : offsets) {
        maps.push_back(map({scaling(glm::dvec3{ratio}), translation(offset)}));
    }
    return maps;
}

inline Rifs tetra() {
    return complete(homotheties(
        0.5, {{0, 0.5, 0}, {0, -0.166, -0.472}, {0.409, -0.166, 0.236}, {-0.409, -0.166, 0.236}}));
}

inline Rifs octo() {
    return complete(homotheties(
        0.5, {{-0.5, 0, 0}, {0.5, 0, 0}, {0, 0, -0.5}, {0, 0, 0.5}, {0, 0.5, 0}, {0, -0.5, 0}}));
}

/// The 20 cubes of side `ratio` whose centres have at most one coordinate that is zero.
inline Rifs menger(double ratio = 0.333, double offset = 0.385) {
    std::vector<glm::dvec3> offsets;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if ((x == 0) + (y == 0) + (z == 0) > 1) continue;
                offsets.push_back(offset * glm::dvec3{x, y, z});
            }
        }
    }
    return complete(homotheties(ratio, offsets));
}

inline Rifs icos() {
    return complete(homotheties(0.5, {{0, 0.926, 0.263},
                                      {0, 0.926, -0.263},
                                      {0, 0.075, 0.263},
                                      {0, 0.075, -0.263},
                                      {0.263, 0.5, 0.425},
                                      {0.263, 0.5, -0.425},
                                      {-0.263, 0.5, 0.425},
                                      {-0.263, 0.5, -0.425},
                                      {0.425, 0.763, 0},
                                      {-0.425, 0.763, 0},
                                      {0.425, 0.237, 0},
                                      {-0.425, 0.237, 0}}));
}

inline Rifs dodec() {
    return complete(homotheties(
        0.382, {{-0.577, 0.618, -0.221}, {0.577, 0.618, -0.221},  {0.577, 0.618, 0.221},
                {-0.577, 0.618, 0.221},  {-0.357, 0.975, -0.357}, {0, 0.839, -0.577},
                {0.357, 0.975, -0.357},  {0.221, 1.195, 0},       {0.357, 0.975, 0.357},
                {0, 0.839, 0.577},       {-0.357, 0.975, 0.357},  {-0.221, 1.195, 0},
                {-0.357, 0.261, -0.357}, {0, 0.397, -0.577},      {0.357, 0.261, -0.357},
                {0.221, 0.041, 0},       {0.357, 0.261, 0.357},   {0, 0.397, 0.577},
                {-0.357, 0.261, 0.357},  {-0.221, 0.041, 0}}));
}

inline Rifs grass() {
    const Affine squash = map({scaling({0.707, 0.96, 0.707}), rotation(Axis::y, 45)});
    return complete(
        {then(squash, translation({-1, 0, 0})), then(squash, translation({1, 0, 0})),
         map({scaling({0.25, 0.01, 0.01}), rotation(Axis::z, 90), translation({0, 0.707, 0})})});
}

inline Rifs elm() {
    const auto branch = [](double turn, double ratio, Axis axis, double bend, double height) {
        return map({rotation(Axis::y, turn), scaling(glm::dvec3{ratio}), rotation(axis, bend),
                    translation({0, height, 0})});
    };
    const auto trunk = [](double turn, double width, double length, double height) {
        return map({rotation(Axis::y, turn), scaling({width, length, width}),
                    translation({0, height, 0})});
    };
    return complete({branch(90, 0.6, Axis::x, 40, 1), branch(75, 0.55, Axis::x, -50, 0.9),
                     branch(105, 0.5, Axis::z, 60, 0.95), branch(95, 0.45, Axis::z, -35, 0.8),
                     trunk(35, 0.055, 0.25, 0.2), trunk(175, 0.055, 0.25, 0.35),
                     trunk(50, 0.0525, 0.25, 0.5), trunk(255, 0.08, -0.25, 0.4),
                     trunk(145, 0.065, -0.25, 0.55), trunk(305, 0.0575, -0.25, 0.7),
                     trunk(210, 0.05, -0.25, 0.85)});
}

inline Rifs pine() {
    const auto branch = [](double bend, double turn) {
        return map({scaling({0.2, 0.7, 0.2}), rotation(Axis::z, bend), rotation(Axis::y, turn),
                    translation({0, 0.1, 0})});
    };
    return complete(
        {branch(96, 0), branch(90, 63), branch(93, 104), branch(97, 167), branch(95, 253),
         branch(100, 311),
         map({rotation(Axis::y, 31), scaling({0.82, 0.84, 0.82}), translation({0, 0.15, 0})})});
}

/// The 3-D pound sign (Fig. 4.4): the octants of a cube, no map twice in a row.
inline Rifs pound_sign() {
    std::vector<glm::dvec3> offsets;
    std::vector<std::vector<int>> follow;
    for (int i = 0; i < 8; ++i) {
        offsets.push_back({(i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5});
        std::vector<int>& others = follow.emplace_back();
        for (int j = 0; j < 8; ++j) {
            if (j != i) others.push_back(j);
        }
    }
    return with_graph(homotheties(0.5, offsets), follow);
}

struct NamedSystem {
    const char* name;
    Rifs rifs;
};

inline std::vector<NamedSystem> thesis_systems() {
    return {{"tetra", tetra()}, {"octo", octo()},   {"menger", menger()},
            {"icos", icos()},   {"dodec", dodec()}, {"elm", elm()},
            {"grass", grass()}, {"pine", pine()},   {"pound sign", pound_sign()}};
}

/// A random affine map: singular values up to `largest`, either orientation, offsets below 1.
inline Affine random_map(std::mt19937_64& random, double largest) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto turn = [&](Axis axis) { return rotation(axis, 180 * unit(random)); };
    return map({turn(Axis::x), turn(Axis::y), turn(Axis::z),
                scaling({largest * unit(random), largest * unit(random), largest}), turn(Axis::x),
                turn(Axis::y), turn(Axis::z),
                translation({unit(random), unit(random), unit(random)})});
}

/// Two to six maps; every third system has a random graph.
inline Rifs random_system(unsigned seed, double largest) {
    std::mt19937_64 random(seed);
    const int count = 2 + static_cast<int>(random() % 5);
    std::vector<Affine> maps;
    for (int i = 0; i < count; ++i) maps.push_back(random_map(random, largest));
    if (seed % 3 != 0) return complete(maps);
    std::vector<std::vector<int>> follow(count);
    for (std::vector<int>& of_map : follow) {
        for (int j = 0; j < count; ++j) {
            if (random() % 2 == 0) of_map.push_back(j);
        }
        if (of_map.empty()) of_map.push_back(static_cast<int>(random() % count));
    }
    return with_graph(maps, follow);
}

/// A point of E_set: a random word's image of a point that stands inside it, `depth` maps deep.
inline glm::dvec3 random_point(const Rifs& rifs, int set, int depth, std::mt19937_64& random) {
    std::vector<int> word;
    for (int i = 0; i < depth; ++i) {
        const std::vector<int>& maps = rifs.follow_sets[set].maps;
        word.push_back(maps[random() % maps.size()]);
        set = rifs.follow_of[word.back()];
    }
    glm::dvec3 point{0.0};
    for (auto m = word.rbegin(); m != word.rend(); ++m) point = rifs.maps[*m].point(point);
    return point;
}

}  // namespace pxm::host::systems
