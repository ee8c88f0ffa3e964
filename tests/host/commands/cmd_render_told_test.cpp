// Laws of what `pxm render` tells besides the picture: --stats and --pixel.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "host/files/image_reader.hpp"
#include "tests/support/command.hpp"

namespace pxm::test {
namespace {

using Json = nlohmann::json;
using host::LoadedImage;

class Told : public testing::Test {
  protected:
    Told() { folder.write("tetra.pxm", tetra_scene); }

    Json statistics(Arguments options) const {
        options.insert(options.begin(),
                       {"render", "tetra.pxm", "-o", "a.exr", "--aov", "Z,volumes,level,heap,node",
                        "--size", "70x53", "--stats", "s.json"});
        expect_done(folder, options);
        return Json::parse(folder.read("s.json"));
    }
    [[nodiscard]] LoadedImage picture() const { return host::read_image(folder.path("a.exr")); }
    Folder folder;
};

/// Sum of a channel over the finite pixels.
double sum(const LoadedImage& image, const char* channel) {
    double total = 0;
    for (std::size_t i = 0; i < image.values.size() / image.channels.size(); ++i) {
        const float value = image.at(i, image.channel(channel));
        if (std::isfinite(value)) total += value;
    }
    return total;
}

std::size_t hits(const LoadedImage& image) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < image.values.size() / image.channels.size(); ++i) {
        n += std::isfinite(image.at(i, image.channel("Z")));
    }
    return n;
}

TEST_F(Told, native_statistics_agree_with_the_picture) {
    const Json s = statistics({"--threads", "2"});
    EXPECT_EQ(s["engine"], "native");
    EXPECT_EQ(s["model"], nullptr);
    EXPECT_EQ(s["scene"], "tetra.pxm");
    EXPECT_EQ(s["numeric"], "float");
    EXPECT_EQ(s["threads"], 2);
    EXPECT_EQ(s["size"], (Json{70, 53}));
    EXPECT_EQ(s["rays"]["eye"], 70 * 53);
    EXPECT_EQ(s["hits"], hits(picture()));
    EXPECT_EQ(s["volumes_tested"], sum(picture(), "volumes.V"));
    EXPECT_FALSE(s.contains("nodes") || s.contains("program") || s.contains("memory") ||
                 s.contains("balance"));
    const Json& seconds = s["seconds"];
    double phases = 0;
    for (const char* phase : {"parse", "compile", "load", "render", "write"}) {
        EXPECT_GE(seconds[phase], 0.0) << phase;
        phases += seconds[phase].get<double>();
    }
    EXPECT_LE(phases, seconds["total"].get<double>() * 1.001);
}

TEST_F(Told, the_nodes_add_up_to_the_picture) {
    const Json s = statistics({"--machine", "964dX"});
    EXPECT_EQ(s["engine"], "machine");
    EXPECT_EQ(s["model"], "964dX");
    ASSERT_EQ(s["nodes"].size(), 64U);
    long pixels = 0, rays = 0, volumes = 0, overflows = 0, slowest = 0;
    double cycles = 0;
    for (const Json& node : s["nodes"]) {
        const int id = node["id"];
        const int column = node["column"], row = node["row"];
        EXPECT_EQ(id, row * 8 + column);
        EXPECT_EQ(node["pixels"], ((70 - column + 7) / 8) * ((53 - row + 7) / 8));
        pixels += node["pixels"].get<long>();
        rays += node["rays"].get<long>();
        volumes += node["volumes_tested"].get<long>();
        overflows += node["heap_overflows"].get<long>();
        slowest = std::max(slowest, node["cycles"].get<long>());
        cycles += node["cycles"].get<double>();
        EXPECT_DOUBLE_EQ(node["seconds"], node["cycles"].get<double>() * 200e-9);
        EXPECT_GE(node["heap_pushes"], node["heap_peak"]);
    }
    EXPECT_EQ(pixels, 70 * 53);
    EXPECT_EQ(rays, s["rays"]["eye"]);
    EXPECT_EQ(volumes, s["volumes_tested"]);
    EXPECT_EQ(volumes, sum(picture(), "volumes.V"));
    EXPECT_EQ(overflows, s["heap_overflows"]);
    EXPECT_EQ(s["hits"], hits(picture()));
    const Json& balance = s["balance"];
    EXPECT_EQ(balance["max_cycles"], slowest);
    EXPECT_DOUBLE_EQ(balance["mean_cycles"], cycles / 64);
    EXPECT_DOUBLE_EQ(balance["efficiency"], cycles / 64 / static_cast<double>(slowest));
    EXPECT_DOUBLE_EQ(balance["predicted_seconds"], static_cast<double>(slowest) * 200e-9);
}

