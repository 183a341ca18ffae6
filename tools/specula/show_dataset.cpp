#include "tools/specula/show_dataset.hpp"

#include <cstdio>

#include "sim/core/atomic_file.hpp"
#include "sim/core/format.hpp"
#include "sim/parallel.hpp"
#include "tools/dataset/dataset_figure.hpp"
#include "tools/dataset/dataset_summary.hpp"
#include "tools/dataset/text_histogram.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/specula/output_place.hpp"

namespace specula {

namespace {

void print_head(const char* what) {
    std::printf("\n%-20s %12s %12s %12s  %s\n", what, "least", "mean", "most", "unit");
}

void print_spread(const std::string& name, const Spread& spread, const char* unit) {
    std::printf("%-20s %12.5g %12.5g %12.5g  %s\n", name.c_str(), spread.least, spread.mean(),
                spread.most, unit);
}

std::string shape_of(const DatasetSummary& summary) {
    const Dataset& head = summary.head;
    std::string text = format("{} frames", summary.n_frames);
    if (head.n_samples > 0)
        text += format(" x {} chirps x {} RX x {} {}samples", head.n_chirps, head.n_rx,
                       head.n_samples, summary.quadrature[0].n == 0 ? "" : "complex ");
    if (head.n_profile_bins > 0)
        text += format(", range profiles of {} RX x {} bins", head.n_rx, head.n_profile_bins);
    if (!head.feature_names.empty()) text += format(" of {} features", head.feature_names.size());
    return text;
}

void print_origin(const Dataset& dataset) {
    const Origin& origin = dataset.origin;
    const std::string bin =
        origin.bin_m > 0.0 ? format("{:.4g} cm", origin.bin_m * 100.0) : "unknown";
    std::printf("condition %s, radar %s, range bin %s, seed %llu, version %s\n",
                origin.condition.c_str(), origin.radar.c_str(), bin.c_str(),
                static_cast<unsigned long long>(origin.seed), origin.version.c_str());
    if (origin.recipe.rfind("augment_seed", 0) == 0)
        std::printf("augmented: changed copies among the frames, see /augmentation\n");
    if (origin.source != "simulation")
        std::printf(
            "source %s%s\n", origin.source.c_str(),
            dataset.sample_axis == SampleAxis::range ? "; samples are range, not time" : "");
}

/// Pieces, sessions and views, where a file tells more than one apart.
void print_groups(const DatasetSummary& summary) {
    std::printf("%zu worlds, %zu samples, %zu sessions", summary.worlds.size(),
                summary.samples.size(), summary.sessions.size());
    if (summary.head.has_views) std::printf(", %zu views", summary.views.size());
    std::printf("\n\n");
}

void print_classes(const DatasetSummary& summary) {
    std::size_t most = 1;
    for (const ClassSummary& each : summary.classes) most = std::max(most, each.n_frames);
    for (const ClassSummary& each : summary.classes) {
        if (each.n_frames == 0) continue;
        constexpr std::size_t longest_bar = 30;
        const std::string bar((longest_bar * each.n_frames + most - 1) / most, '#');
        std::printf("%-20s %8zu frames of %4zu samples, %5zu sessions |%s\n", each.name.c_str(),
                    each.n_frames, each.samples.size(), each.sessions.size(), bar.c_str());
    }
}

void print_codes(const DatasetSummary& summary) {
    if (summary.head.n_samples == 0 || summary.n_frames == 0) return;
    print_head("codes");
    for (std::size_t rx = 0; rx < summary.codes.size(); ++rx)
        print_spread(format("RX {}", rx), summary.codes[rx], "LSB");
    for (std::size_t rx = 0; rx < summary.quadrature.size(); ++rx)
        if (summary.quadrature[rx].n > 0)
            print_spread(format("RX {} quadrature", rx), summary.quadrature[rx], "LSB");
}

void print_features(const DatasetSummary& summary) {
    constexpr std::size_t most_shown = 16;
    const std::size_t n = summary.features.size();
    if (n == 0 || summary.n_frames == 0) return;
    print_head("features");
    for (std::size_t k = 0; k < std::min(n, most_shown); ++k)
        print_spread(summary.head.feature_names[k], summary.features[k], "");
    if (n > most_shown) std::printf("... and %zu more\n", n - most_shown);
}

void print_truth(const DatasetSummary& summary) {
    if (summary.head.unknown_truth.all()) {
        std::printf("\nno truth beyond the class is known\n");
        return;
    }
    if (summary.n_frames == 0) return;
    print_head("truth");
    for (std::size_t i = 0; i < truth_columns.size(); ++i)
        if (summary.truth[i].n > 0)
            print_spread(truth_columns[i].name, summary.truth[i], truth_columns[i].unit);
}

void print_distributions(const DatasetSummary& summary) {
    for (const FrameQuantity& quantity : summary.quantities)
        if (!quantity.values.empty())
            std::printf("\n%s",
                        text_histogram(quantity.name, quantity.unit, quantity.values).c_str());
}

void draw(const DatasetSummary& summary, const std::filesystem::path& file,
          const std::filesystem::path& where) {
    const Figure figure = dataset_figure(file.stem().string(), summary);
    const Drawing drawing = render_figure(figure);
    const std::string kind = where.extension().string();
    if (kind == ".svg" || kind == ".png") {
        write_file_atomically(where, kind == ".svg" ? drawing.svg : drawing.png);
        std::printf("\nWrote %s\n", where.c_str());
        return;
    }
    write_figure(where, figure, drawing);
    std::printf("\nWrote %s.svg, .png and .csv\n", (where / figure.name).c_str());
}

}  // namespace

void show_dataset(const std::filesystem::path& file, const std::filesystem::path& figure) {
    check_figure_place(figure, {".svg", ".png"});
    const DatasetSummary summary = summarise_dataset(file, available_threads());
    std::printf("%s: %s\n", file.c_str(), shape_of(summary).c_str());
    print_origin(summary.head);
    std::printf("fingerprint %s\n", summary.fingerprint.c_str());
    print_groups(summary);
    print_classes(summary);
    print_codes(summary);
    print_features(summary);
    print_truth(summary);
    print_distributions(summary);
    if (!figure.empty()) draw(summary, file, figure);
}

}  // namespace specula
