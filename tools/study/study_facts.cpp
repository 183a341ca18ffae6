#include "tools/study/study_facts.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/format.hpp"
#include "sim/generate.hpp"
#include "sim/limits.hpp"

namespace specula {

std::vector<ClassProfile> profiles_of(const FeatureTable& rows) {
    std::vector<ClassProfile> profiles(rows.class_names.size());
    std::vector<double> count(rows.class_names.size(), 0.0);
    for (ClassProfile& profile : profiles) {
        profile.mean.assign(rows.n_features, 0.0);
        profile.sd.assign(rows.n_features, 0.0);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ClassProfile& profile = profiles[rows.label[i]];
        count[rows.label[i]] += 1.0;
        for (std::size_t k = 0; k < rows.n_features; ++k) {
            const double value = rows.row(i)[k];
            profile.mean[k] += value;
            profile.sd[k] += value * value;
        }
    }
    for (std::size_t label = 0; label < profiles.size(); ++label) {
        const double n = std::max(1.0, count[label]);
        for (std::size_t k = 0; k < rows.n_features; ++k) {
            double& mean = profiles[label].mean[k];
            double& sd = profiles[label].sd[k];
            mean /= n;
            sd = std::sqrt(std::max(0.0, sd / n - mean * mean));
        }
    }
    return profiles;
}

std::vector<int> merged_map(const Experiment& experiment) {
    const auto& merged = experiment.merged_classes;
    std::vector<int> map;
    int next = merged.empty() ? 0 : 1;
    for (std::size_t label = 0; label < experiment.population.classes.size(); ++label) {
        const bool together = std::find(merged.begin(), merged.end(), label) != merged.end();
        map.push_back(together ? 0 : next++);
    }
    return map;
}

std::string merged_label(const Experiment& experiment) {
    std::string label;
    for (const std::size_t i : experiment.merged_classes)
        label += (label.empty() ? "" : " and ") + experiment.population.classes[i].name;
    return label.empty() ? "none merged" : label + " merged";
}

RadarFacts facts_of(const Experiment& experiment) {
    const Chirp& chirp = experiment.radar.chirp;
    return {.name = experiment.radar.title,
            .start_frequency_hz = chirp.frequency_hz(0),
            .slope_hz_s = chirp.slope_hz_s,
            .sampled_bandwidth_hz = chirp.bandwidth_hz(),
            .range_bin_m = chirp.bin_m(),
            .nominal_height_m = experiment.nominal_height_m,
            .nominal_height_bin = chirp.bin_of(experiment.nominal_height_m),
            .first_descriptor_bin = experiment.descriptor.first_bin,
            .feature_quantity = "amplitude (LSB)"};
}

std::vector<std::string> warnings_of(const Experiment& experiment, const Library& materials) {
    const FrequencyBand band = experiment.radar.chirp.band();
    std::vector<std::string> warnings;
    const auto add = [&](const std::string& text) {
        if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
            warnings.push_back(text);
    };
    for (const SampleLaw& law : experiment.population.classes) {
        for (const BandWarning& warning : band_warnings(law.nominal, materials, band))
            add(warning.text());
        Scene scene;
        scene.radar = experiment.radar;
        scene.sample = law.nominal;
        scene.sample.roughness_m = law.roughness_m.median();
        scene.sample.correlation_m = law.correlation_m.median();
        for (const std::string& warning : roughness_warnings(scene.sample, band))
            add(law.name + ": " + warning);
        for (const std::string& limit : optics_limits(scene, materials))
            add(law.name + ": " + limit);
    }
    return warnings;
}

void warn_of_weak_echoes(const std::vector<Recording>& recordings, const Experiment& experiment,
                         const RunSettings& run, std::vector<std::string>& warnings) {
    for (const Recording& recording : recordings) {
        if (recording.weak_echoes == 0) continue;
        warnings.push_back(format(
            "{}: {} of {} sessions have an echo 15 dB or more below that of an endless sheet; "
            "edges count there, and full-wave solutions differ by up to 1.5 dB",
            recording.condition.title, recording.weak_echoes,
            session_count(recording.condition, experiment.population, run.worlds)));
    }
}

}  // namespace specula
