#include <cmath>

#include "materials/diffuse.hpp"
#include "sim/channel/diffuse_power.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/height_field.hpp"
#include "sim/trace/speckle.hpp"
#include "sim/trace/trace.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Pieces drawn for the spread of levels: twice as many move it by less than 3 %.
constexpr int n_pieces = 600;
/// Explicit height fields shown beside it: so few tell their power to within a half of itself, and
/// 80,000 triangles each take a quarter of a second. Larger plates are not worth the wait.
constexpr int n_fields = 4;
constexpr double most_shown_triangles = 2e5;

/// A perfectly conducting square under one antenna.
struct RoughPlate {
    double frequency_hz, roughness_m, correlation_m;
    Plate face;
    AntennaSet antennas;

    Target target() const { return Target({plate_body(face, {}, true, 0.0)}); }
    double n_triangles() const {
        return 50.0 * face.size_x_m * face.size_y_m / (correlation_m * correlation_m);
    }
    Reflector reflector(double heights_m) const {
        return [heights_m, correlation = correlation_m](double at_hz) {
            return Stack{{}, PerfectConductor{heights_m, correlation}, at_hz};
        };
    }
};

RoughPlate plate_of(const Fields& inp) {
    const std::string correlation = lower_case(inp.text("correlation"));
    if (correlation.rfind("gaussian", 0) != 0)
        throw NotComputable("does not know the correlation \"" + correlation + "\"");
    const double side_m = inp.number("L_m", Range::inside(0.0, 3.0));
    const double height_m = inp.number("H_m", Range::above(0.0));
    const PlacedAntenna antenna{
        {0.0, 0.0, height_m}, Rotation::Identity(), antenna_of(inp, "antenna")};
    const Plate square{.size_x_m = side_m, .size_y_m = side_m};
    return {frequency_of(inp),
            inp.number("rms_m", Range::at_least(0.0)),
            inp.number("corr_len_m", Range::above(0.0)),
            square,
            {antenna, {antenna}}};
}

/// What the engine says of the plate.
struct RoughEcho {
    Complex smooth, coherent;
    double diffuse_power = 0.0;       ///< mean over pieces
    double spread_of_level_db = 0.0;  ///< standard deviation over pieces
    double of_fields_power =
        0.0;  ///< diffuse power of explicit height fields; 0: too many triangles
};

double spread_of(const std::vector<double>& values) {
    double sum = 0.0, squares = 0.0;
    for (const double value : values) sum += value;
    const double n = static_cast<double>(values.size()), mean = sum / n;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return std::sqrt(squares / (n - 1.0));
}

/// Mean diffuse power of explicit height fields through the same engine.
double power_of_fields(const RoughPlate& plate, Complex coherent) {
    if (plate.n_triangles() > most_shown_triangles) return 0.0;
    const Reflector metal = plate.reflector(0.0);
    double sum = 0.0;
    for (int i = 0; i < n_fields; ++i) {
        Stream piece({.seed = static_cast<std::uint64_t>(i), .purpose = "heights"});
        const Mesh mesh = height_field(plate.face, {plate.roughness_m, plate.correlation_m}, piece);
        const Scatter scatter = trace(Target({mesh_body(mesh, true, 0.0)}), plate.antennas,
                                      {.highest_hz = plate.frequency_hz});
        sum += std::norm(direct_sum(scatter, 0, {&metal, 1}, plate.frequency_hz) - coherent);
    }
    return sum / n_fields;
}

RoughEcho echo_of(const RoughPlate& plate) {
    const Reflector smooth = plate.reflector(0.0), rough = plate.reflector(plate.roughness_m);
    const double f_hz = plate.frequency_hz;
    const Target target = plate.target();
    const Scatter mirror = trace(target, plate.antennas, {.highest_hz = f_hz, .accuracy_db = 1e-3});
    RoughEcho echo;
    echo.smooth = direct_sum(mirror, 0, {&smooth, 1}, f_hz);
    echo.coherent = direct_sum(mirror, 0, {&rough, 1}, f_hz);
    const RouteScatter cells =
        diffuse_cells(target, plate.antennas, {.correlation_m = plate.correlation_m});
    echo.diffuse_power =
        mean_diffuse_power(cells, {&rough, 1}, {.first_hz = f_hz, .step_hz = 0.0, .n = 1})[0];
    std::vector<double> levels_db;
    for (int i = 0; i < n_pieces; ++i) {
        Scatter piece{.n_rx = 1, .routes = {cells}};
        Stream heights({.seed = static_cast<std::uint64_t>(i), .purpose = "speckle"});
        draw_speckle(piece.routes[0], heights);
        levels_db.push_back(amplitude_db(echo.coherent + direct_sum(piece, 0, {&rough, 1}, f_hz)));
    }
    echo.spread_of_level_db = spread_of(levels_db);
    echo.of_fields_power = power_of_fields(plate, echo.coherent);
    return echo;
}

