#include "scenes/ti_config.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "scenes/ti_commands.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr double adc_clock_hz = 100e6;
constexpr int most_chirps = 1024;

void warn(Radar& radar, const TiCommand& command, const std::string& what) {
    radar.warnings.push_back(
        format("{}:{}: {}: {}", command.file, command.line, command.name, what));
}

std::vector<int> channels_of(const TiCommand& command, std::size_t i, const std::string& what,
                             int n_channels) {
    const int all = (1 << n_channels) - 1;
    const int mask = command.whole_or(i, what, all);
    if (mask < 1 || mask > all)
        command.fail(i, what, format("the board has {} of them", n_channels),
                     format("give a mask of 1 to {}", all));
    std::vector<int> channels;
    for (int channel = 0; channel < n_channels; ++channel)
        if (mask & (1 << channel)) channels.push_back(channel);
    return channels;
}

/// antGeometryCfg: row and column of each virtual antenna, then the pitch of columns and rows.
void place_antennas(Radar& radar, const TiCommand& command) {
    const auto n_rx = radar.rx.size();
    const std::size_t n_virtual = n_rx * static_cast<std::size_t>(radar.n_tx());
    if (command.arguments.size() != 2 * n_virtual + 2)
        return warn(radar, command, "does not fit the board's antennas and has no effect");
    const double column_m = 1e-3 * command.number_or(2 * n_virtual, "dx", 0.0);
    const double row_m = 1e-3 * command.number_or(2 * n_virtual + 1, "dz", 0.0);
    constexpr double widest_pitch_m = 0.05;  // ten wavelengths; the board is not much wider
    if (std::max(std::abs(column_m), std::abs(row_m)) > widest_pitch_m)
        warn(radar, command, "puts antennas more than 50 mm apart; the pitch is in mm");
    const auto from_first = [&](std::size_t antenna) {
        const auto at = [&](std::size_t i) { return command.number_or(i, "row or column", 0.0); };
        return Vector3((at(2 * antenna + 1) - at(1)) * column_m, (at(2 * antenna) - at(0)) * row_m,
                       0.0);
    };
    for (std::size_t rx = 1; rx < n_rx; ++rx)
        radar.rx[rx].position_m = radar.rx[0].position_m + from_first(rx);
    for (std::size_t tx = 1; tx <= radar.further_tx.size(); ++tx)
        radar.further_tx[tx - 1].position_m = radar.tx_position_m + from_first(tx * n_rx);
}

void set_bits(Radar& radar, const TiCommand& command) {
    const int selected = command.whole_or(1, "digOutputBitsSel", 0);
    if (selected == 5) {  // all 16 bits: a 16th of the LSB
        const double finer = std::ldexp(1.0, 16 - radar.receiver.adc_bits);
        radar.receiver.adc_bits = 16;
        radar.receiver.adc_noise_lsb *= finer;
        for (ReceiveChannel& rx : radar.rx) {
            rx.dc_offset_lsb *= finer;
            rx.start_up_lsb *= finer;
        }
    } else if (selected != 0) {
        warn(radar, command, "digOutputBitsSel other than 0 and 5 is simulated as 0, the 12 MSB");
    }
}

void set_sampling(Radar& radar, const TiCommand& command) {
    const int decimation = command.whole_or(0, "digOutputSampRate", 20);
    if (decimation < 1)
        command.fail(0, "digOutputSampRate", "is no divider of 100 MHz", "give 8 to 100");
    Chirp& chirp = radar.chirp;
    chirp.sample_rate_hz = adc_clock_hz / decimation;
    set_bits(radar, command);
    chirp.pass_band = command.whole_or(2, "dfeFirSel", 0) == 1 ? 0.40 : 0.45;
    chirp.n_samples = command.whole_or(3, "numOfAdcSamples", chirp.n_samples);
    if (chirp.n_samples < 16 || chirp.n_samples > 1024 ||
        !std::has_single_bit(static_cast<unsigned>(chirp.n_samples)))
        command.fail(3, "numOfAdcSamples",
                     "is no power of two from 16 to 1024, so range bins "
                     "would be padded ones",
                     "use 64, 128, 256 or 512");
    const int pattern = command.whole_or(4, "chirpTxMimoPatSel", 1);
    if (pattern != 0 && pattern != 1 && pattern != 4)
        command.fail(4, "chirpTxMimoPatSel", "is no pattern of the chip",
                     "give 1 for TDM or 4 for BPM");
    radar.multiplexing = pattern == 4 ? Multiplexing::bpm : Multiplexing::tdm;
    chirp.ramp_end_s = 1e-6 * command.number_or(5, "chirpRampEndTime", chirp.ramp_end_s * 1e6);
    if (chirp.ramp_end_s <= 0.0)
        command.fail(5, "chirpRampEndTime", "is no time", "give it in us, above 0");
    const auto& corners_hz = radar.limits.high_pass_hz;
    const int code = command.whole_or(6, "chirpRxHpfSel", 0);
    if (code < 0 || static_cast<std::size_t>(code) >= corners_hz.size())
        command.fail(6, "chirpRxHpfSel",
                     format("the board has codes 0 to {}", static_cast<int>(corners_hz.size()) - 1),
                     "choose one of them");
    radar.receiver.high_pass_hz = corners_hz[static_cast<std::size_t>(code)];
}

