// The laws of host/studio/gate.hpp: what is let in knows the token, was meant for this studio, and
// comes from its own page.
#include "host/studio/gate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "host/studio/http_message.hpp"
#include "host/studio/rate.hpp"
#include "host/studio/token.hpp"

namespace pxm::host {
namespace {

constexpr int port = 4711;

std::string after(const std::string& text, const std::string& mark) {
    return text.substr(text.find(mark) + mark.size());
}

std::string token_of(const Gate& gate) { return after(gate.address(), "?token="); }

/// What the studio's own page asks.
HttpRequest own_question(const Gate& gate) {
    return {"POST",
            "/api/check",
            "",
            {{"Host", "127.0.0.1:4711"},
             {"Origin", "http://127.0.0.1:4711"},
             {"Sec-Fetch-Site", "same-origin"},
             {"Content-Type", "application/json"},
             {"Cookie", "other=1; pxm_studio_4711=" + token_of(gate)}},
            "{}"};
}

HttpRequest with(HttpRequest request, const std::string& name, const std::string& value) {
    for (HttpField& field : request.fields)
        if (field.first == name) field.second = value;
    return request;
}

HttpRequest without(HttpRequest request, const std::string& name) {
    std::erase_if(request.fields, [&](const HttpField& field) { return field.first == name; });
    return request;
}

/// 0 if it is let in.
int status(Gate& gate, const HttpRequest& request) {
    const auto refusal = gate.refusal(request);
    return refusal ? refusal->status : 0;
}

TEST(Gate, lets_its_own_page_in) {
    Gate gate(port);
    EXPECT_EQ(status(gate, own_question(gate)), 0);
    EXPECT_EQ(status(gate, without(own_question(gate), "Sec-Fetch-Site")), 0)
        << "a browser may not say where a request comes from";
}

TEST(Gate, wants_the_token) {
    Gate gate(port);
    const HttpRequest own = own_question(gate);
    EXPECT_EQ(status(gate, without(own, "Cookie")), 401);
    for (const std::string& wrong : {std::string(32, '0'), std::string(), token_of(Gate(port)),
                                     token_of(gate).substr(1), token_of(gate) + "0"}) {
        EXPECT_EQ(status(gate, with(own, "Cookie", "pxm_studio_4711=" + wrong)), 401) << wrong;
    }
    EXPECT_EQ(status(gate, with(own, "Cookie", "pxm_studio_4712=" + token_of(gate))), 401)
        << "the cookie of a studio at another port";
    HttpRequest twice = own;
    twice.fields.emplace_back("Cookie", "pxm_studio_4711=" + token_of(gate));
    EXPECT_EQ(status(gate, twice), 401);
}

TEST(Gate, is_meant_by_its_own_address) {
    Gate gate(port);
    for (const char* host : {"localhost:4711", "[::1]:4711"}) {
        EXPECT_EQ(status(gate, with(with(own_question(gate), "Host", host), "Origin",
                                    "http://" + std::string(host))),
                  0)
            << host;
    }
    for (const char* host :
         {"evil.example:4711", "127.0.0.1", "127.0.0.1:4712", "127.0.0.1.evil.example:4711",
          "localhost", "", "0.0.0.0:4711", "127.0.0.1:4711, evil.example"}) {
        EXPECT_EQ(status(gate, with(own_question(gate), "Host", host)), 403)
            << host << ": a name of somebody else's that leads here";
    }
    HttpRequest twice = own_question(gate);
    twice.fields.emplace_back("host", "evil.example");
    EXPECT_EQ(status(gate, twice), 403);
}

TEST(Gate, answers_no_other_site) {
    Gate gate(port);
    const HttpRequest own = own_question(gate);
    for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:4711",
                               "http://127.0.0.1:4712", "http://localhost:4711", ""}) {
        EXPECT_EQ(status(gate, with(own, "Origin", origin)), 403) << origin;
    }
    EXPECT_EQ(status(gate, without(own, "Origin")), 403);
    for (const char* site : {"cross-site", "same-site", "x"})
        EXPECT_EQ(status(gate, with(own, "Sec-Fetch-Site", site)), 403) << site;
    // Forms of other sites can send these without asking.
    for (const char* type : {"text/plain", "application/x-www-form-urlencoded", ""})
        EXPECT_EQ(status(gate, with(own, "Content-Type", type)), 415) << type;
}