TEST_F(Told, memory_and_program_lie_within_their_limits) {
    const Json s = statistics({"--machine", "964dX"});
    for (const auto& [bank, use] : s["memory"].items()) {
        EXPECT_LE(use["used_bytes"], use["limit_bytes"]) << bank;
    }
    EXPECT_GT(s["memory"]["back_buffer"]["used_bytes"], 0);
    EXPECT_GT(s["memory"]["zbuffer"]["used_bytes"], 0);
    const Json& program = s["program"];
    EXPECT_EQ(program["limit_bytes"], 36'864);
    long modules = 0;
    for (const Json& module : program["modules"]) {
        EXPECT_GT(module["bytes"], 0) << module["name"];
        EXPECT_NE(module["because"], "") << module["name"];
        modules += module["bytes"].get<long>();
    }
    EXPECT_GE(program["used_bytes"], modules);
    EXPECT_LE(program["used_bytes"], program["limit_bytes"]);
}

TEST_F(Told, cycles_of_the_pixels_add_up_to_those_of_the_nodes) {
    expect_done(folder, {"render", "tetra.pxm", "-o", "a.exr", "--aov", "cycles,node", "--size",
                         "24x24", "--machine", "964dX", "--stats", "s.json"});
    const LoadedImage a = picture();
    std::vector<double> cycles(64);
    for (std::size_t i = 0; i < a.values.size() / a.channels.size(); ++i) {
        const auto node = static_cast<std::size_t>(a.at(i, a.channel("node.V")));
        cycles.at(node) += a.at(i, a.channel("cycles.V"));
    }
    const Json s = Json::parse(folder.read("s.json"));
    ASSERT_EQ(s["nodes"].size(), 64U);
    for (const Json& node : s["nodes"]) {
        EXPECT_EQ(node["cycles"], cycles[node["id"].get<std::size_t>()]) << node["id"];
    }
}

/// The last line of --pixel, and the line before it.
struct Descent {
    std::string before_last;
    std::string last;
};

Descent descent(const std::string& text) {
    Descent d;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        d.before_last = d.last;
        d.last = line;
    }
    return d;
}

TEST_F(Told, a_pixels_descent_ends_as_the_render_shows_it) {
    (void)statistics({"--intersect", "heap"});
    const LoadedImage a = picture();
    const auto before = folder.contents();
    for (const auto& [x, y] : {std::pair{35, 26}, {34, 14}, {0, 0}, {69, 52}}) {
        const std::string place = std::to_string(x) + "," + std::to_string(y);
        SCOPED_TRACE(place);
        const Outcome outcome =
            run(folder, {"render", "tetra.pxm", "--size", "70x53", "--pixel", place});
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_EQ(outcome.out.rfind("pixel " + place + ": ray from ", 0), 0U) << outcome.out;
        const auto i = static_cast<std::size_t>(y * a.width + x);
        const auto at = [&](const char* name) { return a.at(i, a.channel(name)); };
        const bool hit = std::isfinite(at("Z"));
        const Descent d = descent(outcome.out);

        char end[64];
        int volumes = 0, heap = 0;
        double r = 0, g = 0, b = 0;
        ASSERT_EQ(std::sscanf(d.last.c_str(),
                              "ended by %63[^;]; %d volumes tested, at most %d cells in the heap; "
                              "colour %lf %lf %lf",
                              end, &volumes, &heap, &r, &g, &b),
                  6)
            << d.last;
        EXPECT_STREQ(end, hit ? "a terminal cell" : "a miss");
        EXPECT_EQ(static_cast<float>(volumes), at("volumes.V"));
        EXPECT_EQ(static_cast<float>(heap), at("heap.V"));
        EXPECT_NEAR(r, at("R"), 1e-5);
        EXPECT_NEAR(g, at("G"), 1e-5);
        EXPECT_NEAR(b, at("B"), 1e-5);
        if (!hit) continue;
        int level = 0;
        double key = 0;
        ASSERT_EQ(std::sscanf(d.before_last.c_str(), "shows %d %lf", &level, &key), 2)
            << d.before_last;
        EXPECT_EQ(static_cast<float>(level), at("level.V"));
        EXPECT_NEAR(key, at("Z"), 1e-6 * key);
    }
    EXPECT_EQ(folder.contents(), before) << "--pixel writes no file";
}

}  // namespace
}  // namespace pxm::test
