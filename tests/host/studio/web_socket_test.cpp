// The laws of host/studio/web_socket.hpp over real sockets: who is let in, and what is answered.
#include "host/studio/web_socket.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tests/support/asked_studio.hpp"
#include "tests/support/command.hpp"

namespace pxm::host {
namespace {

using Json = nlohmann::ordered_json;
using test::Line;
using testing::HasSubstr;
using testing::StartsWith;

std::uint64_t number_of(std::string_view bytes) {
    std::uint64_t number = 0;
    for (const char byte : bytes) number = number << 8U | static_cast<unsigned char>(byte);
    return number;
}

std::string bytes_of(std::uint64_t number, int count) {
    std::string bytes;
    while (count-- > 0) bytes += static_cast<char>(number >> 8 * count);
    return bytes;
}

/// A frame of RFC 6455 as a client sends it: text, whole, masked by zeros.
std::string frame_of(const std::string& text) {
    const std::size_t size = text.size();
    const std::string length = size < 126     ? bytes_of(0x80 | size, 1)
                               : size < 65536 ? bytes_of(0x80 | 126, 1) + bytes_of(size, 2)
                                              : bytes_of(0x80 | 127, 1) + bytes_of(size, 8);
    return "\x81" + length + std::string(4, '\0') + text;
}

struct Ended {
    std::string pieces;
    std::uint32_t status = 0;
    std::string last;  // what came with the status
};

class WebSocketTest : public test::StudioTest {
  protected:
    [[nodiscard]] std::string hand_shake(const std::string& path, const std::string& origin,
                                         const std::string& token) const {
        return "GET " + path + " HTTP/1.1\r\nHost: " + host_ + "\r\nOrigin: " + origin +
               "\r\nCookie: pxm_studio_" + std::to_string(port_) + "=" + token +
               "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n";
    }
    /// A WebSocket of the studio's own page.
    void open(const Line& line, const std::string& path) {
        line.say(hand_shake(path, "http://" + host_, token_));
        ASSERT_THAT(heard_ = line.hear("\r\n\r\n"), StartsWith("HTTP/1.1 101"));
        heard_.erase(0, heard_.find("\r\n\r\n") + 4);
    }
    /// The next frame's bytes; nothing if the other side hangs up, or says that it will.
    std::string next(const Line& line) {
        const auto has = [&](std::size_t size) {
            while (heard_.size() < size) {
                const std::string more = line.hear_some();
                if (more.empty()) return false;
                heard_ += more;
            }
            return true;
        };
        if (!has(2) || heard_[0] != '\x82') return "";
        std::size_t head = 2;
        std::uint64_t size = number_of(heard_.substr(1, 1));
        if (size >= 126) {
            const std::size_t bytes = size == 126 ? 2 : 8;
            head += bytes;
            if (!has(head)) return "";
            size = number_of(std::string_view(heard_).substr(2, bytes));
        }
        if (!has(head + size)) return "";
        const std::string frame = heard_.substr(head, size);
        heard_.erase(0, head + size);
        return frame;
    }
    /// The ends of so many answers, by their numbers. An answer that ends twice is a failure.
    std::map<std::uint32_t, Ended> ends(const Line& line, std::size_t count) {
        std::map<std::uint32_t, Ended> all;
        for (std::size_t ended = 0; ended < count;) {
            const std::string frame = next(line);
            if (frame.size() < 8) {
                ADD_FAILURE() << "the other side has hung up after " << ended << " answers";
                break;
            }
            const auto word = [&](std::size_t at) {
                std::string bytes = frame.substr(at, 4);
                return static_cast<std::uint32_t>(
                    number_of(std::string(bytes.rbegin(), bytes.rend())));
            };
            Ended& answer = all[word(0)];
            EXPECT_EQ(answer.status, 0U) << word(0);
            if (word(4) == 0) {
                answer.pieces += frame.substr(8);
                continue;
            }
            answer.status = word(4);
            answer.last = frame.substr(8);
            ++ended;
        }
        return all;
    }

