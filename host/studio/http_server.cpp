#include "host/studio/http_server.hpp"

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "host/error.hpp"

namespace pxm::host {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;

/// What all connections share.
struct House {
    HttpGuests guests;
    HttpLimits limits;
    asio::thread_pool workers;
    std::atomic<int> connections = 0;

    explicit House(const HttpLimits& l) : limits(l), workers(static_cast<std::size_t>(l.workers)) {}
    [[nodiscard]] std::chrono::milliseconds patience() const {
        return std::chrono::milliseconds(static_cast<long>(limits.patience_seconds * 1000));
    }
};

std::string text_of(beast::string_view view) { return {view.data(), view.size()}; }

/// One client, from the first request to the last. All but the answering is done by the one thread
/// that runs the io_context.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(tcp::socket socket, House& house) : stream_(std::move(socket)), house_(house) {
        ++house_.connections;
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() { --house_.connections; }

    void read() {
        parser_.emplace();
        parser_->header_limit(static_cast<std::uint32_t>(house_.limits.header_bytes));
        parser_->body_limit(house_.limits.body_bytes);
        stream_.expires_after(house_.patience());
        http::async_read_header(stream_, buffer_, *parser_,
                                [self = shared_from_this()](beast::error_code error, std::size_t) {
                                    self->got_head(error);
                                });
    }

  private:
    void got_head(beast::error_code error) {
        if (error) return refuse_broken(error);
        const auto& head = parser_->get();
        request_ = {};
        request_.method = text_of(head.method_string());
        const std::string target = text_of(head.target());
        const std::size_t mark = target.find('?');
        request_.path = target.substr(0, mark);
        if (mark != std::string::npos) request_.query = target.substr(mark + 1);
        for (const auto& field : head)
            request_.fields.emplace_back(text_of(field.name_string()), text_of(field.value()));
        keep_alive_ = head.keep_alive();
        if (auto refusal = house_.guests.refuse(request_)) {
            keep_alive_ = keep_alive_ && parser_->is_done();
            return write(std::move(*refusal));
        }
        http::async_read(
            stream_, buffer_, *parser_,
            [self = shared_from_this()](beast::error_code e, std::size_t) { self->got_all(e); });
    }

    void got_all(beast::error_code error) {
        if (error) return refuse_broken(error);
        request_.body = std::move(parser_->get().body());
        stream_.expires_never();
        asio::post(house_.workers, [self = shared_from_this()] {
            HttpAnswer answer = self->house_.guests.answer(self->request_);
            asio::post(self->stream_.get_executor(), [self, answer = std::move(answer)]() mutable {
                self->write(std::move(answer));
            });
        });
    }

    /// Says what is wrong where that can still be read, and hangs up.
    void refuse_broken(beast::error_code error) {
        keep_alive_ = false;
        if (error == http::error::body_limit)
            return write({413, "text/plain; charset=utf-8", "the request is too large\n"});
        if (error == http::error::header_limit || error == http::error::buffer_overflow)
            return write({431, "text/plain; charset=utf-8", "the request's head is too large\n"});
        if (error.category() == http::make_error_code(http::error::bad_method).category() &&
            error != http::error::end_of_stream && error != http::error::partial_message)
            return write({400, "text/plain; charset=utf-8", "that is no request\n"});
        hang_up();
    }

    void write(HttpAnswer answer) {
        held_ = std::move(answer.held);
        response_ = {};
        response_.version(11);
        response_.result(static_cast<unsigned>(answer.status));
        response_.set(http::field::content_type, answer.type);
        for (const auto& [name, value] : answer.fields) response_.insert(name, value);
        response_.keep_alive(keep_alive_ && !held_);
        response_.body() = std::move(answer.body);
        if (!held_) response_.prepare_payload();
        serializer_.emplace(response_);
        stream_.expires_after(house_.patience());
        const auto written = [self = shared_from_this()](beast::error_code error, std::size_t) {
            self->wrote(error);
        };
        if (held_) {
            http::async_write_header(stream_, *serializer_, written);
        } else {
            http::async_write(stream_, *serializer_, written);
        }
    }

    void wrote(beast::error_code error) {
        serializer_.reset();
        if (error) return hang_up();
        if (held_) return wait_for_the_end();
        if (!keep_alive_) return see_off();
        response_ = {};
        read();
    }

    /// Clients say nothing after a request whose answer does not end: what comes is their leaving.
    void wait_for_the_end() {
        stream_.expires_never();
        stream_.async_read_some(asio::buffer(rest_),
                                [self = shared_from_this()](beast::error_code, std::size_t) {
                                    self->held_.reset();
                                    self->hang_up();
                                });
    }

    /// Takes a little more of what is being sent, or the answer would be lost with it.
    void see_off() {
        beast::error_code ignored;
        stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        stream_.expires_after(std::chrono::seconds(1));
        drain();
    }
    void drain() {
        constexpr std::size_t most = 4U << 20U;
        stream_.async_read_some(asio::buffer(rest_),
                                [self = shared_from_this()](beast::error_code e, std::size_t n) {
                                    self->drained_ += n;
                                    if (e || self->drained_ > most) return self->hang_up();
                                    self->drain();
                                });
    }

    void hang_up() {
        beast::error_code ignored;
        stream_.socket().close(ignored);
    }

    beast::tcp_stream stream_;
    House& house_;
    beast::flat_buffer buffer_{256U << 10U};  // of what was received and not yet understood
    std::optional<http::request_parser<http::string_body>> parser_;
    HttpRequest request_;
    http::response<http::string_body> response_;
    std::optional<http::response_serializer<http::string_body>> serializer_;
    std::shared_ptr<void> held_;
    std::array<char, 4096> rest_{};
    std::size_t drained_ = 0;
    bool keep_alive_ = false;
};

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
        door.async_accept([this, &door](beast::error_code error, tcp::socket socket) {
            if (!error && house_.connections < house_.limits.connections)
                std::make_shared<Connection>(std::move(socket), house_)->read();
            if (error == asio::error::no_descriptors)
                std::this_thread::sleep_for(std::chrono::milliseconds(20));
            if (error != asio::error::operation_aborted) open(door);
        });
    }

    // The connections that the context holds are gone before what they share.
    House house_;
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
