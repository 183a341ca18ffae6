#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tools/serve/http_message.hpp"
#include "tools/serve/listen_socket.hpp"

namespace specula {

/// What a server does with requests that its guard let through.
struct HttpRoutes {
    /// Before the body arrives: a refusal, or nothing.
    std::function<std::optional<HttpResponse>(const HttpRequest&)> guard;
    /// An answer that is there already, or nothing: then it has to be worked out.
    std::function<std::optional<HttpResponse>(const HttpRequest&)> at_once;
    /// Called on threads of the server's own, several at a time. Does not throw.
    std::function<HttpResponse(const HttpRequest&)> worked_out;
};

/// An HTTP/1.1 server: one thread for all connections, a few for the work.
///
/// The one place that knows libmicrohttpd. Limits: 256 connections, 32 KiB of header, a body of
/// RequestGuard::most_body_bytes, 5 s without a byte, 10 s for a whole request, 60 s to take the answer, and a line of 8
/// requests that wait for work; who finds it full is told 503 and when to ask again.
class HttpServer {
  public:
    /// Serves from here on. Throws SystemError where the library cannot start.
    HttpServer(ListenSocket& socket_to_take, HttpRoutes routes, int work_threads);
    /// Answers what was taken, then closes all connections.
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

  private:
    struct Daemon;
    std::unique_ptr<Daemon> daemon_;
};

}  // namespace specula
