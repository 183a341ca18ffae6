#include "sim/clutter.hpp"

#include <cmath>

#include "sim/core/constants.hpp"

namespace specula {

namespace {

constexpr double widest_angle_rad = 60.0 * pi / 180.0;

}  // namespace

void add_clutter(Channel& channel, const FrequencyComb& comb, const ClutterLaw& law,
                 const Radar& radar, double mirror_transfer, Stream& stream) {
    const double sd = mirror_transfer * std::pow(10.0, law.level_db / 20.0) / std::sqrt(2.0);
    for (int i = 0; i < law.points; ++i) {
        const double range_m = std::abs(law.range_m.sample(stream));
        const double angle_rad = widest_angle_rad * std::sqrt(stream.uniform());
        const double around_rad = two_pi * stream.uniform();
        const double in_phase = stream.normal(), quadrature = stream.normal();
        const Vector3 point_m(range_m * std::sin(angle_rad) * std::cos(around_rad),
                              range_m * std::sin(angle_rad) * std::sin(around_rad),
                              -range_m * std::cos(angle_rad));
        const auto n_rx = static_cast<int>(radar.rx.size());
        for (int link = 0; link < channel.n_rx; ++link) {  // (tx, rx)
            const auto rx = static_cast<std::size_t>(link % n_rx);
            const double length_m = (point_m - radar.tx(link / n_rx).position_m).norm() +
                                    (point_m - radar.rx[rx].position_m).norm();
            add_path(channel, comb,
                     {.rx = link,
                      .length_m = length_m,
                      .transfer = Complex(sd * in_phase, sd * quadrature)});
        }
    }
}

double mirror_transfer(const Radar& radar, double height_m) {
    const double wavelength_m = speed_of_light_m_s / radar.chirp.centre_hz();
    const double gain = gain_towards(radar.pattern, {0.0, 0.0, -1.0});
    return wavelength_m * gain / (4.0 * pi * 2.0 * height_m);
}

}  // namespace specula
