#pragma once

namespace specula {

/// A point target in the far field.
struct RadarEquation {
    double transmitted_dbm;
    double two_way_gain_db;  ///< of both antennas together
    double frequency_hz;
    double cross_section_m2;
    double range_m;
};

/// Pt Gt Gr lambda^2 sigma / ((4 pi)^3 R^4), in dBm.
/// @eq  Skolnik, Introduction to Radar Systems, equation (1.7)
double received_dbm(const RadarEquation& target);

/// Optical cross-sections: of a large sphere, and of corner reflectors along their axis, edge
/// length a.
double sphere_cross_section_m2(double radius_m);
struct CornerReflector {
    double edge_m;
    double frequency_hz;
};
double triangular_trihedral_m2(const CornerReflector& corner);  ///< 4 pi a^4 / (3 lambda^2)
double square_trihedral_m2(const CornerReflector& corner);      ///< 12 pi a^4 / lambda^2

}  // namespace specula
