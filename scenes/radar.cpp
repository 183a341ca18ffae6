#include "scenes/radar.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/core/kind.hpp"

namespace specula {

namespace {

constexpr int most_tx = 4;

Vector3 read_position(Section& section) {
    const auto p = section.quantities("position", Unit::length, 2, Range::between(-1.0, 1.0));
    return {p[0], p[1], 0.0};
}

std::complex<double> feed(double gain_db, double phase_rad, bool inverted) {
    const double amplitude = std::pow(10.0, gain_db / 20.0);
    return (inverted ? -1.0 : 1.0) * std::polar(amplitude, phase_rad);
}

/// The TX that send; empty: all.
std::vector<int> read_enabled(Section& transmitter) {
    std::vector<int> enabled;
    if (!transmitter.has("enabled")) return enabled;
    for (const double tx : transmitter.numbers("enabled", 0, Range::between(0.0, most_tx - 1.0))) {
        enabled.push_back(static_cast<int>(tx));
        if (enabled.back() != tx || std::count(enabled.begin(), enabled.end(), enabled.back()) > 1)
            transmitter.fail("enabled", "is no list of different whole numbers", "write [0, 1]");
    }
    return enabled;
}

/// Refuses what the chip cannot do, at the key to change.
void check_limits(const Radar& radar, Section& chirp, Section& receiver) {
    const auto breach = limit_breach(radar.limits, radar.chirp, radar.receiver);
    if (!breach) return;
    const auto& [setting, problem, remedy] = *breach;
    if (setting == "start") chirp.fail_quantity(setting, Unit::frequency, problem, remedy);
    if (setting == "slope") chirp.fail_quantity(setting, Unit::slope, problem, remedy);
    if (setting == "sample_rate") chirp.fail_quantity(setting, Unit::frequency, problem, remedy);
    if (setting == "n_samples") chirp.fail(setting, problem, remedy);
    if (setting == "ramp_end") chirp.fail_quantity(setting, Unit::time, problem, remedy);
    if (setting == "gain") receiver.fail_quantity(setting, Unit::ratio_db, problem, remedy);
    if (setting == "high_pass") receiver.fail_quantity(setting, Unit::frequency, problem, remedy);
    receiver.fail(setting, problem, remedy);
}

}  // namespace

double Radar::amplitude_lsb(double power_dbm) const {
    const double db = power_dbm + receiver.gain_db - receiver.full_scale_dbm;
    return adc_full_scale_lsb() * std::pow(10.0, db / 20.0);
}

TransmitChannel Radar::tx(int i) const {
    if (i > 0) return further_tx.at(static_cast<std::size_t>(i - 1));
    return {.position_m = tx_position_m};
}

Radar Radar::sending_from(int i) const {
    Radar one = *this;
    one.tx_position_m = tx(i).position_m;
    one.further_tx.clear();
    one.leakage.clear();
    for (const Leakage& leak : leakage)
        if (leak.tx.value_or(i) == i) one.leakage.push_back(leak);
    return one;
}

std::complex<double> feed_factor(const ReceiveChannel& channel) {
    return feed(channel.gain_db, channel.phase_rad, channel.inverted);
}

std::complex<double> feed_factor(const TransmitChannel& channel) {
    return feed(channel.gain_db, channel.phase_rad, channel.inverted);
}

void Radar::use_tx(const std::vector<int>& kept) {
    const std::complex<double> reference = feed_factor(tx(kept.front()));
    const Vector3 first_m = tx(kept.front()).position_m;
    std::vector<TransmitChannel> others;
    for (std::size_t i = 1; i < kept.size(); ++i) {
        const std::complex<double> relative = feed_factor(tx(kept[i])) / reference;
        others.push_back({.position_m = tx(kept[i]).position_m,
                          .inverted = tx(kept[i]).inverted != tx(kept.front()).inverted,
                          .gain_db = 20.0 * std::log10(std::abs(relative)),
                          .phase_rad = tx(kept[i]).phase_rad - tx(kept.front()).phase_rad});
    }
    std::vector<Leakage> leaks;
    for (const Leakage& leak : leakage) {
        Leakage kept_leak = leak;
        if (!leak.tx) leaks.push_back(kept_leak);
        for (std::size_t i = 0; leak.tx && i < kept.size(); ++i)
            if (*leak.tx == kept[i]) {
                kept_leak.tx = static_cast<int>(i);
                leaks.push_back(kept_leak);
            }
    }
    tx_position_m = first_m;
    further_tx = others;
    leakage = leaks;
}

void Radar::use_rx(const std::vector<int>& kept) {
    std::vector<ReceiveChannel> channels;
    std::vector<Leakage> leaks;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        channels.push_back(rx.at(static_cast<std::size_t>(kept[i])));
        for (Leakage leak : leakage) {
            if (leak.rx != kept[i]) continue;
            leak.rx = static_cast<int>(i);
            leaks.push_back(leak);
        }
    }
    rx = channels;
    leakage = leaks;
}

