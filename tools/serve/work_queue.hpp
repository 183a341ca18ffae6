#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace specula {

/// A few threads and a short line in front of them. Work that finds the line full is not taken:
/// who asked had better ask again than wait.
class WorkQueue {
  public:
    struct Extent {
        int threads;
        std::size_t most_waiting;
    };
    explicit WorkQueue(const Extent& extent);
    ~WorkQueue() { finish(); }
    WorkQueue(const WorkQueue&) = delete;
    WorkQueue& operator=(const WorkQueue&) = delete;

    /// False where the line is full. @in  work  does not throw
    bool take(std::function<void()> work);
    /// Finishes what was taken, and takes no more.
    void finish();

  private:
    void run();

    std::size_t most_waiting_;
    std::mutex lock_;
    std::condition_variable wake_;
    std::deque<std::function<void()>> waiting_;
    bool ended_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace specula
