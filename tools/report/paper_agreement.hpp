#pragma once

#include <string>

#include "tools/report/study_summary.hpp"

namespace specula {

/// How the paper's value lies to the simulated ones. The paper is one set of samples and
/// recordings, like one world; so single worlds decide, and the mean is a second question.
enum class Agreement {
    unknown,          ///< the paper gives no number
    too_few,          ///< fewer than least_predictions worlds
    within_interval,  ///< among the worlds, and inside the interval of their mean
    within_worlds,    ///< from the 5th to the 95th percentile of single worlds
    outside,          ///< beyond them
};

/// Where the paper's figure lies in what is predicted for it.
PaperPercentile percentile_of(double paper, std::vector<double> predicted);

Agreement paper_agreement(const StudyCondition& condition);

/// "agrees with the paper", "agrees with the paper within the spread of single worlds", ...
std::string agreement_verdict(const StudySummary& study, const StudyCondition& condition);

/// "94.6 % (95 % interval 93.8 to 95.4 %)"
std::string simulated_text(const ConditionReport& result);

/// Sentences that set the simulated value beside the paper's.
std::string agreement_text(const StudySummary& study, const StudyCondition& condition);

}  // namespace specula
