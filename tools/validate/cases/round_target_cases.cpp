#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/trace/trace.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/plate_under_radar.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// An isotropic antenna of linear gain `G` above the origin, and what is below it.
struct AboveRoundTarget {
    double frequency_hz;
    double gain;
    double height_m;  ///< above the point below it

    explicit AboveRoundTarget(const Fields& inp, const std::string& height_name)
        : frequency_hz(frequency_of(inp)),
          gain(inp.number_or("G", 1.0, Range::above(0.0))),
          height_m(inp.number(height_name, Range::above(0.0))) {}

    double image_db() const {
        return amplitude_db(gain * speed_of_light_m_s / frequency_hz / (8.0 * pi * height_m));
    }
    Complex transfer(const Surface& surface, const Reflector& reflector) const {
        const PlacedAntenna antenna{{0.0, 0.0, height_m},
                                    Rotation::Identity(),
                                    IsotropicPattern{.gain_dbi = power_db(gain)}};
        const Scatter scatter =
            trace(Target({smooth_body(surface)}), {antenna, {antenna}},
                  {.highest_hz = frequency_hz, .accuracy_db = validation_accuracy_db});
        return direct_sum(scatter, 0, {&reflector, 1}, frequency_hz);
    }
    double radius_m(const Fields& inp) const {
        const double radius = inp.number("radius_m", Range::above(0.0));
        if (radius * frequency_hz > 500.0 * speed_of_light_m_s)
            throw NotComputable("sums round targets of up to 500 wavelengths in radius");
        return radius;
    }
};

/// "PEC", or "dielectric" with `eps`.
struct SphereMaterial {
    bool conducts;
    Complex permittivity = 1.0;

    explicit SphereMaterial(const Fields& inp) {
        const std::string name = lower_case(inp.text("sphere"));
        conducts = name == "pec";
        if (!conducts && name != "dielectric")
            throw NotComputable("does not know the sphere \"" + name + "\"");
        if (!conducts) permittivity = inp.permittivity("eps");
    }
    Stack at(double frequency_hz) const {
        if (conducts) return {.backing = PerfectConductor{}, .frequency_hz = frequency_hz};
        return {.backing = HalfSpace{.medium = {.permittivity = permittivity}},
                .frequency_hz = frequency_hz};
    }
};

}  // namespace

std::vector<Quantity> disc_echo_point(const CasePoint& point) {
    const AboveRoundTarget radar(point.inp, "H_m");
    const Complex h =
        radar.transfer(DiscSurface{radar.radius_m(point.inp), {}}, perfect_reflector());
    Comparison compare(point);
    compare.channel("", h);
    compare.level("rel_image_db", amplitude_db(h) - radar.image_db(), "db");
    return compare.finish();
}

std::vector<Quantity> sphere_echo_point(const CasePoint& point) {
    const SphereMaterial material(point.inp);
    const AboveRoundTarget radar(point.inp, "distance_to_surface_m");
    const double radius_m = radar.radius_m(point.inp);
    const Placement below{Rotation::Identity(), {0.0, 0.0, -radius_m}};
    const Complex h = radar.transfer(SphereSurface{radius_m, below}, [&](double frequency_hz) {
        return material.at(frequency_hz);
    });
    // Geometrical optics: the image, spread by the sphere's curvature by a / (a + d).
    const double optics_db =
        radar.image_db() + amplitude_db(radius_m / (radius_m + radar.height_m)) +
        amplitude_db(stack_reflection(material.at(radar.frequency_hz), 1.0).te);
    // The case states no tolerance for dielectric spheres, which its note calls informative: waves
    // that went through them come back too. Theirs are shown against that of conductors.
    Comparison compare(point);
    compare.channel("", h, {.level = "db_pec", .phase = "phase_deg_pec"});
    compare.level("go_abs_db", optics_db, "db_pec");
    compare.level("go_front_face_only_db", optics_db, "db_pec");
    compare.level("exact_over_go_db", amplitude_db(h) - optics_db, "db_pec");
    return compare.finish();
}

}  // namespace specula
