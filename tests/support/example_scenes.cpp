#include "tests/support/example_scenes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

namespace pxm::test {

namespace {

using Point = std::array<double, 3>;

/// Maps with one ratio and the given fixed points.
std::string toward(const std::string& name, double ratio, const std::vector<Point>& corners) {
    std::string text = "ifs " + name + " {\n";
    for (const Point& p : corners) {
        const double rest = 1 - ratio;
        text += fmt::format("newmap scale: {} translate: {},{},{}\n", ratio, rest * p[0],
                            rest * p[1], rest * p[2]);
    }
    return text + "}\n";
}

std::vector<Point> tetrahedron() {
    const double s = std::sqrt(2.0);
    const double h = std::sqrt(2.0 / 3);
    return {{0, 1, 0}, {0, -1. / 3, -2 * s / 3}, {h, -1. / 3, s / 3}, {-h, -1. / 3, s / 3}};
}

std::vector<Point> octahedron() {
    return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

/// The corners and the middles of the edges of a cube.
std::vector<Point> sponge() {
    std::vector<Point> points;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if ((x == 0) + (y == 0) + (z == 0) < 2) {
                    points.push_back(
                        {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
                }
            }
        }
    }
    return points;
}

/// (0, +-1, +-a) and its cyclic permutations.
void add_rectangles(double a, double b, std::vector<Point>& points) {
    for (const double s : {-1., 1.}) {
        for (const double t : {-1., 1.}) {
            points.push_back({0, s * a, t * b});
            points.push_back({t * b, 0, s * a});
            points.push_back({s * a, t * b, 0});
        }
    }
}

std::vector<Point> icosahedron() {
    std::vector<Point> points;
    add_rectangles(1, 1 / std::numbers::phi, points);
    return points;
}

std::vector<Point> dodecahedron() {
    std::vector<Point> points;
    for (const double x : {-1., 1.}) {
        for (const double y : {-1., 1.}) {
            for (const double z : {-1., 1.}) points.push_back({x, y, z});
        }
    }
    add_rectangles(std::numbers::phi, 1 / std::numbers::phi, points);
    return points;
}

constexpr const char* asymmetric = R"(
ifs asymmetric {
    newmap a scale: 0.7 translate: 0,0.5,0 color: 1,0,0,0.5
    newmap b scale: 0.72 rotate: y,40 translate: -0.5,-0.2,0 color: 0,1,0,0.5
    newmap c scale: 0.68 rotate: x,-25 translate: 0.5,-0.3,0.2 color: 0,0,1,0.5
    newmap d scale: 0.55 translate: 0,0,0.7
    follow: a -> b,c   follow: b -> c,d   follow: c -> a,d   follow: d -> d,a,b
}
)";

constexpr const char* hierarchical = R"(
ifs hierarchical {
    newmap big1 scale: 0.55 translate: -1,0.2,0 color: 1,0.5,0,0.6
    newmap big2 scale: 0.6 rotate: z,30 translate: 0.9,0,0
    newmap small1 scale: 0.65 translate: 0,0.6,0 color: 0,0.5,1,0.6
    newmap small2 scale: 0.65,0.65,0.5 translate: 0,-0.6,0
    newmap small3 scale: 0.6 rotate: y,70 translate: 0.5,0,0.5
    follow: big1 -> big1,big2,small1,small2
    follow: big2 -> big1,small2,small3
    follow: small1 -> small1,small2,small3
    follow: small2 -> small1,small3
    follow: small3 -> small1,small2,small3
}
)";

constexpr const char* mirrored = R"(
ifs mirrored {
    newmap scale: -0.55,0.55,0.55 translate: 0.8,0,0.1 color: 1,0.8,0,0.4
    newmap scale: 0.5,-0.5,0.5 rotate: z,20 translate: -0.7,0.4,0
    newmap scale: -0.45,-0.45,-0.45 rotate: x,33 translate: 0,-0.8,0.5 color: 0.1,0.2,1,0.7
    newmap scale: 0.4,0.4,-0.4 translate: 0.1,0.9,-0.4
}
)";

constexpr const char* squashed = R"(
ifs squashed {
    newmap scale: 0.6,0.15,0.5 rotate: z,35 translate: 0.6,0.1,0 color: 0.9,0.4,0.1,0.5
    newmap scale: 0.2,0.6,0.4 rotate: y,50 translate: -0.6,0.2,0.1
    newmap scale: 0.5,0.5,0.1 rotate: x,70 translate: 0,-0.5,0.3 color: 0.1,0.9,0.3,0.3
    newmap matrix: 0.5,0.2,0, 0,0.4,0.1, -0.1,0,0.5, 0,0.6,-0.4
}
)";

