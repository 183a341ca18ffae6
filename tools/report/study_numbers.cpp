#include "tools/report/study_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/expect.hpp"

namespace specula {
namespace {

double ratio(std::int64_t part, std::int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

std::int64_t n_frames(const Confusion& confusion) {
    return std::accumulate(confusion.counts.begin(), confusion.counts.end(), std::int64_t{0});
}

std::int64_t n_correct(const Confusion& confusion) {
    std::int64_t n = 0;
    for (std::size_t i = 0; i < confusion.n; ++i) n += confusion.at(i, i);
    return n;
}

}  // namespace

double accuracy(const Confusion& confusion) {
    return ratio(n_correct(confusion), n_frames(confusion));
}

double predicted_share(const Confusion& confusion, std::size_t predicted) {
    std::int64_t n = 0;
    for (std::size_t truth = 0; truth < confusion.n; ++truth) n += confusion.at(truth, predicted);
    return ratio(n, n_frames(confusion));
}

std::size_t most_predicted(const Confusion& confusion) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < confusion.n; ++i)
        if (predicted_share(confusion, i) > predicted_share(confusion, best)) best = i;
    return best;
}

MergedClasses merged_classes(const Confusion& confusion, const std::vector<std::size_t>& merged) {
    std::int64_t n_within = 0, n_right = 0;
    for (const std::size_t truth : merged)
        for (const std::size_t predicted : merged) {
            n_within += confusion.at(truth, predicted);
            if (truth == predicted) n_right += confusion.at(truth, predicted);
        }
    return {
        .share_of_errors = ratio(n_within - n_right, n_frames(confusion) - n_correct(confusion)),
        .right_within = ratio(n_right, n_within),
        .guessing = merged.empty() ? 0.0 : 1.0 / static_cast<double>(merged.size())};
}

double share_above(const std::array<std::int64_t, ConfidenceHistogram::n_bins>& counts,
                   std::size_t first_bin) {
    const auto first = counts.begin() + static_cast<std::ptrdiff_t>(first_bin);
    return ratio(std::accumulate(first, counts.end(), std::int64_t{0}),
                 std::accumulate(counts.begin(), counts.end(), std::int64_t{0}));
}

const InputDrift* find_drift(const StudySummary& study, std::string_view condition) {
    for (const InputDrift& drift : study.results.drift)
        if (drift.domain == condition) return &drift;
    return nullptr;
}

double echo_bin(const RadarFacts& radar, double height_m) {
    return radar.nominal_height_bin + (height_m - radar.nominal_height_m) / radar.range_bin_m;
}

std::string listed(const std::vector<std::string>& items) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) text += i + 1 == items.size() ? " and " : ", ";
        text += items[i];
    }
    return text;
}

std::string merged_names(const StudySummary& study) {
    std::vector<std::string> names;
    for (const std::size_t i : study.merged_classes) names.push_back(study.class_names.at(i));
    return listed(names);
}

std::string where(const StudyCondition& condition) {
    const std::string& name = condition.result.name;
    if (name == nominal_condition) return "under the nominal geometry";
    if (name == rerecorded_condition) return "when the same samples are recorded again";
    if (name == height_condition) return "at other heights of the radar";
    if (name == tilt_sensor_condition) return "with the sensor tilted";
    if (name == tilt_sample_condition) return "with the sample tilted";
    if (name == similar_condition) return "on similar but unknown samples";
    if (name == joint_condition) return "at other heights with the sensor tilted";
    return "under \u201c" + condition.result.title + "\u201d";
}

}  // namespace specula
