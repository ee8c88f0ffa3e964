// Laws of `pxm studio`: what it refuses before it serves anything. What it serves is tested in
// tests/host/studio/.
#include <gtest/gtest.h>

#include <string>

#include "host/studio/http_server.hpp"
#include "tests/support/command.hpp"
#include "tests/support/folder.hpp"

namespace pxm::test {
namespace {

TEST(StudioCommand, opens_no_scene_outside_of_its_folder) {
    const Folder folder;
    for (const char* scene : {"../a.pxm", "/etc/passwd", "b/../../a.pxm"}) {
        expect_refusal(folder, {"studio", scene, "--no-browser"}, 2,
                       std::string(scene) +
                           ": the studio opens scenes below the folder that it is started in: "
                           "start it there");
    }
}

TEST(StudioCommand, opens_no_scene_that_is_none) {
    const Folder folder;
    folder.write("a.txt", tetra_scene);
    expect_refusal(folder, {"studio", "a.txt", "--no-browser"}, 2,
                   "\"a.txt\": expected a name that ends in .pxm");
    expect_refusal_naming(folder, {"studio", "gone.pxm", "--no-browser"}, 4, {"gone.pxm"});
}

TEST(StudioCommand, takes_no_port_that_is_taken_or_none) {
    const Folder folder;
    const host::HttpServer other(0);
    expect_refusal_naming(folder,
                          {"studio", "--port", std::to_string(other.port()), "--no-browser"}, 1,
                          {"cannot listen on 127.0.0.1:" + std::to_string(other.port())});
    expect_refusal_naming(folder, {"studio", "--port", "65536"}, 2, {"--port"});
}

}  // namespace
}  // namespace pxm::test
