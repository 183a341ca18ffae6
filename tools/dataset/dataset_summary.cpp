#include "tools/dataset/dataset_summary.hpp"

#include <algorithm>
#include <optional>

#include "sim/core/constants.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "tools/dataset/frame_blocks.hpp"
#include "tools/dataset/frame_profiles.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

constexpr std::size_t most_examples = 3;
constexpr double slow_codes = 1e8;  ///< some seconds of transforms

/// Index of a column of the truth.
std::size_t column_of(double Truth::*member) {
    const auto found = std::find_if(truth_columns.begin(), truth_columns.end(),
                                    [&](const TruthColumn& c) { return c.member == member; });
    return static_cast<std::size_t>(found - truth_columns.begin());
}

class Summary {
  public:
    Summary(const DatasetReader& reader, int threads) : threads_(threads) {
        found_.head = reader.form();
        found_.n_frames = reader.n_frames();
        found_.profile_axis = profile_axis(found_.head);
        for (const std::string& name : found_.head.class_names) {
            found_.classes.emplace_back();
            found_.classes.back().name = name;
        }
        const auto n_rx = static_cast<std::size_t>(found_.head.n_rx);
        found_.codes.resize(n_rx);
        found_.quadrature.resize(n_rx);
        found_.features.resize(found_.head.feature_names.size());
        found_.truth.resize(truth_columns.size());
        const auto knows = [&](double Truth::*member) {
            return !found_.head.unknown_truth[column_of(member)];
        };
        if (knows(&Truth::height_m)) add_quantity("height", "mm");
        if (knows(&Truth::sensor_tilt_x_rad) && knows(&Truth::sensor_tilt_y_rad))
            add_quantity("sensor tilt", "deg");
        if (knows(&Truth::sample_tilt_x_rad) && knows(&Truth::sample_tilt_y_rad))
            add_quantity("sample tilt", "deg");
        if (found_.head.n_samples > 0 || found_.head.n_profile_bins > 0) add_quantity("SNR", "dB");
    }

    void add(const Dataset& block) {
        for (const Truth& truth : block.truth) add_truth(truth);
        add_codes(block.adc, found_.codes);
        add_codes(block.adc_quadrature, found_.quadrature);
        const std::size_t n = found_.features.size();
        for (std::size_t i = 0; i < block.features.size(); ++i)
            found_.features[i % n].add(block.features[i]);
        add_profiles(block);
    }

    DatasetSummary result() {
        for (ClassSummary& each : found_.classes)
            for (std::size_t k = 0; k < each.profile_mean.size(); ++k) {
                const double n = static_cast<double>(each.n_frames);
                const double mean = each.profile_mean[k] / n;
                const double variance = each.profile_sd[k] / n - mean * mean;
                each.profile_mean[k] = mean;
                each.profile_sd[k] = std::sqrt(std::max(0.0, variance));
            }
        return std::move(found_);
    }

  private:
    void add_quantity(const char* name, const char* unit) {
        found_.quantities.push_back({.name = name, .unit = unit, .values = {}, .label = {}});
    }

    void note(const char* name, double value, std::uint8_t label) {
        if (!std::isfinite(value)) return;
        for (FrameQuantity& each : found_.quantities)
            if (each.name == name) {
                each.values.push_back(static_cast<float>(value));
                each.label.push_back(label);
            }
    }

    void add_truth(const Truth& truth) {
        found_.worlds.insert(truth.world);
        found_.samples.insert(truth.sample);
        found_.sessions.insert(truth.session);
        found_.views.insert(truth.view);
        ClassSummary& own = found_.classes[truth.label];
        ++own.n_frames;
        own.samples.insert(truth.sample);
        own.sessions.insert(truth.session);
        for (std::size_t i = 0; i < truth_columns.size(); ++i)
            if (!found_.head.unknown_truth[i]) found_.truth[i].add(truth.*truth_columns[i].member);
        const auto degrees = [](double x_rad, double y_rad) {
            return std::hypot(x_rad, y_rad) * 180.0 / pi;
        };
        note("height", truth.height_m * 1e3, truth.label);
        note("sensor tilt", degrees(truth.sensor_tilt_x_rad, truth.sensor_tilt_y_rad), truth.label);
        note("sample tilt", degrees(truth.sample_tilt_x_rad, truth.sample_tilt_y_rad), truth.label);
    }

    /// Level of every RX: what a dead channel, an offset or clipping show in.
    void add_codes(const std::vector<std::int16_t>& codes, std::vector<Spread>& of_rx) {
        const auto n_samples = static_cast<std::size_t>(found_.head.n_samples);
        for (std::size_t i = 0; i < codes.size(); ++i)
            of_rx[i / n_samples % of_rx.size()].add(codes[i]);
    }

    void add_profiles(const Dataset& block) {
        const FrameProfiles profiles = frame_profiles(block, threads_);
        if (profiles.n_values == 0) return;
        const double own_bin_m = block.n_samples == 0 ? block.profile_bin_m : block.origin.bin_m;
        const double bin_m = block.sample_axis == SampleAxis::beat ? own_bin_m : 0.0;
        const bool knows_height = bin_m > 0.0 && !block.unknown_truth[column_of(&Truth::height_m)];
        for (std::size_t i = 0; i < block.n_frames(); ++i) {
            const Truth& truth = block.truth[i];
            const std::span<const float> row = profiles.row(i);
            ClassSummary& own = found_.classes[truth.label];
            own.profile_mean.resize(profiles.n_values);
            own.profile_sd.resize(profiles.n_values);
            for (std::size_t k = 0; k < row.size(); ++k) {
                own.profile_mean[k] += row[k];
                own.profile_sd[k] += static_cast<double>(row[k]) * row[k];
            }
            if (own.examples.size() < most_examples && begun_.insert(truth.session).second)
                own.examples.emplace_back(row.begin(), row.end());
            note("SNR", profile_snr_db(row, knows_height ? truth.height_m / bin_m : -1.0),
                 truth.label);
        }
    }

    DatasetSummary found_;
    int threads_;
    std::set<std::int32_t> begun_;  ///< sessions that an example was taken of
};

}  // namespace

const FrameQuantity* DatasetSummary::quantity(const std::string& name) const {
    for (const FrameQuantity& each : quantities)
        if (each.name == name) return &each;
    return nullptr;
}

DatasetSummary summarise_dataset(const std::filesystem::path& file, int threads) {
    const DatasetReader reader(file);
    Summary summary(reader, threads);
    Fingerprint hash;
    std::optional<Progress> progress;
    const double codes = static_cast<double>(reader.form().codes_per_frame()) *
                         static_cast<double>(reader.n_frames());
    if (codes > slow_codes) progress.emplace("reading", "frames", reader.n_frames());
    for_each_block(reader, [&](std::size_t first, const Dataset& block) {
        InterruptionWatch::check();
        summary.add(block);
        hash.add(reader.frame_hashes({first, first + block.n_frames()}));
        if (progress) progress->done() += block.n_frames();
    });
    DatasetSummary found = summary.result();
    found.fingerprint = hash.text();
    return found;
}

}  // namespace specula
