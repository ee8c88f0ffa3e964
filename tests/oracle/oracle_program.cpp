// The oracle without end: random scenes, rendered by all engines and judged (tools/oracle starts
// it). Writes a line of JSON before each scene and one after it, so that whoever reads them knows
// which scene a crash or a hang is of. What is found is made small and written as a scene.
//   oracle --seed N --seconds T --finds DIR [--only METHOD,...]
//   oracle --scene FILE [--only METHOD,...]
#include <fmt/format.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/scene/check/check.hpp"
#include "host/scene/parse/parser.hpp"
#include "host/scene/print/print.hpp"
#include "tests/support/campaign/random_system.hpp"
#include "tests/support/campaign/scene_grammar.hpp"
#include "tests/support/campaign/shrink.hpp"
#include "tests/support/campaign/trial.hpp"

namespace {

using namespace pxm;
using namespace pxm::test;
using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr rlim_t most_memory_bytes = 4UL << 30;
constexpr double shrink_seconds = 60;
constexpr std::uint64_t of_grammar = 4;  // one scene in so many is of the grammar
constexpr int most_files = 50;           // that one run writes

std::atomic<bool> stop{false};
void on_signal(int) { stop = true; }

struct Options {
    std::uint64_t seed = 1;
    long scenes = -1;  // no more than that; below 0: any number
    double seconds = 60;
    std::string finds = ".";
    std::string scene;  // a file: it is judged, and nothing else
    std::vector<std::string> only;
};

Options options_of(int count, char** words) {
    Options options;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string key = words[i], value = words[i + 1];
        if (key == "--seed") options.seed = std::strtoull(value.c_str(), nullptr, 10);
        if (key == "--scenes") options.scenes = std::strtol(value.c_str(), nullptr, 10);
        if (key == "--seconds") options.seconds = std::strtod(value.c_str(), nullptr);
        if (key == "--finds") options.finds = value;
        if (key == "--scene") options.scene = value;
        if (key != "--only") continue;
        std::istringstream list(value);
        for (std::string method; std::getline(list, method, ',');) options.only.push_back(method);
    }
    return options;
}

void say(const json& line) {
    std::puts(line.dump(-1, ' ', true, json::error_handler_t::replace).c_str());
    std::fflush(stdout);
}

/// How the find is shown again, as comments above the scene.
std::string scene_text(const Shrunk& small, std::uint64_t seed, const std::string& name) {
    std::string text;
    std::istringstream lines(fmt::format("{} at pixel {},{}: {}", small.find.method, small.find.x,
                                         small.find.y, small.find.what));
    for (std::string line; std::getline(lines, line);) text += "# " + line + "\n";
    const std::string methods = small.find.method == "heap"      ? "float,heap"
                                : small.find.method == "machine" ? "dsp32,machine"
                                                                 : small.find.method;
    return text +
           fmt::format("# From seed {}. Shown by: tools/oracle --scene {} --only {}\n", seed, name,
                       methods) +
           host::print_scene(small.scene);
}

class Campaign {
  public:
    explicit Campaign(const Options& options) : options_(options) {
        settings_.only = options.only;
        settings_.stop = &stop;
    }

    void run() {
        const auto end = Clock::now() + std::chrono::duration<double>(options_.seconds);
        std::uint64_t seed = options_.seed;
        for (long n = 0; n != options_.scenes && !stop && Clock::now() < end; ++n) one(seed++);
        say({{"end", seed}});
    }

    /// Judges every pixel of a scene file. Whether it is right.
    bool judge_file() {
        host::Diagnostics diagnostics;
        const host::Scene scene = host::parse_scene(options_.scene, diagnostics);
        diagnostics.throw_if_errors(scene.files);
        settings_.by_definition = 1L << 30;
        settings_.disputed = 1L << 30;
        const Trial trial = try_scene(scene, settings_);
        for (const Find& find : trial.finds)
            fmt::print("{} at pixel {},{}: {}\n", find.method, find.x, find.y, find.what);
        for (const auto& [name, count] : trial.score.counts) fmt::print("{:>12} {}\n", count, name);
        return trial.finds.empty();
    }

  private:
    static bool is_of_grammar(std::uint64_t seed) { return seed % of_grammar == 0; }

    void one(std::uint64_t seed) {
        say({{"begin", seed}});
        settings_.seed = seed;
        host::Scene scene;
        try {
            scene = is_of_grammar(seed) ? grammar_scene(seed) : random_system(seed);
            const Trial trial = try_scene(scene, settings_);
            if (!trial.refused.empty() && is_of_grammar(seed))
                throw std::runtime_error("refused: " + trial.refused);
            json line{{"done", seed}, {"counts", trial.score.counts}};
            for (const Find& find : trial.finds) line["finds"].push_back(kept(scene, find, seed));
            say(line);
        } catch (const std::bad_alloc&) {
            say({{"done", seed}, {"counts", {{"scenes", 1}, {"scenes out of memory", 1}}}});
        } catch (const std::exception& error) {
            const Find find{"exception", -1, -1, error.what()};
            say({{"done", seed},
                 {"counts", {{"scenes", 1}, {"finds", 1}}},
                 {"finds", {written({scene, find, 0}, seed)}}});
        }
    }
    /// A scene of the grammar, which has no mistake.
    host::Scene grammar_scene(std::uint64_t seed) const {
        const std::filesystem::path folder = options_.finds;
        std::filesystem::create_directories(folder);
        std::ofstream(folder / SceneGrammar::part_file) << SceneGrammar::part_text();
        std::ofstream(folder / SceneGrammar::picture_file) << SceneGrammar::picture_bytes();
        host::Diagnostics diagnostics;
        const std::string text = SceneGrammar(seed).scene();
        host::Scene scene = host::parse_scene(folder / "scene.pxm", diagnostics, {}, nullptr, text);
        if (!diagnostics.has_errors()) host::check_scene(scene, diagnostics);
        diagnostics.throw_if_errors(scene.files);
        return scene;
    }
    json kept(const host::Scene& scene, const Find& find, std::uint64_t seed) {
        if (files_ >= most_files) return {{"what", find.what}, {"method", find.method}};
        return written(shrink(scene, find, settings_, shrink_seconds), seed);
    }
    json written(const Shrunk& small, std::uint64_t seed) {
        ++files_;
        const std::string name = fmt::format("{}-{}.pxm", small.find.method, seed);
        const auto path = std::filesystem::path(options_.finds) / name;
        std::filesystem::create_directories(options_.finds);
        std::ofstream(path) << scene_text(small, seed, name);
        return {{"file", path.string()},
                {"method", small.find.method},
                {"what", small.find.what},
                {"tried", small.tried}};
    }

    Options options_;
    TrialSettings settings_;
    int files_ = 0;
};

}  // namespace

int main(int count, char** words) {
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    const rlimit memory{most_memory_bytes, most_memory_bytes};
    setrlimit(RLIMIT_AS, &memory);
    const Options options = options_of(count, words);
    Campaign campaign(options);
    try {
        if (!options.scene.empty()) return campaign.judge_file() ? 0 : 1;
        campaign.run();
    } catch (const std::exception& error) {
        fmt::print(stderr, "oracle: {}\n", error.what());
        return 2;
    }
    return 0;
}
