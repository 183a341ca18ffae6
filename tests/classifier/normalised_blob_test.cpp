#include <cmath>

#include "classifier/descriptor.hpp"
#include "classifier/model_blob.hpp"
#include "classifier/predict.hpp"
#include "classifier/train.hpp"
#include "firmware/fw_classify.h"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

// From frame to class on the chip's own path, with the normalisation that the model was trained on.

namespace specula {
namespace {

/// Strong and weak echoes at any height; the class is the level at 1 / R.
Dataset seeded_echoes(std::uint64_t seed) {
    Dataset dataset;
    dataset.class_names = {"strong", "weak"};
    dataset.n_chirps = 1;
    dataset.n_rx = 3;
    dataset.n_samples = 128;
    Stream stream({.seed = seed, .purpose = "normalised blob test"});
    for (int frame = 0; frame < 120; ++frame) {
        const double bin = 9.0 + 6.0 * stream.uniform();
        const double amplitude = (frame % 2 == 0 ? 1200.0 : 600.0) * 12.0 / bin;
        const double phase = two_pi * stream.uniform();
        dataset.truth.push_back(
            {.label = static_cast<std::uint8_t>(frame % 2), .session = frame / 10});
        for (int rx = 0; rx < 3; ++rx)
            for (int i = 0; i < 128; ++i)
                dataset.adc.push_back(static_cast<std::int16_t>(std::lround(
                    amplitude * std::cos(two_pi * bin * i / 128 + phase) + 4 * stream.normal())));
    }
    return dataset;
}

Model trained(const Dataset& dataset, const Descriptor& descriptor) {
    Model model = train(describe(dataset, descriptor, 1),
                        {.hidden = {8}, .epochs = 60, .batch_size = 16, .learning_rate = 0.01},
                        {.seed = 1, .purpose = "normalised blob test"});
    model.provenance.emplace_back("descriptor", descriptor.text());
    model.measurement =
        Measurement{.chirp = {57'500'000, 150'000, 5'000'000, 128, 28, 3, 1, 17'500, 4000, 12},
                    .descriptor = descriptor.bins};
    return model;
}

TEST_CASE("the chip normalises as the model was trained, and answers the same", "[blob]") {
    const auto line = GENERATE(as<std::string>(), "range_bins 6 12 blackman",
                               "range_bins 6 12 blackman align 12 range 12 log 1 search 5 20",
                               "range_bins 6 12 blackman range 12 log 0.5 search 3 30",
                               "peak_shape 6 12 blackman align 12 range 12 search 5 20",
                               "peak_shape 0 31 hann align 12 range 12 search 0 40");
    const Descriptor descriptor = parse_descriptor(line);
    const Model model = trained(seeded_echoes(1), descriptor);
    const auto blob = model_blob(model, FW_ARITHMETIC_FLOAT);
    fw_model opened;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &opened) == FW_OK);
    std::vector<float> scratch(fw_classify_scratch(&opened) / sizeof(float) + 1);

    const Dataset asked = seeded_echoes(2);
    const FeatureTable rows = describe(asked, descriptor, 1);
    const Predictions answers = predict(fold(model), rows);
    std::size_t n_right = 0;
    for (std::size_t i = 0; i < asked.n_frames(); ++i) {
        const fw_frame frame = asked.frame(i);
        fw_result result;
        REQUIRE(fw_classify(&opened, &frame, scratch.data(), scratch.size() * sizeof(float),
                            &result) == FW_OK);
        REQUIRE(opened.n_features == rows.n_features);
        for (std::size_t k = 0; k < rows.n_features; ++k) CHECK(result.features[k] == rows.row(i)[k]);
        CHECK(result.logits[0] == answers.logits[2 * i]);
        CHECK(result.label == answers.label[i]);
        n_right += answers.label[i] == asked.truth[i].label;
    }
    CHECK((line.find("align") == std::string::npos || n_right == asked.n_frames()));
}

TEST_CASE("a descriptor that the chip has no code for is not exported", "[blob]") {
    const Descriptor descriptor = parse_descriptor("range_bins 6 12 blackman unit");
    const Model model = trained(seeded_echoes(1), descriptor);
    CHECK(message_of([&] { return model_blob(model, FW_ARITHMETIC_FLOAT).size(); }) ==
          "descriptor = \"range_bins 6 12 blackman unit\": the firmware does not compute it; train "
          "on range_bins with align, range and log, or export the network alone as --onnx");
}

TEST_CASE("the exact form of a peak's shape is refused with the form that the chip has", "[blob]") {
    const Descriptor descriptor =
        parse_descriptor("relative_profile 6 12 blackman align 12 range 12 search 5 20");
    const Model model = trained(seeded_echoes(1), descriptor);
    const std::string message = message_of([&] { model_blob(model, FW_ARITHMETIC_FLOAT); });
    CHECK(message.find("train on peak_shape") != std::string::npos);
    CHECK(message_of([&] {
              parse_descriptor("peak_shape 6 12 blackman hwa align 12 range 12 search 5 20");
          }).find("no single, exported or hwa") != std::string::npos);
}

}  // namespace
}  // namespace specula