void set_timing(Radar& radar, const TiCommand& command) {
    Chirp& chirp = radar.chirp;
    chirp.idle_s = 1e-6 * command.number_or(0, "chirpIdleTime", chirp.idle_s * 1e6);
    chirp.skip_samples = command.whole_or(1, "chirpAdcSkipSamples", chirp.skip_samples);
    chirp.slope_hz_s = 1e12 * command.number_or(3, "chirpSlope", chirp.slope_hz_s * 1e-12);
    chirp.start_hz = 1e9 * command.number_or(4, "chirpRfFreqStart", chirp.start_hz * 1e-9);
    // Where the TX begins before the ramp, it is there from the ramp's start.
    chirp.tx_on_s = std::max(0.0, 1e-6 * command.number_or(2, "chirpTxStartTime", 0.0));
    if (chirp.idle_s < 0.0) command.fail(0, "chirpIdleTime", "is below 0", "give it in us");
    if (chirp.skip_samples < 0 || chirp.skip_samples > 1024)
        command.fail(1, "chirpAdcSkipSamples", "is out of range", "give 0 to 1024");
    if (chirp.slope_hz_s <= 0.0)
        command.fail(3, "chirpSlope", "is not simulated: ramps rise here", "give it above 0");
}

struct Bursts {
    int chirps = 1;  ///< in each
    int bursts = 1;  ///< in a frame
    double burst_s = 0.0;
};

/// Chirps must fit their burst, bursts their frame; a period of 0 or none is not checked.
void check_periods(const Radar& radar, const TiCommand& command, const Bursts& frame) {
    const double chirps_s = frame.chirps * (radar.chirp.idle_s + radar.chirp.ramp_end_s);
    if (frame.burst_s > 0.0 && frame.burst_s < chirps_s)
        command.fail(2, "burstPeriodicity",
                     format("is shorter than its {} chirps, {:.4g} us", frame.chirps,
                            chirps_s * 1e6),
                     "lengthen it or send fewer chirps");
    const double frame_s = 1e-3 * command.number_or(4, "framePeriodicity", 0.0);
    const double bursts_s = frame.bursts * std::max(frame.burst_s, chirps_s);
    if (frame_s > 0.0 && frame_s < bursts_s)
        command.fail(4, "framePeriodicity",
                     format("is shorter than its {} bursts, {:.4g} ms", frame.bursts,
                            bursts_s * 1e3),
                     "lengthen it or send fewer bursts");
}

void set_frame(Radar& radar, const TiCommand& command) {
    const int in_burst = command.whole_or(0, "numOfChirpsInBurst", 1);
    const int accumulated = command.whole_or(1, "numOfChirpsAccum", 0);
    const int bursts = command.whole_or(3, "numOfBurstsInFrame", 1);
    const double chirps = static_cast<double>(in_burst) * bursts;
    if (in_burst < 1 || bursts < 1 || chirps > most_chirps)
        command.fail(in_burst < 1 ? 0 : 3,
                     in_burst < 1 ? "numOfChirpsInBurst" : "numOfBurstsInFrame",
                     format("makes a frame of {:.0f} chirps", chirps),
                     format("give 1 to {} together", most_chirps));
    radar.chirps_per_frame = static_cast<int>(chirps);
    if (radar.chirps_per_frame % radar.n_tx() != 0)
        command.fail(0, "numOfChirpsInBurst",
                     format("makes {} chirps, no whole number for each of {} TX",
                            radar.chirps_per_frame, radar.n_tx()),
                     "give a multiple of the number of TX");
    if (accumulated > 1)
        warn(radar, command,
             format("{} chirps are averaged on the chip; noise is that of one", accumulated));
    const double burst_s = 1e-6 * command.number_or(2, "burstPeriodicity", 0.0);
    check_periods(radar, command, {.chirps = in_burst, .bursts = bursts, .burst_s = burst_s});
    if (bursts == 1) return;
    if (in_burst == 1 && burst_s >= radar.chirp.ramp_end_s)
        radar.chirp.idle_s = burst_s - radar.chirp.ramp_end_s;
    else
        warn(radar, command, "chirps follow each other without the pause between bursts");
}

