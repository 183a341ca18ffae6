#include "tools/study/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <exception>

#include "sim/core/format.hpp"

namespace specula {

namespace {

std::string duration_text(double seconds) {
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole < 60) return format("{} s", whole);
    if (whole < 3600) return format("{}:{:02} min", whole / 60, whole % 60);
    return format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(std::string what, std::string unit, std::size_t total)
    : what_(std::move(what)),
      unit_(std::move(unit)),
      total_(total),
      on_terminal_(::isatty(STDERR_FILENO) == 1),
      watcher_([this] { watch(); }) {}

Progress::~Progress() {
    {
        const std::lock_guard<std::mutex> hold(lock_);
        ended_ = true;
    }
    wake_.notify_one();
    watcher_.join();
    // What went wrong is told in one line of its own; a bar beside it would only be in the way.
    if (std::uncaught_exceptions() > 0) {
        if (on_terminal_) std::fprintf(stderr, "\r\033[K");
        return;
    }
    std::fprintf(stderr, on_terminal_ ? "\r\033[K%s\n" : "%s\n", line().c_str());
}

void Progress::watch() {
    const auto pause = on_terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(10);
    std::unique_lock<std::mutex> hold(lock_);
    while (!wake_.wait_for(hold, pause, [this] { return ended_; }))
        std::fprintf(stderr, on_terminal_ ? "\r\033[K%s" : "%s\n", line().c_str());
}

std::string Progress::line() const {
    const std::size_t done = done_;
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
    const double share =
        total_ == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total_);
    const double rate = elapsed_s > 0.0 ? static_cast<double>(done) / elapsed_s : 0.0;
    constexpr int width = 24;
    const int filled = static_cast<int>(share * width);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(width - filled), '.');
    const std::string time = done >= total_ ? "took " + duration_text(elapsed_s)
                             : done > 0 ? duration_text(elapsed_s * (1.0 / share - 1.0)) + " left"
                                        : std::string("starting");
    const std::string written =
        bytes_ > 0 ? format("  {:.1f} MB", static_cast<double>(bytes_) * 1e-6) : std::string();
    return format("{:<26} [{}] {:3.0f} %  {}/{} {}  {:.0f}/s{}  {}", what_, bar, 100.0 * share,
                  done, total_, unit_, rate, written, time);
}

}  // namespace specula
