#include "tools/serve/http_server.hpp"

#include <microhttpd.h>
#include <unistd.h>

#include <array>
#include <atomic>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/serve/connection_watch.hpp"
#include "tools/serve/request_guard.hpp"
#include "tools/serve/work_queue.hpp"

namespace specula {

namespace {

constexpr unsigned most_connections = 256;
constexpr std::size_t most_header_bytes = 32 * 1024;
constexpr unsigned idle_s = 5;
constexpr std::chrono::seconds to_send_request{10};
constexpr std::chrono::seconds to_take_answer{60};  ///< a megabyte over a poor network
constexpr std::size_t most_waiting = 8;

/// One request on its way through.
struct Exchange {
    HttpRequest request;
    std::optional<HttpResponse> response;
    bool refused = false;  ///< answered before its body
    int socket = -1;
};

MHD_Result collect(void* into, MHD_ValueKind, const char* key, const char* value) {
    static_cast<std::vector<std::pair<std::string, std::string>>*>(into)->emplace_back(
        key, value == nullptr ? "" : value);
    return MHD_YES;
}

int socket_of(MHD_Connection* connection) {
    const MHD_ConnectionInfo* info =
        MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
    return info == nullptr ? -1 : info->connect_fd;
}

/// With every answer: nothing from elsewhere, no guessing of types, no frames, nothing kept.
constexpr std::array<std::pair<const char*, const char*>, 8> usual_headers{{
    {"Content-Security-Policy",
     "default-src 'self'; img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; "
     "frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"X-Frame-Options", "DENY"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cache-Control", "no-store"},
    {"Permissions-Policy", "camera=(), geolocation=(), microphone=()"},
}};

MHD_Result send(MHD_Connection* connection, const HttpResponse& answer) {
    MHD_Response* response = MHD_create_response_from_buffer(
        answer.body.size(), const_cast<char*>(answer.body.data()), MHD_RESPMEM_MUST_COPY);
    if (response == nullptr) return MHD_NO;
    MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, answer.type.c_str());
    for (const auto& [name, value] : usual_headers) MHD_add_response_header(response, name, value);
    for (const auto& [name, value] : answer.headers)
        MHD_add_response_header(response, name.c_str(), value.c_str());
    const MHD_Result queued =
        MHD_queue_response(connection, static_cast<unsigned>(answer.status), response);
    MHD_destroy_response(response);
    return queued;
}

HttpResponse busy() {
    HttpResponse answer =
        error_response(503, "the server has enough to do", "ask again in a second");
    answer.headers = {{"Retry-After", "1"}};
    return answer;
}

HttpResponse too_long() {
    return error_response(413, "the body is too long",
                          format("send at most {} bytes", RequestGuard::most_body_bytes));
}

bool announces_too_much(const HttpRequest& request) {
    for (const std::string& length : request.header("Content-Length")) {
        constexpr std::size_t most_digits = 9;
        if (length.size() > most_digits) return true;
        if (std::strtoul(length.c_str(), nullptr, 10) > RequestGuard::most_body_bytes) return true;
    }
    return false;
}

}  // namespace

struct HttpServer::Daemon {
    HttpRoutes routes;
    ConnectionWatch watch;
    std::unique_ptr<WorkQueue> work;
    MHD_Daemon* handle = nullptr;

    MHD_Result begin(MHD_Connection* connection, Exchange& exchange);
    MHD_Result take_body(Exchange& exchange, const char* data, std::size_t* size);
    MHD_Result answer(MHD_Connection* connection, Exchange& exchange);

    static MHD_Result on_request(void* self, MHD_Connection* connection, const char* path,
                                 const char* method, const char*, const char* data,
                                 std::size_t* size, void** place);
    static void on_end(void* self, MHD_Connection*, void** place, MHD_RequestTerminationCode);
    static void on_connection(void* self, MHD_Connection* connection, void**,
                              MHD_ConnectionNotificationCode code);
};

/// The header is here, the body is not.
MHD_Result HttpServer::Daemon::begin(MHD_Connection* connection, Exchange& exchange) {
    MHD_get_connection_values(connection, MHD_HEADER_KIND, collect, &exchange.request.headers);
    MHD_get_connection_values(connection, MHD_GET_ARGUMENT_KIND, collect, &exchange.request.query);
    exchange.socket = socket_of(connection);
    std::optional<HttpResponse> refusal = routes.guard(exchange.request);
    if (!refusal && announces_too_much(exchange.request)) refusal = too_long();
    if (!refusal) return MHD_YES;
    exchange.refused = true;
    return send(connection, *refusal);
}

