#pragma once

#include <string>

namespace specula {

/// Where a server listens.
struct ListenAddress {
    std::string address = "127.0.0.1";  ///< numeric, IPv4 or IPv6
    int port = 8060;                    ///< 0: any free one

    bool is_loopback() const;
    bool is_ipv6() const { return address.find(':') != std::string::npos; }
    /// "127.0.0.1:8060", "[::1]:8060".
    std::string text() const;
    /// What to type elsewhere: where all addresses are listened on (0.0.0.0, ::), the first of
    /// this machine that others can reach, or its loopback where there is none.
    ListenAddress to_type() const;
};

/// A listening TCP socket, closed with this unless it was given away.
class ListenSocket {
  public:
    /// Throws InputError where the address is none of this machine, or the port is taken.
    explicit ListenSocket(const ListenAddress& where);
    ~ListenSocket();
    ListenSocket(const ListenSocket&) = delete;
    ListenSocket& operator=(const ListenSocket&) = delete;

    /// With the port that was found where any would do.
    const ListenAddress& where() const { return where_; }
    /// Gives the descriptor to whoever will close it.
    int release();

  private:
    ListenAddress where_;
    int descriptor_ = -1;
};

}  // namespace specula
