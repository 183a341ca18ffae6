#include "materials/stack.hpp"
#include "sim/core/constants.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/formulas/infinite_plane.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

struct WholePlane {
    Stack stack;             ///< as the simulator takes it
    DipoleOverPlane dipole;  ///< as the spectral integral takes it
};

/// `eps` alone is a half-space; with `d_m` a slab, in air unless `substrate` says otherwise;
/// neither is a perfect conductor, which `surface` must then name.
WholePlane plane_of(const Fields& inp) {
    const double frequency_hz = frequency_of(inp);
    const double least_m = 0.1 * speed_of_light_m_s / frequency_hz;
    WholePlane surface{.stack = {.frequency_hz = frequency_hz},
                       .dipole = {.frequency_hz = frequency_hz,
                                  .height_m = inp.number("H_m", Range::at_least(least_m)),
                                  .layers = {},
                                  .backing = std::nullopt}};
    const std::string name = lower_case(inp.text("surface"));
    if (!inp.has("eps")) {
        if (name.find("pec") == std::string::npos)
            throw NotComputable("does not know the surface \"" + name + "\" without eps");
        surface.stack.backing = PerfectConductor{};
        return surface;
    }
    const Complex permittivity = inp.permittivity("eps");
    Backing backing = HalfSpace{.medium = {.permittivity = permittivity}};
    if (inp.has("d_m")) {
        const double thickness_m = inp.number("d_m", Range::above(0.0));
        surface.stack.layers = {
            {.medium = {.permittivity = permittivity}, .thickness_m = thickness_m}};
        surface.dipole.layers = {{.permittivity = permittivity, .thickness_m = thickness_m}};
        backing = inp.has("substrate") ? backing_of(inp, "substrate") : Backing{HalfSpace{}};
    }
    surface.stack.backing = backing;
    if (const auto* half_space = std::get_if<HalfSpace>(&backing))
        surface.dipole.backing = half_space->medium.permittivity;
    return surface;
}

}  // namespace

std::vector<Quantity> infinite_plane_point(const CasePoint& point) {
    const WholePlane surface = plane_of(point.inp);
    const Complex image = image_source({.frequency_hz = surface.dipole.frequency_hz,
                                        .height_m = surface.dipole.height_m,
                                        .gain = point.inp.number_or("G", 1.0, Range::above(0.0)),
                                        .reflection = stack_reflection(surface.stack, 1.0).te});
    Comparison compare(point);
    compare.channel("image_source.", image);
    compare.channel("image_source_with_slab_r0.", image);
    compare.channel("exact_dipole_over_G.", dipole_over_plane(surface.dipole));
    return compare.finish();
}

}  // namespace specula
