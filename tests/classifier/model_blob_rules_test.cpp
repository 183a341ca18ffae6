#include <cmath>
#include <cstring>

#include "firmware/fw_classify.h"
#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/whole_model.hpp"
#include "tests/firmware/oracle.hpp"
#include "tests/message_of.hpp"

// Every rule of firmware/MODEL_FORMAT.md that a blob with a right checksum can still break.

namespace specula {
namespace {

constexpr std::size_t names_at = 100, name_bytes = 24;
constexpr std::size_t scales_at = names_at + 5 * name_bytes + 12 * 4;

/// A blob with other bytes in one place, and a checksum that agrees with them.
Blob with_bytes(Blob blob, std::size_t at, const std::string& bytes) {
    std::memcpy(blob.data() + at, bytes.data(), bytes.size());
    return resealed(blob);
}

Blob with_float(Blob blob, std::size_t at, float value) {
    fw_write_f32(blob.data() + at, value);
    return resealed(blob);
}

TEST_CASE("class names are text of their own, filled up with zeros", "[blob]") {
    const Blob good = model_blob(whole_model(), FW_ARITHMETIC_FLOAT);
    const auto named = [&](const std::string& bytes) {
        std::string padded = bytes;
        padded.resize(name_bytes);
        return open_status(with_bytes(good, names_at, padded));
    };
    // RFC 3629: one of each length, and the last code point before the surrogates.
    for (const char* text : {"iron", "\xC3\xA9", "\xE6\x9C\xA8", "\xED\x9F\xBF", "\xF0\x9F\xAA\xB5",
                             "abcdefghijklmnopqrstuvw"})
        CHECK(named(text) == FW_OK);
    // A lone continuation, a cut sequence, overlong forms, a surrogate, beyond U+10FFFF, no lead.
    for (const char* text :
         {"\x80", "\xC3", "a\xE6\x9C", "\xC0\xAF", "\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF",
          "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF",
          "abcdefghijklmnopqrstuvwx", "abcdefghijklmnopqrstuv\xC3"})
        CHECK(named(text) == FW_ERR_NAME);
    CHECK(named("") == FW_ERR_NAME);
    CHECK(named(std::string("iron\0x", 6)) == FW_ERR_NAME);
    const std::string second(reinterpret_cast<const char*>(good.data()) + names_at + name_bytes);
    CHECK(named(second) == FW_ERR_NAME);
}

TEST_CASE("numbers that nothing uses are zero, and a scale is not negative", "[blob]") {
    const Blob real = model_blob(whole_model(), FW_ARITHMETIC_FLOAT);
    CHECK(open_status(with_float(real, 40, 11.5f)) == FW_ERR_VALUE);  // target bin without align
    CHECK(open_status(with_float(real, 40, std::nanf(""))) == FW_ERR_VALUE);
    CHECK(open_status(with_float(real, 44, std::nanf(""))) == FW_ERR_VALUE);  // floor without log
    CHECK(open_status(with_float(real, 88, 21.0f)) == FW_ERR_VALUE);  // levels of a float32 model
    CHECK(open_status(with_float(real, 88, -0.0f)) == FW_ERR_VALUE);
    CHECK(open_status(with_float(real, scales_at, -0.1f)) == FW_ERR_VALUE);
    CHECK(open_status(with_float(real, scales_at, 0.0f)) == FW_OK);  // a feature switched off
    Blob searching = real;
    fw_write_u16(searching.data() + 48,
                 5);  // a search in other bins, where nothing asks for a peak
    fw_write_u16(searching.data() + 50, 13);
    CHECK(open_status(resealed(searching)) == FW_ERR_CONFIG);
    Model unwatched = whole_model();
    unwatched.monitor.reset();
    const Blob plain = model_blob(unwatched, FW_ARITHMETIC_FLOAT);
    CHECK(open_status(plain) == FW_OK);
    CHECK(open_status(with_float(plain, 92, 26.0f)) == FW_ERR_VALUE);  // a limit without a monitor
}

TEST_CASE("the padding of integer rows is zero", "[blob]") {
    Model model = whole_model();
    model.hidden[1] = random_model({16, 15, 5}).hidden[0];  // rows of 15 in, padded to 16
    model.output = random_model({12, 15, 5}).output;
    const Blob good = model_blob(model, FW_ARITHMETIC_INT8);
    fw_model opened;
    REQUIRE(fw_model_open(good.data(), good.size(), &opened) == FW_OK);
    const auto* const weight = static_cast<const std::uint8_t*>(opened.whole.layer[2].weight);
    const auto padding = static_cast<std::size_t>(weight - good.data()) + 15;
    CHECK(good[padding] == 0);
    CHECK(open_status(with_bytes(good, padding, "\1")) == FW_ERR_VALUE);
}

TEST_CASE("a normalisation goes into the blob and comes out of it", "[blob]") {
    Model model = whole_model();
    model.provenance = {{"descriptor",
                         "range_bins 6 12 blackman align 11.5 range 11.5 log 0.25 search 3 30"}};
    const Blob blob = model_blob(model, FW_ARITHMETIC_FLOAT);
    fw_model opened;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &opened) == FW_OK);
    CHECK(opened.normalise.align);
    CHECK(opened.normalise.compensate_range);
    CHECK(opened.normalise.logarithm);
    CHECK(opened.normalise.target_bin == 11.5f);
    CHECK(opened.normalise.floor_lsb == 0.25f);
    CHECK(opened.search_first == 3);
    CHECK(opened.n_search == 30);
    model.provenance = {{"descriptor", "range_bins 6 12 blackman log 0.25"}};  // no peak: no search
    const Blob log_only = model_blob(model, FW_ARITHMETIC_FLOAT);
    REQUIRE(fw_model_open(log_only.data(), log_only.size(), &opened) == FW_OK);
    CHECK(opened.search_first == 6);
    CHECK(opened.n_search == 12);
}

