#include "host/studio/http_server.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <chrono>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

#include "host/error.hpp"
#include "host/studio/http_connection.hpp"

namespace pxm::host {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

tcp::acceptor listen_at(asio::io_context& context, const tcp::endpoint& place) {
    tcp::acceptor acceptor(context, place.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    if (place.protocol() == tcp::v6()) acceptor.set_option(asio::ip::v6_only(true));
    acceptor.bind(place);
    acceptor.listen(asio::socket_base::max_listen_connections);
    return acceptor;
}

}  // namespace

class HttpServer::Listening {
  public:
    Listening(int port, const HttpLimits& limits) : house_(limits) {
        const auto number = static_cast<std::uint16_t>(port);
        try {
            doors_.push_back(listen_at(context_, {asio::ip::address_v4::loopback(), number}));
        } catch (const boost::system::system_error& error) {
            throw Error(ErrorKind::failed, "cannot listen on 127.0.0.1:" + std::to_string(port) +
                                               ": " + error.code().message());
        }
        port_ = doors_.front().local_endpoint().port();
        try {
            doors_.push_back(listen_at(context_, {asio::ip::address_v6::loopback(), port_}));
        } catch (const boost::system::system_error&) {
            // A computer without IPv6, or another program on that port of it.
        }
    }
    Listening(const Listening&) = delete;
    Listening& operator=(const Listening&) = delete;
    ~Listening() {
        context_.stop();
        if (thread_.joinable()) thread_.join();
        house_.workers.join();
    }
    [[nodiscard]] int port() const { return port_; }
    void start(HttpGuests guests) {
        house_.guests = std::move(guests);
        for (tcp::acceptor& door : doors_) open(door);
        thread_ = std::thread([this] { context_.run(); });
    }

  private:
    void open(tcp::acceptor& door) {
        door.async_accept([this, &door](boost::system::error_code error, tcp::socket socket) {
            boost::system::error_code ignored;
            // Else the end of an answer waits for the receipt of what went before.
            if (!error) socket.set_option(tcp::no_delay(true), ignored);
            if (!error && house_.connections < house_.limits.connections)
                serve(std::move(socket), house_);
            if (error == asio::error::no_descriptors)
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            if (error != asio::error::operation_aborted) open(door);
        });
    }

    // The connections that the context holds are gone before what they share.
    HttpHouse house_;
    asio::io_context context_{1};
    std::vector<tcp::acceptor> doors_;
    std::uint16_t port_ = 0;
    std::thread thread_;
};

HttpServer::HttpServer(int port, const HttpLimits& limits)
    : listening_(std::make_unique<Listening>(port, limits)) {}

HttpServer::~HttpServer() = default;

int HttpServer::port() const { return listening_->port(); }

void HttpServer::start(HttpGuests guests) { listening_->start(std::move(guests)); }

}  // namespace pxm::host
