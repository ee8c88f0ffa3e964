#include "host/studio/http_connection.hpp"

#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "host/studio/web_socket.hpp"

namespace pxm::host {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using asio::ip::tcp;

std::string text_of(beast::string_view view) { return {view.data(), view.size()}; }

/// One client, from the first request to the last. All but the answering is done by the one thread
/// that runs the io_context.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(tcp::socket socket, HttpHouse& house) : stream_(std::move(socket)), house_(house) {
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
        keep_alive_ = head.keep_alive() && !websocket::is_upgrade(head);
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
        if (websocket::is_upgrade(parser_->get()))
            return serve_web_socket(stream_.release_socket(), house_, std::move(request_),
                                    parser_->release());
        request_.body = std::move(parser_->get().body());
        stream_.expires_never();
        asio::post(house_.workers, [self = shared_from_this()] {
            WholeBody body;
            HttpAnswer answer = self->house_.guests.answer(self->request_, body);
            if (body.begun) answer = std::move(body.answer);
            asio::post(self->stream_.get_executor(), [self, answer = std::move(answer)]() mutable {
                self->write(std::move(answer));
            });
        });
    }

    /// Pieces, put together.
    struct WholeBody : public HttpBody {
        void begin(HttpAnswer head) override {
            answer = std::move(head);
            begun = true;
        }
        void send(std::string piece) override { answer.body += piece; }
        HttpAnswer answer;
        bool begun = false;
    };

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

    void fill_response(HttpAnswer answer) {
        held_ = std::move(answer.held);
        response_ = {};
        response_.version(11);
        response_.result(static_cast<unsigned>(answer.status));
        response_.set(http::field::content_type, answer.type);
        for (const auto& [name, value] : answer.fields) response_.insert(name, value);
        response_.keep_alive(keep_alive_ && !held_);
        response_.body() = std::move(answer.body);
    }

    template <class Then>
    void async_write_head(const Then& then) {
        serializer_.emplace(response_);
        stream_.expires_after(house_.patience());
        http::async_write_header(stream_, *serializer_, then);
    }

    void write(HttpAnswer answer) {
        fill_response(std::move(answer));
        const auto written = [self = shared_from_this()](beast::error_code error, std::size_t) {
            self->wrote(error);
        };
        if (held_) return async_write_head(written);
        response_.prepare_payload();
        serializer_.emplace(response_);
        stream_.expires_after(house_.patience());
        http::async_write(stream_, *serializer_, written);
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
    HttpHouse& house_;
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

}  // namespace

void serve(tcp::socket socket, HttpHouse& house) {
    std::make_shared<Connection>(std::move(socket), house)->read();
}

}  // namespace pxm::host
