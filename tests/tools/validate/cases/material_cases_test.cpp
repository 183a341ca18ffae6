#include <cmath>

#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/tools/validate/made_up_case.hpp"

// Parameters that no reference file has, beside the textbook's words written out naively.

namespace specula {
namespace {

using Json = nlohmann::json;
using C = std::complex<double>;

struct Faces {
    C te, tm;
};

Faces half_space(C eps, double theta_rad) {
    const C q = std::sqrt(eps - std::pow(std::sin(theta_rad), 2));
    const double c = std::cos(theta_rad);
    return {(c - q) / (c + q), (eps * c - q) / (eps * c + q)};
}

/// A slab's echoes, one after the other, until they no longer count.
Faces slab_reflected(C eps, double d_m, double theta_rad, double f_hz) {
    const Faces face = half_space(eps, theta_rad);
    const C q = std::sqrt(eps - std::pow(std::sin(theta_rad), 2));
    const C trip = std::exp(C(0.0, -4.0 * pi * f_hz / speed_of_light_m_s * d_m) * q);
    const auto sum = [&](C r) {
        C total = r, echo = (1.0 - r * r) * -r * trip;
        for (int i = 0; i < 400; ++i, echo *= r * r * trip) total += echo;
        return total;
    };
    return {sum(face.te), sum(face.tm)};
}

TEST_CASE("another slab, angle and frequency is recomputed, not looked up", "[validate][M03]") {
    const C eps(3.7, -0.09);
    const Faces r = slab_reflected(eps, 0.0073, 33.0 * pi / 180.0, 24.1e9);
    const Json inp{{"eps", pair_of(eps)}, {"d_m", 0.0073}, {"theta_deg", 33}, {"f_hz", 24.1e9}};
    const Json expect{{"r_TE", pair_of(r.te)}, {"r_TM", pair_of(r.tm)}};
    check_passes(case_of("M03_slab", inp, expect, {{"abs", 1e-12}}));
    Json thicker = inp;
    thicker["d_m"] = 0.0074;
    CHECK(validated(case_of("M03_slab", thicker, expect, {{"abs", 1e-3}})).verdict() ==
          Verdict::fail);
    // The same as a stack of one layer.
    check_passes(case_of("M04_stack",
                         {{"eps_layers", {pair_of(eps)}},
                          {"d_m", {0.0073}},
                          {"substrate", 1.0},
                          {"theta_deg", 33},
                          {"f_hz", 24.1e9}},
                         expect, {{"abs", 1e-12}}));
}

TEST_CASE("a quarter-wave layer on a conductor turns the field by a half", "[validate][M04]") {
    const double f_hz = 79e9, quarter_m = speed_of_light_m_s / f_hz / 4.0 / 2.0;
    check_passes(case_of("M04_stack",
                         {{"eps_layers", {4.0}},
                          {"d_m", {quarter_m}},
                          {"substrate", "pec"},
                          {"theta_deg", 0},
                          {"f_hz", f_hz}},
                         {{"r_TE", 1.0}, {"r_TM", {-1.0, 0.0}}}, {{"abs", 1e-12}}));
}

TEST_CASE("another half-space reflects as Fresnel says, and least at Brewster's angle",
          "[validate][M01]") {
    const C eps(5.1, -0.7);
    const Faces r = half_space(eps, 71.0 * pi / 180.0);
    const Json tolerance{{"abs", 1e-12}, {"angle_deg", 0.002}, {"abs_r_TM_at_brewster", 1e-9}};
    check_passes(case_of("M01_fresnel", {{"eps", pair_of(eps)}, {"theta_deg", 71}},
                         {{"r_TE", pair_of(r.te)}, {"r_TM", pair_of(r.tm)}}, tolerance));
    check_passes(case_of("M01_fresnel", {{"eps", 3.0}, {"quantity", "Brewster"}},
                         {{"theta_deg", 60.0}, {"abs_r_TM", 0.0}}, tolerance));
    // A search over a grid of 0.001 degrees, as whoever writes a case would make it.
    double least = 2.0, at_deg = 0.0;
    for (int i = 0; i < 90000; ++i) {
        const double tm = std::abs(half_space(eps, i * 1e-3 * pi / 180.0).tm);
        if (tm < least) least = tm, at_deg = i * 1e-3;
    }
    check_passes(case_of("M01_fresnel",
                         {{"eps", pair_of(eps)}, {"quantity", "pseudo-Brewster (min |r_TM|)"}},
                         {{"theta_deg", at_deg}, {"abs_r_TM", least}}, tolerance));
}

TEST_CASE("every row of P.2040-3 is there, under its own name", "[validate][M02]") {
    struct Row {
        const char* name;
        double a, b, c, d;
    };
    for (const Row& row : {Row{"concrete", 5.24, 0, 0.0462, 0.7822},
                           {"brick", 3.91, 0, 0.0238, 0.16},
                           {"plasterboard", 2.73, 0, 0.0085, 0.9395},
                           {"wood", 1.99, 0, 0.0047, 1.0718},
                           {"glass", 6.31, 0, 0.0036, 1.3394},
                           {"ceiling_board", 1.48, 0, 0.0011, 1.0750},
                           {"chipboard", 2.58, 0, 0.0217, 0.7800},
                           {"plywood", 2.71, 0, 0.33, 0},
                           {"marble", 7.074, 0, 0.0055, 0.9262},
                           {"floorboard", 3.66, 0, 0.0044, 1.3515},
                           {"metal", 1, 0, 1e7, 0},
                           {"very dry ground", 3, 0, 0.00015, 2.52},
                           {"medium dry ground", 15, -0.1, 0.035, 1.63},
                           {"wet ground", 30, -0.4, 0.15, 1.30}}) {
        INFO(row.name);
        const double f_ghz = 41.5;
        const double sigma = row.c * std::pow(f_ghz, row.d);
        const double eps_r = row.a * std::pow(f_ghz, row.b);
        const double loss = sigma / (two_pi * f_ghz * 1e9 * 8.8541878128e-12);
        check_passes(case_of("M02_itu_p2040", {{"material", row.name}, {"f_hz", f_ghz * 1e9}},
                             {{"eps", pair_of({eps_r, -loss})},
                              {"sigma_S_per_m", sigma},
                              {"loss_tangent", loss / eps_r}},
                             {{"rel", 1e-6}}));
    }
    CHECK(validated(case_of("M02_itu_p2040", {{"material", "unobtainium"}, {"f_hz", 60e9}},
                            {{"eps_r", 1.0}}, {{"rel", 1e-6}}))
              .verdict() == Verdict::not_computable);
}

TEST_CASE("another mixture keeps the laws' own equations", "[validate][M06]") {
    const C host(4.2, -0.3), pore(1.7, -0.01);
    const double v = 0.37;
    const C root = (1.0 - v) * std::pow(host, 1.0 / 3.0) + v * std::pow(pore, 1.0 / 3.0);
    const C beta = (pore - host) / (pore + 2.0 * host);
    const Json inp{{"host_eps", pair_of(host)}, {"inclusion_eps", pair_of(pore)}, {"porosity", v}};
    check_passes(
        case_of("M06_mixing", inp,
                {{"looyenga", pair_of(root * root * root)},
                 {"maxwell_garnett", pair_of(host * (1.0 + 2.0 * v * beta) / (1.0 - v * beta))},
                 {"lichtenecker", pair_of(std::pow(host, 1.0 - v) * std::pow(pore, v))}},
                {{"rel", 1e-12}}));
    const CaseVerdict verdict =
        validated(case_of("M06_mixing", inp, {{"bruggeman", 1.0}}, {{"rel", 1.0}}));
    const C e = std::get<C>(computed(verdict, "bruggeman"));
    CHECK(std::abs((1.0 - v) * (host - e) / (host + 2.0 * e) + v * (pore - e) / (pore + 2.0 * e)) <
          1e-12);
}

TEST_CASE("another metal has the skin depth and loss of its conductivity", "[validate][M05]") {
    const double sigma = 1.37e7, f_hz = 77e9, mu_r = 3.0;
    const double skin_m = std::sqrt(1.0 / (pi * f_hz * 4e-7 * pi * mu_r * sigma));
    const double loss = 1.0 / (sigma * skin_m) / 376.730313668;
    check_passes(case_of(
        "M05_metals",
        {{"metal", "made up"}, {"sigma", sigma}, {"mu_r", mu_r}, {"f_hz", f_hz}, {"theta_deg", 50}},
        {{"skin_depth_m", skin_m},
         {"Rs_ohm", 1.0 / (sigma * skin_m)},
         {"R_TE_dB", 10.0 * std::log10(1.0 - 4.0 * loss * std::cos(50.0 * pi / 180.0))},
         {"R_TM_dB", 10.0 * std::log10(1.0 - 4.0 * loss / std::cos(50.0 * pi / 180.0))}},
        {{"R_dB", 1e-4}, {"skin_depth_rel", 1e-6}}));
}

TEST_CASE("what a rough face sends back follows its Rayleigh parameter", "[validate][M08]") {
    const double p = 4.0 * pi * 35e9 / speed_of_light_m_s * 0.31e-3 * std::cos(0.3);
    check_passes(case_of("M08_roughness",
                         {{"f_hz", 35e9}, {"rms_m", 0.31e-3}, {"theta_deg", 0.3 * 180.0 / pi}},
                         {{"field_factor", std::exp(-0.5 * p * p)},
                          {"power_db", -10.0 * p * p / std::log(10.0)},
                          {"rayleigh_parameter_2ks_cos", p},
                          {"is_rayleigh_smooth", p < 0.5 * pi}},
                         {{"rel", 1e-9}}));
}

TEST_CASE("a slab of another loss keeps the balance of energy", "[validate][M09]") {
    const CaseVerdict verdict = validated(case_of(
        "M09_energy", {{"eps", {7.1, -1.3}}, {"d_m", 0.0031}, {"theta_deg", 66}, {"f_hz", 94e9}},
        {{"R_TE", 0}, {"T_TE", 0}, {"A_TE", 0}, {"R_TM", 0}, {"T_TM", 0}, {"A_TM", 0}},
        {{"abs", 1}}));
    const auto share = [&](const std::string& name) {
        return std::get<double>(computed(verdict, name));
    };
    for (const std::string pol : {"TE", "TM"}) {
        CHECK(share("R_" + pol) + share("T_" + pol) + share("A_" + pol) == Approx(1.0));
        CHECK(share("A_" + pol) > 0.0);
    }
}

}  // namespace
}  // namespace specula
