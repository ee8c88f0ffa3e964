#include "host/studio/web_socket.hpp"

#include <array>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <utility>

namespace pxm::host {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using asio::ip::tcp;

constexpr int most_asked = 32;                    // that are not answered yet
constexpr std::size_t most_unsent = 256U << 20U;  // bytes
constexpr std::uint32_t piece_of_an_answer = 0;   // instead of a status
constexpr int status_of_too_many = 429;

/// All but the answering is done by the one thread that runs the io_context.
class WebSocket : public std::enable_shared_from_this<WebSocket> {
  public:
    WebSocket(tcp::socket socket, HttpHouse& house, HttpRequest first)
        : stream_(std::move(socket)), house_(house), asked_(std::move(first)) {
        ++house_.connections;
        asked_.method = "POST";
        asked_.fields.emplace_back("Content-Type", "application/json");
    }
    WebSocket(const WebSocket&) = delete;
    WebSocket& operator=(const WebSocket&) = delete;
    ~WebSocket() { --house_.connections; }

    void open(beast::http::request<beast::http::string_body> head) {
        stream_.set_option(websocket::stream_base::timeout{house_.patience(),
                                                           websocket::stream_base::none(), false});
        stream_.read_message_max(house_.limits.body_bytes);
        stream_.binary(true);
        stream_.auto_fragment(false);  // a message goes as it lies there
        head_ = std::move(head);
        stream_.async_accept(head_, [self = shared_from_this()](beast::error_code error) {
            if (!error) self->read();
        });
    }

  private:
    struct Message {
        std::array<std::uint32_t, 2> numbers;  // of the question, and what this is
        std::string bytes;
    };

    /// Hands pieces from the threads that make them to the one that writes.
    struct Pieces : public HttpBody {
        Pieces(WebSocket& s, std::uint32_t n) : socket(s), number(n) {}
        void begin(HttpAnswer /*head*/) override { begun = true; }
        void send(std::string bytes) override {
            socket.post({{number, piece_of_an_answer}, std::move(bytes)});
        }
        WebSocket& socket;
        std::uint32_t number;
        bool begun = false;
    };

    void read() {
        stream_.async_read(buffer_,
                           [self = shared_from_this()](beast::error_code error, std::size_t) {
                               if (error) return self->hang_up();
                               self->got_message();
                               self->read();
                           });
    }

    void got_message() {
        const std::uint32_t number = ++count_;
        HttpRequest request = asked_;
        request.body = beast::buffers_to_string(buffer_.data());
        buffer_.consume(buffer_.size());
        if (under_way_ >= most_asked)
            return add({{number, status_of_too_many}, "too many questions at a time\n"});
        if (const auto refusal = house_.guests.refuse(request))
            return add({{number, static_cast<std::uint32_t>(refusal->status)}, refusal->body});
        ++under_way_;
        asio::post(house_.workers, [self = shared_from_this(), number,
                                    request = std::move(request)] {
            Pieces pieces(*self, number);
            HttpAnswer answer = self->house_.guests.answer(request, pieces);
            if (pieces.begun) answer = {};
            self->post(
                {{number, static_cast<std::uint32_t>(answer.status)}, std::move(answer.body)}, 1);
        });
    }

    /// From any thread. `ended`: how many answers end with it.
    void post(Message message, int ended = 0) {
        asio::post(stream_.get_executor(),
                   [self = shared_from_this(), ended, message = std::move(message)]() mutable {
                       self->under_way_ -= ended;
                       self->add(std::move(message));
                   });
    }

    void add(Message message) {
        if (!stream_.is_open()) return;
        unsent_ += message.bytes.size();
        if (unsent_ > most_unsent) return hang_up();
        messages_.push_back(std::move(message));
        if (messages_.size() == 1) write();
    }

    void write() {
        const Message& message = messages_.front();
        const std::array<asio::const_buffer, 2> parts{asio::buffer(message.numbers),
                                                      asio::buffer(message.bytes)};
        stream_.async_write(parts,
                            [self = shared_from_this()](beast::error_code error, std::size_t) {
                                if (error) return self->hang_up();
                                self->unsent_ -= self->messages_.front().bytes.size();
                                self->messages_.pop_front();
                                if (!self->messages_.empty()) self->write();
                            });
    }

    void hang_up() {
        beast::error_code ignored;
        stream_.next_layer().close(ignored);
    }

    websocket::stream<tcp::socket> stream_;
    HttpHouse& house_;
    HttpRequest asked_;  // but for its body
    beast::http::request<beast::http::string_body> head_;
    beast::flat_buffer buffer_;
    std::uint32_t count_ = 0;       // of messages that were read
    int under_way_ = 0;             // answers
    std::deque<Message> messages_;  // that are to be written; the first is being written
    std::size_t unsent_ = 0;        // bytes of them
};

}  // namespace

void serve_web_socket(tcp::socket socket, HttpHouse& house, HttpRequest first,
                      beast::http::request<beast::http::string_body> head) {
    std::make_shared<WebSocket>(std::move(socket), house, std::move(first))->open(std::move(head));
}

}  // namespace pxm::host
