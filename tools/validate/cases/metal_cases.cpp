#include "materials/stack.hpp"
#include "materials/surface_impedance.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/compare.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

Stack bare(const Conductive& metal, double frequency_hz) {
    return {.backing = HalfSpace{.medium = metal.at(frequency_hz)}, .frequency_hz = frequency_hz};
}

std::vector<Quantity> bare_point(const CasePoint& point) {
    point.inp.describe({"metal"});
    const Conductive metal{.conductivity_s_m = point.inp.number("sigma", Range::above(0.0)),
                           .permeability = point.inp.number_or("mu_r", 1.0, Range::above(0.0))};
    const double frequency_hz = frequency_of(point.inp);
    const double cosine = cos_incidence_of(point.inp);
    const Reflection exact = stack_reflection(bare(metal, frequency_hz), cosine);
    const SurfaceImpedance surface(metal, frequency_hz);
    const Reflection leontovich = surface.reflection(cosine);
    Comparison compare(point);
    compare.level("R_TE_dB", level_db(exact.te), "R_dB");
    compare.level("R_TM_dB", level_db(exact.tm), "R_dB");
    compare.level("R_TE_leontovich_dB", level_db(leontovich.te), "R_dB");
    compare.level("R_TM_leontovich_dB", level_db(leontovich.tm), "R_dB");
    compare.relative("skin_depth_m", surface.skin_depth_m(), "skin_depth_rel");
    compare.relative("Rs_ohm", surface.resistance_ohm(), "skin_depth_rel");
    return compare.finish();
}

std::vector<Quantity> film_point(const CasePoint& point) {
    point.inp.describe({"film", "metal"});
    const double frequency_hz = frequency_of(point.inp);
    const Conductive metal{
        .conductivity_s_m = point.inp.number_of({"metal_sigma", "sigma"}, Range::above(0.0)),
        .permeability = point.inp.number_or(point.inp.has("mu_r") ? "mu_r" : "metal_mu_r", 1.0,
                                            Range::above(0.0))};
    Stack stack = bare(metal, frequency_hz);
    const double cosine = cos_incidence_of(point.inp);
    const Reflection naked = stack_reflection(stack, cosine);
    stack.layers = slab_of(point.inp).layers;
    const Reflection r = stack_reflection(stack, cosine);
    Comparison compare(point);
    compare.absolute("r_TE", r.te, "r_abs");
    compare.absolute("r_TM", r.tm, "r_abs");
    compare.level("R_dB", level_db(r.te), "R_dB");
    compare.level("R_TE_dB", level_db(r.te), "R_dB");
    compare.level("R_TM_dB", level_db(r.tm), "R_dB");
    compare.level("R_bare_dB", level_db(naked.te), "R_dB");
    return compare.finish();
}

}  // namespace

std::vector<Quantity> metal_point(const CasePoint& point) {
    return point.inp.has("eps") ? film_point(point) : bare_point(point);
}

}  // namespace specula
