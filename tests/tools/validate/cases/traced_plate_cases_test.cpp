#include <cmath>

#include "tests/tools/validate/made_up_case.hpp"
#include "tests/tools/validate/naive_surface_sum.hpp"

// Plates that no reference file has, against the integral as it is written down.

namespace specula {
namespace {

using Json = nlohmann::json;
using C = std::complex<double>;

// The midpoint rule with steps of a sixteenth of a wavelength is off by 0.01 dB.
const Json naive_tolerance{{"db", 0.03}, {"phase_deg", 0.3}};

Json echo(C h) {
    return {{"h", pair_of(h)},
            {"abs_db", 20.0 * std::log10(std::abs(h))},
            {"phase_deg", std::arg(h) * 180.0 / pi}};
}

/// Passes with the right expectation, fails with one that is off by a tenth.
void check_judged(const std::string& id, const Json& inp, C h, const Json& tolerance) {
    check_passes(case_of(id, inp, echo(h), tolerance));
    CHECK(validated(case_of(id, inp, echo(1.1 * h), tolerance)).verdict() == Verdict::fail);
}

TEST_CASE("other plates, tilts and antennas give the written-out integral",
          "[validate][N03][N04]") {
    check_judged(
        "N03_plate_height",
        {{"antenna", "patch"}, {"L_m", 0.07}, {"H_m", 0.23}, {"tilt_deg", 0}, {"f_hz", 57e9}},
        NaivePlate{.side_m = 0.07,
                   .height_m = 0.23,
                   .frequency_hz = 57e9,
                   .tx_is_patch = true,
                   .rx_is_patch = true}
            .transfer(),
        naive_tolerance);
    for (const bool about_x : {true, false}) {
        const double tilt_rad = 7.0 * pi / 180.0;
        check_judged("N04_plate_tilt",
                     {{"antenna", "patch"},
                      {"L_m", 0.08},
                      {"H_m", 0.31},
                      {"tilt_deg", 7},
                      {"tilt_axis", about_x ? "x (elevation)" : "y"},
                      {"pivot", "plate centre"},
                      {"f_hz", 62e9}},
                     NaivePlate{.side_m = 0.08,
                                .height_m = 0.31,
                                .frequency_hz = 62e9,
                                .about_x_rad = about_x ? tilt_rad : 0.0,
                                .about_y_rad = about_x ? 0.0 : tilt_rad,
                                .tx_is_patch = true,
                                .rx_is_patch = true}
                         .transfer(),
                     naive_tolerance);
    }
}

TEST_CASE("other antennas apart, off centre or unlike give the written-out integral",
          "[validate][N05][N08][E01]") {
    const NaivePlate apart{.side_m = 0.06,
                           .height_m = 0.27,
                           .frequency_hz = 64e9,
                           .about_y_rad = -0.05,
                           .tx_m = {0.02, -0.03, 0.0},
                           .rx_m = {-0.04, 0.01, 0.0}};
    Json inp{{"antenna", "iso"},
             {"L_m", 0.06},
             {"H_m", 0.27},
             {"f_hz", 64e9},
             {"tilt_deg", -0.05 * 180.0 / pi},
             {"tilt_axis", "y"},
             {"tx_xy_m", {0.02, -0.03}},
             {"rx_xy_m", {-0.04, 0.01}}};
    check_judged("N05_bistatic", inp, apart.transfer(), naive_tolerance);

    NaivePlate unlike = apart;
    unlike.rx_is_patch = true;
    inp.erase("antenna");
    inp["ant_tx"] = "iso";
    inp["ant_rx"] = "patch";
    Json tolerance = naive_tolerance;
    tolerance["self_consistency_rel"] = 0.02;
    check_judged("E01_reciprocity", inp, unlike.transfer(), tolerance);
    tolerance["self_consistency_rel"] = 1e-9;  // physical optics is not exactly reciprocal
    CHECK(
        validated(case_of("E01_reciprocity", inp, echo(unlike.transfer()), tolerance)).verdict() ==
        Verdict::fail);

    check_judged(
        "N08_lateral_offset",
        {{"L_m", 0.09},
         {"H_m", 0.4},
         {"plate_centre_xy_m", {0.03, -0.05}},
         {"f_hz", 58e9},
         {"antenna", "iso"}},
        NaivePlate{
            .side_m = 0.09, .height_m = 0.4, .frequency_hz = 58e9, .centre_m = {0.03, -0.05, 0.0}}
            .transfer(),
        naive_tolerance);
}

TEST_CASE("another bowed plate gives the written-out integral and its optics", "[validate][N12]") {
    const Json inp{{"L_m", 0.08},
                   {"H_m", 0.33},
                   {"f_hz", 60e9},
                   {"antenna", "iso"},
                   {"sag_at_edge_midpoint_m", 0.002},
                   {"surface", "z=-sag*(x^2+y^2)/(L/2)^2"}};
    const NaivePlate plate{.side_m = 0.08, .height_m = 0.33, .frequency_hz = 60e9, .sag_m = 0.002};
    check_judged("N12_bowed_plate", inp, plate.transfer(), naive_tolerance);
    // A mirror's focal length is half its radius (L/2)^2 / (2 sag).
    const double radius_m = 0.04 * 0.04 / 0.004;
    check_passes(case_of("N12_bowed_plate", inp,
                         {{"go_divergence_db", 20.0 * std::log10(radius_m / (radius_m + 0.33))}},
                         {{"db", 1e-9}}));
}

TEST_CASE("low levels are judged by the band that the case gives them", "[validate][N04]") {
    const Json inp{{"L_m", 0.05},      {"H_m", 0.45},  {"tilt_deg", 14},
                   {"tilt_axis", "y"}, {"f_hz", 60e9}, {"antenna", "iso"}};
    const C h = NaivePlate{.side_m = 0.05,
                           .height_m = 0.45,
                           .frequency_hz = 60e9,
                           .about_y_rad = 14.0 * pi / 180.0}
                    .transfer();
    const double image = 299792458.0 / 60e9 / (8.0 * pi * 0.45);
    REQUIRE(std::abs(h) < 0.09 * image);
    const Json off = echo(std::pow(10.0, 0.5 / 20.0) * h);
    Json tolerance{{"db", 0.2}, {"phase_deg", 3.0}, {"db_below_minus20dB_rel_image", 1.0}};
    check_passes(case_of("N04_plate_tilt", inp, off, tolerance));
    tolerance.erase("db_below_minus20dB_rel_image");
    CHECK(validated(case_of("N04_plate_tilt", inp, off, tolerance)).verdict() == Verdict::fail);
}

TEST_CASE("a level slab returns its plate's echo times Airy's sum", "[validate][N06]") {
    const C index = std::sqrt(C(3.4, -0.2)), r = (1.0 - index) / (1.0 + index);
    const double k = two_pi * 61e9 / 299792458.0;
    const C round = std::exp(C(0.0, -2.0) * k * index * 0.007);
    const double r0_db = 20.0 * std::log10(std::abs(r * (1.0 - round) / (1.0 - r * r * round)));
    const Json inp{
        {"material", "some"}, {"eps", {3.4, -0.2}}, {"d_m", 0.007}, {"backing", "none (air)"},
        {"L_m", 0.1},         {"H_m", 0.5},         {"f_hz", 61e9}, {"antenna", "iso"}};
    // The plate is seen within 8 degrees of its normal: case N06 gives 0.3 dB.
    check_passes(case_of("N06_dielectric_plate", inp,
                         {{"rel_pec_plate_db", r0_db}, {"slab_r0_db", r0_db}}, {{"db", 0.3}}));
    CHECK(validated(case_of("N06_dielectric_plate", inp, {{"rel_pec_plate_db", r0_db + 0.7}},
                            {{"db", 0.3}}))
              .verdict() == Verdict::fail);
}

TEST_CASE("far away another plate obeys the radar equation", "[validate][N10]") {
    const double wavelength = 299792458.0 / 77e9,
                 sigma = 4.0 * pi * std::pow(0.013, 4) / (wavelength * wavelength);
    const double far_db = 10.0 * std::log10(wavelength * wavelength * sigma /
                                            (std::pow(4.0 * pi, 3) * std::pow(30.0, 4)));
    const Json inp{{"L_m", 0.013}, {"H_m", 30.0}, {"f_hz", 77e9}, {"antenna", "iso"}};
    check_passes(
        case_of("N10_near_to_far", inp,
                {{"far_field_radar_eq_db", far_db}, {"near_over_far_db", 0.0}, {"abs_db", far_db}},
                {{"db", 1e-3}}));
}

TEST_CASE("another chirp's samples are the channel at its frequencies", "[validate][N11]") {
    constexpr int n = 12;
    Json real = Json::array(), imaginary = Json::array();
    for (int i = 0; i < n; ++i) {
        const C h = NaivePlate{.side_m = 0.04,
                               .height_m = 0.2,
                               .frequency_hz = 59e9 + 3e9 * i / n,
                               .about_y_rad = 0.06,
                               .tx_is_patch = true,
                               .rx_is_patch = true}
                        .transfer(130);
        real.push_back(h.real());
        imaginary.push_back(h.imag());
    }
    const Json inp{{"L_m", 0.04},        {"H_m", 0.2},        {"tilt_deg", 0.06 * 180.0 / pi},
                   {"tilt_axis", "y"},   {"material", "PEC"}, {"antenna", "patch"},
                   {"f0_hz", 59e9},      {"B_hz", 3e9},       {"N", n},
                   {"f_n", "f0 + B n/N"}};
    const Json tolerance{{"db_bins_within_30dB_of_peak", 0.02}, {"db_other", 1.0}};
    check_passes(case_of(
        "N11_chirp_response", inp,
        {{"h_real", real}, {"h_imag", imaginary}, {"bin_size_m", 299792458.0 / 6e9}}, tolerance));
    real[5] = 0.0;
    CHECK(validated(case_of("N11_chirp_response", inp, {{"h_real", real}, {"h_imag", imaginary}},
                            tolerance))
              .verdict() == Verdict::fail);
}

TEST_CASE("what a plate's case does not say in known words is not computed",
          "[validate][N04][N11][N12]") {
    const Json inp{{"L_m", 0.05}, {"H_m", 0.3}, {"f_hz", 60e9}};
    const auto refused = [&](const char* id, const char* name, const char* value) {
        Json odd = inp;
        odd[name] = value;
        return validated(case_of(id, odd, {{"abs_db", -60.0}}, naive_tolerance)).verdict() ==
               Verdict::not_computable;
    };
    CHECK(refused("N04_plate_tilt", "tilt_axis", "z"));
    CHECK(refused("N04_plate_tilt", "pivot", "corner"));
    CHECK(refused("N04_plate_tilt", "antenna", "horn"));
    CHECK(refused("N12_bowed_plate", "surface", "z=sin(x)"));
}

}  // namespace
}  // namespace specula
