#include "materials/transmission.hpp"
#include "sim/core/error.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

std::vector<Quantity> slab_point(const CasePoint& point) {
    const Stack slab = slab_of(point.inp);
    const double cosine = cos_incidence_of(point.inp);
    const Reflection r = stack_reflection(slab, cosine);
    const Transmission t = stack_transmission(slab, cosine);
    Comparison compare(point);
    compare.absolute("r_TE", r.te, "abs");
    compare.absolute("r_TM", r.tm, "abs");
    compare.absolute("t_TE", t.te, "abs");
    compare.absolute("t_TM", t.tm, "abs");
    return compare.finish();
}

std::vector<Quantity> stack_point(const CasePoint& point) {
    const auto permittivity = point.inp.complexes("eps_layers");
    const auto thickness_m = point.inp.numbers("d_m", Range::above(0.0));
    if (permittivity.size() != thickness_m.size())
        point.inp.fail("d_m", "not as long as eps_layers", "give one thickness for each layer");
    Stack stack{.backing = backing_of(point.inp, "substrate"),
                .frequency_hz = frequency_of(point.inp)};
    for (std::size_t i = 0; i < permittivity.size(); ++i) {
        if (permittivity[i].imag() > 0.0 || permittivity[i] == 0.0)
            point.inp.fail("eps_layers", "no passive medium", "give eps' - j eps''");
        stack.layers.push_back(
            {.medium = {.permittivity = permittivity[i]}, .thickness_m = thickness_m[i]});
    }
    const double cosine = cos_incidence_of(point.inp);
    const Reflection r = stack_reflection(stack, cosine);
    const Transmission t = stack_transmission(stack, cosine);
    Comparison compare(point);
    compare.absolute("r_TE", r.te, "abs");
    compare.absolute("r_TM", r.tm, "abs");
    compare.absolute("t_TE", t.te, "abs");
    compare.absolute("t_TM", t.tm, "abs");
    return compare.finish();
}

std::vector<Quantity> energy_point(const CasePoint& point) {
    point.inp.describe({"kind"});
    const StackPower power = stack_power(slab_of(point.inp), cos_incidence_of(point.inp));
    Comparison compare(point);
    compare.absolute("R_TE", power.te.reflected, "abs");
    compare.absolute("T_TE", power.te.transmitted, "abs");
    compare.absolute("A_TE", power.te.absorbed, "abs");
    compare.absolute("R_TM", power.tm.reflected, "abs");
    compare.absolute("T_TM", power.tm.transmitted, "abs");
    compare.absolute("A_TM", power.tm.absorbed, "abs");
    return compare.finish();
}

}  // namespace specula