constexpr const char* elm = R"(
ifs elm {
    newmap rotate: y,90 scale: 0.6 rotate: x,40 translate: 0,1,0 color: 0,1,0,0.05
    newmap rotate: y,75 scale: 0.55 rotate: x,-50 translate: 0,0.9,0 color: 0,0.9,0.2,0.05
    newmap rotate: y,105 scale: 0.5 rotate: z,60 translate: 0,0.95,0 color: 0.2,0.9,0,0.05
    newmap rotate: y,95 scale: 0.45 rotate: z,-35 translate: 0,0.8,0 color: 0.4,0.8,0.4,0.05
    newmap rotate: y,35 scale: 0.055,0.25,0.055 translate: 0,0.2,0 color: 0.4,0.3,0.1,1
    newmap rotate: y,175 scale: 0.055,0.25,0.055 translate: 0,0.35,0 color: 0.4,0.3,0.1,1
    newmap rotate: y,50 scale: 0.0525,0.25,0.0525 translate: 0,0.5,0 color: 0.4,0.3,0.1,1
    newmap rotate: y,255 scale: 0.08,-0.25,0.08 translate: 0,0.4,0 color: 0.4,0.3,0.1,1
    newmap rotate: y,145 scale: 0.065,-0.25,0.065 translate: 0,0.55,0 color: 0.4,0.3,0.1,1
    newmap rotate: y,305 scale: 0.0575,-0.25,0.0575 translate: 0,0.7,0 color: 0.4,0.3,0.1,1
    newmap rotate: y,210 scale: 0.05,-0.25,0.05 translate: 0,0.85,0 color: 0.4,0.3,0.1,1
}
)";

constexpr const char* bulging = R"(
ifs bulging {
    newmap matrix: 0.1,0.85,0, -0.6,0.1,0, 0,0,0.5, 0.5,0,0
    newmap matrix: 0.1,0,0.8, 0,0.5,0, -0.5,0,0.1, -0.5,0.1,0.2
    newmap scale: 0.6 rotate: z,60 translate: 0,-0.4,-0.5
}
)";

constexpr const char* grass = R"(
ifs grass {
    newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: -1,0,0
    newmap scale: 0.707,0.96,0.707 rotate: y,45 translate: 1,0,0
    newmap scale: 0.25,0.01,0.01 rotate: z,90 translate: 0,0.707,0
}
)";

constexpr const char* narrow = R"(
ifs narrow {
    newmap scale: 0.5 translate: 0,0.45,0
    newmap scale: 0.4 rotate: y,70 translate: 0.3,0.05,0.1
    newmap scale: 0.45,0.4,0.4 rotate: y,20 translate: -0.3,0.1,-0.15
}
)";

/// Objects and views that need more than a system's name.
std::vector<Example> composed_scenes(const std::string& image) {
    return {
        {"inside",
         ifs("tetra") + "camera { eye: 0.05,0.02,0.11 look: 0.4,-0.2,1 fov: 70 }" + image},
        {"inside-sponge",
         ifs("menger") + "camera { eye: 0.02,0.05,-0.03 look: 0.3,0.1,1 fov: 60 }" + image},
        {"orthographic",
         ifs("menger") + "camera { eye: 1.1,1.7,-5 look: 0.03,0.01,0 orthographic: 3.37 }" + image},
        {"instanced", ifs("icos") + ifs("mirrored") +
                          "object a { ifs: icos scale: 1,0.4,1.7 rotate: z,25 rotate: x,40 "
                          "translate: -1.2,0.3,0.5 color: 0.9,0.2,0.2,0.8 }"
                          "object b { ifs: mirrored scale: 0.8,1.5,0.6 rotate: y,-70 "
                          "translate: 1.4,0,0.2 diffuse: 0.6 }" +
                          image},
        {"overlapping", ifs("tetra") + ifs("octo") + ifs("menger") +
                            "object a { ifs: tetra color: 1,0,0,0.5 } object b { ifs: octo scale: "
                            "0.8 rotate: y,30 }"
                            "object c { ifs: tetra rotate: x,180 levels: 3 color: 0,0,1,1 } "
                            "object d { ifs: menger scale: 0.3 translate: 0.2,0.1,-0.6 }"
                            "light sun { direction: 0.3,0.8,-1 color: 1,0.9,0.8 } "
                            "light lamp { position: -2,2,-3 color: 0.3,0.4,0.5 }" +
                            image},
        {"declared", ifs("tetra") + "object a { ifs: tetra sphere: (0,0,0) 1.3 }" + image},
        {"declared-hull", ifs("octo") + "object a { ifs: octo hull rotate: z,20 }" + image},
        {"declared-cone",
         ifs("narrow") + "object a { ifs: narrow cone scale: 1,2,1 rotate: x,25 }" + image},
        {"declared-cylinder",
         ifs("narrow") + "object a { ifs: narrow cylinder rotate: z,65 }" + image},
        {"primitives",
         "object a { sphere: (0,0.3,0) 0.9 scale: 1,0.6,1.4 rotate: y,30 translate: -1.5,0,0.4 }"
         "object b { box: (-0.5,-0.8,-0.4)(0.6,0.7,0.5) rotate: x,35 rotate: z,15 }"
         "object c { cone scale: 0.7,-1.3,0.9 rotate: z,20 translate: 1.4,0.5,0 }"
         "object d { cylinder scale: 0.4,0.9,0.3 rotate: x,70 translate: 0.3,1.2,0.5 }" +
             ifs("tetra") + "object e { ifs: tetra scale: 0.7 translate: 0,-1.1,-0.6 }" + image},
        {"declared-box", ifs("octo") + "object a { ifs: octo box: (-1.1,-1,-1)(1,1.2,1) }" + image},
    };
}

}  // namespace

