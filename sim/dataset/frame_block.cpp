#include "sim/dataset/frame_block.hpp"

namespace specula {

namespace {

/// The row of one frame in a table of (frame, per_frame) values; nothing of an empty table.
template <typename T>
std::span<const T> row_of(const std::vector<T>& table, std::size_t per_frame, std::size_t frame) {
    if (table.empty()) return {};
    return std::span(table).subspan(frame * per_frame, per_frame);
}

template <typename T>
std::vector<T> rows_of(const std::vector<T>& table, std::size_t per_frame,
                       const FrameRange& range) {
    if (table.empty()) return {};
    const auto at = [&](std::size_t frame) {
        return table.begin() + static_cast<std::ptrdiff_t>(frame * per_frame);
    };
    return {at(range.first), at(range.last)};
}

}  // namespace

std::uint64_t FrameHash::of(const Dataset& dataset, std::size_t frame) {
    const auto add = [&](const auto& table, std::size_t per_frame) {
        hash_.add(bytes_of_values(row_of(table, per_frame, frame)));
    };
    add(dataset.adc, dataset.codes_per_frame());
    add(dataset.adc_quadrature, dataset.codes_per_frame());
    add(dataset.profile, dataset.profile_per_frame());
    add(dataset.features, dataset.feature_names.size());
    add(dataset.probability, dataset.answer_names.size());
    hash_.add({&dataset.truth[frame].label, 1});
    const Sha256::Digest digest = hash_.finish();
    std::uint64_t value = 0;
    for (unsigned i = 0; i < 8; ++i) value |= std::uint64_t{digest[i]} << (8 * i);
    return value;
}

FrameBlock pack_frames(const Dataset& dataset, const FrameRange& range) {
    FrameBlock block;
    ChunkPacker packer;
    FrameHash hash;
    const auto pack = [&](const std::vector<std::int16_t>& codes, std::size_t frame,
                          PackedFrames& to) {
        if (!codes.empty()) packer.add(row_of(codes, dataset.codes_per_frame(), frame), to);
    };
    for (std::size_t frame = range.first; frame < range.last; ++frame) {
        pack(dataset.adc, frame, block.adc);
        pack(dataset.adc_quadrature, frame, block.adc_quadrature);
        block.frame_hash.push_back(hash.of(dataset, frame));
    }
    block.profile = rows_of(dataset.profile, dataset.profile_per_frame(), range);
    block.features = rows_of(dataset.features, dataset.feature_names.size(), range);
    block.probability = rows_of(dataset.probability, dataset.answer_names.size(), range);
    block.truth = rows_of(dataset.truth, 1, range);
    return block;
}

}  // namespace specula
