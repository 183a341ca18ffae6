#pragma once

#include <span>
#include <string>

#include "sim/dataset/dataset.hpp"
#include "sim/dataset/sha256.hpp"

namespace specula {

/// A hash of recordings: the first 16 hexadecimal digits of the SHA-256 of their frames' hashes
/// (FORMAT.md), in order. Equal for equal codes, profiles, features and labels, whatever file they
/// came from.
class Fingerprint {
  public:
    void add(std::span<const std::uint64_t> frame_hashes) {
        hash_.add(bytes_of_values(frame_hashes));
    }
    std::string text() { return hexadecimal(hash_.finish()).substr(0, 16); }

  private:
    Sha256 hash_;
};

std::string fingerprint(const Dataset& dataset);

}  // namespace specula
