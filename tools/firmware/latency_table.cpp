#include <algorithm>

#include "sim/core/format.hpp"
#include "tools/firmware/latency_study.hpp"
#include "tools/report/csv_table.hpp"

namespace specula {

namespace {

constexpr double budget_us = 20.0;

std::string shape_of(const LatencyStudy& study, const LatencyPoint& point) {
    std::string text = format("{}", study.n_features);
    for (const int units : point.hidden) text += format("-{}", units);
    return text + format("-{}", study.n_classes);
}

/// What the network sees costs the same for every size.
std::string features_text(const LatencyStudy& study) {
    const StageCost& features = study.points.front().features;
    return format(
        "Before the network, {} ({} numbers of {} rows) takes {:.0f} instructions, {:.1f} to {:.1f} "
        "us, estimated likewise.\n\n",
        study.descriptor, study.n_features, study.n_rows, features.instructions,
        features.cycles.low / cycles_per_us, features.cycles.high / cycles_per_us);
}

const char* fit_of(const LatencyPoint& point) {
    if (point.cycles.high <= budget_us * cycles_per_us) return "yes";
    return point.cycles.low <= budget_us * cycles_per_us ? "perhaps" : "no";
}

std::string percent(const Interval& interval) {
    return format("{:.1f} [{:.1f}, {:.1f}]", 100.0 * interval.mean, 100.0 * interval.low,
                  100.0 * interval.high);
}

std::string points_of(const PairedDifference& difference) {
    return format("{:+.1f} [{:+.1f}, {:+.1f}]", 100.0 * difference.value.mean,
                  100.0 * difference.value.low, 100.0 * difference.value.high);
}

/// Columns as wide as their widest cell, two spaces between.
class TextTable {
  public:
    explicit TextTable(std::vector<std::string> head) { add(std::move(head)); }

    void add(std::vector<std::string> row) {
        width_.resize(std::max(width_.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) width_[i] = std::max(width_[i], row[i].size());
        rows_.push_back(std::move(row));
    }
    std::string text() const {
        std::string text;
        for (const auto& row : rows_) {
            for (std::size_t i = 0; i + 1 < row.size(); ++i)
                text += format("{:<{}}  ", row[i], width_[i]);
            text += row.back() + "\n";
        }
        return text;
    }

  private:
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> width_;
};

/// Integers against float32: all is well near the training rows, and little far from them.
std::string agreement_text(const LatencyStudy& study) {
    std::vector<std::string> head{"network", "arithmetic"};
    for (const Agreement& agreement : study.points.front().agreement)
        head.push_back(agreement.condition);
    TextTable table(head);
    for (const LatencyPoint& point : study.points) {
        if (point.arithmetic == "float32") continue;
        std::vector<std::string> row{shape_of(study, point), point.arithmetic};
        for (const Agreement& agreement : point.agreement)
            row.push_back(format("{:.1f} ({:+.1f}) {:.1f}", 100.0 * agreement.same_label,
                                 100.0 * agreement.f1_change, 100.0 * agreement.clipped));
        table.add(row);
    }
    return "Integers against the same network in float32: frames with the same label in percent "
           "(change of\nmacro-F1 in points), frames with an input beyond the integers' reach of 6 "
           "sigma in percent.\n\n" +
           table.text();
}

std::vector<std::string> csv_head(const LatencyStudy& study) {
    std::vector<std::string> head{"network",
                                  "arithmetic",
                                  "multiplications",
                                  "model_bytes",
                                  "instructions",
                                  "cycles_low",
                                  "cycles_high",
                                  "us_low",
                                  "us_high",
                                  "fits_20_us",
                                  "nominal_macro_f1",
                                  "rerecorded_macro_f1",
                                  "nominal_loss",
                                  "nominal_loss_low",
                                  "nominal_loss_high",
                                  "rerecorded_loss",
                                  "rerecorded_loss_low",
                                  "rerecorded_loss_high",
                                  "features_instructions",
                                  "features_us_low",
                                  "features_us_high"};
    for (const Agreement& agreement : study.points.front().agreement)
        for (const char* what : {"same_label", "f1_change", "clipped"})
            head.push_back(format("{}_{}", agreement.condition, what));
    return head;
}

}  // namespace

std::string latency_text(const LatencyStudy& study) {
    std::string text = format(
        "{} worlds of {}, {} epochs; macro-F1 in percent with 95 % interval over worlds; losses "
        "are "
        "paired, in points,\nagainst the largest network in float32. Time of network and softmax "
        "at "
        "160 MHz: an ESTIMATE (specula verify-firmware says how).\n\n",
        study.worlds, study.experiment, study.epochs);
    TextTable table({"network", "arithmetic", "MACs", "bytes", "insn", "us", "<= 20 us", "nominal",
                     "re-recorded", "loss, nominal", "loss, re-recorded"});
    for (const LatencyPoint& point : study.points)
        table.add({shape_of(study, point), point.arithmetic, format("{}", point.n_multiplications),
                   format("{}", point.model_bytes), format("{:.0f}", point.instructions),
                   format("{:.1f} to {:.1f}", point.cycles.low / cycles_per_us,
                          point.cycles.high / cycles_per_us),
                   fit_of(point), percent(point.nominal), percent(point.rerecorded),
                   points_of(point.nominal_loss), points_of(point.rerecorded_loss)});
    return text + table.text() + "\n" + features_text(study) + agreement_text(study);
}

std::string latency_csv(const LatencyStudy& study) {
    CsvTable table(csv_head(study));
    for (const LatencyPoint& point : study.points) {
        std::vector<std::string> row{shape_of(study, point), point.arithmetic};
        for (const std::size_t count : {point.n_multiplications, point.model_bytes})
            row.push_back(format("{}", count));
        for (const double value :
             {point.instructions, point.cycles.low, point.cycles.high,
              point.cycles.low / cycles_per_us, point.cycles.high / cycles_per_us})
            row.push_back(format("{:.6g}", value));
        row.push_back(fit_of(point));
        for (const double value :
             {point.nominal.mean, point.rerecorded.mean, point.nominal_loss.value.mean,
              point.nominal_loss.value.low, point.nominal_loss.value.high,
              point.rerecorded_loss.value.mean, point.rerecorded_loss.value.low,
              point.rerecorded_loss.value.high, point.features.instructions,
              point.features.cycles.low / cycles_per_us, point.features.cycles.high / cycles_per_us})
            row.push_back(format("{:.6g}", value));
        for (const Agreement& agreement : point.agreement)
            for (const double value :
                 {agreement.same_label, agreement.f1_change, agreement.clipped})
                row.push_back(format("{:.6g}", value));
        table.add(row);
    }
    return table.text();
}

}  // namespace specula
