#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace specula {

/// Frames' codes as a file stores them, one chunk after another.
struct PackedFrames {
    std::vector<std::uint8_t> bytes;
    std::vector<std::size_t> ends;  ///< (frame): of its chunk in `bytes`

    std::size_t n_frames() const { return ends.size(); }
    std::span<const std::uint8_t> chunk(std::size_t frame) const {
        const std::size_t begin = frame == 0 ? 0 : ends[frame - 1];
        return std::span(bytes).subspan(begin, ends[frame] - begin);
    }
};

/// Makes of codes the chunk that HDF5's filters shuffle, deflate and fletcher32 would, outside of
/// that library's one lock and five times as fast; with ChunkUnpacker the one door to libdeflate.
///
/// One per thread. The same codes give the same bytes with the same version of libdeflate.
class ChunkPacker {
  public:
    ChunkPacker();
    ~ChunkPacker();
    ChunkPacker(const ChunkPacker&) = delete;
    ChunkPacker& operator=(const ChunkPacker&) = delete;

    void add(std::span<const std::int16_t> codes, PackedFrames& to);

  private:
    struct Compressor;  ///< hides the library
    std::unique_ptr<Compressor> compressor_;
    std::vector<std::uint8_t> shuffled_;
};

/// The way back, as much faster than HDF5's as that.
class ChunkUnpacker {
  public:
    ChunkUnpacker();
    ~ChunkUnpacker();
    ChunkUnpacker(const ChunkUnpacker&) = delete;
    ChunkUnpacker& operator=(const ChunkUnpacker&) = delete;

    /// @out  codes  of one chunk, all of them
    /// False, with `codes` undefined, where the checksum does not fit or other codes come out: let
    /// HDF5 say what is wrong.
    bool unpack(std::span<const std::uint8_t> chunk, std::span<std::int16_t> codes);

  private:
    struct Decompressor;  ///< hides the library
    std::unique_ptr<Decompressor> decompressor_;
    std::vector<std::uint8_t> shuffled_;
};

}  // namespace specula
