// The laws of host/studio/studio.hpp and http_server.hpp over real sockets: what an attacker sends
// is refused, bounded or hung up on, and the page goes on.
#include "host/studio/studio.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "host/error.hpp"
#include "host/studio/http_server.hpp"
#include "tests/support/asked_studio.hpp"
#include "tests/support/command.hpp"

namespace pxm::host {
namespace {

using test::Line;
using test::StudioTest;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(StudioTest, gives_its_page_to_who_has_the_address) {
    const Line line(port_);
    line.say("GET /?token=" + token_ + " HTTP/1.1\r\nHost: " + host_ +
             "\r\nConnection: close\r\n\r\n");
    const std::string page = line.hear();
    EXPECT_THAT(page, StartsWith("HTTP/1.1 200 OK"));
    EXPECT_THAT(page, HasSubstr("Set-Cookie: pxm_studio_"));
    EXPECT_THAT(page, HasSubstr("<!doctype html>"));
    EXPECT_THAT(page, HasSubstr("Content-Security-Policy: default-src 'none'"));
    EXPECT_THAT(page, HasSubstr("connect-src 'self' ws://" + host_ + " "));
    EXPECT_THAT(page, Not(HasSubstr("unsafe")));
    EXPECT_THAT(ask("GET /studio.js"), HasSubstr("text/javascript"));
    EXPECT_THAT(ask("GET /gone.js"), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(ask("GET /../studio.hpp"), StartsWith("HTTP/1.1 404"));
}

TEST_F(StudioTest, says_nothing_to_strangers) {
    for (const char* first : {"GET / HTTP/1.1", "GET /api/start HTTP/1.1",
                              "POST /api/picture HTTP/1.1", "GET /studio.js HTTP/1.1"}) {
        const Line line(port_);
        line.say(std::string(first) + "\r\nHost: " + host_ + "\r\nOrigin: http://" + host_ +
                 "\r\nContent-Type: application/json\r\nConnection: close\r\n\r\n");
        const std::string heard = line.hear();
        EXPECT_THAT(heard, StartsWith("HTTP/1.1 401")) << first;
        EXPECT_THAT(heard, Not(HasSubstr("pxm_studio_"))) << first;
        EXPECT_THAT(heard, Not(HasSubstr("Access-Control"))) << first;
    }
}

TEST_F(StudioTest, checks_inspects_and_renders) {
    const Json checked = answer("POST /api/check", scene(test::tetra_scene));
    EXPECT_EQ(checked["ifs"][0]["maps"].size(), 4U);
    EXPECT_EQ(checked["ifs"][0]["maps"][0]["matrix"].size(), 12U);
    const Json facts = answer("POST /api/inspect", scene(test::tetra_scene));
    EXPECT_NEAR(facts["ifs"].front()["contractivity"].get<double>(), 0.5, 1e-9);
    EXPECT_THAT(ask("POST /api/picture", picture(test::tetra_scene, 16).dump()),
                HasSubstr("application/octet-stream"));
    EXPECT_THAT(ask("POST /api/png", picture(test::tetra_scene, 16).dump()),
                HasSubstr("image/png"));
    Json pixel = picture(test::tetra_scene, 64);
    pixel.update({{"x", 32}, {"y", 32}});
    const Json picked = answer("POST /api/pick", pixel);
    EXPECT_EQ(picked["cell"]["point"].size(), 3U);
    EXPECT_FALSE(picked["cell"]["word"].empty());
    pixel["serial"] = ++serial_;
    EXPECT_THAT(answer("POST /api/pixel", pixel)["text"].get<std::string>(), HasSubstr("shows"));
}

TEST_F(StudioTest, says_where_a_scene_is_wrong) {
    const Json wrong = answer("POST /api/check", scene("ifs a {\n  newmap scale: <b>\n}"));
    EXPECT_EQ(wrong["error"]["kind"], "scene");
    EXPECT_EQ(wrong["error"]["mistakes"][0]["line"], 2);
    const Json growing = answer("POST /api/check", scene("ifs a { newmap scale: 2 }"));
    EXPECT_EQ(growing["error"]["kind"], "scene");
    EXPECT_FALSE(growing["error"]["mistakes"].empty());
}

TEST_F(StudioTest, opens_and_saves_below_its_folder_alone) {
    EXPECT_EQ(answer("POST /api/open", {{"name", "a.pxm"}})["text"], test::tetra_scene);
    for (const std::string& name :
         {std::string("../a.pxm"), outside_.path("secret.pxm"), std::string("/etc/passwd")}) {
        EXPECT_THAT(ask("POST /api/open", Json{{"name", name}}.dump()),
                    Not(HasSubstr("the secret")));
        EXPECT_TRUE(answer("POST /api/save", {{"name", name}, {"text", "x"}, {"seen", ""}})
                        .contains("error"))
            << name;
    }
    const Json saved = answer("POST /api/save", {{"name", "b.pxm"}, {"text", "b"}, {"seen", ""}});
    EXPECT_EQ(saved["saved"], true);
    EXPECT_EQ(folder_.read("b.pxm"), "b");
    EXPECT_EQ(answer("POST /api/save", {{"name", "b.pxm"}, {"text", "c"}, {"seen", ""}})["saved"],
              false);
    EXPECT_EQ(folder_.read("b.pxm"), "b");
    EXPECT_EQ(outside_.read("secret.pxm"), "the secret");
}

TEST_F(StudioTest, refuses_bodies_beyond_its_limit_without_reading_them) {
    const Line line(port_);
    line.say(head("POST /api/check", std::size_t{1} << 30U));
    EXPECT_THAT(line.hear(), StartsWith("HTTP/1.1 413"));
    // Without a length, piece by piece.
    const Line pieces(port_);
    std::string first = head("POST /api/check", 0);
    first.replace(first.find("Content-Length: 0"), 17, "Transfer-Encoding: chunked");
    pieces.say(first);
    const std::string piece = "10000\r\n" + std::string(0x10000, ' ') + "\r\n";
    for (int i = 0; i < 64; ++i)
        if (!pieces.say(piece)) break;
    const std::string heard = pieces.hear();
    EXPECT_TRUE(heard.empty() || heard.starts_with("HTTP/1.1 413")) << heard.substr(0, 80);
    expect_alive();
}

TEST_F(StudioTest, refuses_heads_beyond_its_limit) {
    const Line line(port_);
    line.say("GET / HTTP/1.1\r\nHost: " + host_ + "\r\nX: " + std::string(100'000, 'x'));
    const std::string heard = line.hear();
    EXPECT_TRUE(heard.empty() || heard.starts_with("HTTP/1.1 431")) << heard.substr(0, 80);
    const Line many(port_);
    std::string fields = "GET / HTTP/1.1\r\n";
    for (int i = 0; i < 10'000; ++i) fields += "a: b\r\n";
    many.say(fields + "\r\n");
    const std::string refusal = many.hear();
    EXPECT_TRUE(refusal.empty() || refusal.starts_with("HTTP/1.1 431")) << refusal.substr(0, 80);
    expect_alive();
}

TEST_F(StudioTest, refuses_what_is_no_request) {
    for (const std::string& noise : {std::string("\x16\x03\x01\x02"), std::string("GET\r\n\r\n"),
                                     std::string("\r\n\r\n\r\n\r\n"), std::string(1000, '\0'),
                                     std::string("GET / HTTP/9.9\r\n\r\n")}) {
        const Line line(port_);
        line.say(noise + "\r\n\r\n");
        const std::string heard = line.hear();
        EXPECT_TRUE(heard.empty() || heard.starts_with("HTTP/1.1 4")) << heard.substr(0, 80);
    }
    expect_alive();
}

TEST_F(StudioTest, gives_up_a_picture_when_a_newer_one_is_wanted) {
    // Two million samples: minutes, unless it is stopped.
    Json slow = picture(test::tetra_scene, 2048);
    slow["samples"] = 64;
    const Line first(port_);
    first.say(head("POST /api/picture", slow.dump().size()) + slow.dump());
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_THAT(ask("POST /api/picture", picture(test::tetra_scene, 8).dump()),
                HasSubstr("octet-stream"));
    EXPECT_THAT(first.hear(), HasSubstr("superseded"));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST_F(StudioTest, ends_while_a_picture_is_rendered) {
    Json slow = picture(test::tetra_scene, 2048);
    slow["samples"] = 64;
    const Line first(port_);
    first.say(head("POST /api/picture", slow.dump().size()) + slow.dump());
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    const auto begin = std::chrono::steady_clock::now();
    studio_.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

class HurriedStudioTest : public StudioTest {
  protected:
    HurriedStudioTest() : StudioTest(0.05) {}
};

TEST_F(HurriedStudioTest, ends_what_would_take_hours) {
    const std::string hours =
        std::string(test::tetra_scene) + "render { samples: 4096 detail: 0.0001 }\n";
    Json slow = picture(hours, 2048);
    slow["samples"] = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (const char* first : {"POST /api/picture", "POST /api/png"}) {
        slow["serial"] = ++serial_;
        EXPECT_THAT(ask(first, slow.dump()), HasSubstr("this takes longer than the studio waits"));
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
    expect_alive();  // a small picture may take as long where computers are slow
}

TEST_F(StudioTest, bears_many_connections_and_many_requests) {
    std::vector<std::unique_ptr<Line>> idle;
    for (int i = 0; i < 200; ++i) idle.push_back(std::make_unique<Line>(port_));
    idle.clear();
    const Line line(port_);
    const std::string one = "GET /studio.js HTTP/1.1\r\nHost: " + host_ + "\r\n\r\n";
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        line.say(one);
        if (line.hear("\r\n\r\n").empty()) break;
        ++refused;
    }
    EXPECT_EQ(refused, 3000) << "one connection may ask again and again, and is refused each time";
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    expect_alive();
}

TEST_F(StudioTest, knows_when_it_is_deserted) {
    EXPECT_FALSE(studio_->is_deserted());
    {
        const Line page(port_);
        page.say(head("GET /api/alive?view=test", 0));
        EXPECT_THAT(page.hear("\r\n\r\n"), HasSubstr("text/event-stream"));
    }
    EXPECT_FALSE(studio_->is_deserted()) << "it stays for the grace time";
}

TEST(Studio, opens_no_scene_that_is_not_there) {
    const test::Folder folder;
    StudioSettings settings;
    settings.folder = folder.path();
    settings.scene = "gone.pxm";
    EXPECT_THROW(Studio{settings}, Error);
    settings.folder = folder.path("gone");
    settings.scene = "";
    EXPECT_THROW(Studio{settings}, Error);
}

TEST(HttpServer, takes_no_port_that_is_taken) {
    const HttpServer first(0);
    EXPECT_THROW(HttpServer{first.port()}, Error);
}

}  // namespace
}  // namespace pxm::host