MHD_Result HttpServer::Daemon::take_body(Exchange& exchange, const char* data, std::size_t* size) {
    // A body in chunks announces nothing; the library takes no answer in the middle of it.
    if (exchange.request.body.size() + *size > RequestGuard::most_body_bytes) return MHD_NO;
    exchange.request.body.append(data, *size);
    *size = 0;
    return MHD_YES;
}

/// The request is whole, or its answer has been worked out since.
MHD_Result HttpServer::Daemon::answer(MHD_Connection* connection, Exchange& exchange) {
    watch.limit(exchange.socket, to_take_answer);
    if (exchange.response) return send(connection, *exchange.response);
    if (const auto known = routes.at_once(exchange.request)) return send(connection, *known);
    watch.forget(exchange.socket);
    MHD_suspend_connection(connection);
    const bool taken = work->take([this, connection, &exchange] {
        exchange.response = routes.worked_out(exchange.request);
        MHD_resume_connection(connection);
    });
    if (!taken) {
        exchange.response = busy();
        MHD_resume_connection(connection);
    }
    return MHD_YES;
}

MHD_Result HttpServer::Daemon::on_request(void* self, MHD_Connection* connection, const char* path,
                                          const char* method, const char*, const char* data,
                                          std::size_t* size, void** place) {
    auto* daemon = static_cast<Daemon*>(self);
    try {
        if (*place == nullptr) {
            auto exchange = std::make_unique<Exchange>();
            exchange->request.method = method;
            exchange->request.path = path;
            *place = exchange.release();
            return daemon->begin(connection, *static_cast<Exchange*>(*place));
        }
        auto& exchange = *static_cast<Exchange*>(*place);
        if (*size > 0) return daemon->take_body(exchange, data, size);
        return daemon->answer(connection, exchange);
    } catch (const std::exception&) {  // out of memory: C cannot be thrown through
        return MHD_NO;
    }
}

void HttpServer::Daemon::on_end(void* self, MHD_Connection*, void** place,
                                MHD_RequestTerminationCode) {
    const std::unique_ptr<Exchange> exchange(static_cast<Exchange*>(*place));
    *place = nullptr;
    if (exchange) static_cast<Daemon*>(self)->watch.limit(exchange->socket, to_send_request);
}

void HttpServer::Daemon::on_connection(void* self, MHD_Connection* connection, void**,
                                       MHD_ConnectionNotificationCode code) {
    ConnectionWatch& watch = static_cast<Daemon*>(self)->watch;
    const int socket = socket_of(connection);
    if (code == MHD_CONNECTION_NOTIFY_STARTED)
        watch.limit(socket, to_send_request);
    else
        watch.forget(socket);
}

HttpServer::HttpServer(ListenSocket& socket, HttpRoutes routes, int work_threads)
    : daemon_(std::make_unique<Daemon>()) {
    Daemon& daemon = *daemon_;
    daemon.routes = std::move(routes);
    daemon.work = std::make_unique<WorkQueue>(WorkQueue::Extent{work_threads, most_waiting});
    const int descriptor = socket.release();
    daemon.handle = MHD_start_daemon(
        MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME, 0, nullptr, nullptr,
        &Daemon::on_request, &daemon, MHD_OPTION_LISTEN_SOCKET, descriptor,
        MHD_OPTION_CONNECTION_LIMIT, most_connections, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
        most_header_bytes, MHD_OPTION_CONNECTION_TIMEOUT, idle_s, MHD_OPTION_STRICT_FOR_CLIENT, 1,
        MHD_OPTION_NOTIFY_COMPLETED, &Daemon::on_end, &daemon, MHD_OPTION_NOTIFY_CONNECTION,
        &Daemon::on_connection, &daemon, MHD_OPTION_END);
    if (daemon.handle == nullptr)
        throw SystemError(
            "the web server: cannot start; are there enough file descriptors "
            "(ulimit -n)?");
}

HttpServer::~HttpServer() {
    const int listening = MHD_quiesce_daemon(daemon_->handle);
    daemon_->work->finish();  // what is suspended must go on before the library may stop
    MHD_stop_daemon(daemon_->handle);
    if (listening >= 0) ::close(listening);
}

}  // namespace specula
