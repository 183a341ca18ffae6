#include "tools/validate/validate.hpp"

#include <chrono>
#include <exception>
#include <mutex>
#include <optional>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/parallel.hpp"
#include "tools/study/progress.hpp"
#include "tools/validate/case_file.hpp"
#include "tools/validate/case_kind.hpp"

namespace specula {

namespace {

/// A progress line that appears only when the work takes long.
class LateProgress {
  public:
    explicit LateProgress(std::size_t total) : total_(total) {}

    void count_one() {
        const std::lock_guard<std::mutex> hold(lock_);
        ++done_;
        if (!line_ && Clock::now() - start_ > std::chrono::seconds(2))
            line_.emplace("Validating", "points", total_);
        if (line_) line_->done() = done_;
    }

  private:
    using Clock = std::chrono::steady_clock;
    std::size_t total_;
    std::size_t done_ = 0;
    Clock::time_point start_ = Clock::now();
    std::mutex lock_;
    std::optional<Progress> line_;
};

PointVerdict computed(const CaseFile& file, std::size_t index, const Library& library) {
    const ComputePoint compute = find_case_kind(file.kind());
    if (compute == nullptr)
        return {.quantities = {},
                .problem = format("cases of the kind \"{}\" cannot be computed", file.kind())};
    try {
        const CasePoint point(file, index, library);
        PointVerdict verdict{.quantities = compute(point), .problem = {}};
        if (point.is_informative())
            for (Quantity& quantity : verdict.quantities) quantity.judged = false;
        return verdict;
    } catch (const NotComputable& error) {
        return {.quantities = {}, .problem = error.what()};
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {  // our own mistake, or a size beyond the machine
        return {.quantities = {}, .problem = error.what()};
    }
}

}  // namespace

Validation validate(const ValidationRequest& request, const Library& library) {
    const CaseFolder folder = read_case_folder(request.folder);
    Validation validation{.folder = request.folder, .cases = {}, .others = folder.others};
    struct Task {
        std::size_t file, point;
    };
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < folder.cases.size(); ++i) {
        const CaseFile& file = folder.cases[i];
        validation.cases.push_back({.id = file.id,
                                    .title = file.title,
                                    .level = file.level,
                                    .kind = file.kind(),
                                    .path = file.path,
                                    .points = std::vector<PointVerdict>(file.n_points)});
        for (std::size_t point = 0; point < file.n_points; ++point) tasks.push_back({i, point});
    }
    // Each task keeps its error, so that the first in order is thrown, whatever the threads did.
    std::vector<std::exception_ptr> errors(tasks.size());
    {
        LateProgress progress(tasks.size());
        for_each_index(tasks.size(), request.threads, [&](std::size_t i) {
            const auto [file, point] = tasks[i];
            try {
                validation.cases[file].points[point] = computed(folder.cases[file], point, library);
            } catch (...) {
                errors[i] = std::current_exception();
            }
            progress.count_one();
        });
    }
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    return validation;
}

}  // namespace specula
