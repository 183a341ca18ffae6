#include "scenes/catalogue.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/random.hpp"
#include "sim/recording/export_recording.hpp"
#include "sim/recording/import_recording.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"

// Out and back in: every format returns the codes, features and groups it was given, bit by bit.

namespace specula {
namespace {

/// Two classes of two pieces each; codes of 12 bits from end to end.
Dataset made_up_codes(bool is_complex) {
    Stream stream({.seed = 8, .purpose = "round trip"});
    Dataset dataset;
    dataset.origin.condition = "a \"quoted\" name";
    dataset.origin.radar = "iwrl6432boost";
    dataset.origin.bin_m = 0.0234;
    dataset.class_names = {"iron", "wood, pine"};
    dataset.n_chirps = 2;
    dataset.n_rx = 3;
    dataset.n_samples = 16;
    dataset.has_views = true;
    for (int i = 0; i < 8; ++i) {
        Truth truth;
        truth.label = static_cast<std::uint8_t>(i / 4);
        truth.sample = 10 + i / 2;
        truth.session = 20 + i / 2;
        truth.view = i / 2 % 2;
        truth.frame = i % 2;
        dataset.truth.push_back(truth);
    }
    const std::size_t n = dataset.n_frames() * dataset.codes_per_frame();
    const auto draw = [&] { return static_cast<std::int16_t>(int(stream.below(4096)) - 2048); };
    for (std::size_t i = 0; i < n; ++i) dataset.adc.push_back(draw());
    for (std::size_t i = 0; i < n && is_complex; ++i) dataset.adc_quadrature.push_back(draw());
    return dataset;
}

/// The same frames as a sensor that sends range profiles gives them.
Dataset made_up_features(bool whole) {
    Dataset dataset = made_up_codes(false);
    dataset.adc.clear();
    dataset.n_chirps = dataset.n_rx = dataset.n_samples = 0;
    Stream stream({.seed = 9, .purpose = "round trip"});
    dataset.feature_names = {"bin 0", "bin 1", "bin 2"};
    dataset.answer_names = {"class 0", "class 1"};
    for (std::size_t i = 0; i < 3 * dataset.n_frames(); ++i)
        dataset.features.push_back(whole ? double(stream.bits()) : stream.normal() * 1e-7);
    for (std::size_t i = 0; i < 2 * dataset.n_frames(); ++i)
        dataset.probability.push_back(static_cast<float>(stream.uniform()));
    return dataset;
}

const SentChirps chirp{
    .infineon = {.start_hz = 58e9, .end_hz = 63.5e9, .sample_rate_hz = 2e6}};

Dataset there_and_back(const std::string& format, const Dataset& dataset,
                       const SentChirps& sent = chirp) {
    const TemporaryFolder folder;
    const std::filesystem::path out = folder / "recording";
    for (const ExportedFile& file : export_recording(format, dataset, out, sent))
        write_file_atomically(file.name, file.content);
    const std::filesystem::path beside = out.string() + ".toml";
    const Section section =
        std::filesystem::exists(beside) ? Section::read(beside) : Section::parse("", "no manifest");
    const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    return import_recording(format, out, read_manifest(section, catalogue)).dataset;
}

void check_groups(const Dataset& back, const Dataset& given) {
    CHECK(back.class_names == given.class_names);
    REQUIRE(back.n_frames() == given.n_frames());
    CHECK(back.has_views);
    for (std::size_t i = 0; i < given.n_frames(); ++i) {
        CHECK(back.truth[i].label == given.truth[i].label);
        CHECK(back.truth[i].sample == given.truth[i].sample);
        CHECK(back.truth[i].session == given.truth[i].session);
        CHECK(back.truth[i].view == given.truth[i].view);
        CHECK(back.truth[i].frame == given.truth[i].frame);
    }
    CHECK(back.unknown_truth.all());  // no format carries heights and tilts
}

TEST_CASE("real codes come back from every format of codes", "[recording]") {
    const Dataset given = made_up_codes(false);
    for (const std::string& format : export_formats()) {
        if (carries_features(format)) continue;
        INFO(format);
        const Dataset back = there_and_back(format, given);
        CHECK(back.adc == given.adc);
        CHECK(back.adc_quadrature.empty());
        CHECK(back.n_chirps == 2);
        CHECK(back.n_rx == 3);
        CHECK(back.n_samples == 16);
        CHECK(back.origin.condition == given.origin.condition);
        CHECK(back.origin.bin_m == given.origin.bin_m);
        CHECK(back.origin.source == "import " + format);
        check_groups(back, given);
    }
}

TEST_CASE("TX that take turns are virtual antennas of an injection file", "[recording]") {
    const Dataset given = made_up_codes(false);  // 2 chirps of 3 RX
    const SentChirps by_turns{.infineon = {}, .n_tx = 2};
    const auto files = export_recording("injection", given, "x", by_turns);
    // u32 each: samples, virtual antennas, chirps of each TX, frames.
    CHECK(files.at(0).content.substr(0, 16) ==
          std::string("\x10\0\0\0\x06\0\0\0\x01\0\0\0\x08\0\0\0", 16));
    const Dataset back = there_and_back("injection", given, by_turns);
    CHECK(back.n_chirps == 2);
    CHECK(back.n_rx == 3);
    CHECK(back.adc == given.adc);
    CHECK(message_of([&] {
              return export_recording("injection", given, "x", {.infineon = {}, .n_tx = 3}).size();
          }).find("2 chirps of a frame are no whole number for each of 3 TX") !=
          std::string::npos);
}

TEST_CASE("complex codes come back, or are refused", "[recording]") {
    const Dataset given = made_up_codes(true);
    for (const std::string format : {"adc", "dca1000", "npy"}) {
        INFO(format);
        const Dataset back = there_and_back(format, given);
        CHECK(back.adc == given.adc);
        CHECK(back.adc_quadrature == given.adc_quadrature);
    }
    for (const std::string format : {"rdif", "injection", "infineon"})
        CHECK(message_of([&] {
                  return export_recording(format, given, "x", chirp).size();
              }).find("the codes are complex, which " + format + " cannot hold") !=
              std::string::npos);
}

TEST_CASE("features and answers come back from every format of features", "[recording]") {
    for (const std::string format : {"uart", "csv", "npy"}) {
        INFO(format);
        const Dataset given = made_up_features(format == "uart");
        const Dataset back = there_and_back(format, given);
        CHECK(back.features == given.features);
        CHECK(back.adc.empty());
        check_groups(back, given);
        if (format == "npy") continue;
        CHECK(back.feature_names == given.feature_names);
        if (format == "uart") CHECK(back.probability == given.probability);
    }
}

TEST_CASE("what a format cannot say is refused before anything is written", "[recording]") {
    const auto refusal = [](const std::string& format, const Dataset& dataset) {
        return message_of([&] { return export_recording(format, dataset, "x", chirp).size(); });
    };
    CHECK(refusal("uart", made_up_features(false)).find("is no whole number of 32 bits") !=
          std::string::npos);
    CHECK(refusal("rdif", made_up_features(true)).find("there are no codes") != std::string::npos);
    CHECK(refusal("uart", made_up_codes(false)).find("there are no features") != std::string::npos);
    Dataset wide = made_up_codes(false);
    wide.adc[5] = -2049;
    CHECK(refusal("infineon", wide).find("code -2049: is below the 12 bits") != std::string::npos);
    CHECK(refusal("rdif", wide).find("does not fit into 12 bits") != std::string::npos);
    CHECK(refusal("wav", wide).find("\"wav\": no such format; use ") == 0);
}

}  // namespace
}  // namespace specula
