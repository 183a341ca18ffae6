#include <cstdlib>

#include "sim/link_budget.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/radar_equation.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// The length behind "a=" in a target's description, as "a=5 cm".
double length_in(const std::string& target) {
    const std::size_t found = target.find("a=");
    if (found == std::string::npos)
        throw NotComputable("finds no size, as \"a=5 cm\", in \"" + target + "\"");
    char* rest = nullptr;
    const double value = std::strtod(target.c_str() + found + 2, &rest);
    while (*rest == ' ') ++rest;
    const std::string unit = std::string(rest).substr(0, std::string(rest).find_first_of(" (,;"));
    const double metres = unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : unit == "m" ? 1.0 : 0.0;
    if (!(value * metres > 0.0))
        throw NotComputable("finds no length in mm, cm or m in \"" + target + "\"");
    return value * metres;
}

/// A ramp that is centred on the frequency, and a pattern of the mean gain.
Radar radar_of(const RadarEquation& link) {
    Radar radar;
    radar.chirp.skip_samples = radar.chirp.filter_latency_samples = 0;
    radar.chirp.start_hz = link.frequency_hz - 0.5 * radar.chirp.bandwidth_hz();
    radar.tx_power_dbm = link.transmitted_dbm;
    radar.pattern = IsotropicPattern{.gain_dbi = 0.5 * link.two_way_gain_db};
    return radar;
}

double cross_section_m2(const std::string& target, double frequency_hz) {
    if (target.find("sphere") != std::string::npos)
        return sphere_cross_section_m2(length_in(target));
    const bool trihedral = target.find("trihedral") != std::string::npos;
    if (trihedral && target.find("triangular") != std::string::npos)
        return triangular_trihedral_m2({.edge_m = length_in(target), .frequency_hz = frequency_hz});
    if (trihedral && target.find("square") != std::string::npos)
        return square_trihedral_m2({.edge_m = length_in(target), .frequency_hz = frequency_hz});
    throw NotComputable("does not know the target \"" + target + "\"");
}

}  // namespace

std::vector<Quantity> received_power_point(const CasePoint& point) {
    const std::string target = lower_case(point.inp.text("target"));
    RadarEquation link{.transmitted_dbm = point.inp.number("Pt_dbm"),
                       .two_way_gain_db = point.inp.number("Gt_dbi") + point.inp.number("Gr_dbi"),
                       .frequency_hz = frequency_of(point.inp),
                       .cross_section_m2 = 0.0,
                       .range_m = point.inp.number("R_m", Range::above(0.0))};
    Comparison compare(point);
    if (target.find("mirror") != std::string::npos) {
        compare.level("Pr_dbm", mirror_budget(radar_of(link), link.range_m).received_dbm, "db");
        return compare.finish();
    }
    link.cross_section_m2 = cross_section_m2(target, link.frequency_hz);
    compare.level("Pr_dbm", received_dbm(link), "db");
    if (compare.wants("sigma_m2")) {
        const double expected = point.expect.number("sigma_m2", Range::above(0.0));
        const double tolerance = std::pow(10.0, 0.1 * point.tolerance.number("db")) - 1.0;
        compare.within("sigma_m2", link.cross_section_m2, {tolerance * expected, "m^2"});
    }
    return compare.finish();
}

}  // namespace specula
