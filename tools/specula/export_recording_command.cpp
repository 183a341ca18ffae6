#include <cstdio>

#include "classifier/descriptor.hpp"
#include "classifier/extract_features.hpp"
#include "classifier/model_file.hpp"
#include "classifier/predict.hpp"
#include "classifier/same_measurement.hpp"
#include "firmware/fw_exported_profile.h"
#include "firmware/fw_range_profile.h"
#include "firmware/fw_softmax.h"
#include "sim/core/atomic_file.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"
#include "sim/parallel.hpp"
#include "sim/recording/export_recording.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/commands.hpp"

namespace specula {

namespace {

constexpr int injection_samples = 128, injection_rx = 3;  // TI's MMW_DEMO_TEST_ADC_BUFF_SIZE

/// All range bins of every frame, in the whole numbers of the firmware (fw_exported_profile.h),
/// through the window and the rows that the model was trained on, if there is one.
void add_range_profile(const std::optional<Measurement>& trained, Dataset& dataset) {
    const Descriptor fitting = descriptor_for(dataset, BinChoice{0, 1});
    if (fitting.extractor != "range_bins")
        throw InputError(
            "a profile of TLV 302 is made of beat samples, and these are none; use npy or csv");
    fw_extract_config config = trained ? trained->descriptor : fitting.bins;
    const auto n_samples = static_cast<std::uint16_t>(dataset.n_samples);
    config.first_bin = 0;
    config.n_bins = static_cast<std::uint16_t>(fw_range_fft_size(n_samples) / 2);
    const FeatureTable table = extract_features(dataset, config, available_threads());
    fw_window_shape window;
    SPECULA_EXPECT(fw_window_find(config.window, n_samples, &window) == FW_OK);
    std::vector<std::uint32_t> counts(config.n_bins);
    for (std::size_t i = 0; i < table.size(); ++i) {
        SPECULA_EXPECT(fw_exported_from_amplitude(&window, table.row(i).data(), config.n_bins,
                                                  counts.data()) == FW_OK);
        dataset.features.insert(dataset.features.end(), counts.begin(), counts.end());
    }
    for (int bin = 0; bin < config.n_bins; ++bin)
        dataset.feature_names.push_back(format("bin {}", bin));
}

void add_descriptor(Dataset& dataset) {
    const Descriptor descriptor = descriptor_for(dataset);
    const FeatureTable table = describe(dataset, descriptor, available_threads());
    for (int k = 0; k < descriptor.bins.n_bins; ++k)
        dataset.feature_names.push_back(format("bin {}", descriptor.bins.first_bin + k));
    dataset.features.assign(table.features.begin(), table.features.end());
}

/// The model's answers to every frame, softmax of its logits.
void add_answers(const Model& model, const std::filesystem::path& file, const Catalogue& catalogue,
                 Dataset& dataset) {
    try {
        if (model.measurement && !dataset.adc.empty())
            expect_same_measurement(*model.measurement, dataset, known_radar(dataset, catalogue));
    } catch (const InputError& error) {
        throw InputError(format("--model {}: {}", file.string(), error.what()));
    }
    const FeatureTable rows = describe(dataset, descriptor_of(model), available_threads());
    const Predictions predictions = predict(fold(model), rows);
    const std::size_t n = predictions.n_classes;
    dataset.answer_names = model.class_names;
    dataset.probability.resize(predictions.logits.size());
    for (std::size_t i = 0; i < predictions.size(); ++i)
        SPECULA_EXPECT(fw_softmax(&predictions.logits[i * n], static_cast<std::uint16_t>(n),
                                  &dataset.probability[i * n]) == FW_OK);
}

/// What an Infineon folder says beside the codes.
InfineonConfig chirp_of(const ExportRecordingArguments& arguments, const Dataset& dataset,
                        const Catalogue& catalogue) {
    const std::string name = arguments.radar.empty() ? dataset.origin.radar : arguments.radar;
    Section wanted = Section::parse("radar = '" + name + "'", "--radar");
    const Chirp chirp = catalogue.radar(wanted, "radar").chirp;
    const double bin_m = dataset.origin.bin_m > 0.0 ? dataset.origin.bin_m : chirp.bin_m();
    const double start_hz = chirp.frequency_hz(0);
    return {.start_hz = start_hz,
            .end_hz = start_hz + speed_of_light_m_s / (2.0 * bin_m),
            .sample_rate_hz = chirp.sample_rate_hz};
}

void warn_of_limits(const std::string& format_name, const Dataset& dataset) {
    if (format_name == "injection" &&
        (dataset.n_samples > injection_samples || dataset.n_rx % injection_rx != 0))
        say_warning(
            format("{} RX of {} samples: TI's IWRL6432 demo takes 3 RX (or 6 virtual) of at "
                   "most {}",
                   dataset.n_rx, dataset.n_samples, injection_samples));
}

}  // namespace

void export_recording_command(const ExportRecordingArguments& arguments,
                              const Catalogue& catalogue) {
    Dataset dataset = read_dataset(arguments.input);
    try {
        std::optional<Measurement> trained;
        if (!arguments.model.empty()) {
            const Model model = read_model(arguments.model);
            add_answers(model, arguments.model, catalogue, dataset);
            trained = model.measurement;
        }
        if (arguments.what == "uart" && dataset.features.empty())
            add_range_profile(trained, dataset);
        if (arguments.what == "csv" && dataset.features.empty()) add_descriptor(dataset);
        warn_of_limits(arguments.what, dataset);
        const InfineonConfig chirp = arguments.what == "infineon"
                                         ? chirp_of(arguments, dataset, catalogue)
                                         : InfineonConfig{};
        const auto files = export_recording(arguments.what, dataset, arguments.out, chirp);
        for (const ExportedFile& file : files) {
            write_file_atomically(file.name, file.content);
            std::printf("Wrote %s, %zu bytes\n", file.name.c_str(), file.content.size());
        }
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", arguments.input.string(), error.what()));
    }
}

}  // namespace specula
