#include "classifier/extract_features.hpp"

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/parallel.hpp"

namespace specula {

namespace {

constexpr std::size_t frames_per_block = 256;

}  // namespace

FeatureTable extract_features(const Dataset& dataset, const fw_extract_config& config, int threads,
                              std::atomic<std::size_t>* frames_done) {
    FeatureTable table;
    table.extractor = "range_bins";
    table.n_features = config.n_bins;
    table.class_names = dataset.class_names;
    table.features.resize(dataset.n_frames() * table.n_features);
    for (const Truth& truth : dataset.truth) {
        table.label.push_back(truth.label);
        table.world.push_back(truth.world);
        table.session.push_back(truth.session);
    }
    const auto extract_block = [&](std::size_t block) {
        const std::size_t first = block * frames_per_block;
        const std::size_t last = std::min(first + frames_per_block, dataset.n_frames());
        std::vector<float> scratch;
        for (std::size_t i = first; i < last; ++i) {
            const fw_frame frame = dataset.frame(i);
            const std::size_t bytes = fw_extract_scratch(&frame);
            scratch.resize(bytes / sizeof(float) + 1);
            const fw_status status =
                fw_extract(&frame, &config, scratch.data(), scratch.size() * sizeof(float),
                           &table.features[i * table.n_features]);
            if (status != FW_OK)
                throw InputError(format(
                    "the descriptor (bins {} to {}) cannot be taken from frames of {} samples: {}; "
                    "choose other bins or another window",
                    config.first_bin, config.first_bin + config.n_bins - 1, dataset.n_samples,
                    fw_status_name(status)));
        }
        if (frames_done) *frames_done += last - first;
    };
    const std::size_t n_blocks = (dataset.n_frames() + frames_per_block - 1) / frames_per_block;
    for_each_index(n_blocks, threads, extract_block);
    return table;
}

}  // namespace specula
