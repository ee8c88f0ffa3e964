// One client of the server, from its first request to its last.
#pragma once

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/thread_pool.hpp>
#include <chrono>
#include <cstddef>

#include "host/studio/http_server.hpp"

namespace pxm::host {

/// What all connections share.
struct HttpHouse {
    HttpGuests guests;
    HttpLimits limits;
    boost::asio::thread_pool workers;
    std::atomic<int> connections = 0;

    explicit HttpHouse(const HttpLimits& l)
        : limits(l), workers(static_cast<std::size_t>(l.workers)) {}
    [[nodiscard]] std::chrono::milliseconds patience() const {
        return std::chrono::milliseconds(static_cast<long>(limits.patience_seconds * 1000));
    }
};

/// Answers what the client asks until one of both hangs up. The house must outlive the context of
/// the socket.
void serve(boost::asio::ip::tcp::socket socket, HttpHouse& house);

}  // namespace pxm::host
