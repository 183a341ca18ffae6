#pragma once

#include <complex>
#include <string>
#include <vector>

#include "scenes/antenna.hpp"
#include "scenes/chip_limits.hpp"
#include "scenes/chirp.hpp"
#include "scenes/receiver.hpp"
#include "scenes/transmitter.hpp"

namespace specula {

/// A radar: chirp, antennas and receivers. Every number's origin is in its file.
struct Radar {
    std::string name;
    std::string title;
    std::string source;
    Chirp chirp;
    int chirps_per_frame = 1;  ///< of all TX together
    double tx_power_dbm = 11.0;
    Pattern pattern;                          ///< of every antenna
    Vector3 tx_position_m = Vector3::Zero();  ///< of the first TX
    std::vector<TransmitChannel> further_tx;  ///< besides the first, relative to its feed
    Multiplexing multiplexing = Multiplexing::tdm;
    std::vector<ReceiveChannel> rx{ReceiveChannel{}};
    Receiver receiver;
    std::vector<Leakage> leakage;
    std::optional<Interferer> interferer;
    ChipLimits limits;
    std::string description;            ///< the whole file of the board
    std::vector<std::string> warnings;  ///< what its file says that is not simulated so

    int n_tx() const { return 1 + static_cast<int>(further_tx.size()); }
    TransmitChannel tx(int i) const;
    /// Keeps these TX, in this order; gains and phases become relative to the first of them.
    void use_tx(const std::vector<int>& kept);
    /// Keeps these RX, in this order.
    void use_rx(const std::vector<int>& kept);
    /// The same radar with TX `i` alone, at full amplitude: what that TX's channel is traced with.
    Radar sending_from(int i) const;
    /// ADC code amplitude of a tone of the given power at the RX port.
    double amplitude_lsb(double power_dbm) const;
    double adc_full_scale_lsb() const { return static_cast<double>(1 << (receiver.adc_bits - 1)); }
};

/// Amplitude factor of a feed: gain, phase and polarity in one.
std::complex<double> feed_factor(const ReceiveChannel& channel);
std::complex<double> feed_factor(const TransmitChannel& channel);

/// Reads one radar file; its name is the file's stem. See scenes/README.md for the keys.
Radar read_radar(const std::filesystem::path& file);

/// The same with every TX of the board, whichever the file enables, and no check against the limits
/// of the chip: what other settings than the file's are put on.
Radar read_board(const std::filesystem::path& file);

}  // namespace specula
