#include "classifier/normalised_bins.hpp"

#include <cmath>

#include "classifier/extract_features.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

void scale_to_unit_energy(std::span<float> row) {
    double energy = 0.0;
    for (const float value : row) energy += static_cast<double>(value) * static_cast<double>(value);
    if (energy == 0.0) return;  // silence has no shape
    const double factor = 1.0 / std::sqrt(energy);
    for (float& value : row) value = static_cast<float>(factor * static_cast<double>(value));
}

}  // namespace

FeatureTable normalised_bins(const Dataset& dataset, const Descriptor& descriptor, int threads,
                             std::atomic<std::size_t>* frames_done) {
    const fw_normalise_config& steps = descriptor.normalise;
    const BinChoice search = descriptor.profile();
    fw_extract_config wide = descriptor.bins;
    wide.first_bin = static_cast<std::uint16_t>(search.first);
    wide.n_bins = static_cast<std::uint16_t>(search.count);
    FeatureTable table = extract_features(dataset, wide, threads, frames_done);
    const std::size_t n_out = descriptor.bins.n_bins;
    std::vector<float> features(table.size() * n_out);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const fw_bins profile{
            .amplitude = table.row(i).data(), .first_bin = wide.first_bin, .n_bins = wide.n_bins};
        const std::span<float> row = std::span(features).subspan(i * n_out, n_out);
        const fw_status status = fw_normalise(&profile, &steps, descriptor.bins.first_bin,
                                              descriptor.bins.n_bins, row.data());
        if (status != FW_OK)
            throw InputError(
                format("descriptor: frame {} cannot be normalised: {}; look at the recording", i,
                       fw_status_name(status)));
        if (descriptor.unit_energy) scale_to_unit_energy(row);
    }
    table.n_features = n_out;
    table.features = std::move(features);
    return table;
}

}  // namespace specula
