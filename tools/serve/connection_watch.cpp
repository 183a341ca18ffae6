#include "tools/serve/connection_watch.hpp"

#include <sys/socket.h>

namespace specula {

namespace {

constexpr std::chrono::seconds between_looks{1};

}  // namespace

ConnectionWatch::ConnectionWatch() : watcher_([this] { watch(); }) {}

ConnectionWatch::~ConnectionWatch() {
    {
        const std::lock_guard<std::mutex> hold(lock_);
        ended_ = true;
    }
    wake_.notify_one();
    watcher_.join();
}

void ConnectionWatch::limit(int socket, std::chrono::seconds time) {
    const std::lock_guard<std::mutex> hold(lock_);
    end_[socket] = Clock::now() + time;
}

void ConnectionWatch::forget(int socket) {
    const std::lock_guard<std::mutex> hold(lock_);
    end_.erase(socket);
}

void ConnectionWatch::watch() {
    std::unique_lock<std::mutex> hold(lock_);
    while (!wake_.wait_for(hold, between_looks, [this] { return ended_; })) {
        const Clock::time_point now = Clock::now();
        for (auto it = end_.begin(); it != end_.end();) {
            const bool late = now > it->second;
            // The library then finds the connection at its end, and closes it.
            if (late) ::shutdown(it->first, SHUT_RDWR);
            it = late ? end_.erase(it) : std::next(it);
        }
    }
}

}  // namespace specula
