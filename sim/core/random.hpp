#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace specula {

/// Which random numbers: the same key gives the same stream on every machine, for any number of
/// threads and in any order of work. `purpose` is text, so that adding a purpose moves no other.
struct StreamKey {
    std::uint64_t seed = 0;
    std::string_view purpose;
    std::uint32_t world = 0;
    std::uint32_t item = 0;  ///< sample, session or frame: whatever the purpose is drawn for
};

/// A counter-based stream: Philox4x32-10 (Salmon et al., SC'11; the Random123 library).
///
/// Sequential draws come from consecutive counters, so a stream holds no state worth sharing.
/// Length: 2^34 numbers per key.
class Stream {
  public:
    explicit Stream(const StreamKey& key);

    std::uint32_t bits();
    /// In the open interval (0, 1), 32 bits of resolution.
    double uniform();
    /// Zero mean, unit variance (Box and Muller 1958).
    double normal();
    /// Integer in [0, n), n > 0, unbiased to 2^-32 n.
    std::uint32_t below(std::uint32_t n);
    /// The same numbers as one by one, many at a time.
    void fill_normal(std::span<double> values);
    void fill_bits(std::span<std::uint32_t> words);

  private:
    void refill();

    std::array<std::uint32_t, 2> key_;
    std::array<std::uint32_t, 4> counter_;
    std::array<std::uint32_t, 4> block_{};
    int used_ = 4;
    double spare_normal_ = 0.0;
    bool has_spare_ = false;
};

}  // namespace specula