TEST(Gate, knows_two_methods) {
    Gate gate(port);
    for (const char* method : {"OPTIONS", "PUT", "DELETE", "HEAD", "TRACE", "CONNECT", "X"}) {
        HttpRequest request = own_question(gate);
        request.method = method;
        EXPECT_EQ(status(gate, request), 405) << method;
    }
}

HttpRequest visit(const std::string& address, const std::string& site, const std::string& mode) {
    return {"GET",
            "/",
            after(address, "?"),
            {{"Host", "127.0.0.1:4711"}, {"Sec-Fetch-Site", site}, {"Sec-Fetch-Mode", mode}},
            ""};
}

TEST(Gate, is_entered_by_its_address_from_anywhere_and_from_no_page) {
    Gate gate(port);
    EXPECT_EQ(status(gate, visit(gate.address(), "none", "navigate")), 0);
    EXPECT_EQ(status(gate, visit(gate.address(), "cross-site", "navigate")), 0) << "a link";
    EXPECT_TRUE(gate.enters(visit(gate.address(), "none", "navigate")));
    EXPECT_EQ(status(gate, visit(gate.address(), "cross-site", "no-cors")), 403) << "an image";
    EXPECT_NE(gate.cookie().second.find("HttpOnly"), std::string::npos);
    EXPECT_NE(gate.cookie().second.find("SameSite=Strict"), std::string::npos);
    HttpRequest elsewhere = visit(gate.address(), "none", "navigate");
    elsewhere.path = "/api/start";
    EXPECT_EQ(status(gate, elsewhere), 401) << "the token in an address opens the page alone";
}

TEST(Gate, is_entered_once_by_the_address_that_others_may_see) {
    Gate gate(port);
    const std::string address = gate.address_for_once();
    EXPECT_EQ(address.find(token_of(gate)), std::string::npos);
    EXPECT_EQ(status(gate, visit(address, "none", "navigate")), 0);
    EXPECT_TRUE(gate.enters(visit(address, "none", "navigate")));
    EXPECT_EQ(status(gate, visit(address, "none", "navigate")), 401);
    EXPECT_EQ(status(gate, visit("http://127.0.0.1:4711/?once=", "none", "navigate")), 401);
}

TEST(Gate, is_shut_to_a_crowd) {
    Gate gate(port);
    int shut = 0;
    for (int i = 0; i < 5000; ++i)
        if (status(gate, own_question(gate)) == 429) ++shut;
    EXPECT_GT(shut, 2000);
}

TEST(Rate, fills_steadily_to_its_brim) {
    const Rate::Clock::time_point start{};
    const auto at = [&](double seconds) {
        return start + std::chrono::duration_cast<Rate::Clock::duration>(
                           std::chrono::duration<double>(seconds));
    };
    Rate rate(10, 3, start);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(rate.take(start));
    EXPECT_FALSE(rate.take(start));
    EXPECT_FALSE(rate.take(at(0.09)));
    EXPECT_TRUE(rate.take(at(0.11)));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(rate.take(at(1000)));
    EXPECT_FALSE(rate.take(at(1000)));
    EXPECT_FALSE(rate.take(at(999))) << "a clock that goes back gives nothing";
}

TEST(Token, has_128_bits_that_nobody_has_seen) {
    const std::string a = random_token(), b = random_token();
    EXPECT_EQ(a.size(), 32U);
    EXPECT_EQ(a.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_NE(a, b);
    EXPECT_TRUE(same_token(a, a));
    EXPECT_FALSE(same_token(a, b));
    EXPECT_FALSE(same_token(a, ""));
}

}  // namespace
}  // namespace pxm::host
