#include "sim/dataset/chunk_packer.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <new>

#include "sim/core/expect.hpp"

namespace specula {

namespace {

constexpr int compression_level = 4;

/// HDF5's checksum of a chunk: Fletcher's two sums over big-endian words of 16 bits, modulo 65535
/// (J. G. Fletcher, IEEE Trans. Comm. 30, 1982), an odd last byte being the high one.
std::uint32_t fletcher32(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t words_before_overflow = 360;
    const auto fold = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
    std::uint32_t first = 0, second = 0;
    std::size_t n_words = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 2) {
        const std::uint32_t low = i + 1 < bytes.size() ? bytes[i + 1] : 0;
        first += static_cast<std::uint32_t>(bytes[i]) << 8 | low;
        second += first;
        if (++n_words % words_before_overflow == 0) {
            first = fold(first);
            second = fold(second);
        }
    }
    first = fold(fold(first));
    second = fold(fold(second));
    return second << 16 | first;
}

}  // namespace

struct ChunkPacker::Compressor {
    libdeflate_compressor* library = libdeflate_alloc_compressor(compression_level);
    Compressor() {
        if (!library) throw std::bad_alloc();
    }
    ~Compressor() { libdeflate_free_compressor(library); }
};

ChunkPacker::ChunkPacker() : compressor_(std::make_unique<Compressor>()) {}
ChunkPacker::~ChunkPacker() = default;

void ChunkPacker::add(std::span<const std::int16_t> codes, PackedFrames& to) {
    const std::size_t n = codes.size();
    shuffled_.resize(2 * n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto code = static_cast<std::uint16_t>(codes[i]);
        shuffled_[i] = static_cast<std::uint8_t>(code & 0xff);
        shuffled_[n + i] = static_cast<std::uint8_t>(code >> 8);
    }
    libdeflate_compressor* const library = compressor_->library;
    const std::size_t begin = to.bytes.size();
    to.bytes.resize(begin + libdeflate_zlib_compress_bound(library, shuffled_.size()));
    const std::size_t size =
        libdeflate_zlib_compress(library, shuffled_.data(), shuffled_.size(),
                                 to.bytes.data() + begin, to.bytes.size() - begin);
    SPECULA_EXPECT(size > 0);
    to.bytes.resize(begin + size);
    const std::uint32_t sum = fletcher32(std::span(to.bytes).subspan(begin));
    for (int shift = 0; shift < 32; shift += 8)
        to.bytes.push_back(static_cast<std::uint8_t>(sum >> shift));
    to.ends.push_back(to.bytes.size());
}

struct ChunkUnpacker::Decompressor {
    libdeflate_decompressor* library = libdeflate_alloc_decompressor();
    Decompressor() {
        if (!library) throw std::bad_alloc();
    }
    ~Decompressor() { libdeflate_free_decompressor(library); }
};

ChunkUnpacker::ChunkUnpacker() : decompressor_(std::make_unique<Decompressor>()) {}
ChunkUnpacker::~ChunkUnpacker() = default;

bool ChunkUnpacker::unpack(std::span<const std::uint8_t> chunk, std::span<std::int16_t> codes) {
    constexpr std::size_t checksum_size = 4;
    if (chunk.size() < checksum_size) return false;
    const auto packed = chunk.first(chunk.size() - checksum_size);
    std::uint32_t stored = 0;
    for (std::size_t i = 0; i < checksum_size; ++i)
        stored |= static_cast<std::uint32_t>(chunk[packed.size() + i]) << (8 * i);
    if (stored != fletcher32(packed)) return false;
    const std::size_t n = codes.size();
    shuffled_.resize(2 * n);
    std::size_t n_out = 0;
    if (libdeflate_zlib_decompress(decompressor_->library, packed.data(), packed.size(),
                                   shuffled_.data(), shuffled_.size(),
                                   &n_out) != LIBDEFLATE_SUCCESS ||
        n_out != shuffled_.size())
        return false;
    for (std::size_t i = 0; i < n; ++i)
        codes[i] = static_cast<std::int16_t>(
            static_cast<std::uint16_t>(shuffled_[i] | shuffled_[n + i] << 8));
    return true;
}

}  // namespace specula
