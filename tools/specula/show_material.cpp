#include "tools/specula/show_material.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "materials/brewster.hpp"
#include "materials/stack.hpp"
#include "materials/surface_impedance.hpp"
#include "materials/validity.hpp"
#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"
#include "tools/report/reflection_curves.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/specula/output_place.hpp"

namespace specula {

namespace {

constexpr double usual_hz = 60e9;
constexpr FrequencyBand radar_band{57e9, 64e9};

double level_db(Complex value) {
    constexpr double nothing = 1e-10;  // air in air: told as -200 dB
    return 20.0 * std::log10(std::max(std::abs(value), nothing));
}

std::string text_of(const Electrics& medium) {
    return format("{:.4g} - j{:.3g}", medium.permittivity.real(), -medium.permittivity.imag());
}

void show_origin(const Material& material) {
    std::printf("%s: %s\n", material.name.c_str(), material.title.c_str());
    std::printf("%s: %s\nvalid from %s\n", std::string(evidence_name(material.evidence)).c_str(),
                material.source.c_str(), material.valid().text().c_str());
    for (const NumberOrigin& number : material.numbers)
        std::printf("  %s, %s: %s\n", number.key.c_str(),
                    std::string(evidence_name(number.evidence)).c_str(), number.source.c_str());
    for (const Ingredient& part : material.ingredients())
        if (!part.material->name.empty())
            std::printf("contains %s: %s\n", part.material->name.c_str(),
                        part.material->title.c_str());
    for (const BandWarning& warning : band_warnings(material, radar_band))
        std::printf("extrapolated: %s\n", warning.text().c_str());
}

void show_at_60_ghz(const Material& material) {
    const Electrics medium = material.at(usual_hz);
    std::printf("\nat 60 GHz\n");
    if (const auto* metal = std::get_if<Conductive>(&material.dispersion)) {
        const SurfaceImpedance impedance(*metal, usual_hz);
        std::printf("  skin depth           %.3g um\n", impedance.skin_depth_m() * 1e6);
        std::printf("  surface resistance   %.3g ohm\n", impedance.resistance_ohm());
        return;
    }
    if (material.has_grain()) {
        const Grained grained = material.grained(usual_hz);
        std::printf("  eps_r along grain    %s\n  eps_r across grain   %s\n",
                    text_of(grained.along).c_str(), text_of(grained.across).c_str());
    }
    std::printf("  loss tangent         %.3g\n",
                -medium.permittivity.imag() / medium.permittivity.real());
    if (medium.permittivity.imag() < 0.0)
        std::printf("  field falls to 1/e   within %.3g mm\n",
                    penetration_depth_m(medium, usual_hz) * 1e3);
    if (medium.permittivity != 1.0)
        std::printf("  Brewster angle       %.1f deg\n",
                    brewster_angle(medium).incidence_rad * 180.0 / pi);
}

void show_levels(const Material& material) {
    const int digits = material.is_metal() ? 4 : 2;  // metals differ in the third
    std::printf("\nhead-on, over a mirror\n%8s %22s %18s %18s\n", "GHz", "eps_r", "half-space, dB",
                "slab 5 mm, dB");
    for (int ghz = 57; ghz <= 64; ++ghz) {
        const double f_hz = ghz * 1e9;
        const Electrics medium = material.at(f_hz);
        const Stack half{{}, HalfSpace{medium}, f_hz};
        const Stack slab{{{.medium = medium, .thickness_m = 0.005}}, HalfSpace{}, f_hz};
        std::printf("%8d %22s %18.*f %18.*f%s\n", ghz, text_of(medium).c_str(), digits,
                    level_db(stack_reflection(half, 1.0).te), digits,
                    level_db(stack_reflection(slab, 1.0).te),
                    material.valid_at(f_hz) ? "" : "  extrapolated");
    }
}

void show_angles(const Material& material) {
    const int digits = material.is_metal() ? 4 : 2;
    const Electrics medium = material.at(usual_hz);
    const Stack half{{}, HalfSpace{medium}, usual_hz};
    const Stack slab{{{.medium = medium, .thickness_m = 0.005}}, HalfSpace{}, usual_hz};
    std::printf("\nat 60 GHz, over a mirror, dB\n%8s %14s %14s %14s %14s\n", "deg", "half-space TE",
                "TM", "slab 5 mm TE", "TM");
    for (const int incidence_deg : {0, 10, 20, 30, 45, 60, 75, 85}) {
        const double cosine = std::cos(incidence_deg * pi / 180.0);
        const Reflection a = stack_reflection(half, cosine), b = stack_reflection(slab, cosine);
        std::printf("%8d %14.*f %14.*f %14.*f %14.*f\n", incidence_deg, digits, level_db(a.te),
                    digits, level_db(a.tm), digits, level_db(b.te), digits, level_db(b.tm));
    }
}

/// A file stem from a name that came from the user's own file.
std::string figure_name(const std::string& material) {
    std::string name = "reflection_" + material;
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return !std::isalnum(c) && c != '_' && c != '-'; }, '_');
    return name;
}

}  // namespace

void show_material(const Material& material, const std::filesystem::path& figure_folder) {
    check_figure_place(figure_folder, {});
    show_origin(material);
    show_at_60_ghz(material);
    show_levels(material);
    show_angles(material);
    if (figure_folder.empty()) {
        std::printf("\n--figure FOLDER draws this over all frequencies and angles\n");
        return;
    }
    const std::string name = figure_name(material.name);
    write_figure(figure_folder, reflection_figure(name, reflection_curves(material)));
    std::printf("\nWrote %s.svg, .png and .csv\n", (figure_folder / name).c_str());
}

}  // namespace specula
