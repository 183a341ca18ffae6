#include <cmath>
#include <cstdio>

#include "materials/validity.hpp"
#include "tools/specula/commands.hpp"

namespace specula {

namespace {

constexpr const char* name_and_title = "%-18s %s\n";

constexpr FrequencyBand usual_band{60e9, 60e9};

/// Names stand at the beginning of their line, group names do not: completion goes by that.
void list_material(const Material& material) {
    const Complex eps = material.at(usual_band.min_hz).permittivity;
    std::printf("%-18s %-46s ", material.name.c_str(), material.title.c_str());
    if (const auto* metal = std::get_if<Conductive>(&material.dispersion))
        std::printf("%13.3g MS/m %8s", metal->conductivity_s_m * 1e-6, "");
    else
        std::printf("%8.3g - j%-7.2g %8.2g", eps.real(), std::abs(eps.imag()),
                    std::abs(eps.imag()) / eps.real());
    std::printf("  %5g to %-5g %s%s\n", material.valid_min_hz * 1e-9, material.valid_max_hz * 1e-9,
                std::string(evidence_name(material.evidence)).c_str(),
                band_warnings(material, usual_band).empty() ? "" : ", extrapolated at 60 GHz");
}

void list_materials(const Catalogue& catalogue) {
    std::printf("%-18s %-46s %18s %8s  %-14s %s\n", "name", "title", "eps_r at 60 GHz", "tan d",
                "valid, GHz", "numbers from");
    for (const std::string& group : material_groups()) {
        std::printf("\n  %s\n", group.c_str());
        for (const std::string& name : catalogue.materials.names())
            if (const Material& material = *catalogue.materials.find(name); material.group == group)
                list_material(material);
    }
}

void list_radars(const Catalogue& catalogue) {
    std::printf(name_and_title, "name", "title");
    for (const std::string& name : catalogue.radar_names()) {
        const Radar radar = read_radar(catalogue.root / "scenes/radars" / (name + ".toml"));
        std::printf(name_and_title, name.c_str(), radar.title.c_str());
    }
}

void list_experiments(const Catalogue& catalogue) {
    std::printf(name_and_title, "name", "title");
    for (const std::string& name : catalogue.experiment_names()) {
        Section section = Section::read(catalogue.experiment_file(name));
        std::printf(name_and_title, name.c_str(), section.text("title").c_str());
    }
}

void list_datasets(const Catalogue& catalogue) {
    std::printf(name_and_title, "name", "title");
    for (const std::string& name : catalogue.dataset_names()) {
        Section section = Section::read(catalogue.dataset_file(name));
        std::printf(name_and_title, name.c_str(), section.text("title").c_str());
    }
}

void list_sweeps(const Catalogue& catalogue) {
    std::printf(name_and_title, "name", "title");
    for (const std::string& name : catalogue.sweep_names()) {
        Section section = Section::read(catalogue.sweep_file(name));
        std::printf(name_and_title, name.c_str(), section.text("title").c_str());
    }
}

}  // namespace

void list_command(const std::string& what, const Catalogue& catalogue) {
    if (what == "materials") list_materials(catalogue);
    if (what == "radars") list_radars(catalogue);
    if (what == "experiments") list_experiments(catalogue);
    if (what == "datasets") list_datasets(catalogue);
    if (what == "sweeps") list_sweeps(catalogue);
}

}  // namespace specula
