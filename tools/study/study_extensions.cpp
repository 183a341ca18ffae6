#include <algorithm>

#include "tools/report/paper_agreement.hpp"
#include "tools/study/attribution.hpp"
#include "tools/study/honesty.hpp"
#include "tools/study/ladder.hpp"
#include "tools/study/remedy_models.hpp"
#include "tools/study/sensitivity.hpp"
#include "tools/study/severity.hpp"
#include "tools/study/study_stages.hpp"

/// The parts of a study beyond its conditions, in the order in which they run.
namespace specula {

namespace {

std::vector<const Recording*> conditions_of(const StudyState& state) {
    std::vector<const Recording*> conditions;
    for (std::size_t i = 1; i < state.recordings.size(); ++i)
        conditions.push_back(&state.recordings[i]);
    return conditions;
}

void add_checks(const StudyState& state, StudyResults& results) {
    const auto conditions = conditions_of(state);
    const CheckInput input{state.recordings.front(), conditions, state.baseline.scores};
    results.checks = honesty_checks(state.context, input);
    const auto baselines = simple_baselines(state.context, input);
    results.checks.insert(results.checks.end(), baselines.begin(), baselines.end());
}

void add_monitors(const StudyState& state, StudyResults& results) {
    const Baseline& baseline = state.baseline;
    std::vector<JudgedDomain> domains;
    for (std::size_t i = 0; i < baseline.domains.size(); ++i)
        domains.push_back({baseline.domains[i], baseline.rows[i], baseline.outcomes[i]});
    judge_monitors(state.context, {baseline.models, baseline.splits.training}, domains, results);
}

/// The paper's tilt figure within what is predicted for either way to tilt.
void add_percentiles(const StudyState& state, StudyResults& results) {
    const auto& papers = state.context.experiment.paper_macro_f1;
    const auto paper = papers.find(std::string(tilt_sensor_condition));
    if (paper == papers.end()) return;
    const auto add = [&](const std::string& domain, const std::string& over,
                         std::vector<double> predicted) {
        if (predicted.size() < 2) return;
        PaperPercentile percentile = percentile_of(paper->second, std::move(predicted));
        percentile.domain = domain;
        percentile.over = over;
        results.percentiles.push_back(percentile);
    };
    for (const DomainScore& score : state.baseline.scores)
        if (score.domain == tilt_sensor_condition || score.domain == tilt_sample_condition)
            add(score.domain, "worlds", score.per_world.all);
    for (std::size_t i = 0; i < results.prior.domains.size(); ++i) {
        const std::string& domain = results.prior.domains[i];
        if (domain != tilt_sensor_condition && domain != tilt_sample_condition) continue;
        std::vector<double> accepted;
        for (const PriorDraw& draw : results.prior.draws)
            if (draw.accepted) accepted.push_back(draw.domains[i]);
        add(domain, "prior draws that meet the nominal figure", std::move(accepted));
    }
}

void add_severity(const StudyState& state, const std::optional<Remedy>& remedy,
                  StudyResults& results) {
    const StudyContext& context = state.context;
    const auto worlds =
        static_cast<std::size_t>(std::min(context.extent.severity_worlds, context.run.worlds));
    const auto first = [&](const std::vector<Model>& models) {
        return std::vector<Model>(models.begin(),
                                  models.begin() + static_cast<std::ptrdiff_t>(worlds));
    };
    std::vector<GridEntrant> entrants{{"As in the paper", "", first(state.baseline.models)}};
    const bool is_other = remedy && remedy->plan != &context.experiment.protocol.rungs.front();
    if (is_other && !remedy->plan->motion)  // the grid stands still
        entrants.push_back({remedy->plan->title, remedy->plan->kind(), first(remedy->models)});
    results.severity = severity_grid(context, entrants);
}

}  // namespace

void extend_study(const StudyState& state, StageClock& clock, StudySummary& summary) {
    const StudyContext& context = state.context;
    const Protocol& protocol = context.experiment.protocol;
    StudyResults& results = summary.results;
    results.waterfall = waterfall(context, state.baseline.scores);
    if (protocol.checks) {
        add_checks(state, results);
        clock.ended("honesty checks");
        add_monitors(state, results);
        clock.ended("monitors");
    }
    std::optional<Ladder> ladder;
    std::optional<Remedy> remedy;
    const auto conditions = conditions_of(state);
    const LadderInput input{state.recordings.front(), conditions};
    if (context.extent.ladder && !protocol.rungs.empty()) {
        ladder.emplace(context, input);
        clock.ended("recording for remedies");
        results.ladder = ladder->run();
        results.choosing_worlds = choosing_worlds(static_cast<std::size_t>(context.run.worlds));
        remedy = train_remedy(*ladder, protocol.rungs, results.ladder);
        if (remedy)
            results.device = write_remedy(*remedy, context.experiment.radar, context.run.folder);
        clock.ended("remedies");
    }
    if (context.extent.severity_worlds > 0 && protocol.severity) {
        add_severity(state, remedy, results);
        clock.ended("severity grid");
    }
    if (context.extent.variant_worlds > 0) {
        results.sensitivity = sensitivity(context);
        clock.ended("assumptions");
    }
    const auto nominal = context.experiment.paper_macro_f1.find(std::string(nominal_condition));
    if (context.extent.prior_draws > 0 && nominal != context.experiment.paper_macro_f1.end()) {
        results.prior = prior_prediction(context, nominal->second);
        clock.ended("prior draws");
    }
    add_percentiles(state, results);
}

}  // namespace specula