namespace {

struct ReadBoard {
    Radar radar;
    std::vector<int> enabled;  ///< TX
};

ReadBoard read_whole(const std::filesystem::path& file, bool check) {
    Section section = Section::read(file);
    Radar radar;
    radar.name = file.stem().string();
    radar.title = section.text("title");
    radar.source = section.text("source");
    radar.description = section.source();

    Section chirp = section.section("chirp");
    radar.chirp = Chirp::read(chirp);
    radar.chirps_per_frame = chirp.count("chirps_per_frame", Range::between(1, 1024), 1);
    chirp.finish();

    Section transmitter = section.section("transmitter");
    radar.tx_power_dbm =
        transmitter.quantity("power", Unit::power_dbm, Range::between(-60.0, 60.0));
    radar.tx_position_m = read_position(transmitter);
    radar.multiplexing = read_multiplexing(transmitter, "multiplexing");
    std::vector<int> enabled = read_enabled(transmitter);
    transmitter.finish();
    for (Section& tx : section.sections("tx"))
        radar.further_tx.push_back(TransmitChannel::read(tx));
    if (radar.n_tx() > most_tx)
        section.fail("tx", format("{} transmit channels with that of [transmitter]", radar.n_tx()),
                     format("describe {} at most", most_tx));
    if (enabled.empty())
        for (int i = 0; i < radar.n_tx(); ++i) enabled.push_back(i);
    for (const int i : enabled)
        if (i >= radar.n_tx())
            transmitter.fail("enabled", format("the board has no TX {}", i),
                             "count from 0, that of [transmitter]");

    Section antenna = section.section("antenna");
    radar.pattern = read_kind<Pattern>(antenna, "pattern");
    antenna.finish();

    Section receiver = section.section("receiver");
    radar.receiver = Receiver::read(receiver);
    if (auto limits = section.find_section("limits")) radar.limits = ChipLimits::read(*limits);
    if (check) check_limits(radar, chirp, receiver);
    radar.rx.clear();
    for (Section& rx : section.sections("rx")) radar.rx.push_back(ReceiveChannel::read(rx));
    if (radar.rx.empty() || radar.rx.size() > 16)
        section.fail("rx", format("{} receive channels", radar.rx.size()),
                     "describe 1 to 16 of them, each as [[rx]]");
    for (Section& leak : section.sections("leakage"))
        radar.leakage.push_back(Leakage::read(
            leak, {.n_rx = radar.rx.size(), .n_tx = static_cast<std::size_t>(radar.n_tx())}));
    if (auto other = section.find_section("interferer"))
        radar.interferer = Interferer::read(*other);
    const auto n_sending = static_cast<int>(enabled.size());
    if (radar.chirps_per_frame % n_sending != 0)
        chirp.fail("chirps_per_frame",
                   format("is no whole number of chirps for each of {} TX", n_sending),
                   "give a multiple of the number of TX");
    section.finish();
    return {radar, enabled};
}

}  // namespace

Radar read_radar(const std::filesystem::path& file) {
    ReadBoard board = read_whole(file, true);
    board.radar.use_tx(board.enabled);
    return board.radar;
}

Radar read_board(const std::filesystem::path& file) {
    return read_whole(file, false).radar;
}

}  // namespace specula
