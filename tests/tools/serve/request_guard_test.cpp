#include "tools/serve/request_guard.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

HttpRequest get_from(const std::string& host) {
    HttpRequest request;
    request.method = "GET";
    request.path = "/";
    request.headers = {{"host", host}};
    return request;
}

HttpRequest post_from(const std::string& origin) {
    HttpRequest request = get_from("127.0.0.1:8060");
    request.method = "POST";
    request.headers.emplace_back("Content-Type", "application/json; charset=utf-8");
    request.headers.emplace_back("Origin", origin);
    return request;
}

int status_of(const RequestGuard& guard, const HttpRequest& request) {
    const auto refusal = guard.check(request);
    return refusal ? refusal->status : 200;
}

TEST_CASE("where all addresses are listened on, one that opens the page is printed", "[serve]") {
    for (const char* all : {"0.0.0.0", "::"}) {
        const ListenAddress where{all, 8060};
        const ListenAddress printed = where.to_type();
        INFO(printed.text());
        CHECK(printed.address != all);
        CHECK(printed.is_ipv6() == where.is_ipv6());
        CHECK(status_of(RequestGuard(where, ""), get_from(printed.text())) == 200);
        if (printed.is_ipv6()) continue;  // which a machine may have switched off
        // The system binds to none but this machine's own addresses.
        CHECK(ListenSocket({printed.address, 0}).where().address == printed.address);
    }
    CHECK(ListenAddress{"192.168.1.5", 8060}.to_type().address == "192.168.1.5");
}

TEST_CASE("only this machine's own names and port pass as Host", "[serve]") {
    const RequestGuard guard({"127.0.0.1", 8060}, "");
    for (const char* host : {"127.0.0.1:8060", "localhost:8060", "LOCALHOST:8060", "[::1]:8060"})
        CHECK(status_of(guard, get_from(host)) == 200);
    for (const char* host : {"", "localhost", "127.0.0.1", "localhost:80", "evil.example:8060",
                             "192.168.1.5:8060", "127.0.0.1:8060.evil.example", ":8060"})
        CHECK(status_of(guard, get_from(host)) == 403);
    HttpRequest two = get_from("127.0.0.1:8060");
    two.headers.emplace_back("Host", "127.0.0.1:8060");
    CHECK(status_of(guard, two) == 403);
}

TEST_CASE("on port 80 the Host may leave the port out, as browsers do", "[serve]") {
    const RequestGuard guard({"127.0.0.1", 80}, "");
    CHECK(status_of(guard, get_from("localhost")) == 200);
    CHECK(status_of(guard, get_from("evil.example")) == 403);
}

TEST_CASE("a POST passes from our own page alone, and as JSON", "[serve]") {
    const RequestGuard guard({"127.0.0.1", 8060}, "");
    CHECK(status_of(guard, post_from("http://localhost:8060")) == 200);
    for (const char* origin : {"http://evil.example", "null", "https://localhost:8060",
                               "http://localhost:8061", "http://localhost:8060.evil.example"})
        CHECK(status_of(guard, post_from(origin)) == 403);
    HttpRequest form = post_from("http://localhost:8060");
    form.headers[1].second = "text/plain";
    CHECK(status_of(guard, form) == 415);
    form.headers.erase(form.headers.begin() + 1);
    CHECK(status_of(guard, form) == 415);
}

TEST_CASE("off the loopback a request needs the token, once as a query, then as a cookie",
          "[serve]") {
    const std::string token = random_token();
    CHECK(token.size() == 32);
    CHECK(token != random_token());
    const RequestGuard guard({"0.0.0.0", 8060}, token);
    HttpRequest request = get_from("192.168.1.5:8060");
    CHECK(status_of(guard, request) == 401);
    request.query = {{"token", token.substr(1) + "0"}};
    CHECK(status_of(guard, request) == 401);
    request.query = {{"token", token}};
    const auto moved = guard.check(request);
    REQUIRE(moved);
    CHECK(moved->status == 303);
    const std::string cookie = moved->headers.at(1).second;
    CHECK(cookie.find("HttpOnly; SameSite=Strict") != std::string::npos);

    request.query.clear();
    request.headers.emplace_back("Cookie", "other=1; " + cookie.substr(0, cookie.find(';')));
    CHECK(status_of(guard, request) == 200);
    request.headers.front().second = "evil.example:8060";  // a name may be made to point here
    CHECK(status_of(guard, request) == 403);
}

}  // namespace
}  // namespace specula
