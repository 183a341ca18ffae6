#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace specula {

/// Ends connections that do not get on in time, however busily they drip bytes: the HTTP library's
/// own limit starts anew with every byte.
class ConnectionWatch {
  public:
    ConnectionWatch();
    ~ConnectionWatch();
    ConnectionWatch(const ConnectionWatch&) = delete;
    ConnectionWatch& operator=(const ConnectionWatch&) = delete;

    /// What goes on now must end within this time; replaces an earlier limit.
    void limit(int socket, std::chrono::seconds time);
    /// It may take what time it needs. To be called before the descriptor is closed.
    void forget(int socket);

  private:
    using Clock = std::chrono::steady_clock;
    void watch();

    std::mutex lock_;
    std::condition_variable wake_;
    std::map<int, Clock::time_point> end_;  ///< (socket)
    bool ended_ = false;
    std::thread watcher_;
};

}  // namespace specula
