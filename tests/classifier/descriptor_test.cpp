#include "classifier/descriptor.hpp"

#include "classifier/extract_features.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

/// Two frames of two chirps and 24 samples, which count upwards.
Dataset frames_along(SampleAxis axis) {
    Dataset dataset;
    dataset.class_names = {"a"};
    dataset.n_chirps = 2;
    dataset.n_rx = 1;
    dataset.n_samples = 64;
    dataset.sample_axis = axis;
    dataset.truth.resize(2);
    for (int i = 0; i < 2 * 2 * 64; ++i) dataset.adc.push_back(static_cast<std::int16_t>(3 * i));
    return dataset;
}

TEST_CASE("beat samples are described by the firmware's own extractor", "[classifier]") {
    const Dataset dataset = frames_along(SampleAxis::beat);
    const Descriptor descriptor = descriptor_for(dataset);
    CHECK(descriptor.text() == "range_bins 6 12 blackman");
    CHECK(describe(dataset, descriptor, 1).features ==
          extract_features(dataset, descriptor.bins, 1).features);
    CHECK(descriptor_for(dataset, BinChoice{0, 32}).text() == "range_bins 0 32 blackman");
}

TEST_CASE("samples that are range are described by mean magnitudes of windows", "[classifier]") {
    Dataset dataset = frames_along(SampleAxis::range);
    for (const std::int16_t code : dataset.adc)
        dataset.adc_quadrature.push_back(static_cast<std::int16_t>(code / 3 * 4));
    const Descriptor descriptor = descriptor_for(dataset, BinChoice{0, 4});
    const FeatureTable rows = describe(dataset, descriptor, 1);
    CHECK(rows.n_features == 4);
    // |3 i + 4 i j| = 5 i; window w of the first frame: i from 16 w to 16 w + 15, and 64 later.
    for (int w = 0; w < 4; ++w)
        CHECK(rows.features[static_cast<std::size_t>(w)] ==
              5.0f * (16.0f * float(w) + 7.5f + 32.0f));
    CHECK(descriptor_for(dataset).text() == "range_windows 0 12 blackman");
}

TEST_CASE("recorded features are taken as they are", "[classifier]") {
    Dataset dataset;
    dataset.class_names = {"a"};
    dataset.truth.resize(2);
    dataset.feature_names = {"x", "y", "z"};
    dataset.features = {1, 2, 3, 4, 5, 6};
    CHECK(describe(dataset, descriptor_for(dataset), 1).features ==
          std::vector<float>{1, 2, 3, 4, 5, 6});
    CHECK(describe(dataset, descriptor_for(dataset, BinChoice{1, 2}), 1).features ==
          std::vector<float>{2, 3, 5, 6});
    CHECK(message_of([&] {
              return descriptor_for(dataset, BinChoice{2, 2}).text();
          }) == "bins 2:2: there are 3 features; choose among them");
}

TEST_CASE("a model says what it was trained on, and data of another kind are refused",
          "[classifier]") {
    Model model;
    model.extractor = "range_windows";
    model.input_mean = {0, 0, 0, 0};
    model.provenance = {{"descriptor", "range_windows 0 4 rect"}};
    CHECK(descriptor_of(model).text() == "range_windows 0 4 rect");
    CHECK(message_of([&] {
              return describe(frames_along(SampleAxis::beat), descriptor_of(model), 1).size();
          }).rfind("range_windows: takes samples along range, and /adc holds beat samples; ", 0) ==
          0);
    Dataset bare;
    bare.class_names = {"a"};
    bare.truth.resize(1);
    CHECK(
        message_of([&] {
            return descriptor_for(bare, BinChoice{0, 12}).text();
        }).rfind("columns: takes recorded features (/features), and the dataset holds none; ", 0) ==
        0);
    model.provenance = {{"descriptor", "range_windows 0 5 rect"}};
    CHECK(message_of([&] {
              return descriptor_of(model).text();
          }).rfind("provenance: descriptor = ", 0) == 0);
    model.provenance.clear();
    model.extractor = "range_bins";
    CHECK(descriptor_of(model).text() == "range_bins 6 4 blackman");
}

TEST_CASE("complex beat samples are refused, for the firmware takes real ones", "[classifier]") {
    Dataset dataset = frames_along(SampleAxis::beat);
    dataset.adc_quadrature = dataset.adc;
    CHECK(message_of([&] {
              return descriptor_for(dataset).text();
          }).rfind("the codes are complex", 0) == 0);
}

}  // namespace
}  // namespace specula
