#include "host/studio/gate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "host/studio/token.hpp"

namespace pxm::host {

namespace {

HttpAnswer refused(int status, const std::string& why) {
    return {status, "text/plain; charset=utf-8", why + "\n"};
}

}  // namespace

Gate::Gate(int port) : port_(port), token_(random_token()), once_(random_token()) {}

// Not every browser takes 'self' for its WebSockets too. No source can name an address of IPv6.
std::vector<HttpField> Gate::guarding_fields() const {
    return {{"Content-Security-Policy",
             fmt::format("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
                         "connect-src 'self' ws://127.0.0.1:{0} ws://localhost:{0}; "
                         "form-action 'none'; frame-ancestors 'none'; base-uri 'none'",
                         port_)},
            {"X-Content-Type-Options", "nosniff"},
            {"X-Frame-Options", "DENY"},
            {"Cross-Origin-Resource-Policy", "same-origin"},
            {"Cross-Origin-Opener-Policy", "same-origin"},
            {"Referrer-Policy", "no-referrer"},
            {"Cache-Control", "no-store"}};
}

std::optional<HttpAnswer> Gate::refusal(const HttpRequest& request) {
    std::optional<HttpAnswer> answer = judge(request);
    if (answer) answer->fields = guarding_fields();
    return answer;
}

std::optional<HttpAnswer> Gate::judge(const HttpRequest& request) {
    if (request.method != "GET" && request.method != "POST")
        return refused(405, "GET and POST alone are answered");
    if (!is_own_host(field_of(request, "Host")))
        return refused(403, "this is the studio of another address");
    const bool by_address = uses_address(request);
    if (comes_from_elsewhere(request) && !by_address)
        return refused(403, "pages of other sites are not answered");
    if (request.method == "POST") {
        if (field_of(request, "Origin").empty())
            return refused(403, "a request that changes something says where it is from");
        if (field_of(request, "Content-Type") != "application/json")
            return refused(415, "expected application/json");
    }
    if (!by_address && !has_cookie(request))
        return refused(401, "Open the address that pxm studio printed: it has the token.");
    // Strangers are refused at no cost, and do not use up what the page may ask.
    if (!rate_.take()) return refused(429, "too many requests");
    return std::nullopt;
}

bool Gate::is_own_host(const std::string& host) const {
    return host == fmt::format("127.0.0.1:{}", port_) ||
           host == fmt::format("localhost:{}", port_) || host == fmt::format("[::1]:{}", port_);
}

bool Gate::comes_from_elsewhere(const HttpRequest& request) const {
    if (fields_of(request, "Origin") > 0 &&
        field_of(request, "Origin") != "http://" + field_of(request, "Host"))
        return true;
    if (fields_of(request, "Sec-Fetch-Site") == 0) return false;
    const std::string site = field_of(request, "Sec-Fetch-Site");
    return site != "same-origin" && site != "none";
}

bool Gate::has_cookie(const HttpRequest& request) const {
    if (fields_of(request, "Cookie") != 1) return false;
    const std::string name = fmt::format("pxm_studio_{}=", port_);
    const std::string cookies = field_of(request, "Cookie");
    std::string_view rest = cookies;
    while (!rest.empty()) {
        std::string_view one = rest.substr(0, rest.find(';'));
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        one.remove_prefix(std::min(one.size(), one.find_first_not_of(' ')));
        if (one.starts_with(name) && same_token(one.substr(name.size()), token_)) return true;
    }
    return false;
}

bool Gate::uses_address(const HttpRequest& request) {
    if (request.method != "GET" || request.path != "/") return false;
    // A link may be followed from anywhere; an image or a script of another page may not.
    const std::string mode = field_of(request, "Sec-Fetch-Mode");
    if (!mode.empty() && mode != "navigate") return false;
    if (same_token(query_value(request.query, "token"), token_)) return true;
    const std::string code = query_value(request.query, "once");
    const std::lock_guard lock(mutex_);
    if (once_.empty() || !same_token(code, once_)) return false;  // it was used, or is another
    entered_ = std::exchange(once_, "");
    return true;
}

bool Gate::enters(const HttpRequest& request) const {
    if (same_token(query_value(request.query, "token"), token_)) return true;
    const std::lock_guard lock(mutex_);
    return !entered_.empty() && same_token(query_value(request.query, "once"), entered_);
}

HttpField Gate::cookie() const {
    return {"Set-Cookie",
            fmt::format("pxm_studio_{}={}; Path=/; HttpOnly; SameSite=Strict", port_, token_)};
}

std::string Gate::address() const {
    return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
}

std::string Gate::address_for_once() const {
    const std::lock_guard lock(mutex_);
    return fmt::format("http://127.0.0.1:{}/?once={}", port_, once_);
}

}  // namespace pxm::host
