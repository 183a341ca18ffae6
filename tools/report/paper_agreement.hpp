#pragma once

#include <string>

#include "tools/report/study_summary.hpp"

namespace specula {

/// How the paper's value lies to the simulated ones. The paper is one set of samples and
/// recordings, like one world; so there are two questions, about the mean and about single worlds.
enum class Agreement {
    unknown,          ///< the paper gives no number
    within_interval,  ///< inside the interval of the mean
    within_worlds,    ///< outside it, but single worlds reach the value
    outside,          ///< no single world reaches the value
};

Agreement paper_agreement(const StudyCondition& condition);

/// "agrees with the paper", "agrees with the paper within the spread of single worlds", ...
std::string agreement_verdict(const StudySummary& study, const StudyCondition& condition);

/// "94.6 % (95 % interval 93.8 to 95.4 %)"
std::string simulated_text(const ConditionReport& result);

/// Sentences that set the simulated value beside the paper's.
std::string agreement_text(const StudySummary& study, const StudyCondition& condition);

}  // namespace specula
