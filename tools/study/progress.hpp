#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <thread>

namespace specula {

/// A progress line on standard error: share done, rate and time left.
///
/// On a terminal it redraws itself; elsewhere it prints a line every ten seconds and one at the
/// end, so that logs stay short. Whoever works counts `done` up.
class Progress {
  public:
    Progress(std::string what, std::string unit, std::size_t total);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();

    std::atomic<std::size_t>& done() { return done_; }
    /// Written so far; shown where there are any.
    std::atomic<std::size_t>& bytes() { return bytes_; }

  private:
    using Clock = std::chrono::steady_clock;
    void watch();
    std::string line() const;

    std::string what_;
    std::string unit_;
    std::size_t total_;
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> bytes_{0};
    Clock::time_point start_ = Clock::now();
    bool on_terminal_;
    bool ended_ = false;
    std::mutex lock_;
    std::condition_variable wake_;
    std::thread watcher_;
};

}  // namespace specula
