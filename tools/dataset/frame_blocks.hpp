#pragma once

#include <algorithm>

#include "sim/dataset/dataset_reader.hpp"

namespace specula {

/// As many frames as make a block of some 8 MB of codes.
inline std::size_t frames_per_block(const Dataset& form) {
    constexpr std::size_t block_bytes = 8 << 20, most_frames = 1 << 16;
    const std::size_t bytes = 4 * form.codes_per_frame() + 4 * form.profile_per_frame() +
                              8 * form.feature_names.size() + sizeof(Truth);
    return std::clamp<std::size_t>(block_bytes / bytes, 1, most_frames);
}

/// Calls work(first frame of the block, Dataset) for all frames in their order, so that memory does
/// not grow with the file.
template <typename Work>
void for_each_block(const DatasetReader& reader, const Work& work) {
    const std::size_t step = frames_per_block(reader.form()), n = reader.n_frames();
    for (std::size_t first = 0; first < n; first += step)
        work(first, reader.read({first, std::min(first + step, n)}));
}

/// Some frames of a block, of all its tables.
inline Dataset frames_of(const Dataset& block, const FrameRange& range) {
    Dataset some = block;
    const auto cut = [&](auto& table) {
        const std::size_t per_frame = table.size() / block.n_frames();
        table = {table.begin() + static_cast<std::ptrdiff_t>(range.first * per_frame),
                 table.begin() + static_cast<std::ptrdiff_t>(range.last * per_frame)};
    };
    cut(some.truth);
    cut(some.adc);
    cut(some.adc_quadrature);
    cut(some.profile);
    cut(some.features);
    cut(some.probability);
    return some;
}

}  // namespace specula
