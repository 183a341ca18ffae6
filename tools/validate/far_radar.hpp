#pragma once

#include "sim/channel/channel.hpp"
#include "sim/trace/trace.hpp"

namespace specula {

/// A wave far from a target at the origin.
struct FarWave {
    Vector3 from;          ///< unit, from the target to the antenna
    Vector3 polarisation;  ///< unit, across `from`
};

/// A point of the sphere around a target, and its unit vectors there.
struct SphericalDirection {
    double from_z_rad;
    double from_x_rad;

    Vector3 outward() const;
    Vector3 along_theta() const;
    Vector3 along_phi() const;
};

/// Antennas so far away that the waves at a target about the origin are plane.
struct FarRadar {
    double frequency_hz;
    double target_size_m;
    FarWave sent;
    FarWave received;

    /// What is traced: all waves that met up to `n_bounces` surfaces, or those that met so many.
    struct Waves {
        int n_bounces = 1;
        bool these_only = false;
    };
    /// F in E_s = F E_i exp(-jkr)/r of a target of metal, its phase referred to the origin, in m.
    ///
    /// Traced from a million times the size of the target and from twice that, then carried on to
    /// infinity: the phase over the target is off by k size / 4e6 there, which falls as 1/r; double
    /// holds the path to k size / 1e9.
    Complex amplitude_m(const Target& target, const Waves& waves) const;
    /// sigma = 4 pi |F|^2.
    double cross_section_m2(const Target& target, const Waves& waves) const;

  private:
    Complex amplitude_from(double distance_m, const Target& target, const Waves& waves) const;
};

/// The radar that hears itself.
FarRadar monostatic(const FarWave& wave, double frequency_hz, double target_size_m);

}  // namespace specula
