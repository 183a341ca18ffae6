#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace specula {

/// Ends connections whose request does not arrive whole in time, however busily its sender drips
/// bytes: the HTTP library's own limit starts anew with every byte.
class ConnectionWatch {
  public:
    explicit ConnectionWatch(std::chrono::milliseconds most_time);
    ~ConnectionWatch();
    ConnectionWatch(const ConnectionWatch&) = delete;
    ConnectionWatch& operator=(const ConnectionWatch&) = delete;

    void opened(int socket);    ///< a first request may come
    void arrived(int socket);   ///< the request is here: it may take what time it needs
    void answered(int socket);  ///< another one may come
    void closed(int socket);    ///< before the descriptor is

  private:
    using Clock = std::chrono::steady_clock;
    void restart(int socket);
    void watch();

    std::chrono::milliseconds most_time_;
    std::mutex lock_;
    std::condition_variable wake_;
    std::map<int, Clock::time_point> waiting_since_;
    bool ended_ = false;
    std::thread watcher_;
};

}  // namespace specula
