#include "firmware/fw_classify.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "firmware/fw_exported_profile.h"
#include "tests/check.hpp"
#include "tests/classifier/whole_model.hpp"

namespace specula {
namespace {

/// An opened model that owns its bytes.
struct Opened {
    Blob blob;
    fw_model model{};
    std::vector<float> scratch;

    Opened(const Model& source, fw_arithmetic arithmetic) : blob(model_blob(source, arithmetic)) {
        REQUIRE(fw_model_open(blob.data(), blob.size(), &model) == FW_OK);
        scratch.resize(fw_classify_scratch(&model) / sizeof(float));
    }
    fw_status classify(const fw_frame& frame, fw_result& result) {
        return fw_classify(&model, &frame, scratch.data(), scratch.size() * 4, &result);
    }
    fw_status classify(const fw_bins& spectrum, fw_result& result) {
        return fw_classify_bins(&model, &spectrum, scratch.data(), fw_classify_bins_scratch(&model),
                                &result);
    }
};

/// Three rows of a tone at a range bin, with a little of everything else.
std::vector<std::int16_t> rows_of_tone(double bin, double amplitude_lsb, std::size_t n_samples) {
    std::vector<std::int16_t> samples(3 * n_samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double angle = 2 * std::numbers::pi * bin * static_cast<double>(i % n_samples) /
                             static_cast<double>(n_samples);
        samples[i] = static_cast<std::int16_t>(std::lround(
            amplitude_lsb * std::cos(angle) + 7.0 * std::sin(0.37 * static_cast<double>(i))));
    }
    return samples;
}

Model normalising_model(fw_integration integration) {
    Model model = whole_model();
    model.measurement->descriptor.integration = integration;
    model.provenance = {
        {"descriptor", "range_bins 6 12 blackman align 11.5 range 11.5 log 0.25 search 4 24"}};
    model.input_mean.assign(12, 3.0f);
    model.input_scale.assign(12, 0.5f);
    model.monitor->mean.assign(12, 3.0f);
    return model;
}

TEST_CASE("a class from bins is the class from the frame, normalisation and monitors included",
          "[firmware]") {
    const auto integration = GENERATE(FW_INTEGRATE_MEAN, FW_INTEGRATE_EXPORTED);
    const auto arithmetic = GENERATE(FW_ARITHMETIC_FLOAT, FW_ARITHMETIC_INT8);
    Opened opened(normalising_model(integration), arithmetic);
    const auto samples = rows_of_tone(9.3, 400.0, 128);
    const fw_frame frame{samples.data(), 1, 3, 128};
    fw_result whole{}, from_bins{};
    REQUIRE(opened.classify(frame, whole) == FW_OK);

    fw_extract_config all = opened.model.descriptor;
    all.first_bin = 0;
    all.n_bins = 64;
    std::vector<float> scratch(fw_extract_scratch(&frame) / 4), spectrum(64);
    REQUIRE(fw_extract(&frame, &all, scratch.data(), 4 * scratch.size(), spectrum.data()) == FW_OK);
    REQUIRE(opened.classify(fw_bins{spectrum.data(), 0, 64}, from_bins) == FW_OK);
    for (std::size_t i = 0; i < 12; ++i) CHECK(from_bins.features[i] == whole.features[i]);
    for (std::size_t c = 0; c < 5; ++c) CHECK(from_bins.logits[c] == whole.logits[c]);
    for (std::size_t c = 0; c < 5; ++c) CHECK(from_bins.probabilities[c] == whole.probabilities[c]);
    CHECK(from_bins.label == whole.label);
    CHECK(from_bins.squared == whole.squared);
    CHECK(from_bins.squared > 0.0f);
    CHECK(from_bins.energy == whole.energy);
    CHECK(from_bins.suspicious == whole.suspicious);
    CHECK(from_bins.n_clipped_inputs == whole.n_clipped_inputs);
    CHECK(from_bins.quality.peak == 0);

    // fw_infer alone on the raw bins, as PORTING.md once had it, is another answer.
    std::vector<float> logits(5);
    REQUIRE(fw_infer(&opened.model, spectrum.data() + 6, opened.scratch.data(),
                     4 * opened.scratch.size(), logits.data(), nullptr) == FW_OK);
    CHECK(logits[0] != whole.logits[0]);
}

TEST_CASE("bins that do not hold the model's, or are no amplitudes, are refused", "[firmware]") {
    Opened opened(normalising_model(FW_INTEGRATE_MEAN), FW_ARITHMETIC_FLOAT);
    std::vector<float> spectrum(64, 1.0f);
    fw_result result{};
    result.label = 77;
    CHECK(opened.classify(fw_bins{spectrum.data() + 4, 4, 24}, result) == FW_OK);
    result = {};
    result.label = 77;
    CHECK(opened.classify(fw_bins{spectrum.data() + 5, 5, 40}, result) == FW_ERR_SHAPE);
    CHECK(opened.classify(fw_bins{spectrum.data(), 0, 27}, result) == FW_ERR_SHAPE);
    CHECK(opened.classify(fw_bins{nullptr, 0, 64}, result) == FW_ERR_NULL);
    spectrum[20] = std::numeric_limits<float>::quiet_NaN();
    CHECK(opened.classify(fw_bins{spectrum.data(), 0, 64}, result) == FW_ERR_NONFINITE);
    spectrum[20] = 1.0f;
    const fw_bins bins{spectrum.data(), 0, 64};
    CHECK(fw_classify_bins(&opened.model, &bins, opened.scratch.data(),
                           fw_classify_bins_scratch(&opened.model) - 1, &result) == FW_ERR_SCRATCH);
    CHECK(fw_classify_bins(nullptr, &bins, opened.scratch.data(), 4, &result) == FW_ERR_NULL);
    CHECK(fw_classify_bins_scratch(nullptr) == 0);
    CHECK(result.label == 77);
}

TEST_CASE("a frame whose HWA-like spectrum is cut off is suspicious, below the converter's limit",
          "[firmware]") {
    Model model = whole_model();
    model.measurement->chirp.n_samples = 512;
    model.measurement->descriptor.path = FW_RANGE_HWA_LIKE;
    model.monitor->suspicious_squared = 1e9f;
    model.input_scale.assign(12, 1e-4f);
    Opened opened(model, FW_ARITHMETIC_FLOAT);
    fw_result result{};
    const auto quiet = rows_of_tone(10.0, 1100.0, 512);
    REQUIRE(opened.classify(fw_frame{quiet.data(), 1, 3, 512}, result) == FW_OK);
    CHECK(result.n_saturated_bins == 0);
    CHECK_FALSE(result.suspicious);
    const auto loud = rows_of_tone(10.0, 2000.0, 512);
    REQUIRE(opened.classify(fw_frame{loud.data(), 1, 3, 512}, result) == FW_OK);
    CHECK(result.quality.n_saturated == 0);
    CHECK(result.n_saturated_bins == 3);  // in each of three rows
    CHECK(result.suspicious);
}

TEST_CASE(
    "inputs beyond an integer network's reach make a frame suspicious, in float32 they do not",
    "[firmware]") {
    Model model = whole_model();
    model.monitor->suspicious_squared = 1e9f;
    model.input_scale.assign(12, 0.05f);  // 20 LSB are one sigma: 400 LSB are 18
    const auto samples = rows_of_tone(10.0, 400.0, 128);
    const fw_frame frame{samples.data(), 1, 3, 128};
    fw_result result{};
    Opened whole(model, FW_ARITHMETIC_INT16);
    REQUIRE(whole.classify(frame, result) == FW_OK);
    CHECK(result.n_clipped_inputs == 3);  // bin 10 and what Blackman leaves in 9 and 11
    CHECK(result.suspicious);
    Opened real(model, FW_ARITHMETIC_FLOAT);
    REQUIRE(real.classify(frame, result) == FW_OK);
    CHECK(result.n_clipped_inputs == 0);
    CHECK_FALSE(result.suspicious);
}

}  // namespace
}  // namespace specula
