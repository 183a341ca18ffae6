#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>

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
#include "sim/recording/manifest.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/output_place.hpp"

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

/// The radar that is named, or that the dataset names; nothing where that is none of the catalogue.
std::optional<Radar> radar_of(const ExportRecordingArguments& arguments, const Dataset& dataset,
                              const Catalogue& catalogue) {
    if (!arguments.radar.empty()) return catalogue.radar_called(arguments.radar);
    const auto known = catalogue.radar_names();
    if (std::ranges::count(known, dataset.origin.radar) == 0) return std::nullopt;
    return catalogue.radar_called(dataset.origin.radar);
}

/// What an Infineon folder says beside the codes.
InfineonConfig infineon_of(const std::optional<Radar>& radar, const Dataset& dataset) {
    if (!radar)
        throw InputError(
            format("its radar, \"{}\", is none of the catalogue, and the format asks for its "
                   "frequencies; give --radar",
                   dataset.origin.radar));
    const Chirp& chirp = radar->chirp;
    if (chirp.n_samples != dataset.n_samples)
        throw InputError(format("its chirps have {} samples, those of radar {} have {}; give the "
                                "radar that made it by --radar",
                                dataset.n_samples, radar->name, chirp.n_samples));
    const double bin_m = dataset.origin.bin_m > 0.0 ? dataset.origin.bin_m : chirp.bin_m();
    const double start_hz = chirp.frequency_hz(0);
    return {.start_hz = start_hz,
            .end_hz = start_hz + speed_of_light_m_s / (2.0 * bin_m),
            .sample_rate_hz = chirp.sample_rate_hz,
            .chirp_repetition_s = chirp.ramp_end_s + chirp.idle_s,
            .high_pass_hz = radar->receiver.high_pass_hz};
}

SentChirps sent_chirps(const ExportRecordingArguments& arguments, const Dataset& dataset,
                       const Catalogue& catalogue) {
    const std::optional<Radar> radar = radar_of(arguments, dataset, catalogue);
    SentChirps chirps;
    if (arguments.what == "infineon") chirps.infineon = infineon_of(radar, dataset);
    if (radar) chirps.n_tx = static_cast<std::size_t>(radar->n_tx());
    return chirps;
}

void warn_of_losses(const std::string& format_name, const Dataset& dataset) {
    if (!dataset.probability.empty() && (format_name == "npy" || format_name == "csv"))
        say_warning(format("{} has no place for the probabilities; uart has", format_name));
    if (format_name == "csv" && !dataset.adc.empty())
        say_warning("csv holds the range bins, not the codes they are made of; npy holds codes");
}

void warn_of_limits(const std::string& format_name, const Dataset& dataset) {
    if (format_name == "injection" &&
        (dataset.n_samples > injection_samples || dataset.n_rx % injection_rx != 0))
        say_warning(
            format("{} RX of {} samples: TI's IWRL6432 demo takes 3 RX (or 6 virtual) of at "
                   "most {}",
                   dataset.n_rx, dataset.n_samples, injection_samples));
}

/// A manifest that somebody wrote by hand is theirs; those of earlier exports begin alike.
void check_output(const ExportedFile& file, const ExportRecordingArguments& arguments) {
    prepare_output(file.name, {arguments.input, arguments.model, arguments.radar});
    if (file.name.extension() != ".toml" || !std::filesystem::is_regular_file(file.name)) return;
    std::ifstream there(file.name);
    std::string first_line;
    std::getline(there, first_line);
    if (first_line + "\n" != manifest_first_line)
        throw InputError(format("{}: is a manifest that specula did not write; move it away, or "
                                "give --out another name",
                                file.name.string()));
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
        warn_of_losses(arguments.what, dataset);
        const auto files = export_recording(arguments.what, dataset, arguments.out,
                                            sent_chirps(arguments, dataset, catalogue));
        for (const ExportedFile& file : files) check_output(file, arguments);
        for (const ExportedFile& file : files) {
            write_file_atomically(file.name, file.content);
            std::printf("Wrote %s, %zu bytes\n", file.name.c_str(), file.content.size());
        }
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", arguments.input.string(), error.what()));
    }
}

}  // namespace specula