void set_gain(Radar& radar, const TiCommand& command) {
    radar.receiver.gain_db = command.number_or(2, "rxGain", radar.receiver.gain_db);
    const double backoff_db = command.number_or(3, "txBackoff", 0.0);
    if (backoff_db < 0.0 || backoff_db > 40.0)
        command.fail(3, "txBackoff", "is out of range", "give 0 to 40 dB");
    radar.tx_power_dbm -= backoff_db;
    for (Leakage& leak : radar.leakage) leak.level_dbm -= backoff_db;
}

void check_samples_on_ramp(const Radar& radar, const TiCommand& command) {
    const Chirp& chirp = radar.chirp;
    if (chirp.n_samples + chirp.settle_samples() < 8)
        command.fail(3, "numOfAdcSamples", "leaves fewer than 8 samples on the ramp",
                     "skip or take more samples");
    const double last_s = (chirp.settle_samples() + chirp.n_samples) / chirp.sample_rate_hz;
    if (last_s > chirp.ramp_end_s)
        command.fail(5, "chirpRampEndTime",
                     format("samples run to {:.4g} us, beyond the ramp's end", last_s * 1e6),
                     "end the ramp later, or take fewer samples");
}

/// Which argument of which command holds a setting that the chip does not have.
struct SettingPlace {
    const char* setting;
    const char* command;
    std::size_t argument;
    const char* what;
};
constexpr SettingPlace setting_places[] = {
    {"start", "chirpTimingCfg", 4, "chirpRfFreqStart"},
    {"slope", "chirpTimingCfg", 3, "chirpSlope"},
    {"sample_rate", "chirpComnCfg", 0, "digOutputSampRate"},
    {"n_samples", "chirpComnCfg", 3, "numOfAdcSamples"},
    {"tx_on", "chirpTimingCfg", 2, "chirpTxStartTime"},
    {"ramp_end", "chirpComnCfg", 5, "chirpRampEndTime"},
    {"gain", "factoryCalibCfg", 2, "rxGain"},
    {"high_pass", "chirpComnCfg", 6, "chirpRxHpfSel"},
};

void check_limits(const Radar& radar, const TiCommandFile& file) {
    const auto breach = limit_breach(radar.limits, radar.chirp, radar.receiver);
    if (!breach) return;
    for (const SettingPlace& place : setting_places) {
        if (breach->setting != place.setting) continue;
        if (const TiCommand* command = file.find(place.command))
            command->fail(place.argument, place.what, breach->problem, breach->remedy);
    }
    throw InputError(
        format("{}: {}: {}; {}", file.file, breach->setting, breach->problem, breach->remedy));
}

}  // namespace

bool is_ti_config(const std::filesystem::path& file) {
    return file.extension() == ".cfg";
}

Radar read_ti_config(const std::filesystem::path& path, const std::filesystem::path& board) {
    const TiCommandFile file = TiCommandFile::read(path);
    const TiCommand& common = file.need("chirpComnCfg");
    const TiCommand& timing = file.need("chirpTimingCfg");
    Radar radar = read_board(board);
    radar.title = format("{} set up by {}", board.stem().string(), path.filename().string());
    radar.source = format("commands of {}; board: {}", path.string(), radar.source);
    radar.name = path.stem().string();
    radar.warnings = file.warnings;
    if (const TiCommand* command = file.find("antGeometryCfg")) place_antennas(radar, *command);
    if (const TiCommand* command = file.find("channelCfg")) {
        const auto tx = channels_of(*command, 1, "txChCtrlBitMask", radar.n_tx());
        radar.use_rx(
            channels_of(*command, 0, "rxChCtrlBitMask", static_cast<int>(radar.rx.size())));
        radar.use_tx(tx);
    }
    set_sampling(radar, common);
    set_timing(radar, timing);
    check_samples_on_ramp(radar, common);
    radar.chirps_per_frame = radar.n_tx();
    if (const TiCommand* command = file.find("frameCfg")) set_frame(radar, *command);
    if (const TiCommand* command = file.find("factoryCalibCfg")) set_gain(radar, *command);
    if (const TiCommand* command = file.find("clutterRemoval"))
        if (command->whole_or(0, "enabled", 0) == 1)
            warn(radar, *command,
                 "takes standing echoes out of the chip's own results, samples of a table among "
                 "them; the ADC codes here keep them");
    check_limits(radar, file);
    return radar;
}

}  // namespace specula
