#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/random.hpp"
#include "tests/check.hpp"
#include "tests/tools/validate/made_up_case.hpp"

// A rough plate that the reference does not have, summed here over heights made of plane waves.

namespace specula {
namespace {

using Json = nlohmann::json;
using C = std::complex<double>;

constexpr double side_m = 0.09, height_m = 0.3, frequency_hz = 58e9;
constexpr double rms_m = 1.5e-4, correlation_m = 4e-3, step_m = 1.5e-3;
constexpr int n_surfaces = 40;
const double k = two_pi * frequency_hz / speed_of_light_m_s;

/// Many plane waves of random direction and phase: their sum is Gaussian, and wave numbers with a
/// standard deviation of sqrt(2) / l per axis make its correlation exp(-r^2 / l^2).
struct PlaneWaves {
    static constexpr int n = 32;
    double kx[n], ky[n], phase[n];

    explicit PlaneWaves(Stream& random) {
        for (int i = 0; i < n; ++i) {
            kx[i] = std::sqrt(2.0) / correlation_m * random.normal();
            ky[i] = std::sqrt(2.0) / correlation_m * random.normal();
            phase[i] = two_pi * random.uniform();
        }
    }
    double at(double x, double y) const {
        double sum = 0.0;
        for (int i = 0; i < n; ++i) sum += std::cos(kx[i] * x + ky[i] * y + phase[i]);
        return rms_m * std::sqrt(2.0 / n) * sum;
    }
};

/// Physical optics of a conductor under one isotropic antenna: -j/(4 pi) cos e^{-2jkr} / r^2.
template <typename HeightAt>
C echo_of_face(HeightAt height_at) {
    C sum = 0.0;
    const int n = static_cast<int>(side_m / step_m);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double x = (i + 0.5) * step_m - 0.5 * side_m;
            const double y = (j + 0.5) * step_m - 0.5 * side_m;
            const double z = height_m - height_at(x, y);
            const double r = std::sqrt(x * x + y * y + z * z);
            sum += z / (r * r * r) * std::polar(1.0, -2.0 * k * r);
        }
    }
    return C(0.0, -1.0 / (4.0 * pi)) * sum * step_m * step_m;
}

Json other_plate() {
    Stream random({.seed = 11, .purpose = "plane waves"});
    std::vector<C> echoes;
    for (int i = 0; i < n_surfaces; ++i) {
        const PlaneWaves waves(random);
        echoes.push_back(echo_of_face([&](double x, double y) { return waves.at(x, y); }));
    }
    const C smooth = echo_of_face([](double, double) { return 0.0; });
    C mean = 0.0;
    for (const C& h : echoes) mean += h / double(n_surfaces);
    double power = 0.0, level = 0.0, spread = 0.0;
    for (const C& h : echoes) {
        power += std::norm(h - mean) / (n_surfaces - 1);
        level += 20.0 * std::log10(std::abs(h)) / n_surfaces;
    }
    for (const C& h : echoes)
        spread += std::pow(20.0 * std::log10(std::abs(h)) - level, 2) / (n_surfaces - 1);
    const double smooth_db = 20.0 * std::log10(std::abs(smooth));
    return case_of(
        "S01_other",
        {{"L_m", side_m},
         {"H_m", height_m},
         {"f_hz", frequency_hz},
         {"rms_m", rms_m},
         {"corr_len_m", correlation_m},
         {"correlation", "Gaussian exp(-r^2/lc^2)"},
         {"n_real", n_surfaces},
         {"antenna", "iso"}},
        {{"mean_h", {{"h", pair_of(mean)}}},
         {"coherent_rel_smooth_db", 20.0 * std::log10(std::abs(mean)) - smooth_db},
         {"ament_prediction_db", -20.0 * std::log10(std::exp(1.0)) * 2.0 * std::pow(k * rms_m, 2)},
         {"incoherent_power_rel_smooth_db", 10.0 * std::log10(power) - smooth_db},
         {"std_of_abs_db", std::sqrt(spread)}},
        {{"coherent_db", 0.5}, {"incoherent_db", 2.0}, {"std_rel", 0.35}});
}

TEST_CASE("another rough plate scatters as a sum over made-up heights says", "[validate][S01]") {
    const Json plate = other_plate();
    check_passes(plate);
    Json wrong = plate;
    Json& expected = wrong["points"][0]["expect"];
    for (const auto& [name, off_db] :
         {std::pair{"incoherent_power_rel_smooth_db", 4.0}, {"ament_prediction_db", 0.6}})
        expected[name] = expected[name].get<double>() + off_db;
    const CaseVerdict verdict = validated(wrong);
    for (const Quantity& quantity : verdict.points.front().quantities)
        CHECK(quantity.passes() == (quantity.name != "incoherent_power_rel_smooth_db" &&
                                    quantity.name != "ament_prediction_db"));
    wrong = plate;
    wrong["points"][0]["inp"]["correlation"] = "exponential exp(-r/lc)";
    CHECK(validated(wrong).verdict() == Verdict::not_computable);
}

}  // namespace
}  // namespace specula
