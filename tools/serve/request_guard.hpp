#pragma once

#include <optional>
#include <string>

#include "tools/serve/http_message.hpp"
#include "tools/serve/listen_socket.hpp"

namespace specula {

/// Decides before routing whether a request may be answered at all.
///
/// A page anywhere on the web can make a browser send requests to this machine, under a name that
/// was made to point here (DNS rebinding) or across origins. So the Host must be an address or a
/// name of this machine with our port, a POST must come from a page of ours as JSON, and off the
/// loopback a token is asked for that no other page knows.
class RequestGuard {
  public:
    /// @in  token  empty: none is asked for
    RequestGuard(ListenAddress where, std::string token);

    /// The refusal, or, of the first request with the token in its query, the redirection that
    /// moves it into a cookie; nothing where the request may pass.
    std::optional<HttpResponse> check(const HttpRequest& request) const;

    /// Largest body of a request in bytes.
    static constexpr std::size_t most_body_bytes = 64 * 1024;

  private:
    bool is_own_host(const std::string& host) const;
    bool is_own_origin(const std::string& origin) const;
    std::optional<HttpResponse> check_token(const HttpRequest& request) const;

    ListenAddress where_;
    std::string token_;
    std::string machine_;  ///< its name
};

/// 128 bits from the system, as 32 hexadecimal digits.
std::string random_token();

}  // namespace specula
