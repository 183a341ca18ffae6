#pragma once

#include <algorithm>

#include "classifier/matrix.hpp"
#include "classifier/model.hpp"

namespace specula {

/// What a convolution sees at one position of a row: a run of the row that begins `before` it.
struct Neighbourhood {
    Eigen::Index row_begin;    ///< first value of the row that is seen
    Eigen::Index patch_begin;  ///< where it stands in the patch; what is beyond the row is 0
    Eigen::Index length;
};

inline Neighbourhood neighbourhood(const Convolution& convolution, Eigen::Index n_channels,
                                   Eigen::Index position) {
    const auto n = static_cast<Eigen::Index>(convolution.n_positions);
    const auto reach = static_cast<Eigen::Index>(convolution.kernel / 2);
    const Eigen::Index first = std::max<Eigen::Index>(0, position - reach);
    const Eigen::Index last = std::min(n - 1, position + reach);
    return {first * n_channels, (first - (position - reach)) * n_channels,
            (last - first + 1) * n_channels};
}

/// Rows (position channel, example) -> patches (kernel channel, example position).
template <typename Rows, typename Patches>
void gather_patches(const Convolution& convolution, const Rows& rows, Patches& patches) {
    const auto n_positions = static_cast<Eigen::Index>(convolution.n_positions);
    const Eigen::Index n_channels = rows.rows() / n_positions;
    for (Eigen::Index example = 0; example < rows.cols(); ++example)
        for (Eigen::Index position = 0; position < n_positions; ++position) {
            const Neighbourhood seen = neighbourhood(convolution, n_channels, position);
            auto patch = patches.col(example * n_positions + position);
            patch.setZero();
            patch.segment(seen.patch_begin, seen.length) =
                rows.col(example).segment(seen.row_begin, seen.length);
        }
}

/// The transpose of gather_patches: adds up what the patches say about each value of the rows.
template <typename Patches, typename Rows>
void scatter_patches(const Convolution& convolution, const Patches& patches, Rows& rows) {
    const auto n_positions = static_cast<Eigen::Index>(convolution.n_positions);
    const Eigen::Index n_channels = rows.rows() / n_positions;
    rows.setZero();
    for (Eigen::Index example = 0; example < rows.cols(); ++example)
        for (Eigen::Index position = 0; position < n_positions; ++position) {
            const Neighbourhood seen = neighbourhood(convolution, n_channels, position);
            rows.col(example).segment(seen.row_begin, seen.length) +=
                patches.col(example * n_positions + position)
                    .segment(seen.patch_begin, seen.length);
        }
}

}  // namespace specula
