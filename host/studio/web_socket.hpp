// Questions and answers on one connection that stays open (RFC 6455), for a page that asks again
// and again: a browser takes four milliseconds for a request of HTTP, one for a message.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "host/studio/http_connection.hpp"

namespace pxm::host {

/// Opens the WebSocket that `head` asks for; `first` is the same request, which was let in. Each
/// message is answered as the body of a POST of JSON to the same path with the same fields: it
/// passes the same gate. The n-th message, from 1, is answered by messages of two numbers of four
/// bytes, lowest first, and bytes: n, 0 and a piece of the answer; n, the status and the answer's
/// body, which is empty after pieces, at the end. Several are answered at a time. Who asks more
/// than `most_asked` at a time is answered 429, who does not read what is sent is hung up on.
void serve_web_socket(boost::asio::ip::tcp::socket socket, HttpHouse& house, HttpRequest first,
                      boost::beast::http::request<boost::beast::http::string_body> head);

}  // namespace pxm::host
