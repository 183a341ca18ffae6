#include "tools/study/severity.hpp"

#include <algorithm>

#include "classifier/metrics.hpp"
#include "sim/core/expect.hpp"
#include "sim/generate.hpp"

namespace specula {

namespace {

/// The geometry part of the grid as one condition: every height with every tilt.
Condition grid_condition(const SeverityPlan& plan, const Experiment& experiment) {
    Condition condition;
    condition.name = "severity";
    condition.title = "Severity grid";
    condition.number = Condition::most_conditions - 1;
    for (const double offset_m : plan.height_offsets_m)
        condition.heights_m.push_back(experiment.nominal_height_m + offset_m);
    condition.tilts_rad = plan.tilts_rad;
    condition.sessions = plan.sessions;
    condition.frames = plan.frames;
    return condition;
}

Condition nominal_cell(const SeverityPlan& plan, const Experiment& experiment) {
    Condition condition = grid_condition(plan, experiment);
    condition.heights_m = {experiment.nominal_height_m};
    condition.tilts_rad = {0.0};
    return condition;
}

const FeatureTable& features_for(const GridEntrant& entrant, const PassingRecording& recording) {
    return entrant.kind.empty() ? recording.features : recording.described.at(entrant.kind);
}

void score_cell(const StudyContext& context, const GridEntrant& entrant, const FeatureTable& rows,
                SeverityCell& cell) {
    const WorldRows own = rows_by_world(rows, static_cast<int>(entrant.models.size()));
    const DomainScore score = context.score(
        "", scores_of(judge_each(entrant.models, own, context.run.threads), context.merged));
    cell.all.push_back(score.all.mean);
    cell.merged.push_back(score.merged.mean);
    cell.intervals.push_back(score.all);
}

bool is_shifted(const SeverityCell& cell) {
    return cell.height_offset_m != 0.0 || cell.tilt_rad != 0.0 || !cell.receiver.empty();
}

void add_means(SeverityGrid& grid) {
    const std::size_t n = grid.classifiers.size();
    grid.mean_all.assign(n, 0.0);
    grid.mean_merged.assign(n, 0.0);
    double cells = 0.0;
    for (const SeverityCell& cell : grid.cells) {
        if (!is_shifted(cell)) continue;
        cells += 1.0;
        for (std::size_t i = 0; i < n; ++i) {
            grid.mean_all[i] += cell.all[i];
            grid.mean_merged[i] += cell.merged[i];
        }
    }
    for (std::size_t i = 0; i < n && cells > 0.0; ++i) {
        grid.mean_all[i] /= cells;
        grid.mean_merged[i] /= cells;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double baseline = 1.0 - grid.mean_all[0];
        grid.relative_error.push_back(baseline > 0.0 ? (1.0 - grid.mean_all[i]) / baseline : 1.0);
    }
}

}  // namespace

SeverityGrid severity_grid(const StudyContext& context, const std::vector<GridEntrant>& entrants) {
    SPECULA_EXPECT(!entrants.empty());
    const SeverityPlan& plan = *context.experiment.protocol.severity;
    RunSettings run = context.run_with(static_cast<int>(entrants.front().models.size()));
    for (const GridEntrant& entrant : entrants)
        if (!entrant.kind.empty()) run.kinds.push_back(entrant.kind);
    SeverityGrid grid;
    grid.n_worlds = entrants.front().models.size();
    for (const GridEntrant& entrant : entrants) grid.classifiers.push_back(entrant.name);
    grid.height_offsets_m = plan.height_offsets_m;
    grid.tilts_rad = plan.tilts_rad;
    const Condition geometry = grid_condition(plan, context.experiment);
    const Condition nominal = nominal_cell(plan, context.experiment);
    const auto count = [&](const Condition& condition) {
        return session_count(condition, context.experiment.population, run.worlds);
    };
    Progress progress("Recording the grid", "sessions",
                      count(geometry) + plan.receiver.size() * count(nominal));
    {
        const PassingRecording recording =
            observe(context.frozen, context.source(), run, geometry, progress);
        for (int place = 0; place < geometry.geometries(); ++place) {
            const auto n_tilts = static_cast<int>(plan.tilts_rad.size());
            SeverityCell cell{
                .height_offset_m = plan.height_offsets_m[static_cast<std::size_t>(place / n_tilts)],
                .tilt_rad = plan.tilts_rad[static_cast<std::size_t>(place % n_tilts)]};
            for (const GridEntrant& entrant : entrants)
                score_cell(context, entrant,
                           rows_of_geometry(features_for(entrant, recording), geometry, place),
                           cell);
            grid.cells.push_back(std::move(cell));
        }
    }
    for (const Assumption& severity : plan.receiver) {
        const Experiment other = under(severity, context.experiment);
        const PassingRecording recording =
            observe(context.frozen, {other, context.materials}, run, nominal, progress);
        SeverityCell cell{.receiver = severity.title};
        for (const GridEntrant& entrant : entrants)
            score_cell(context, entrant, features_for(entrant, recording), cell);
        grid.cells.push_back(std::move(cell));
    }
    add_means(grid);
    return grid;
}

}  // namespace specula