/// Standard error, in share of its size, of a coherent amplitude that is itself the mean over
/// `n_real` random surfaces: the diffuse echo has half its power in phase with it.
double standard_error(const CasePoint& point, const RoughEcho& echo) {
    const double smooth_db = amplitude_db(echo.smooth);
    const double diffuse_db = point.expect.number_or("incoherent_power_rel_smooth_db",
                                                     power_db(echo.diffuse_power) - smooth_db);
    const double coherent_db =
        point.expect.number_or("coherent_rel_smooth_db", amplitude_db(echo.coherent) - smooth_db);
    const int n_real = point.inp.count("n_real", Range::between(1, 1'000'000));
    return std::sqrt(0.5 * std::pow(10.0, (diffuse_db - coherent_db) / 10.0) / n_real);
}

/// The mean over surfaces is a Monte Carlo estimate: twice its own standard error is no error of
/// ours. Everything else keeps the tolerance of the case.
void compare_mean(Comparison& compare, const CasePoint& point, const RoughEcho& echo) {
    const double level_db = point.tolerance.number("coherent_db", Range::at_least(0.0));
    const double share = std::pow(10.0, level_db / 20.0) - 1.0;
    const double error = 2.0 * standard_error(point, echo);
    const Allowed level{level_db + 20.0 * std::log10(1.0 + error), "dB"};
    const Allowed phase{std::asin(std::min(1.0, share + error)) * 180.0 / pi, "deg"};
    const auto compare_phase = [&](const std::string& name, double expected_deg) {
        const double off_deg = wrapped_error({phase_deg(echo.coherent), expected_deg}, 360.0);
        compare.beside(name, {expected_deg + off_deg, expected_deg}, phase);
    };
    if (compare.wants("mean_h.h")) {
        const Complex expected = point.expect.complex("mean_h.h");
        compare.beside("mean_h.h (level)", {amplitude_db(echo.coherent), amplitude_db(expected)},
                       level);
        compare_phase("mean_h.h (phase)", phase_deg(expected));
    }
    compare.within("mean_h.abs_db", amplitude_db(echo.coherent), level);
    if (compare.wants("mean_h.phase_deg"))
        compare_phase("mean_h.phase_deg", point.expect.number("mean_h.phase_deg"));
    compare.within("coherent_rel_smooth_db", amplitude_db(echo.coherent / echo.smooth), level);
}

}  // namespace

std::vector<Quantity> rough_plate_point(const CasePoint& point) {
    const RoughEcho echo = echo_of(plate_of(point.inp));
    Comparison compare(point);
    compare_mean(compare, point, echo);
    compare.level("ament_prediction_db", amplitude_db(echo.coherent / echo.smooth), "coherent_db");
    compare.level("incoherent_power_rel_smooth_db",
                  power_db(echo.diffuse_power) - amplitude_db(echo.smooth), "incoherent_db");
    compare.relative("std_of_abs_db", echo.spread_of_level_db, "std_rel");
    if (compare.wants("incoherent_power_rel_smooth_db") && echo.of_fields_power > 0.0) {
        compare.not_judged();
        compare.beside(format("incoherent_power_rel_smooth_db ({} height fields)", n_fields),
                       {power_db(echo.of_fields_power) - amplitude_db(echo.smooth),
                        point.expect.number("incoherent_power_rel_smooth_db")},
                       {point.tolerance.number("incoherent_db"), "dB"});
    }
    return compare.finish();
}

}  // namespace specula