TEST_CASE("the shape of a peak goes into a blob of version 2 and comes out of it", "[blob]") {
    const auto arithmetic = GENERATE(FW_ARITHMETIC_FLOAT, FW_ARITHMETIC_INT16, FW_ARITHMETIC_INT8);
    const Blob blob = model_blob(shape_model(), arithmetic);
    CHECK(fw_read_u16(blob.data() + 4) == 2);
    fw_model opened;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &opened) == FW_OK);
    CHECK(opened.kind == FW_FEATURES_PEAK_SHAPE);
    CHECK(opened.n_features == 25);
    CHECK(opened.shape.search_first == 4);
    CHECK(opened.shape.n_search == 20);
    CHECK(opened.shape.n_around == 12);
    CHECK(opened.shape.window == FW_WINDOW_BLACKMAN);
    CHECK(opened.shape.target_bin == 11.5f);
    CHECK(opened.shape.floor_lsb == 0.01f);
    CHECK_FALSE(opened.normalise.align);
}

TEST_CASE("what the first version can say is said in it, in the bytes that it always had",
          "[blob]") {
    const Blob bins = model_blob(whole_model(), FW_ARITHMETIC_FLOAT);
    CHECK(fw_read_u16(bins.data() + 4) == 1);
    CHECK(fw_read_u16(bins.data() + 26) == 0);  // reserved there
    const Blob shape = model_blob(shape_model(), FW_ARITHMETIC_FLOAT);
    const auto with = [](Blob blob, std::size_t at, std::uint16_t value) {
        fw_write_u16(blob.data() + at, value);
        return open_status(resealed(blob));
    };
    CHECK(with(bins, 4, 2) == FW_ERR_VERSION);  // a later form of the same
    CHECK(with(bins, 4, 3) == FW_ERR_VERSION);
    CHECK(with(shape, 4, 1) == FW_ERR_CONFIG);  // as programs of version 1 refuse a reserved field
    CHECK(with(shape, 26, 0) == FW_ERR_VERSION);
    CHECK(with(shape, 26, 2) == FW_ERR_CONFIG);
}

