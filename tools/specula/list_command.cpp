#include <cstdio>

#include "tools/specula/commands.hpp"

namespace specula {

namespace {

void list_materials(const Catalogue& catalogue) {
    constexpr double at_hz = 60e9;
    std::printf("%-14s %-34s %14s  %-14s\n", "name", "what", "eps_r, 60 GHz", "valid, GHz");
    for (const std::string& name : catalogue.materials.names()) {
        const Material& material = *catalogue.materials.find(name);
        const Complex eps = material.at(at_hz).permittivity;
        std::printf("%-14s %-34s %6.3g - j%-6.3g %g to %g\n", name.c_str(), material.title.c_str(),
                    eps.real(), -eps.imag(), material.valid_min_hz * 1e-9,
                    material.valid_max_hz * 1e-9);
    }
}

void list_radars(const Catalogue& catalogue) {
    for (const std::string& name : catalogue.radar_names()) {
        const Radar radar = read_radar(catalogue.root / "scenes/radars" / (name + ".toml"));
        std::printf("%-16s %s\n", name.c_str(), radar.title.c_str());
    }
}

void list_experiments(const Catalogue& catalogue) {
    for (const std::string& name : catalogue.experiment_names()) {
        Section section = Section::read(catalogue.experiment_file(name));
        std::printf("%-16s %s\n", name.c_str(), section.text("title").c_str());
    }
}

}  // namespace

void list_command(const std::string& what, const Catalogue& catalogue) {
    if (what == "materials") list_materials(catalogue);
    if (what == "radars") list_radars(catalogue);
    if (what == "experiments") list_experiments(catalogue);
}

}  // namespace specula
