#include "tools/serve/work_queue.hpp"

namespace specula {

WorkQueue::WorkQueue(const Extent& extent) : most_waiting_(extent.most_waiting) {
    for (int i = 0; i < extent.threads; ++i) threads_.emplace_back([this] { run(); });
}

void WorkQueue::finish() {
    {
        const std::lock_guard<std::mutex> hold(lock_);
        ended_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
}

bool WorkQueue::take(std::function<void()> work) {
    {
        const std::lock_guard<std::mutex> hold(lock_);
        if (ended_ || waiting_.size() >= most_waiting_) return false;
        waiting_.push_back(std::move(work));
    }
    wake_.notify_one();
    return true;
}

void WorkQueue::run() {
    std::unique_lock<std::mutex> hold(lock_);
    while (true) {
        wake_.wait(hold, [this] { return ended_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        const std::function<void()> work = std::move(waiting_.front());
        waiting_.pop_front();
        hold.unlock();
        work();
        hold.lock();
    }
}

}  // namespace specula
