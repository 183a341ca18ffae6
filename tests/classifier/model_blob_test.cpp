#include "classifier/model_blob.hpp"

#include <cstring>

#include "classifier/folded_model.hpp"
#include "classifier/integer_model.hpp"
#include "firmware/fw_classify.h"
#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/naive_model.hpp"
#include "tests/classifier/whole_model.hpp"
#include "tests/firmware/oracle.hpp"

namespace specula {
namespace {

TEST_CASE("a blob opens as the model it was written from, bit for bit", "[blob]") {
    const Model model = whole_model();
    const Blob blob = model_blob(model, FW_ARITHMETIC_FLOAT);
    const FoldedModel folded = fold(model);
    fw_model opened;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &opened) == FW_OK);
    CHECK(opened.n_features == 12);
    CHECK(opened.chirp.start_khz == 57'500'000);
    CHECK(opened.chirp.slope_khz_us == 150'000);
    CHECK(opened.chirp.gain_db_100 == 4000);
    CHECK(opened.chirp.adc_bits == 12);
    CHECK(opened.descriptor.window == FW_WINDOW_BLACKMAN);
    CHECK(opened.suspicious_squared == 26.0f);
    for (std::size_t c = 0; c < 5; ++c) CHECK(opened.class_name[c] == model.class_names[c]);
    REQUIRE(opened.real.n_layers == 3);
    for (std::size_t l = 0; l < 3; ++l) {
        const auto& layer = folded.layers[l];
        CHECK(std::memcmp(opened.real.layer[l].weight, layer.weight.data(),
                          4 * layer.weight.size()) == 0);
        CHECK(std::memcmp(opened.real.layer[l].bias, layer.bias.data(), 4 * layer.bias.size()) ==
              0);
    }
}

TEST_CASE("an integer blob runs as the quantised model it holds", "[blob]") {
    const auto arithmetic = GENERATE(FW_ARITHMETIC_INT16, FW_ARITHMETIC_INT8);
    const Model model = whole_model();
    const Blob blob = model_blob(model, arithmetic);
    fw_model opened;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &opened) == FW_OK);
    const IntegerModel integers =
        quantise(model, arithmetic == FW_ARITHMETIC_INT8 ? FW_INT8 : FW_INT16);
    const fw_int_mlp view = integers.view();
    std::vector<float> scratch(256), a(5), b(5);
    Stream stream({.seed = 4, .purpose = "blob test"});
    for (int i = 0; i < 20; ++i) {
        auto features = random_features(12, stream);
        for (float& feature : features) feature = 30.0f + 10.0f * feature;
        REQUIRE(fw_int_mlp_run(&view, features.data(), scratch.data(), 1024, a.data(), nullptr) ==
                FW_OK);
        REQUIRE(fw_infer(&opened, features.data(), scratch.data(), 1024, b.data(), nullptr) ==
                FW_OK);
        CHECK(a == b);
    }
}

TEST_CASE("each way to spoil a blob has a status of its own", "[blob]") {
    const Blob good = model_blob(whole_model(), FW_ARITHMETIC_FLOAT);
    REQUIRE(open_status(good) == FW_OK);
    const auto with = [&](std::size_t at, std::uint16_t value) {
        Blob blob = good;
        fw_write_u16(blob.data() + at, value);
        return blob;
    };
    CHECK(open_status(with(0, 0x5252)) == FW_ERR_MAGIC);
    CHECK(open_status(with(4, 2)) == FW_ERR_VERSION);
    CHECK(open_status(with(8, 77)) == FW_ERR_LENGTH);
    CHECK(open_status(with(300, 77)) == FW_ERR_CHECKSUM);
    CHECK(open_status(resealed(with(16, 3))) == FW_ERR_CONFIG);       // arithmetic
    CHECK(open_status(resealed(with(32, 9))) == FW_ERR_CONFIG);       // window
    CHECK(open_status(resealed(with(28, 60))) == FW_ERR_CONFIG);      // bins beyond the spectrum
    CHECK(open_status(resealed(with(22, 13))) == FW_ERR_SHAPE);       // features
    CHECK(open_status(resealed(with(24, 17))) == FW_ERR_SHAPE);       // classes
    CHECK(open_status(resealed(with(78, 17))) == FW_ERR_LENGTH);      // wider than its weights
    CHECK(open_status(resealed(with(302, 0x7FC0))) == FW_ERR_VALUE);  // a NaN among the weights
    Blob shorter = good;
    shorter.resize(good.size() - 4);
    CHECK(open_status(shorter) == FW_ERR_LENGTH);
    CHECK(open_status({'R', 'F'}) == FW_ERR_MAGIC);
    std::vector<std::uint32_t> aligned(good.size() / 4 + 1);
    auto* moved = reinterpret_cast<std::uint8_t*>(aligned.data()) + 2;
    std::memcpy(moved, good.data(), good.size());
    fw_model model;
    CHECK(fw_model_open(moved, good.size(), &model) == FW_ERR_ALIGNMENT);
    CHECK(fw_model_open(nullptr, 100, &model) == FW_ERR_NULL);
}

