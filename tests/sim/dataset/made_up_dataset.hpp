#pragma once

#include <cmath>
#include <fstream>
#include <iterator>

#include "sim/core/random.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/dataset/truth_range.hpp"
#include "tests/message_of.hpp"

namespace specula {

/// A dataset whose every field differs from every other and from its default.
inline Dataset made_up_dataset(std::size_t n_frames = 7) {
    Stream stream({.seed = 5, .purpose = "made up"});
    Dataset dataset;
    dataset.origin = {.condition = "tilt_sample",
                      .experiment = "title = \"Prüfung\"\n[sample]\nsize_mm = [300, 300]\n",
                      .seed = 18446744073709551615ull,
                      .version = "9.8.7",
                      .radar = "toy",
                      .bin_m = 0.0390625,
                      .recipe = "seed = 18446744073709551615\n"};
    dataset.class_names = {"iron", "a much longer name", "Nüsse"};
    dataset.n_chirps = 2;
    dataset.n_rx = 3;
    dataset.n_samples = 16;
    for (std::size_t i = 0; i < n_frames; ++i) {
        Truth truth;
        truth.label = static_cast<std::uint8_t>(stream.below(3));
        truth.world = static_cast<std::int32_t>(stream.bits() >> 1);
        truth.sample = -static_cast<std::int32_t>(stream.bits() >> 1);
        truth.session = static_cast<std::int32_t>(stream.bits() >> 1);
        truth.frame = static_cast<std::int32_t>(stream.bits() >> 1);
        for (std::size_t k = 0; k < truth_columns.size(); ++k) {
            const double value = stream.normal();
            truth.*truth_columns[k].member =
                0.4 * (truth_range(k).least < 0.0 ? value : std::abs(value));
        }
        dataset.truth.push_back(truth);
    }
    dataset.adc.resize(n_frames * dataset.codes_per_frame());
    for (std::int16_t& code : dataset.adc) code = static_cast<std::int16_t>(stream.bits() >> 16);
    return dataset;
}

/// The same as a recording would be: complex, processed by the sensor, little of its truth known.
inline Dataset made_up_recording() {
    Dataset dataset = made_up_dataset();
    Stream stream({.seed = 6, .purpose = "made up"});
    dataset.origin.source = "import npz";
    dataset.sample_axis = SampleAxis::range;
    dataset.has_views = true;
    dataset.feature_names = {"bin 0", "bin 1", "bin 2", "bin 3"};
    dataset.n_profile_bins = 8;
    dataset.profile_bin_m = 0.0375;
    dataset.profile_window = "blackman";
    for (std::size_t i = 0; i < dataset.n_frames() * dataset.profile_per_frame(); ++i)
        dataset.profile.push_back(static_cast<float>(stream.normal()));
    for (std::size_t i = 0; i < dataset.adc.size(); ++i)
        dataset.adc_quadrature.push_back(static_cast<std::int16_t>(stream.bits() >> 16));
    for (std::size_t i = 0; i < dataset.n_frames() * 4; ++i)
        dataset.features.push_back(stream.normal());
    dataset.answer_names = {"grass", "no grass"};
    for (std::size_t i = 0; i < dataset.n_frames() * 2; ++i)
        dataset.probability.push_back(static_cast<float>(stream.uniform()));
    for (Truth& truth : dataset.truth) truth.view = static_cast<std::int32_t>(stream.bits() >> 1);
    return dataset;
}

inline std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::string refusal_of(const std::filesystem::path& file) {
    return message_of([&] { return read_dataset(file); });
}

}  // namespace specula
