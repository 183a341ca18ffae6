#pragma once

#include "tools/study/study_context.hpp"

namespace specula {

/// What has been recorded and judged when the checks begin. Borrows all.
struct CheckInput {
    const Recording& training;
    const std::vector<const Recording*>& conditions;  ///< recorded anew, shifted, ...
    const std::vector<DomainScore>& scores;           ///< of the baseline, nominal first
};

/// Checks that the results mean what they say. Those that only need the training recordings run in
/// every study; placebo, one material and no nuisance have recordings of their own and run where
/// the extent gives them worlds. A check passes if its 95 % interval reaches its band.
std::vector<HonestyCheck> honesty_checks(const StudyContext& context, const CheckInput& input);

/// Class and merged class told by other means than the network: logistic regression and the five
/// nearest neighbours, on random frames and on every condition. Reported, without a band.
std::vector<HonestyCheck> simple_baselines(const StudyContext& context, const CheckInput& input);

}  // namespace specula
