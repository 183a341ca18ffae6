#pragma once

#include <cstdint>
#include <vector>

#include "sim/dataset/chunk_packer.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/dataset/sha256.hpp"

namespace specula {

/// Frames ready for a file, and what files give back without unpacking: each vector holds one row
/// per frame, or nothing where the file has no such table.
struct FrameBlock {
    PackedFrames adc;
    PackedFrames adc_quadrature;
    std::vector<float> profile;
    std::vector<double> features;
    std::vector<float> probability;
    std::vector<std::uint64_t> frame_hash;
    std::vector<Truth> truth;

    std::size_t n_frames() const { return truth.size(); }
};

/// Rows [first, last) of a dataset.
struct FrameRange {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// Hashes and packs some frames of a dataset. Depends on nothing but them.
FrameBlock pack_frames(const Dataset& dataset, const FrameRange& range);

/// The first eight bytes, little-endian, of the SHA-256 of a frame's rows: /adc, /adc_quadrature,
/// /profile, /features and /probability, of those that the dataset has and in this order, as
/// little-endian numbers; last its /label.
class FrameHash {
  public:
    std::uint64_t of(const Dataset& dataset, std::size_t frame);

  private:
    Sha256 hash_;
};

}  // namespace specula
