#include "tests/support/kills.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <map>
#include <optional>
#include <thread>

#include "tests/support/command.hpp"

namespace pxm::test {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Bytes = std::map<std::string, std::string>;

constexpr double patience_seconds = 120;

constexpr const char* film = R"(
animation { frames: 6  rate: 10 }
ifs a {
    newmap scale: 0.5 rotate: y,90*t
    newmap scale: 0.5 translate: 0.5,0,0
    newmap scale: 0.5 translate: 0,0.5,0
}
camera { eye: 0.3,0.4,-2  look: 0.3,0.3,0 }
)";

void clear(const Folder& folder, const KilledWork& work) {
    for (const auto& entry : fs::directory_iterator(folder.path())) fs::remove_all(entry.path());
    folder.write("tetra.pxm", tetra_scene);
    folder.write("film.pxm", film);
    work.prepare(folder);
    if (work.old.empty()) return;
    for (const std::string& name : work.finals) folder.write(name, work.old);
}

Bytes finals_in(const Folder& folder, const KilledWork& work) {
    Bytes bytes;
    for (const std::string& name : work.finals) bytes[name] = folder.read(name);
    return bytes;
}

/// The bytes of a run that nobody disturbs, and how long it takes.
std::pair<Bytes, std::chrono::duration<double>> undisturbed(const KilledWork& work) {
    const Folder folder;
    clear(folder, work);
    const auto begin = Clock::now();
    const Outcome outcome = run_program(folder, work.command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return {finals_in(folder, work), Clock::now() - begin};
}

void expect_old_or_new(const Folder& folder, const KilledWork& work, const Bytes& right) {
    for (const auto& [name, bytes] : finals_in(folder, work))
        EXPECT_TRUE(bytes == work.old || bytes == right.at(name)) << name << " " << bytes.size();
}

/// The run that follows, with its companion if it has one: both end well.
void expect_rest(const Folder& folder, const KilledWork& work, const Bytes& right) {
    const Outcome outcome = run_program(folder, work.command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* harm : {"damaged", "cut short"})
        EXPECT_EQ(outcome.err.find(harm), std::string::npos) << outcome.err;
    for (const auto& [name, bytes] : finals_in(folder, work))
        EXPECT_TRUE(bytes == right.at(name)) << name << " " << bytes.size();
    for (const std::string& name : folder.names())
        EXPECT_FALSE(name.starts_with(".pxm-part-")) << name << " is left";
}

void kill_once(const Folder& folder, const KilledWork& work, std::chrono::duration<double> moment) {
    std::optional<Process> companion;
    if (!work.companion.empty()) companion.emplace(folder, work.companion);
    {
        const Process process(folder, work.command);
        std::this_thread::sleep_for(moment);
    }  // which kills it
    if (!companion) return;
    const Outcome outcome = companion->wait(patience_seconds);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace

void kill_at_random(const KilledWork& work, int kills, std::mt19937& random) {
    const auto [right, seconds] = undisturbed(work);
    std::uniform_real_distribution<double> share(0, 1.1);
    const Folder folder;
    clear(folder, work);
    for (int i = 0; i < kills && !testing::Test::HasFailure(); ++i) {
        kill_once(folder, work, seconds * share(random));
        expect_old_or_new(folder, work, right);
        if (random() % 4 == 0 && i + 1 < kills) continue;  // and once more
        expect_rest(folder, work, right);
        clear(folder, work);
    }
}

std::vector<KilledWork> killed_works() {
    const auto render = [](const Arguments& more, const std::string& size = "1200x900") {
        Arguments all{"render", "tetra.pxm", "--size", size, "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const auto frames = [](const Arguments& more) {
        Arguments all{"render", "film.pxm", "--frames", "0-5", "--size", "240x180", "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    };
    const auto names = [](const std::string& before, int first, int last,
                          const std::string& after) {
        std::vector<std::string> all;
        for (int i = first; i <= last; ++i) all.push_back(before + std::to_string(i) + after);
        return all;
    };
    const auto make_frame_folder = [](const Folder& folder) {
        fs::create_directory(folder.path("f"));
    };
    const Arguments claim =
        render({"--claim", "parts", "--part", "any/6", "--claim-expiry", "0.3", "--threads", "1"});
    return {
        {.command = render({"-o", "a.png", "--keep", "kept"}), .finals = {"a.png"}},
        {.command = render({"--machine", "964", "-o", "a.exr", "--keep", "kept"}, "40x30"),
         .finals = {"a.exr"},
         .old = "an older picture"},
        {.command = render({"-o", "parts", "--part", "2/3"}),
         .finals = {"parts/part-2-of-3.pxmpart"}},
        {.command = claim,
         .finals = names("parts/part-", 1, 6, "-of-6.pxmpart"),
         .companion = claim},
        {.command = {"join", "parts", "-o", "a.exr", "--quiet"},
         .finals = {"a.exr"},
         .prepare =
             [render](const Folder& folder) {
                 expect_done(folder, render({"-o", "parts", "--part", "1/1"}));
             },
         .old = "an older picture"},
        {.command = {"points", "tetra.pxm", "-n", "700000", "-o", "a.ply", "--keep", "kept",
                     "--quiet"},
         .finals = {"a.ply"}},
        {.command = frames({"-o", "f/%d.png"}),
         .finals = names("f/", 0, 5, ".png"),
         .prepare = make_frame_folder},
        {.command = frames({"-o", "f/%d.png", "--keep", "kept"}),
         .finals = names("f/", 0, 5, ".png"),
         .prepare = make_frame_folder},
        {.command = frames({"-o", "parts", "--part", "1/2"}),
         .finals = names("parts/frame-000", 0, 0, "/part-1-of-1.pxmpart")},
    };
}

}  // namespace pxm::test
