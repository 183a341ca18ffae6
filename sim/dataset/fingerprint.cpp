#include "sim/dataset/fingerprint.hpp"

#include "sim/dataset/frame_block.hpp"

namespace specula {

std::string fingerprint(const Dataset& dataset) {
    FrameHash hash;
    std::vector<std::uint64_t> hashes(dataset.n_frames());
    for (std::size_t i = 0; i < hashes.size(); ++i) hashes[i] = hash.of(dataset, i);
    Fingerprint all;
    all.add(hashes);
    return all.text();
}

}  // namespace specula
