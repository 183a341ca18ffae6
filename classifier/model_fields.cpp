#include "classifier/model_fields.hpp"

#include <limits>

#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr float below_all = std::numeric_limits<float>::lowest();

const std::vector<std::string> window_names{"rectangular", "hann", "blackman"};
const std::vector<std::string> integration_names{"single", "mean", "exported"};
const std::vector<std::string> path_names{"float", "hwa-like"};

template <typename Choice>
Choice read_choice(const JsonField& field, const std::vector<std::string>& names) {
    const std::string name = field.text();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name) return static_cast<Choice>(i);
    field.fail("is no such choice", "use " + quoted_list(names));
}

}  // namespace

FloatJson batch_norm_json(const BatchNorm& norm) {
    return {{"gamma", norm.gamma},
            {"beta", norm.beta},
            {"mean", norm.mean},
            {"variance", norm.variance}};
}

BatchNorm read_batch_norm(const JsonField& field, std::size_t n) {
    return {.gamma = field.at("gamma").numbers(n, below_all),
            .beta = field.at("beta").numbers(n, below_all),
            .mean = field.at("mean").numbers(n, below_all),
            .variance = field.at("variance").numbers(n, 0.0f)};
}

FloatJson convolution_json(const Convolution& convolution) {
    return {{"positions", convolution.n_positions}, {"kernel", convolution.kernel}};
}

Convolution read_convolution(const JsonField& field, std::size_t n_in) {
    const JsonField positions = field.at("positions");
    const JsonField kernel = field.at("kernel");
    const Convolution convolution{.n_positions = positions.integer_as<std::uint16_t>(),
                                  .kernel = kernel.integer_as<std::uint16_t>()};
    if (convolution.n_positions == 0 || n_in % convolution.n_positions != 0)
        positions.fail(format("does not part the {} values that come in", n_in),
                       "train the model again");
    if (convolution.kernel % 2 == 0) kernel.fail("is even", "use an odd one");
    return convolution;
}

FloatJson measurement_json(const Measurement& measurement) {
    const fw_chirp& chirp = measurement.chirp;
    const fw_extract_config& descriptor = measurement.descriptor;
    return {{"start_khz", chirp.start_khz},
            {"slope_khz_us", chirp.slope_khz_us},
            {"sample_rate_hz", chirp.sample_rate_hz},
            {"n_samples", chirp.n_samples},
            {"skip_samples", chirp.skip_samples},
            {"n_rx", chirp.n_rx},
            {"n_chirps", chirp.n_chirps},
            {"high_pass_hz_10", chirp.high_pass_hz_10},
            {"gain_db_100", chirp.gain_db_100},
            {"adc_bits", chirp.adc_bits},
            {"first_bin", descriptor.first_bin},
            {"n_bins", descriptor.n_bins},
            {"window", window_names.at(descriptor.window)},
            {"integration", integration_names.at(descriptor.integration)},
            {"range_fft", path_names.at(descriptor.path)}};
}

Measurement read_measurement(const JsonField& field) {
    Measurement measurement;
    measurement.chirp = {.start_khz = field.at("start_khz").integer_as<std::uint32_t>(),
                         .slope_khz_us = field.at("slope_khz_us").integer_as<std::int32_t>(),
                         .sample_rate_hz = field.at("sample_rate_hz").integer_as<std::uint32_t>(),
                         .n_samples = field.at("n_samples").integer_as<std::uint16_t>(),
                         .skip_samples = field.at("skip_samples").integer_as<std::uint16_t>(),
                         .n_rx = field.at("n_rx").integer_as<std::uint16_t>(),
                         .n_chirps = field.at("n_chirps").integer_as<std::uint16_t>(),
                         .high_pass_hz_10 = field.at("high_pass_hz_10").integer_as<std::uint16_t>(),
                         .gain_db_100 = field.at("gain_db_100").integer_as<std::int16_t>(),
                         .adc_bits = field.at("adc_bits").integer_as<std::uint16_t>()};
    measurement.descriptor = {
        .first_bin = field.at("first_bin").integer_as<std::uint16_t>(),
        .n_bins = field.at("n_bins").integer_as<std::uint16_t>(),
        .window = read_choice<fw_window>(field.at("window"), window_names),
        .integration = read_choice<fw_integration>(field.at("integration"), integration_names),
        .path = read_choice<fw_range_path>(field.at("range_fft"), path_names)};
    return measurement;
}

FloatJson monitor_json(const InputMonitor& monitor) {
    return {{"mean", monitor.mean},
            {"whitening", monitor.whitening},
            {"centre", monitor.centre},
            {"suspicious_squared", std::vector<float>{monitor.suspicious_squared}}};
}

InputMonitor read_monitor(const JsonField& field, const MonitorShape& shape) {
    const std::size_t n = shape.n_features;
    return {.mean = field.at("mean").numbers(n, below_all),
            .whitening = field.at("whitening").numbers(n * (n + 1) / 2, below_all),
            .centre = field.at("centre").numbers(shape.n_classes * n, below_all),
            .suspicious_squared =
                field.at("suspicious_squared").numbers(1, std::numeric_limits<float>::min())[0]};
}

FloatJson prototypes_json(const InputPrototypes& prototypes) {
    FloatJson rows = FloatJson::array();
    const std::size_t n = prototypes.mean.size();
    for (std::size_t at = 0; at < prototypes.centre.size(); at += n)
        rows.push_back(std::vector<float>(
            prototypes.centre.begin() + static_cast<std::ptrdiff_t>(at),
            prototypes.centre.begin() + static_cast<std::ptrdiff_t>(at + n)));
    return {{"mean", prototypes.mean}, {"scale", prototypes.scale}, {"centre", rows}};
}

InputPrototypes read_prototypes(const JsonField& field, std::size_t n_features) {
    InputPrototypes prototypes{.mean = field.at("mean").numbers(n_features, below_all),
                               .scale = field.at("scale").numbers(n_features, 0.0f),
                               .centre = {}};
    const auto rows = field.at("centre").items();
    if (rows.empty()) field.at("centre").fail("holds no prototype", "train the model again");
    for (const JsonField& row : rows) {
        const std::vector<float> numbers = row.numbers(n_features, below_all);
        prototypes.centre.insert(prototypes.centre.end(), numbers.begin(), numbers.end());
    }
    return prototypes;
}

}  // namespace specula
