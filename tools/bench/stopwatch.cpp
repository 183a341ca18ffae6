#include "tools/bench/stopwatch.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <ctime>

namespace specula {

namespace {

constexpr int fewest_batches = 3;
constexpr double batches_per_budget = 5.0;
/// What takes longer is called once only; what takes less may have made tables at first.
constexpr double longest_twice_s = 1.0;

double seconds_of(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double thread_seconds() {
    return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

double process_seconds() {
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

double wall_seconds() {
    return seconds_of(CLOCK_MONOTONIC);
}

double seconds_per_call(double budget_s, const std::function<void()>& work) {
    const double begin_s = thread_seconds();
    work();  // fills caches and what is made once
    const double first_s = std::max(thread_seconds() - begin_s, 1e-9);
    if (first_s > budget_s) {
        if (first_s > longest_twice_s) return first_s;
        const double again_s = thread_seconds();
        work();
        return std::max(std::min(first_s, thread_seconds() - again_s), 1e-9);
    }
    const int calls = std::max(1, static_cast<int>(budget_s / batches_per_budget / first_s));
    double best_s = first_s;
    for (int batch = 0; batch < fewest_batches || thread_seconds() - begin_s < budget_s; ++batch) {
        const double from_s = thread_seconds();
        for (int i = 0; i < calls; ++i) work();
        best_s = std::min(best_s, (thread_seconds() - from_s) / calls);
    }
    return std::max(best_s, 1e-12);
}

double peak_memory_bytes() {
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) return 0.0;
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace specula
