#include "scenes/receiver.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

const Range any_turn = Range::between(-two_pi, two_pi);

Range index_below(std::size_t n) {
    return Range::between(0.0, static_cast<double>(n) - 1.0);
}

}  // namespace

double Receiver::high_pass_db(double beat_hz) const {
    const auto pole_db = [&](double corner_hz) {
        const double below = corner_hz / beat_hz;  // the corner may be 0
        return -10.0 * std::log10(1.0 + below * below);
    };
    return pole_db(high_pass_hz) +
           pole_db(second_high_pass_hz < 0.0 ? high_pass_hz : second_high_pass_hz);
}

Receiver Receiver::read(Section section) {
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
        .complex_samples = section.choice("sampling", {"real", "complex"}, "real") == "complex",
        .adc_noise_lsb = section.number("adc_noise_lsb", Range::between(0.0, 1e3), 0.0),
    };
    if (section.has_quantity("second_high_pass", Unit::frequency))
        r.second_high_pass_hz =
            section.quantity("second_high_pass", Unit::frequency, Range::between(0.0, 1e7));
    if (section.has("phase_noise_dbc_hz"))
        r.phase_noise_dbc_hz = section.number("phase_noise_dbc_hz", Range::between(-200.0, -40.0));
    r.start_up_fraction = section.number("start_up_fraction", Range::inside(-1.0, 1.0), 0.0);
    section.finish();
    return r;
}

ReceiveChannel ReceiveChannel::read(Section section) {
    const auto p = section.quantities("position", Unit::length, 2, Range::between(-1.0, 1.0));
    ReceiveChannel channel{
        .position_m = {p[0], p[1], 0.0},
        .inverted = section.flag("inverted", false),
        .dc_offset_lsb = section.number("dc_offset_lsb", Range::between(-1e4, 1e4), 0.0),
        .gain_db = section.quantity("gain", Unit::ratio_db, Range::between(-40.0, 40.0), 0.0),
        .phase_rad = section.quantity("phase", Unit::angle, any_turn, 0.0),
        .start_up_lsb = section.number("start_up_lsb", Range::between(-1e4, 1e4), 0.0),
    };
    section.finish();
    return channel;
}

Leakage Leakage::read(Section section, const Board& board) {
    Leakage leakage{
        .rx = section.count("rx", index_below(board.n_rx)),
        .tx = {},
        .range_m = section.quantity("range", Unit::length, Range::between(0.0, 10.0)),
        .level_dbm = section.quantity("level", Unit::power_dbm, Range::between(-200.0, 30.0)),
        .phase_rad = section.quantity("phase", Unit::angle, any_turn, 0.0),
    };
    if (section.has("tx")) leakage.tx = section.count("tx", index_below(board.n_tx));
    section.finish();
    return leakage;
}

Interferer Interferer::read(Section section) {
    Interferer other{
        .level_dbm = section.quantity("level", Unit::power_dbm, Range::between(-200.0, 30.0)),
        .start_hz = section.quantity("start", Unit::frequency, Range::between(1e9, 300e9)),
        .slope_hz_s = section.quantity("slope", Unit::slope, Range::between(-1e15, 1e15)),
        .ramp_s = section.quantity("ramp", Unit::time, Range::above(0.0)),
        .period_s = section.quantity("period", Unit::time, Range::above(0.0)),
    };
    if (other.period_s < other.ramp_s)
        section.fail_quantity("period", Unit::time, "is shorter than the ramp",
                              "give the time from ramp to ramp");
    section.finish();
    return other;
}

}  // namespace specula
