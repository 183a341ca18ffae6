#include "tools/report/reflection_curves.hpp"

#include <algorithm>
#include <cmath>

#include "materials/brewster.hpp"
#include "materials/stack.hpp"
#include "materials/surface_impedance.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "sim/core/literals.hpp"

namespace specula {
namespace {

using namespace literals;

constexpr double middle_hz = 60.0_GHz;
constexpr double faintest = 1e-4;  // -80 dB, far below every scale

double level_db(Complex r) {
    return 20.0 * std::log10(std::max(std::abs(r), faintest));
}

/// A sheet, or without a thickness a half-space.
struct Shape {
    std::string label;
    double thickness_m = 0.0;

    Stack of(const Electrics& medium, double frequency_hz) const {
        if (thickness_m == 0.0) return {{}, HalfSpace{medium}, frequency_hz};
        return {{{.medium = medium, .thickness_m = thickness_m}}, HalfSpace{}, frequency_hz};
    }
};

template <typename MediumAt>
ReflectionCurve over_frequency(const Shape& shape, const MediumAt& medium_at) {
    ReflectionCurve curve{.label = shape.label, .x = {}, .level_db = {}};
    for (int i = 0; i <= 140; ++i) {
        const double f_hz = 57.0_GHz + 0.05_GHz * i;
        curve.x.push_back(f_hz * 1e-9);
        curve.level_db.push_back(
            level_db(stack_reflection(shape.of(medium_at(f_hz), f_hz), 1.0).te));
    }
    return curve;
}

/// TE, then TM.
std::vector<ReflectionCurve> over_angle(const Shape& shape, const Electrics& medium) {
    ReflectionCurve te{.label = "TE, " + shape.label, .x = {}, .level_db = {}};
    ReflectionCurve tm{.label = "TM, " + shape.label, .x = {}, .level_db = {}};
    const Stack stack = shape.of(medium, middle_hz);
    for (int i = 0; i < 360; ++i) {
        const double incidence_deg = 0.25 * i;
        const Reflection r = stack_reflection(stack, std::cos(incidence_deg * pi / 180.0));
        for (ReflectionCurve* curve : {&te, &tm}) curve->x.push_back(incidence_deg);
        te.level_db.push_back(level_db(r.te));
        tm.level_db.push_back(level_db(r.tm));
    }
    return {te, tm};
}

std::vector<ReflectionCurve> head_on(const Material& material) {
    const auto any = [&](double f_hz) { return material.at(f_hz); };
    std::vector<ReflectionCurve> curves;
    if (!material.has_grain()) {
        curves.push_back(over_frequency({"half-space"}, any));
        if (material.is_metal()) return curves;  // no wave comes back from a sheet's other face
        for (const Shape& sheet :
             {Shape{"3 mm", 3.0_mm}, Shape{"5 mm", 5.0_mm}, Shape{"10 mm", 10.0_mm}})
            curves.push_back(over_frequency(sheet, any));
        return curves;
    }
    const auto along = [&](double f_hz) { return material.grained(f_hz).along; };
    const auto across = [&](double f_hz) { return material.grained(f_hz).across; };
    return {over_frequency({"half-space, along"}, along), over_frequency({"across"}, across),
            over_frequency({"10 mm, along", 10.0_mm}, along),
            over_frequency({"across", 10.0_mm}, across)};
}

std::string permittivity_text(const Electrics& medium) {
    return format("{:.4g} - j{:.3g}", medium.permittivity.real(), -medium.permittivity.imag());
}

std::string numbers_text(const Material& material) {
    if (const auto* metal = std::get_if<Conductive>(&material.dispersion))
        return format("{:.3g} S/m, \u03bc = {:.3g}, skin depth {:.2g} \u03bcm at 60 GHz",
                      metal->conductivity_s_m, metal->permeability,
                      SurfaceImpedance(*metal, middle_hz).skin_depth_m() * 1e6);
    if (!material.has_grain())
        return format("\u03b5 = {} at 60 GHz", permittivity_text(material.at(middle_hz)));
    const Grained grained = material.grained(middle_hz);
    return format("\u03b5 = {} along, {} across the grain at 60 GHz",
                  permittivity_text(grained.along), permittivity_text(grained.across));
}

}  // namespace

ReflectionCurves reflection_curves(const Material& material) {
    const Electrics medium = material.at(middle_hz);
    ReflectionCurves curves{
        .title = material.title,
        .second_line = format("{}; valid from {}; {}", numbers_text(material),
                              material.valid().text(), evidence_name(material.evidence)),
        .over_frequency = head_on(material),
        .over_angle = over_angle({"half-space"}, medium),
        .beside = {},
        .angle_title = "angle of incidence (degrees), 60 GHz",
        .brewster_deg = {},
        .valid = material.valid()};
    if (material.is_metal()) return curves;
    curves.beside = over_angle({"5 mm", 5.0_mm}, medium);
    curves.angle_title += "; dashed: 5 mm";
    if (material.has_grain()) curves.angle_title += "; mean \u03b5";
    if (medium.permittivity != 1.0)
        curves.brewster_deg = brewster_angle(medium).incidence_rad * 180.0 / pi;
    return curves;
}

}  // namespace specula
