#include "tools/dataset/dataset_check.hpp"

#include <optional>

#include "tools/dataset/frame_blocks.hpp"
#include "tools/generate/interruption.hpp"
#include "tools/study/progress.hpp"

namespace specula {

void check_dataset(const DatasetReader& reader) {
    constexpr double long_codes = 3e7;  // about a second of unpacking
    std::optional<Progress> progress;
    const double codes = static_cast<double>(reader.form().codes_per_frame()) *
                         static_cast<double>(reader.n_frames());
    if (codes > long_codes) progress.emplace("Checking", "frames", reader.n_frames());
    for_each_block(reader, [&](std::size_t, const Dataset& block) {
        InterruptionWatch::check();
        if (progress) progress->done() += block.n_frames();
    });
}

}  // namespace specula
