#include <cmath>
#include <cstdio>

#include "scenes/scene.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/simulate.hpp"
#include "tools/likeness/calibration.hpp"
#include "tools/specula/commands.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

void print_calibration(const Calibration& result) {
    const Radar& radar = result.radar;
    std::printf("%zu chirps; noise figure %.2f dB, noise behind the high-pass %.3f LSB rms\n",
                result.n_chirps, radar.receiver.noise_figure_db, radar.receiver.adc_noise_lsb);
    for (std::size_t rx = 0; rx < radar.rx.size(); ++rx) {
        const ReceiveChannel& channel = radar.rx[rx];
        const NoiseFit& noise = result.noise[rx];
        std::printf("\nRX %zu  noise %.3f LSB rms in bins %d to %d, DC %.2f LSB", rx,
                    noise.quiet_lsb, noise.first_quiet_bin, noise.last_quiet_bin,
                    channel.dc_offset_lsb);
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

}  // namespace

void calibrate_command(const CalibrateArguments& arguments, const Catalogue& catalogue) {
    const ChirpSeries series = ChirpSeries::read(arguments.recording);
    const Radar radar = catalogue.radar_called(arguments.radar);
    const Calibration result = calibrated(arguments, catalogue, series, radar);
    const fs::path out =
        arguments.out.empty() ? fs::path(radar.name + "_calibrated.toml") : arguments.out;
    const std::string provenance =
        format("specula {} calibrate: {} chirps of {}, {}; the rest as in radar {} ({})",
               program_version, result.n_chirps, arguments.recording.filename().string(),
               arguments.scene.empty() ? "taken for an empty scene"
                                       : "scene " + arguments.scene.filename().string(),
               radar.name, radar.source);
    write_file_atomically(out, radar_file_text(result.radar, provenance));
    print_calibration(result);
    std::printf("\nWrote %s; specula show %s\n", out.c_str(), out.c_str());
}

}  // namespace specula
