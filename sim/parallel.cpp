#include "sim/parallel.hpp"

#include <omp.h>

#include <exception>
#include <mutex>

namespace specula {

void for_each_index(std::size_t n, int threads, const std::function<void(std::size_t)>& work,
                    std::atomic<std::size_t>* done) {
    std::exception_ptr first_error;
    std::mutex error_lock;
    std::atomic<bool> stop{false};
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
    for (std::size_t i = 0; i < n; ++i) {
        if (stop) continue;
        try {
            work(i);
            if (done) ++*done;
        } catch (...) {
            const std::lock_guard<std::mutex> lock(error_lock);
            if (!first_error) first_error = std::current_exception();
            stop = true;
        }
    }
    if (first_error) std::rethrow_exception(first_error);
}

int available_threads() { return omp_get_num_procs(); }

}  // namespace specula
