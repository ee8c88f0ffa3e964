// A study that is interrupted leaves what it has measured, and nothing half written.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"

namespace pxm::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double soon_seconds = 5;
constexpr int patience = 12'000;  // times 5 ms

TEST(InterruptedStudy, goes_on_where_it_stopped) {
    Folder folder;
    folder.write("tetra.pxm", tetra_scene);
    fs::copy(source_dir + "/scenes/parts/elm.pxm", folder.path("elm.pxm"));
    const Arguments command{"study", "balance", "tetra.pxm", "elm.pxm",
                            "-o",    "out",     "--size",    "400x300"};
    {
        Process program(folder, command);
        program.wait_until_it_catches(SIGTERM);
        for (int i = 0; i < patience && !folder.has("out/units/tetra.json"); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_TRUE(folder.has("out/units/tetra.json"));
        program.send(SIGTERM);
        EXPECT_EQ(program.wait(soon_seconds).exit_code, 143);
    }
    EXPECT_FALSE(folder.has("out/data.json"));
    EXPECT_FALSE(folder.has("out/units/elm.json"));
    for (const auto& [name, bytes] : folder.contents()) EXPECT_EQ(name.find("part"), name.npos);
    EXPECT_NE(expect_done(folder, command).find("1 of 2 measurements"), std::string::npos);
    expect_done(folder,
                {"study", "balance", "tetra.pxm", "elm.pxm", "-o", "whole", "--size", "400x300"});
    const auto counted = [&](const char* path) {
        Json data = Json::parse(folder.read(path));
        for (Json& scene : data["scenes"]) scene.erase("host");
        return data;
    };
    EXPECT_EQ(counted("out/data.json"), counted("whole/data.json"));
}

}  // namespace
}  // namespace pxm::test
