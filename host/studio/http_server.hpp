// Requests over HTTP/1.1 from this computer alone. Its .cpp, http_connection and web_socket alone
// know Boost.Beast, whose headers cost more to compile than the rest of the room.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "host/studio/http_message.hpp"

namespace pxm::host {

struct HttpLimits {
    std::size_t header_bytes = 16U << 10U;
    std::size_t body_bytes = 2U << 20U;
    int connections = 64;          // more are closed before they say anything
    int workers = 10;              // threads that answer
    double patience_seconds = 20;  // for a request to arrive whole, and for the next one
};

/// What is done with requests. Both may be called by any thread.
struct HttpGuests {
    /// Before the body is read: an answer if the request is refused.
    std::function<std::optional<HttpAnswer>(const HttpRequest&)> refuse;
    /// In a thread of its own, which may take its time. What is long is sent piece by piece; else
    /// it is returned. Must not throw.
    std::function<HttpAnswer(const HttpRequest&, HttpBody&)> answer;
};

/// Listens on 127.0.0.1, and on ::1 where there is that, from its beginning to its end.
class HttpServer {
  public:
    /// Port 0 is one that is free. Clients wait until start(). Throws Error(ErrorKind::failed) if
    /// it cannot listen.
    explicit HttpServer(int port, const HttpLimits& limits = {});
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;
    /// Waits for the answers that are being made.
    ~HttpServer();

    [[nodiscard]] int port() const;
    /// Once: from now on requests are answered.
    void start(HttpGuests guests);

  private:
    class Listening;
    std::unique_ptr<Listening> listening_;
};

}  // namespace pxm::host
