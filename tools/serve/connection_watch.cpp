#include "tools/serve/connection_watch.hpp"

#include <sys/socket.h>

namespace specula {

ConnectionWatch::ConnectionWatch(std::chrono::milliseconds most_time)
    : most_time_(most_time), watcher_([this] { watch(); }) {}

ConnectionWatch::~ConnectionWatch() {
    {
        const std::lock_guard<std::mutex> hold(lock_);
        ended_ = true;
    }
    wake_.notify_one();
    watcher_.join();
}

void ConnectionWatch::restart(int socket) {
    const std::lock_guard<std::mutex> hold(lock_);
    waiting_since_[socket] = Clock::now();
}

void ConnectionWatch::opened(int socket) {
    restart(socket);
}

void ConnectionWatch::answered(int socket) {
    restart(socket);
}

void ConnectionWatch::arrived(int socket) {
    closed(socket);
}

void ConnectionWatch::closed(int socket) {
    const std::lock_guard<std::mutex> hold(lock_);
    waiting_since_.erase(socket);
}

void ConnectionWatch::watch() {
    std::unique_lock<std::mutex> hold(lock_);
    while (!wake_.wait_for(hold, most_time_ / 4, [this] { return ended_; })) {
        const Clock::time_point now = Clock::now();
        for (auto it = waiting_since_.begin(); it != waiting_since_.end();) {
            const bool late = now - it->second > most_time_;
            // The library then finds the connection at its end, and closes it.
            if (late) ::shutdown(it->first, SHUT_RDWR);
            it = late ? waiting_since_.erase(it) : std::next(it);
        }
    }
}

}  // namespace specula
