#include <cmath>
#include <map>

#include "materials/mixing.hpp"
#include "materials/models/conductive.hpp"
#include "materials/models/power_law.hpp"
#include "materials/models/water.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// Rows of ITU-R P.2040-3, table 3, that are no files of the materials library: a metal without a
/// name, and what is given for other bands.
const std::map<std::string, PowerLaw> other_rows{
    {"metal", {.a = 1.0, .b = 0.0, .c = 1e7, .d = 0.0}},
    {"glass_high", {.a = 5.79, .b = 0.0, .c = 0.0004, .d = 1.658}},
    {"ceiling_board_high", {.a = 1.52, .b = 0.0, .c = 0.0029, .d = 1.029}},
    {"very_dry_ground", {.a = 3.0, .b = 0.0, .c = 0.00015, .d = 2.52}},
    {"medium_dry_ground", {.a = 15.0, .b = -0.1, .c = 0.035, .d = 1.63}},
    {"wet_ground", {.a = 30.0, .b = -0.4, .c = 0.15, .d = 1.30}},
};

double conductivity_s_m(const Electrics& medium, double frequency_hz) {
    return -medium.permittivity.imag() * two_pi * frequency_hz * vacuum_permittivity_f_m;
}

std::vector<Quantity> medium_point(const CasePoint& point, const Electrics& medium,
                                   double frequency_hz) {
    const Complex permittivity = medium.permittivity;
    Comparison compare(point);
    compare.relative("eps", permittivity, "rel");
    compare.relative("eps_r", permittivity.real(), "rel");
    compare.relative("sigma_S_per_m", conductivity_s_m(medium, frequency_hz), "rel");
    compare.relative("loss_tangent", -permittivity.imag() / permittivity.real(), "rel");
    return compare.finish();
}

std::string with_underscores(std::string name) {
    for (char& c : name)
        if (c == ' ' || c == '-') c = '_';
    return name;
}

}  // namespace

std::vector<Quantity> building_material_point(const CasePoint& point) {
    const std::string name = with_underscores(lower_case(point.inp.text("material")));
    const double frequency_hz = frequency_of(point.inp);
    if (const Material* material = point.materials.find(name))
        return medium_point(point, material->at(frequency_hz), frequency_hz);
    const auto row = other_rows.find(name);
    if (row == other_rows.end())
        throw NotComputable(format("does not know the material \"{}\"", name));
    return medium_point(point, row->second.at(frequency_hz), frequency_hz);
}

std::vector<Quantity> relaxation_point(const CasePoint& point) {
    point.inp.describe({"model"});
    const std::string name = with_underscores(lower_case(point.inp.text("medium")));
    const double frequency_hz = frequency_of(point.inp);
    if (name == "water") {
        const double celsius = point.inp.number("T_C", Range::between(-100.0, 300.0));
        return medium_point(point, Water{.temperature_k = 273.15 + celsius}.at(frequency_hz),
                            frequency_hz);
    }
    const Material* material = point.materials.find(name);
    if (material == nullptr) throw NotComputable(format("does not know the medium \"{}\"", name));
    return medium_point(point, material->at(frequency_hz), frequency_hz);
}

std::vector<Quantity> mixing_point(const CasePoint& point) {
    point.inp.describe({"inclusion", "host", "f_hz", "T_C"});
    const char* fraction = point.inp.has("v") ? "v" : "porosity";
    const Mix mix{.host = point.inp.permittivity("host_eps"),
                  .inclusion = point.inp.permittivity(point.inp.has("water_eps") ? "water_eps"
                                                                                 : "inclusion_eps"),
                  .inclusion_fraction = point.inp.number(fraction, Range::between(0.0, 1.0))};
    Comparison compare(point);
    compare.relative("looyenga", mixed_permittivity(MixingLaw::looyenga, mix), "rel");
    compare.relative("maxwell_garnett", mixed_permittivity(MixingLaw::maxwell_garnett, mix), "rel");
    compare.relative("bruggeman", mixed_permittivity(MixingLaw::bruggeman, mix), "rel");
    compare.relative("lichtenecker", mixed_permittivity(MixingLaw::lichtenecker, mix), "rel");
    return compare.finish();
}

}  // namespace specula
