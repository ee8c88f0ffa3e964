// What a page asks and what it is answered, whatever library carries it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pxm::host {

using HttpField = std::pair<std::string, std::string>;  // a header line: name, value

struct HttpRequest {
    std::string method;
    std::string path;   // from the first '/' to the '?', as it was sent
    std::string query;  // what follows the '?'
    std::vector<HttpField> fields;
    std::string body;
};

struct HttpAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::string body = {};
    std::vector<HttpField> fields = {};
    /// If there is one, the answer has no end: it is let go when the client hangs up.
    std::shared_ptr<void> held = {};
};

/// An answer that is made in pieces. On a WebSocket each is sent at once, as the answer to a
/// request they are put together. For the thread that answers, and for those that it works with.
class HttpBody {
  public:
    virtual ~HttpBody() = default;
    /// Once, before anything else: all but the body. What the guest returns afterwards is ignored.
    virtual void begin(HttpAnswer head) = 0;
    /// A piece, not empty. One thread at a time.
    virtual void send(std::string piece) = 0;
};

/// The value of a header line that stands there once, in whatever case; empty if it is not there
/// or there several times.
[[nodiscard]] std::string field_of(const HttpRequest& request, std::string_view name);
/// How often the line is there.
[[nodiscard]] std::size_t fields_of(const HttpRequest& request, std::string_view name);

/// A value of a query `a=1&b=2`; empty if it is not there. Nothing is decoded: what pxm's page asks
/// with needs no escapes.
[[nodiscard]] std::string query_value(std::string_view query, std::string_view name);

}  // namespace pxm::host
