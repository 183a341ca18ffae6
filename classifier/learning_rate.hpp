#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace specula {

/// How the learning rate goes over a training.
///
/// constant   the same at every step
/// cosine     half a cosine from the peak towards 0
/// one_cycle  from peak / 25 up to the peak within the first 30 % of the steps, then down to
///            1e-4 of where it began, both along half a cosine
enum class Schedule { constant, cosine, one_cycle };

/// Names in the order of the enumeration, as options and model files have them.
const std::vector<std::string>& schedule_names();

/// One step of a training.
struct ScheduledStep {
    Schedule schedule = Schedule::constant;
    double peak = 1e-3;        ///< largest learning rate, > 0
    std::int64_t step = 0;     ///< from 0, < n_steps
    std::int64_t n_steps = 1;  ///< of the whole training, >= 1
};

/// The learning rate of one step, in (0, peak].
/// @eq  cosine: Loshchilov and Hutter 2017, arXiv 1608.03983, equation (5), no restarts.
///      one_cycle: Smith and Topin 2017, arXiv 1708.07120; numbers and cosines as torch's
///      OneCycleLR has them by default.
double learning_rate_at(const ScheduledStep& place);

}  // namespace specula
