#include "tools/serve/listen_socket.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr int backlog = 128;

union SocketAddress {
    sockaddr any;
    sockaddr_in v4;
    sockaddr_in6 v6;
};

/// Returns its length; 0 where the text is no address.
socklen_t parse(const ListenAddress& where, SocketAddress& address) {
    std::memset(&address, 0, sizeof address);
    const auto port = htons(static_cast<std::uint16_t>(where.port));
    if (where.is_ipv6()) {
        address.v6.sin6_family = AF_INET6;
        address.v6.sin6_port = port;
        const bool good = ::inet_pton(AF_INET6, where.address.c_str(), &address.v6.sin6_addr) == 1;
        return good ? sizeof address.v6 : 0;
    }
    address.v4.sin_family = AF_INET;
    address.v4.sin_port = port;
    const bool good = ::inet_pton(AF_INET, where.address.c_str(), &address.v4.sin_addr) == 1;
    return good ? sizeof address.v4 : 0;
}

bool is_any(const SocketAddress& address) {
    if (address.any.sa_family == AF_INET6) return IN6_IS_ADDR_UNSPECIFIED(&address.v6.sin6_addr);
    return address.v4.sin_addr.s_addr == htonl(INADDR_ANY);
}

/// In numbers; empty for IPv6 addresses that mean nothing without the name of a link.
std::string numeric(const sockaddr& address) {
    const bool is_v6 = address.sa_family == AF_INET6;
    SocketAddress copy;
    std::memcpy(&copy, &address, is_v6 ? sizeof copy.v6 : sizeof copy.v4);
    if (is_v6 && IN6_IS_ADDR_LINKLOCAL(&copy.v6.sin6_addr)) return "";
    const void* bytes = is_v6 ? static_cast<const void*>(&copy.v6.sin6_addr) : &copy.v4.sin_addr;
    char text[INET6_ADDRSTRLEN] = "";
    return ::inet_ntop(address.sa_family, bytes, text, sizeof text) == nullptr ? "" : text;
}

bool is_seen_by_others(const ifaddrs& link) {
    return (link.ifa_flags & IFF_UP) != 0 && (link.ifa_flags & IFF_LOOPBACK) == 0;
}

[[noreturn]] void refuse(const ListenAddress& where, int reason) {
    if (reason == EADDRINUSE)
        throw InputError(format(
            "--port = {}: another program listens there; use another one, or --port 0 for any "
            "that is free",
            where.port));
    if (reason == EACCES)
        throw InputError(
            format("--port = {}: is for the system alone; use 1024 or more", where.port));
    if (reason == EADDRNOTAVAIL)
        throw InputError(
            format("--listen = {}: is no address of this machine; use one that "
                   "\"ip address\" lists, or 0.0.0.0 for all",
                   where.address));
    throw SystemError(format("{}: cannot listen: {}", where.text(), std::strerror(reason)));
}

}  // namespace

bool ListenAddress::is_loopback() const {
    SocketAddress parsed;
    if (parse(*this, parsed) == 0) return false;
    if (is_ipv6()) return IN6_IS_ADDR_LOOPBACK(&parsed.v6.sin6_addr);
    return (ntohl(parsed.v4.sin_addr.s_addr) >> 24) == 127;
}

ListenAddress ListenAddress::to_type() const {
    SocketAddress parsed;
    if (parse(*this, parsed) == 0 || !is_any(parsed)) return *this;
    ifaddrs* listed = nullptr;
    ::getifaddrs(&listed);
    const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> owner(listed, ::freeifaddrs);
    for (const ifaddrs* each = listed; each != nullptr; each = each->ifa_next) {
        if (each->ifa_addr == nullptr || each->ifa_addr->sa_family != parsed.any.sa_family)
            continue;
        const std::string found = numeric(*each->ifa_addr);
        if (is_seen_by_others(*each) && !found.empty()) return {found, port};
    }
    return {is_ipv6() ? "::1" : "127.0.0.1", port};
}

std::string ListenAddress::text() const {
    return is_ipv6() ? format("[{}]:{}", address, port) : format("{}:{}", address, port);
}

ListenSocket::ListenSocket(const ListenAddress& where) : where_(where) {
    SocketAddress address;
    const socklen_t length = parse(where, address);
    if (length == 0)
        throw InputError(
            format("--listen = {}: is no address; use one in numbers, as 192.168.1.5, "
                   "0.0.0.0 or ::1",
                   where.address));
    const int type = SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK;
    descriptor_ = ::socket(address.any.sa_family, type, 0);
    if (descriptor_ < 0) refuse(where, errno);
    const int yes = 1;
    ::setsockopt(descriptor_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (::bind(descriptor_, &address.any, length) != 0 || ::listen(descriptor_, backlog) != 0) {
        const int reason = errno;
        ::close(descriptor_);
        refuse(where, reason);
    }
    socklen_t found_length = sizeof address;
    ::getsockname(descriptor_, &address.any, &found_length);
    where_.port = ntohs(where.is_ipv6() ? address.v6.sin6_port : address.v4.sin_port);
}

ListenSocket::~ListenSocket() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

int ListenSocket::release() {
    const int given = descriptor_;
    descriptor_ = -1;
    return given;
}

}  // namespace specula
