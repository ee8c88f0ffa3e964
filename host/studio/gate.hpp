// Who is let in. A server on the loopback address is reached by every page that the browser shows
// and by every program of the computer: a request counts only if it knows the studio's token, was
// meant for this studio, and comes from its own page.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "host/studio/http_message.hpp"
#include "host/studio/rate.hpp"

namespace pxm::host {

class Gate {
  public:
    explicit Gate(int port);

    /// The answer to a request that is not let in: another method than GET and POST (405), another
    /// host than this one (403), from another page (403), with no JSON (415), without the token
    /// (401), or one too many (429).
    [[nodiscard]] std::optional<HttpAnswer> refusal(const HttpRequest& request);

    /// Whether the request asks for the page with the token in the address: its answer sets the
    /// cookie.
    [[nodiscard]] bool enters(const HttpRequest& request) const;
    /// The header line that makes the browser keep the token: for this host, out of reach of
    /// scripts, and never sent along from other sites.
    [[nodiscard]] HttpField cookie() const;

    /// What is said in every answer: load nothing from elsewhere, run no script but the page's own,
    /// show in no other page, keep no copy.
    [[nodiscard]] std::vector<HttpField> guarding_fields() const;

    /// The address to be shown to the user.
    [[nodiscard]] std::string address() const;
    /// One to be handed to the browser, which others may see on its command line: it lets in once.
    [[nodiscard]] std::string address_for_once() const;

  private:
    [[nodiscard]] std::optional<HttpAnswer> judge(const HttpRequest& request);
    [[nodiscard]] bool is_own_host(const std::string& host) const;
    [[nodiscard]] bool comes_from_elsewhere(const HttpRequest& request) const;
    [[nodiscard]] bool has_cookie(const HttpRequest& request) const;
    [[nodiscard]] bool uses_address(const HttpRequest& request);

    int port_;
    std::string token_;
    mutable std::mutex mutex_;
    std::string once_;     // empty once it was used
    std::string entered_;  // the code that was used, for enters()
    Rate rate_{400, 1200};
};

}  // namespace pxm::host
