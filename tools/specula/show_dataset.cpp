#include "tools/specula/show_dataset.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "sim/core/format.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/dataset/fingerprint.hpp"

namespace specula {

namespace {

struct Spread {
    double least = INFINITY, most = -INFINITY, sum = 0.0, n = 0.0;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
        sum += value;
        n += 1.0;
    }
    void print(const std::string& name, const char* unit) const {
        std::printf("%-20s %12.5g %12.5g %12.5g  %s\n", name.c_str(), least, sum / n, most, unit);
    }
};

void print_head(const char* what) {
    std::printf("\n%-20s %12s %12s %12s  %s\n", what, "least", "mean", "most", "unit");
}

std::string shape_of(const Dataset& dataset) {
    std::string text = format("{} frames", dataset.n_frames());
    if (dataset.n_samples > 0)
        text += format(" x {} chirps x {} RX x {} {}samples", dataset.n_chirps, dataset.n_rx,
                       dataset.n_samples, dataset.adc_quadrature.empty() ? "" : "complex ");
    if (!dataset.features.empty()) text += format(" of {} features", dataset.feature_names.size());
    return text;
}

void print_origin(const Dataset& dataset) {
    const Origin& origin = dataset.origin;
    const std::string bin =
        origin.bin_m > 0.0 ? format("{:.4g} cm", origin.bin_m * 100.0) : "unknown";
    std::printf("condition %s, radar %s, range bin %s, seed %llu, version %s\n",
                origin.condition.c_str(), origin.radar.c_str(), bin.c_str(),
                static_cast<unsigned long long>(origin.seed), origin.version.c_str());
    if (origin.source != "simulation")
        std::printf(
            "source %s%s\n", origin.source.c_str(),
            dataset.sample_axis == SampleAxis::range ? "; samples are range, not time" : "");
}

/// Pieces, sessions and views, where a file tells more than one apart.
void print_groups(const Dataset& dataset) {
    std::set<std::int32_t> samples, sessions, views;
    for (const Truth& truth : dataset.truth) {
        samples.insert(truth.sample);
        sessions.insert(truth.session);
        views.insert(truth.view);
    }
    std::printf("%zu samples, %zu sessions", samples.size(), sessions.size());
    if (dataset.has_views) std::printf(", %zu views", views.size());
    std::printf("\n\n");
}

void print_classes(const Dataset& dataset) {
    std::map<std::string, std::size_t> frames_of;
    for (const Truth& truth : dataset.truth) ++frames_of[dataset.class_names.at(truth.label)];
    for (const auto& [name, n] : frames_of) std::printf("%-20s %8zu frames\n", name.c_str(), n);
}

/// Level of every RX: what a dead channel, an offset or clipping show in.
void print_codes(const Dataset& dataset) {
    print_head("codes");
    const auto n_rx = static_cast<std::size_t>(dataset.n_rx);
    const auto n_samples = static_cast<std::size_t>(dataset.n_samples);
    const auto print = [&](const std::vector<std::int16_t>& codes, const char* part) {
        for (std::size_t rx = 0; rx < n_rx && !codes.empty(); ++rx) {
            Spread spread;
            for (std::size_t row = rx; row * n_samples < codes.size(); row += n_rx)
                for (std::size_t n = 0; n < n_samples; ++n) spread.add(codes[row * n_samples + n]);
            spread.print(format("RX {}{}", rx, part), "LSB");
        }
    };
    print(dataset.adc, "");
    print(dataset.adc_quadrature, " quadrature");
}

void print_features(const Dataset& dataset) {
    constexpr std::size_t most_shown = 16;
    const std::size_t n = dataset.feature_names.size();
    print_head("features");
    for (std::size_t k = 0; k < std::min(n, most_shown); ++k) {
        Spread spread;
        for (std::size_t i = 0; i < dataset.n_frames(); ++i)
            spread.add(dataset.features[i * n + k]);
        spread.print(dataset.feature_names[k], "");
    }
    if (n > most_shown) std::printf("... and %zu more\n", n - most_shown);
}

void print_truth(const Dataset& dataset) {
    if (dataset.unknown_truth.all()) {
        std::printf("\nno truth beyond the class is known\n");
        return;
    }
    print_head("truth");
    for (std::size_t i = 0; i < truth_columns.size(); ++i) {
        if (dataset.unknown_truth[i]) continue;
        Spread spread;
        for (const Truth& truth : dataset.truth) spread.add(truth.*truth_columns[i].member);
        spread.print(truth_columns[i].name, truth_columns[i].unit);
    }
}

}  // namespace

void show_dataset(const std::filesystem::path& file) {
    const Dataset dataset = read_dataset(file);
    std::printf("%s: %s\n", file.c_str(), shape_of(dataset).c_str());
    print_origin(dataset);
    std::printf("fingerprint %s\n", fingerprint(dataset).c_str());
    print_groups(dataset);
    print_classes(dataset);
    if (!dataset.adc.empty()) print_codes(dataset);
    if (!dataset.features.empty()) print_features(dataset);
    print_truth(dataset);
}

}  // namespace specula