TEST_CASE("a peak's shape has numbers of its own, and no others", "[blob]") {
    const Blob good = model_blob(shape_model(), FW_ARITHMETIC_FLOAT);
    REQUIRE(open_status(good) == FW_OK);
    const auto with = [&](std::size_t at, std::uint16_t value) {
        Blob blob = good;
        fw_write_u16(blob.data() + at, value);
        return open_status(resealed(blob));
    };
    CHECK(with(22, 24) == FW_ERR_SHAPE);   // not 2 bins + 1
    CHECK(with(28, 6) == FW_ERR_CONFIG);   // a first bin: nothing uses it
    CHECK(with(30, 32) == FW_ERR_CONFIG);  // more bins than fw_relative takes
    CHECK(with(30, 11) == FW_ERR_SHAPE);
    CHECK(with(34, FW_INTEGRATE_SINGLE) == FW_ERR_CONFIG);
    CHECK(with(36, FW_RANGE_HWA_LIKE) == FW_ERR_CONFIG);
    CHECK(with(38, 1) == FW_ERR_CONFIG);  // a normalisation
    CHECK(open_status(with_float(good, 40, 0.0f)) == FW_ERR_CONFIG);
    CHECK(open_status(with_float(good, 40, std::nanf(""))) == FW_ERR_CONFIG);
    CHECK(open_status(with_float(good, 44, -1.0f)) == FW_ERR_CONFIG);
    CHECK(with(50, 61) == FW_ERR_CONFIG);  // bins 4 to 64 of 64
    CHECK(with(50, 2) == FW_ERR_CONFIG);   // no peak among two
    CHECK(with(64, 96) == FW_ERR_SHAPE);   // samples that are no power of two
}

TEST_CASE("a peak's shape needs the samples, and an echo in every row", "[blob]") {
    const Blob blob = model_blob(shape_model(), FW_ARITHMETIC_FLOAT);
    fw_model model;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &model) == FW_OK);
    std::vector<float> scratch(fw_classify_scratch(&model) / sizeof(float));
    const std::size_t n_bytes = scratch.size() * sizeof(float);
    fw_result result{};
    result.label = 77;
    const std::vector<float> amplitude(64, 1.0f);
    const fw_bins spectrum{.amplitude = amplitude.data(), .first_bin = 0, .n_bins = 64};
    CHECK(fw_classify_bins(&model, &spectrum, scratch.data(), n_bytes, &result) == FW_ERR_CONFIG);
    auto samples = oracle::random_codes(3 * 128, 1);
    const fw_frame frame{samples.data(), 1, 3, 128};
    CHECK(fw_classify(&model, &frame, scratch.data(), n_bytes - 4, &result) == FW_ERR_SCRATCH);
    std::fill(samples.begin() + 128, samples.begin() + 256, std::int16_t{0});  // a dead receiver
    CHECK(fw_classify(&model, &frame, scratch.data(), n_bytes, &result) == FW_ERR_NONFINITE);
    CHECK(result.label == 77);
    samples = oracle::random_codes(3 * 128, 1);
    const fw_frame whole{samples.data(), 1, 3, 128};
    CHECK(fw_classify(&model, &whole, scratch.data(), n_bytes, &result) == FW_OK);
    CHECK(result.label < 5);
}

TEST_CASE("a model without its measurement is refused with what is missing and a way on",
          "[blob]") {
    Model model = whole_model();
    model.measurement.reset();
    model.provenance = {{"descriptor", "columns 0 12 blackman"}};
    const std::string message = message_of([&] { model_blob(model, FW_ARITHMETIC_FLOAT); });
    for (const char* part : {"measurement: is missing", "columns 0 12 blackman", "radar = \"NAME\"",
                             "specula study", "--onnx"})
        CHECK(message.find(part) != std::string::npos);
}

}  // namespace
}  // namespace specula
