#include <cmath>
#include <cstdio>

#include "scenes/scene.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/simulate.hpp"
#include "tools/likeness/calibration.hpp"
#include "tools/console/console.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/output_place.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

constexpr double implausible_gain_db = 15.0;  ///< a board's parts spread by a few dB

void print_calibration(const Calibration& result) {
    const Radar& radar = result.radar;
    std::printf("%zu chirps; noise figure %.2f dB, noise behind the high-pass %.3f LSB rms\n",
                result.n_chirps, radar.receiver.noise_figure_db, radar.receiver.adc_noise_lsb);
    for (std::size_t rx = 0; rx < radar.rx.size(); ++rx) {
        const ReceiveChannel& channel = radar.rx[rx];
        const NoiseFit& noise = result.noise[rx];
        std::printf("\nRX %zu  noise %.3f LSB rms in bins %d to %d, DC %.2f +- %.2f LSB", rx,
                    noise.quiet_lsb, noise.first_quiet_bin, noise.last_quiet_bin,
                    channel.dc_offset_lsb, result.channels[rx].dc_error_lsb);
        if (channel.start_up_lsb != 0.0)
            std::printf(", start-up pulse %.1f LSB", channel.start_up_lsb);
        if (result.knows_gain)
            std::printf(", gain %+.2f dB, phase %.1f deg", channel.gain_db,
                        channel.phase_rad * 57.29577951308232);
        std::printf("\n      what no part explains: %.2f LSB rms; %zu tones of the room\n",
                    result.channels[rx].residual_lsb, result.room[rx].size());
        for (const Leakage& leak : radar.leakage)
            if (leak.rx == static_cast<int>(rx))
                std::printf("      leakage at %6.1f mm: %6.1f dBm\n", leak.range_m * 1e3,
                            leak.level_dbm);
    }
}

Calibration calibrated(const CalibrateArguments& arguments, const Catalogue& catalogue,
                       const ChirpSeries& series, const Radar& radar) {
    Progress progress("Calibrating", "RX", radar.rx.size());  // ends its line when done
    if (arguments.scene.empty()) return calibrate(series, radar, nullptr, {}, &progress.done());
    Scene scene = read_scene(arguments.scene, catalogue);
    scene.radar = radar;
    const BeatSignal echo = dechirp(echo_channel(scene, catalogue.materials), radar.chirp);
    return calibrate(series, radar, &echo, {}, &progress.done());
}

/// Puts the radar file in place if it can be read back: what a recording of something else gives is
/// seldom a radar.
void write_checked(const fs::path& out, const std::string& text,
                   const CalibrateArguments& arguments) {
    const fs::path draft = out.string() + ".draft";
    write_file_atomically(draft, text);
    try {
        read_radar(draft);
    } catch (const InputError& error) {
        std::error_code ignored;
        fs::remove(draft, ignored);
        const std::string problem = error.what();
        throw InputError(format("{}: its fit is no radar ({}); was it made with radar {}{}?",
                                arguments.recording.string(),
                                problem.substr(std::min(problem.size(), draft.string().size() + 1)),
                                arguments.radar,
                                arguments.scene.empty() ? ", of an empty scene"
                                                        : ", of the scene that is named"));
    }
    publish_file(draft, out);
}

void warn_of_doubts(const Calibration& result) {
    const Radar& radar = result.radar;
    for (const Leakage& leak : radar.leakage)
        if (leak.level_dbm > radar.tx_power_dbm)
            say_warning(
                format("RX {}: leakage at {:.1f} mm comes out at {:.1f} dBm, more than the TX "
                       "sends; near tones partly cancel, and only their sum was recorded",
                       leak.rx, leak.range_m * 1e3, leak.level_dbm));
    if (!result.knows_gain) return;
    for (std::size_t rx = 0; rx < radar.rx.size(); ++rx)
        if (std::abs(radar.rx[rx].gain_db) > implausible_gain_db)
            say_warning(format("RX {}: {:.1f} dB off its stated gain; is the scene the recorded one?",
                               rx, radar.rx[rx].gain_db));
}

}  // namespace

void calibrate_command(const CalibrateArguments& arguments, const Catalogue& catalogue) {
    const fs::path out = arguments.out.empty()
                             ? fs::path(catalogue.radar_called(arguments.radar).name + "_calibrated.toml")
                             : arguments.out;
    prepare_output(out, {arguments.recording, arguments.scene, arguments.radar});
    const ChirpSeries series = ChirpSeries::read(arguments.recording);
    const Radar radar = catalogue.radar_called(arguments.radar);
    const Calibration result = calibrated(arguments, catalogue, series, radar);
    const std::string provenance =
        format("specula {} calibrate: {} chirps of {}, {}; the rest as in radar {} ({})",
               program_version, result.n_chirps, arguments.recording.filename().string(),
               arguments.scene.empty() ? "taken for an empty scene"
                                       : "scene " + arguments.scene.filename().string(),
               radar.name, radar.source);
    write_checked(out, radar_file_text(result.radar, provenance), arguments);
    warn_of_doubts(result);
    print_calibration(result);
    std::printf("\nWrote %s; specula show %s\n", out.c_str(), out.c_str());
}

}  // namespace specula
