#include <cctype>
#include <cmath>
#include <sstream>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/likeness/calibration.hpp"

namespace specula {

namespace {

std::string in_quotes(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return quoted + "\"";
}

/// The lines of one table of a description, heading included; empty where it has none.
std::string table_text(const std::string& description, const std::string& name) {
    std::istringstream lines(description);
    std::string text;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        const bool is_heading =
            line.size() > 1 && line[0] == '[' &&
            (line[1] == '[' || std::isalpha(static_cast<unsigned char>(line[1])));
        if (is_heading) inside = line.rfind("[" + name + "]", 0) == 0;
        const bool is_remark_of_next = inside && !line.empty() && line[0] == '#';
        if (inside && !is_remark_of_next) text += line + "\n";
    }
    return text;
}

std::string position_text(const Vector3& position_m) {
    return format("position_mm = [{:.6g}, {:.6g}]\n", position_m.x() * 1e3, position_m.y() * 1e3);
}

/// A key that is written only where it says something. Near tones may cancel: eight digits.
std::string key_text(const char* key, double value) {
    return value == 0.0 ? "" : format("{} = {:.8g}\n", key, value);
}

std::string chirp_text(const Radar& radar) {
    const Chirp& chirp = radar.chirp;
    return format("[chirp]\nstart_ghz = {:.12g}\nslope_mhz_per_us = {:.12g}\n",
                  chirp.start_hz * 1e-9, chirp.slope_hz_s * 1e-12) +
           format("sample_rate_mhz = {:.12g}\nn_samples = {}\nskip_samples = {}\n",
                  chirp.sample_rate_hz * 1e-6, chirp.n_samples, chirp.skip_samples) +
           format("filter_latency_samples = {}\nramp_end_us = {:.9g}\n",
                  chirp.filter_latency_samples, chirp.ramp_end_s * 1e6) +
           format("idle_us = {:.9g}\ntx_on_us = {:.9g}\n", chirp.idle_s * 1e6,
                  chirp.tx_on_s * 1e6) +
           format("pass_band = {:.6g}\nchirps_per_frame = {}\n\n", chirp.pass_band,
                  radar.chirps_per_frame);
}

std::string receiver_text(const Receiver& receiver) {
    std::string text =
        format("[receiver]\ngain_db = {:.6g}\nnoise_figure_db = {:.4g}\ntemperature_k = {:.6g}\n",
               receiver.gain_db, receiver.noise_figure_db, receiver.temperature_k) +
        format("high_pass_khz = {:.9g}\n", receiver.high_pass_hz * 1e-3);
    if (receiver.second_high_pass_hz >= 0.0)
        text += format("second_high_pass_khz = {:.9g}\n", receiver.second_high_pass_hz * 1e-3);
    text += format("full_scale_dbm = {:.6g}\nadc_bits = {}\nsampling = \"{}\"\n",
                   receiver.full_scale_dbm, receiver.adc_bits,
                   receiver.complex_samples ? "complex" : "real");
    text += key_text("adc_noise_lsb", receiver.adc_noise_lsb);
    if (std::isfinite(receiver.phase_noise_dbc_hz))
        text += format("phase_noise_dbc_hz = {:.6g}\n", receiver.phase_noise_dbc_hz);
    return text + key_text("start_up_fraction", receiver.start_up_fraction) + "\n";
}

}  // namespace

std::string radar_file_text(const Radar& radar, const std::string& provenance) {
    const double deg = 180.0 / pi;
    std::string text = format("title  = {}\nsource = {}\n\n",
                              in_quotes(radar.title + ", calibrated"), in_quotes(provenance));
    text += chirp_text(radar);
    text += format("[transmitter]\npower_dbm = {:.6g}\n", radar.tx_power_dbm) +
            position_text(radar.tx_position_m) + "\n";
    text += table_text(radar.description, "antenna");
    text += receiver_text(radar.receiver);
    for (const ReceiveChannel& rx : radar.rx) {
        text += "[[rx]]\n" + position_text(rx.position_m);
        if (rx.inverted) text += "inverted = true\n";
        text += key_text("dc_offset_lsb", rx.dc_offset_lsb) + key_text("gain_db", rx.gain_db) +
                key_text("phase_deg", rx.phase_rad * deg) +
                key_text("start_up_lsb", rx.start_up_lsb);
    }
    for (const Leakage& leak : radar.leakage)
        text += format("\n[[leakage]]\nrx = {}\nrange_mm = {:.8g}\nlevel_dbm = {:.8g}\n", leak.rx,
                       leak.range_m * 1e3, leak.level_dbm) +
                key_text("phase_deg", leak.phase_rad * deg);
    const std::string limits = table_text(radar.description, "limits");
    return text + (limits.empty() ? "" : "\n" + limits);
}

}  // namespace specula
