#include <cstdlib>
#include <numeric>

#include "classifier/cross_validation.hpp"
#include "classifier/descriptor.hpp"
#include "sim/recording/import_recording.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"

// Public recordings of real radars, whose licences do not let them into the project. A folder that
// holds them is named by SPECULA_CAPTURES; without it these tests say so and end.

namespace specula {
namespace {

namespace fs = std::filesystem;

/// The file or folder of that name; empty where there is none.
fs::path capture(const std::string& name) {
    const char* folder = std::getenv("SPECULA_CAPTURES");
    const fs::path path = folder == nullptr ? fs::path() : fs::path(folder) / name;
    std::error_code ignored;
    if (!path.empty() && fs::exists(path, ignored)) return path;
    WARN("skipped: SPECULA_CAPTURES names no folder that holds " << name);
    return {};
}

Dataset imported_capture(const std::string& format, const fs::path& input,
                         const std::string& manifest) {
    const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    const auto section = Section::parse(manifest, "manifest");
    const auto recording = import_recording(format, input, read_manifest(section, catalogue));
    CHECK(recording.notes.empty());
    return recording.dataset;
}

struct Channel {
    double mean = 0.0;
    int largest = 0;  ///< of the magnitudes
};

Channel channel(const Dataset& dataset, std::size_t rx) {
    const auto n_rx = static_cast<std::size_t>(dataset.n_rx);
    const auto n_samples = static_cast<std::size_t>(dataset.n_samples);
    Channel channel;
    std::size_t n = 0;
    for (std::size_t row = rx; row * n_samples < dataset.adc.size(); row += n_rx)
        for (std::size_t k = 0; k < n_samples; ++k, ++n) {
            const int code = dataset.adc[row * n_samples + k];
            channel.mean += code;
            channel.largest = std::max(channel.largest, std::abs(code));
        }
    channel.mean /= static_cast<double>(n);
    return channel;
}

TEST_CASE("a raw IWRL6432 recording has the levels others measured on it", "[captures]") {
    const fs::path file = capture("iwrl6432_adc/adc_i16le_1024frames_3rx_256samp.bin");
    if (file.empty()) return;
    const Dataset dataset = imported_capture("adc", file, "[layout]\nrx = 3\nsamples = 256\n");
    CHECK(dataset.n_frames() == 1024);
    const double offset[] = {-5, -47, 39};
    const int largest[] = {1009, 531, 693};
    for (std::size_t rx = 0; rx < 3; ++rx) {
        const Channel found = channel(dataset, rx);
        CHECK(found.mean == Approx(offset[rx]).margin(0.5));  // given in whole LSB
        CHECK(found.largest == largest[rx]);
    }
}

TEST_CASE("real chirps read with receivers and samples exchanged are refused", "[captures]") {
    const fs::path file = capture("iwrl6432_adc/adc_i16le_1024frames_3rx_256samp.bin");
    if (file.empty()) return;
    const std::string exchanged =
        "[layout]\naxes = ['frame', 'sample', 'rx']\nrx = 3\nsamples = 256\n";
    CHECK(message_of([&] {
              return imported_capture("adc", file, exchanged).n_frames();
          }).find("the codes jump 5.7 times as much as with rx and sample exchanged") !=
          std::string::npos);
    CHECK(imported_capture("adc", file, exchanged + "trust_axes = true\n").n_frames() == 1024);
}

TEST_CASE("a UART dump of an IWRL6432 is whole packets of 64 bins", "[captures]") {
    const fs::path file = capture("iwrl6432_uart/pHistBytes_1.bin");
    if (file.empty()) return;
    const Dataset dataset = imported_capture("uart", file, "");
    CHECK(dataset.n_frames() == 100);
    CHECK(dataset.feature_names.size() == 64);
    CHECK(dataset.features[0] == 0x0c79);  // as a hex dump of the file shows
    CHECK(dataset.features[1] == 0x0c0c);
    CHECK(dataset.features[64] == 0x0f2c);
    CHECK(dataset.truth[0].frame == 1);
}

TEST_CASE("an Infineon folder gives frames around the middle of its ADC", "[captures]") {
    const fs::path folder = capture("bgt60tr13c");
    if (folder.empty()) return;
    const Dataset dataset = imported_capture("infineon", folder, "");
    CHECK(dataset.n_frames() == 256);
    CHECK(dataset.n_chirps == 8);
    CHECK(dataset.n_rx == 3);
    CHECK(dataset.n_samples == 64);
    CHECK(dataset.origin.bin_m == Approx(0.02725).epsilon(1e-3));  // 5.5 GHz
    for (std::size_t rx = 0; rx < 3; ++rx) CHECK(channel(dataset, rx).largest < 2048);
}

TEST_CASE("complex arrays of a 77 GHz radar are unwrapped", "[captures]") {
    const fs::path folder = capture("iwr_adc_openradar");
    if (folder.empty()) return;
    const Dataset dataset =
        imported_capture("npy", folder / "doppler_example_1.npy",
                         "[layout]\naxes = ['chirp', 'rx', 'sample']\nwrapped = true\n");
    CHECK(dataset.n_chirps == 128);
    CHECK(dataset.n_rx == 8);
    CHECK(dataset.n_samples == 128);
    CHECK(dataset.adc_quadrature.size() == dataset.adc.size());
    CHECK(channel(dataset, 0).largest < 8192);  // wrapped codes would be about 65000
}

TEST_CASE("views left out tell more of real materials than objects left out", "[captures]") {
    const fs::path file = capture("a111_materials_60ghz.npz");
    if (file.empty()) return;
    const Dataset dataset = imported_capture(
        "npz", file,
        "range_bin_mm = 0.48\nsample_axis = 'range'\n"
        "class_names = ['cardboard', 'glass', 'plastic']\n"
        "[layout]\nmember = 'frames_iq'\naxes = ['recording', 'frame', 'sample', 'iq']\n"
        "[labels]\nclass = 'cls'\nsample = 'obj'\nview = 'view'\n");
    CHECK(dataset.n_frames() == 299 * 20);
    CHECK(groups_of(dataset, LeaveOut::sample).size() == 299 * 20);
    const FeatureTable rows = describe(dataset, descriptor_for(dataset), 2);
    CHECK(rows.n_features == 12);
    const auto score = [&](LeaveOut what) {
        const CrossValidation how{.fold = deal_folds(rows, groups_of(dataset, what), 10),
                                  .n_folds = 10,
                                  .options = {},
                                  .threads = 2};
        return accuracy(rows.label, cross_predict(rows, how));
    };
    const double view = score(LeaveOut::view), object = score(LeaveOut::sample);
    // Independent figures for a descriptor of 12 bins and an MLP: 88.8 and 74.8 %.
    CHECK(view == Approx(0.888).margin(0.03));
    CHECK(object == Approx(0.748).margin(0.03));
}

}  // namespace
}  // namespace specula
