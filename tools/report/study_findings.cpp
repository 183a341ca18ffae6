#include "tools/report/study_findings.hpp"

#include "sim/core/format.hpp"
#include "tools/report/paper_agreement.hpp"

namespace specula {

std::optional<Paragraph> nominal_finding(const StudySummary& study) {
    const StudyCondition* nominal = find_condition(study, nominal_condition);
    if (nominal == nullptr) return {};
    return Paragraph{.lead = format("Nominal geometry: {}.", agreement_verdict(study, *nominal)),
                     .text = format("Simulated macro-F1 is {}. {}", simulated_text(nominal->result),
                                    agreement_text(study, *nominal))};
}

std::vector<Paragraph> study_findings(const StudySummary& study) {
    std::vector<Paragraph> findings;
    for (const auto finding :
         {nominal_finding, session_finding, height_finding, tilt_finding, similar_finding,
          merged_finding, confidence_finding, monitor_finding})
        if (std::optional<Paragraph> paragraph = finding(study))
            findings.push_back(std::move(*paragraph));
    return findings;
}

}  // namespace specula
