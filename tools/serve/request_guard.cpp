#include "tools/serve/request_guard.hpp"

#include <arpa/inet.h>
#include <strings.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

bool same_text(const std::string& a, const std::string& b) {
    return ::strcasecmp(a.c_str(), b.c_str()) == 0;
}

bool is_address(const std::string& name) {
    std::array<unsigned char, 16> unused{};
    if (::inet_pton(AF_INET, name.c_str(), unused.data()) == 1) return true;
    if (name.size() < 4 || name.front() != '[' || name.back() != ']') return false;
    return ::inet_pton(AF_INET6, name.substr(1, name.size() - 2).c_str(), unused.data()) == 1;
}

bool is_loopback_name(const std::string& name) {
    return same_text(name, "localhost") || name == "127.0.0.1" || name == "[::1]";
}

/// Takes the same time whatever differs.
bool same_secret(const std::string& a, const std::string& b) {
    if (a.size() != b.size()) return false;
    unsigned char differences = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        differences |= static_cast<unsigned char>(a[i] ^ b[i]);
    return differences == 0;
}

constexpr int web_port = 80;  // which browsers leave out of Host

constexpr const char* cookie_name = "specula_token=";

/// The value of our cookie among those of a Cookie header; empty: none.
std::string token_in(const std::string& cookies) {
    std::size_t begin = 0;
    while (begin < cookies.size()) {
        const std::size_t end = std::min(cookies.find(';', begin), cookies.size());
        std::string one = cookies.substr(begin, end - begin);
        one.erase(0, one.find_first_not_of(' '));
        if (one.rfind(cookie_name, 0) == 0) return one.substr(std::string(cookie_name).size());
        begin = end + 1;
    }
    return "";
}

bool is_json(const std::string& type) {
    const std::string media = type.substr(0, type.find(';'));
    return same_text(media.substr(0, media.find_last_not_of(' ') + 1), "application/json");
}

std::string name_of_machine() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

RequestGuard::RequestGuard(ListenAddress where, std::string token)
    : where_(std::move(where)), token_(std::move(token)), machine_(name_of_machine()) {}

bool RequestGuard::is_own_host(const std::string& host) const {
    const std::string port = format(":{}", where_.port);
    const bool names_port =
        host.size() > port.size() && host.substr(host.size() - port.size()) == port;
    if (!names_port && where_.port != web_port) return false;
    const std::string name = names_port ? host.substr(0, host.size() - port.size()) : host;
    if (is_loopback_name(name)) return true;
    if (where_.is_loopback()) return name + port == where_.text();
    // An address in numbers cannot be made to point elsewhere; a name can, unless it is our own.
    return is_address(name) || same_text(name, machine_) || same_text(name, machine_ + ".local");
}

bool RequestGuard::is_own_origin(const std::string& origin) const {
    constexpr const char* scheme = "http://";
    return origin.rfind(scheme, 0) == 0 && is_own_host(origin.substr(std::string(scheme).size()));
}

std::optional<HttpResponse> RequestGuard::check_token(const HttpRequest& request) const {
    if (token_.empty()) return std::nullopt;
    for (const std::string& cookies : request.header("Cookie"))
        if (same_secret(token_in(cookies), token_)) return std::nullopt;
    for (const auto& [key, value] : request.query) {
        if (key != "token" || !same_secret(value, token_)) continue;
        HttpResponse moved{.status = 303, .type = "text/plain", .body = "", .headers = {}};
        moved.headers = {
            {"Location", "/"},
            {"Set-Cookie", format("{}{}; HttpOnly; SameSite=Strict; Path=/", cookie_name, token_)}};
        return moved;
    }
    return error_response(401, "this server asks for its token",
                          "open the whole address that specula serve printed");
}

std::optional<HttpResponse> RequestGuard::check(const HttpRequest& request) const {
    const auto hosts = request.header("Host");
    if (hosts.size() != 1 || !is_own_host(hosts.front()))
        return error_response(403, "the Host header names another machine",
                              format("open http://{}/", where_.text()));
    if (request.method != "GET" && request.method != "HEAD" && request.method != "POST") {
        HttpResponse refused = error_response(405, "no such method here", "use GET or POST");
        refused.headers = {{"Allow", "GET, HEAD, POST"}};
        return refused;
    }
    if (auto refusal = check_token(request)) return refusal;
    for (const std::string& origin : request.header("Origin"))
        if (!is_own_origin(origin))
            return error_response(403, "the Origin header names another page",
                                  "use the page of this server");
    if (request.method != "POST") return std::nullopt;
    const auto types = request.header("Content-Type");
    if (types.size() != 1 || !is_json(types.front()))
        return error_response(415, "the body is not said to be JSON",
                              "send Content-Type: application/json");
    return std::nullopt;
}

std::string random_token() {
    std::array<unsigned char, 16> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw SystemError("the system's random numbers: cannot be read");
    std::string text;
    for (const unsigned char byte : bytes) text += format("{:02x}", byte);
    return text;
}

}  // namespace specula