TEST_CASE("every single wrong bit in a blob is refused", "[blob]") {
    Blob blob = model_blob(whole_model(), FW_ARITHMETIC_INT8);
    std::size_t accepted = 0;
    for (std::size_t bit = 0; bit < 8 * blob.size(); bit += 3) {
        blob[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
        accepted += open_status(blob) == FW_OK;
        blob[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    }
    CHECK(accepted == 0);
}

TEST_CASE("a model is refused under another chirp and for frames of another shape", "[blob]") {
    const Blob blob = model_blob(whole_model(), FW_ARITHMETIC_FLOAT);
    fw_model model;
    REQUIRE(fw_model_open(blob.data(), blob.size(), &model) == FW_OK);
    const fw_chirp own = model.chirp;
    CHECK(fw_model_accepts_chirp(&model, &own) == FW_OK);
    const auto refused = [&](auto change) {
        fw_chirp other = own;
        change(other);
        CHECK(fw_model_accepts_chirp(&model, &other) == FW_ERR_CHIRP);
    };
    refused([](fw_chirp& c) { c.start_khz += 1; });
    refused([](fw_chirp& c) { c.slope_khz_us = -c.slope_khz_us; });
    refused([](fw_chirp& c) { c.sample_rate_hz += 1; });
    refused([](fw_chirp& c) { c.n_samples = 256; });
    refused([](fw_chirp& c) { c.skip_samples = 0; });
    refused([](fw_chirp& c) { c.n_rx = 2; });
    refused([](fw_chirp& c) { c.n_chirps = 2; });
    refused([](fw_chirp& c) { c.high_pass_hz_10 = 35'000; });
    refused([](fw_chirp& c) { c.gain_db_100 = 3800; });
    refused([](fw_chirp& c) { c.adc_bits = 16; });

    const auto samples = oracle::random_codes(3 * 256, 1);
    std::vector<float> scratch(fw_classify_scratch(&model) / sizeof(float));
    fw_result result{};
    const auto status = [&](fw_frame frame) {
        return fw_classify(&model, &frame, scratch.data(), scratch.size() * 4, &result);
    };
    CHECK(status({samples.data(), 1, 3, 128}) == FW_OK);
    CHECK(result.suspicious);  // random codes of 16 bits saturate a converter of 12
    CHECK(status({samples.data(), 1, 3, 256}) == FW_ERR_GEOMETRY);
    CHECK(status({samples.data(), 1, 2, 128}) == FW_ERR_GEOMETRY);
    CHECK(status({samples.data(), 2, 3, 128}) == FW_ERR_GEOMETRY);
    CHECK(status({nullptr, 1, 3, 128}) == FW_ERR_NULL);
}

TEST_CASE("a model the firmware cannot hold is not exported", "[blob]") {
    const auto refused = [](auto spoil) {
        Model model = whole_model();
        spoil(model);
        CHECK_THROWS_AS(model_blob(model, FW_ARITHMETIC_FLOAT), InputError);
    };
    refused([](Model& model) { model.measurement.reset(); });
    refused([](Model& model) { model.class_names[0] = std::string(24, 'a'); });
    refused([](Model& model) { model.class_names[0] = ""; });
    refused([](Model& model) { model.measurement->descriptor.n_bins = 11; });
    refused([](Model& model) { model.measurement->descriptor.first_bin = 60; });
    refused([](Model& model) { model.measurement->chirp.n_samples = 8; });
}

TEST_CASE("a blob as C holds its very bytes", "[blob]") {
    const std::string text = blob_as_c({0x52, 0x00, 0xff, 0x0a}, "bench");
    CHECK(text.find("_Alignas(4) const unsigned char bench[4] = {") != std::string::npos);
    CHECK(text.find("0x52, 0x00, 0xff, 0x0a,") != std::string::npos);
    CHECK_THROWS_AS(blob_as_c({1}, "no name"), InputError);
}

}  // namespace
}  // namespace specula
