#include "classifier/peak_shape.hpp"

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/parallel.hpp"

namespace specula {

namespace {

constexpr std::size_t shapes_per_turn = 256;
constexpr float least_level_lsb = 0.01f;  // below all that noise leaves of a mean over receivers

}  // namespace

fw_relative_config shape_config(const Descriptor& descriptor) {
    const BinChoice search = descriptor.profile();
    return {.search_first = static_cast<std::uint16_t>(search.first),
            .n_search = static_cast<std::uint16_t>(search.count),
            .n_around = descriptor.bins.n_bins,
            .window = descriptor.bins.window,
            .target_bin = descriptor.normalise.target_bin,
            .floor_lsb = least_level_lsb};
}

FeatureTable peak_shapes(const Dataset& dataset, const Descriptor& descriptor, int threads) {
    const fw_relative_config config = shape_config(descriptor);
    FeatureTable table;
    table.n_features = fw_relative_features(&config);
    table.features.resize(dataset.n_frames() * table.n_features);
    const auto describe_turn = [&](std::size_t turn) {
        std::vector<float> scratch;
        const std::size_t end = std::min((turn + 1) * shapes_per_turn, dataset.n_frames());
        for (std::size_t i = turn * shapes_per_turn; i < end; ++i) {
            const fw_frame frame = dataset.frame(i);
            scratch.resize(fw_relative_scratch(&frame) / sizeof(float) + 1);
            const fw_status status =
                fw_relative(&frame, &config, scratch.data(), scratch.size() * sizeof(float),
                            &table.features[i * table.n_features]);
            if (status != FW_OK)
                throw InputError(format(
                    "descriptor: peak_shape cannot be taken from frames of {} samples: {}; use a "
                    "power of two of them, or range_bins",
                    dataset.n_samples, fw_status_name(status)));
        }
    };
    for_each_index((dataset.n_frames() + shapes_per_turn - 1) / shapes_per_turn, threads,
                   describe_turn);
    return table;
}

}  // namespace specula
