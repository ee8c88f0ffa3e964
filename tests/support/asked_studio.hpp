// A studio that is asked over real sockets, with a scene in its folder and a file outside of it.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host/studio/studio.hpp"
#include "tests/support/command.hpp"
#include "tests/support/folder.hpp"

namespace pxm::test {

/// A connection to the loopback address; closed with it.
class Line {
  public:
    explicit Line(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        const timeval patience{20, 0};
        setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_port = htons(static_cast<std::uint16_t>(port));
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        connected_ =
            ::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
    }
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;
    ~Line() { ::close(socket_); }

    [[nodiscard]] bool connected() const { return connected_; }
    /// False once the other side has hung up.
    bool say(const std::string& text) const {
        return ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) ==
               static_cast<ssize_t>(text.size());
    }
    /// What has come, at least a byte; nothing once the other side has hung up.
    [[nodiscard]] std::string hear_some() const {
        char buffer[65536];
        const ssize_t count = ::recv(socket_, buffer, sizeof buffer, 0);
        return {buffer, count > 0 ? static_cast<std::size_t>(count) : 0};
    }
    /// What comes until the other side hangs up, or until it holds `until`.
    [[nodiscard]] std::string hear(const std::string& until = "") const {
        std::string heard;
        char buffer[4096];
        while (until.empty() || heard.find(until) == std::string::npos) {
            const ssize_t count = ::recv(socket_, buffer, sizeof buffer, 0);
            if (count <= 0) break;
            heard.append(buffer, static_cast<std::size_t>(count));
        }
        return heard;
    }

  private:
    int socket_;
    bool connected_ = false;
};

class StudioTest : public testing::Test {
  protected:
    explicit StudioTest(double seconds = host::asked_seconds) {
        folder_.write("a.pxm", tetra_scene);
        outside_.write("secret.pxm", "the secret");
        host::StudioSettings settings;
        settings.folder = folder_.path();
        settings.seconds = seconds;
        studio_ = std::make_unique<host::Studio>(settings);
        const std::string address = studio_->address();
        const std::size_t mark = address.find("/?token=");
        host_ = address.substr(7, mark - 7);
        token_ = address.substr(mark + 8);
        port_ = std::stoi(host_.substr(host_.find(':') + 1));
    }

    using Json = nlohmann::ordered_json;

    [[nodiscard]] std::string head(const std::string& first, std::size_t length) const {
        return first + " HTTP/1.1\r\nHost: " + host_ + "\r\nOrigin: http://" + host_ +
               "\r\nContent-Type: application/json\r\nCookie: pxm_studio_" + std::to_string(port_) +
               "=" + token_ + "\r\nContent-Length: " + std::to_string(length) +
               "\r\nConnection: close\r\n\r\n";
    }
    /// The whole answer.
    [[nodiscard]] std::string ask(const std::string& first, const std::string& body = "") const {
        const Line line(port_);
        line.say(head(first, body.size()) + body);
        return line.hear();
    }
    [[nodiscard]] Json answer(const std::string& first, const Json& question) const {
        const std::string heard = ask(first, question.dump());
        return Json::parse(heard.substr(heard.find("\r\n\r\n") + 4), nullptr, false);
    }
    [[nodiscard]] Json scene(const std::string& text) {
        return {{"view", "test-a"}, {"serial", ++serial_}, {"name", "a.pxm"}, {"text", text}};
    }
    [[nodiscard]] Json picture(const std::string& text, long side) {
        Json json = scene(text);
        json.update({{"columns", side}, {"rows", side}, {"samples", 1}, {"machine", ""}});
        return json;
    }
    void expect_alive() const { EXPECT_TRUE(ask("GET /api/start").starts_with("HTTP/1.1 200 OK")); }

    Folder folder_;
    Folder outside_;
    std::unique_ptr<host::Studio> studio_;
    std::string host_;
    std::string token_;
    int port_ = 0;
    int serial_ = 0;
};

}  // namespace pxm::test
