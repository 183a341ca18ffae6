#include "tools/validate/read_inputs.hpp"

#include <cctype>
#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

std::string lower_case(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

double cos_incidence_of(const Fields& inp) {
    constexpr Range below_grazing{.min = 0.0, .max = 90.0, .max_excluded = true};
    return std::cos(inp.number("theta_deg", below_grazing) * pi / 180.0);
}

double frequency_of(const Fields& inp) {
    return inp.number_of({"f_hz", "f"}, Range::between(1e3, 1e13));
}

namespace {

Chirp sampled_at(const Fields& inp, double rate_hz) {
    const int n_samples = inp.count("N", Range::between(2, most_samples));
    const double bandwidth_hz = inp.number_of({"B_hz", "B"}, Range::above(0.0));
    const double duration_s = n_samples / rate_hz;
    return {.start_hz = inp.number_of({"f0_hz", "f0"}, Range::between(1e3, 1e13)),
            .slope_hz_s = bandwidth_hz / duration_s,
            .sample_rate_hz = rate_hz,
            .n_samples = n_samples,
            .skip_samples = 0,
            .filter_latency_samples = 0,
            .ramp_end_s = duration_s};
}

}  // namespace

Chirp chirp_of(const Fields& inp) {
    return sampled_at(inp, inp.number_of({"fs_hz", "fs"}, Range::above(0.0)));
}

Chirp chirp_of(const Fields& inp, double usual_rate_hz) {
    return inp.has("fs_hz") || inp.has("fs") ? chirp_of(inp) : sampled_at(inp, usual_rate_hz);
}

Stack slab_of(const Fields& inp) {
    return {.layers = {{.medium = {.permittivity = inp.permittivity("eps")},
                        .thickness_m = inp.number("d_m", Range::above(0.0))}},
            .frequency_hz = frequency_of(inp)};
}

Backing backing_of(const Fields& inp, const std::string& name) {
    if (!inp.is_text(name)) return HalfSpace{.medium = {.permittivity = inp.permittivity(name)}};
    const std::string text = lower_case(inp.text(name));
    if (text == "pec" || text == "metal") return PerfectConductor{};
    if (text == "air" || text == "none" || text == "none (air)") return HalfSpace{};
    throw NotComputable(format("does not know the backing \"{}\"", text));
}

Pattern antenna_of(const Fields& inp, const std::string& name) {
    const std::string text = lower_case(inp.text(name));
    if (text == "iso" || text == "isotropic") return IsotropicPattern{.gain_dbi = 0.0};
    if (text == "patch")
        return PatchPattern{.gain_dbi = 5.5,
                            .half_width_azimuth_rad = 60.0 * pi / 180.0,
                            .half_width_elevation_rad = 35.0 * pi / 180.0};
    throw NotComputable(format("does not know the antenna \"{}\"", text));
}

}  // namespace specula