    std::string heard_;
};

TEST_F(WebSocketTest, is_opened_for_the_studios_own_page_alone) {
    const std::string own = "http://" + host_;
    const auto opened = [&](const std::string& origin, const std::string& token) {
        const Line line(port_);
        line.say(hand_shake("/api/picture", origin, token));
        return line.hear("\r\n\r\n").substr(0, 12);
    };
    EXPECT_EQ(opened(own, token_), "HTTP/1.1 101");
    EXPECT_EQ(opened("http://evil.example", token_), "HTTP/1.1 403");
    EXPECT_EQ(opened("null", token_), "HTTP/1.1 403");
    EXPECT_EQ(opened(own, std::string(token_.size(), '0')), "HTTP/1.1 401");
    expect_alive();
}

TEST_F(WebSocketTest, answers_what_a_request_is_answered) {
    const Line line(port_);
    open(line, "/api/picture");
    line.say(frame_of(picture(test::tetra_scene, 40).dump()));
    const Ended answer = ends(line, 1)[1];
    EXPECT_EQ(answer.status, 200U);
    EXPECT_EQ(answer.last, "");
    const std::string whole = ask("POST /api/picture", picture(test::tetra_scene, 40).dump());
    const std::string body = whole.substr(whole.find("\r\n\r\n") + 4);
    // Behind the pixels are times, which differ.
    const std::size_t pixels = body.find("{\"") - 4;
    EXPECT_GT(pixels, 300U);
    EXPECT_EQ(answer.pieces.substr(0, pixels), body.substr(0, pixels));
    EXPECT_THAT(answer.pieces, HasSubstr("\"statistics\""));
}

TEST_F(WebSocketTest, refuses_what_a_request_is_refused_with_the_same_words) {
    const std::string wrong = scene("ifs a { }").dump();
    for (const std::string path : {"/api/picture", "/api/nothing"}) {
        for (const std::string& question : {std::string("{"), wrong}) {
            const Line line(port_);
            open(line, path);
            line.say(frame_of(question));
            const Ended answer = ends(line, 1)[1];
            const std::string whole = ask("POST " + path, question);
            EXPECT_EQ(whole.substr(9, 3), std::to_string(answer.status)) << path << question;
            EXPECT_EQ(answer.pieces + answer.last, whole.substr(whole.find("\r\n\r\n") + 4));
        }
    }
}

TEST_F(WebSocketTest, every_question_is_answered_once_however_many_there_are) {
    const Line line(port_);
    open(line, "/api/picture");
    constexpr std::size_t count = 200;
    for (std::size_t i = 0; i < count; ++i)
        line.say(frame_of(picture(test::tetra_scene, 8).dump()));
    const auto answers = ends(line, count);
    EXPECT_EQ(answers.size(), count);
    EXPECT_EQ(answers.begin()->first, 1U);
    EXPECT_EQ(answers.rbegin()->first, count);
    for (const auto& [number, answer] : answers)
        EXPECT_TRUE(answer.status == 200 || answer.status == 429) << answer.status;
}

TEST_F(WebSocketTest, hangs_up_on_what_is_no_question) {
    const std::string large = frame_of(std::string(3U << 20U, 'x'));
    const std::string unmasked = "\x81\x02{}", unknown = "\x8F\x80" + std::string(4, '\0');
    for (const std::string& bad : {large, unmasked, unknown}) {
        const Line line(port_);
        open(line, "/api/picture");
        line.say(bad);
        EXPECT_EQ(next(line), "");
    }
    expect_alive();
}

TEST_F(WebSocketTest, may_be_left_while_a_picture_is_rendered) {
    Json slow = picture(test::tetra_scene, 2048);
    slow["samples"] = 64;
    {
        const Line line(port_);
        open(line, "/api/picture");
        line.say(frame_of(slow.dump()));
        EXPECT_GT(next(line).size(), 8U);
    }
    EXPECT_THAT(ask("POST /api/picture", picture(test::tetra_scene, 8).dump()),
                HasSubstr("\"statistics\""));
}

}  // namespace
}  // namespace pxm::host
