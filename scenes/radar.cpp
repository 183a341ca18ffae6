#include "scenes/radar.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/core/kind.hpp"

namespace specula {

namespace {

Vector3 read_position(Section& section) {
    const auto p = section.quantities("position", Unit::length, 2, Range::between(-1.0, 1.0));
    return {p[0], p[1], 0.0};
}

Receiver read_receiver(Section section) {
    Receiver r{
        .gain_db = section.quantity("gain", Unit::ratio_db, Range::between(-20.0, 100.0)),
        .noise_figure_db =
            section.quantity("noise_figure", Unit::ratio_db, Range::between(0., 60.)),
        .temperature_k =
            section.quantity("temperature", Unit::temperature, Range::between(1.0, 1000.0), 290.0),
        .high_pass_hz = section.quantity("high_pass", Unit::frequency, Range::between(0.0, 1e7)),
        .full_scale_dbm =
            section.quantity("full_scale", Unit::power_dbm, Range::between(-60., 60.)),
        .adc_bits = section.count("adc_bits", Range::between(2, 16)),
    };
    section.finish();
    return r;
}

ReceiveChannel read_channel(Section section) {
    ReceiveChannel channel{
        .position_m = read_position(section),
        .inverted = section.flag("inverted", false),
        .dc_offset_lsb = section.number("dc_offset_lsb", Range::between(-1e4, 1e4), 0.0),
    };
    section.finish();
    return channel;
}

Leakage read_leakage(Section section, std::size_t n_rx) {
    Leakage leakage{
        .rx = section.count("rx", Range::between(0.0, static_cast<double>(n_rx) - 1.0)),
        .range_m = section.quantity("range", Unit::length, Range::between(0.0, 10.0)),
        .level_dbm = section.quantity("level", Unit::power_dbm, Range::between(-200.0, 30.0)),
        .phase_rad = section.quantity("phase", Unit::angle, Range::between(-two_pi, two_pi), 0.0),
    };
    section.finish();
    return leakage;
}

}  // namespace

double Radar::amplitude_lsb(double power_dbm) const {
    const double db = power_dbm + receiver.gain_db - receiver.full_scale_dbm;
    return adc_full_scale_lsb() * std::pow(10.0, db / 20.0);
}

Radar read_radar(const std::filesystem::path& file) {
    Section section = Section::read(file);
    Radar radar;
    radar.name = file.stem().string();
    radar.title = section.text("title");
    radar.source = section.text("source");

    Section chirp = section.section("chirp");
    radar.chirp = Chirp::read(chirp);
    radar.chirps_per_frame = chirp.count("chirps_per_frame", Range::between(1, 1024), 1);
    chirp.finish();

    Section transmitter = section.section("transmitter");
    radar.tx_power_dbm =
        transmitter.quantity("power", Unit::power_dbm, Range::between(-60.0, 60.0));
    radar.tx_position_m = read_position(transmitter);
    transmitter.finish();

    Section antenna = section.section("antenna");
    radar.pattern = read_kind<Pattern>(antenna, "pattern");
    antenna.finish();

    radar.receiver = read_receiver(section.section("receiver"));
    radar.rx.clear();
    for (Section& rx : section.sections("rx")) radar.rx.push_back(read_channel(rx));
    if (radar.rx.empty() || radar.rx.size() > 16)
        section.fail("rx", format("{} receive channels", radar.rx.size()),
                     "describe 1 to 16 of them, each as [[rx]]");
    for (Section& leak : section.sections("leakage"))
        radar.leakage.push_back(read_leakage(leak, radar.rx.size()));
    section.finish();
    return radar;
}

}  // namespace specula