std::string ifs(const std::string& name) {
    if (name == "tetra") return toward(name, 0.5, tetrahedron());
    if (name == "octo") return toward(name, 0.5, octahedron());
    if (name == "menger") return toward(name, 1. / 3, sponge());
    if (name == "icos") return toward(name, 0.5, icosahedron());
    if (name == "dodec") return toward(name, 2 - std::numbers::phi, dodecahedron());
    static const std::map<std::string, std::string> others = {{"asymmetric", asymmetric},
                                                              {"hierarchical", hierarchical},
                                                              {"mirrored", mirrored},
                                                              {"squashed", squashed},
                                                              {"elm", elm},
                                                              {"bulging", bulging},
                                                              {"grass", grass},
                                                              {"narrow", narrow}};
    return others.at(name);
}

std::string scene_of(const std::string& name, const std::string& render, const std::string& image) {
    return ifs(name) + "image { " + image + " }\n" +
           (render.empty() ? "" : "render { " + render + " }\n");
}

std::vector<Example> example_scenes(const std::string& size) {
    const std::string image = "size: " + size;
    std::vector<Example> examples = composed_scenes("image { " + image + " }\n");
    for (const char* name : {"tetra", "octo", "menger", "icos", "dodec", "asymmetric",
                             "hierarchical", "mirrored", "squashed", "elm", "bulging"}) {
        examples.push_back({name, scene_of(name, "", image)});
    }
    for (const char* lipschitz : {"product", "determinant", "polar"}) {
        for (const char* volume : {"sphere", "box"}) {
            for (const char* name : {"mirrored", "hierarchical", "squashed"}) {
                examples.push_back(
                    {fmt::format("{}-{}-{}", name, lipschitz, volume),
                     scene_of(name,
                              fmt::format("lipschitz: {} volume: {} shading: low-pass", lipschitz,
                                          volume),
                              image)});
            }
        }
    }
    for (const char* volume : {"oriented", "hull"}) {
        for (const char* name : {"tetra", "squashed", "asymmetric", "mirrored"}) {
            examples.push_back(
                {fmt::format("{}-{}", name, volume),
                 scene_of(name, fmt::format("volume: {} shading: low-pass", volume), image)});
        }
    }
    for (const char* shading : {"constant", "low-pass", "high-pass", "facet"}) {
        examples.push_back({fmt::format("tetra-{}", shading),
                            scene_of("tetra", fmt::format("shading: {}", shading), image)});
        examples.push_back(
            {fmt::format("elm-{}", shading),
             scene_of("elm", fmt::format("shading: {} volume: box detail: 3", shading), image)});
    }
    for (const double detail : {0.5, 1.0, 4.0}) {
        examples.push_back({fmt::format("octo-detail-{}", detail),
                            scene_of("octo", fmt::format("detail: {}", detail), image)});
    }
    for (int levels = 0; levels <= 3; ++levels) {
        examples.push_back({fmt::format("dodec-levels-{}", levels),
                            scene_of("dodec", "shading: high-pass", image) +
                                fmt::format("object a {{ ifs: dodec levels: {} }}", levels)});
    }
    for (Example& example : examples) {
        for (char& c : example.name) {
            if (c == '-' || c == '.') c = '_';
        }
    }
    return examples;
}

}  // namespace pxm::test
