#include "scenes/catalogue.hpp"

#include <algorithm>

#include "scenes/ti_config.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> stems(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_description(entry.path())) names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> stems_if_there(const fs::path& folder) {
    return fs::is_directory(folder) ? stems(folder) : std::vector<std::string>{};
}

}  // namespace

Catalogue Catalogue::open(const fs::path& root) {
    for (const char* part : {"materials/library", "scenes/radars", "scenes/experiments"})
        if (!fs::is_directory(root / part))
            throw InputError((root / part).string() +
                             ": no such folder; set SPECULA_HOME to the folder that holds it");
    return {root, Library(root / "materials/library")};
}

std::vector<std::string> Catalogue::radar_names() const {
    return stems(root / "scenes/radars");
}

std::vector<std::string> Catalogue::experiment_names() const {
    return stems(root / "scenes/experiments");
}

fs::path Catalogue::experiment_file(const std::string& name) const {
    return root / "scenes/experiments" / (name + ".toml");
}

std::vector<std::string> Catalogue::dataset_names() const {
    return stems_if_there(root / "scenes/datasets");
}

fs::path Catalogue::dataset_file(const std::string& name) const {
    return root / "scenes/datasets" / (name + ".toml");
}

std::vector<std::string> Catalogue::sweep_names() const {
    return stems_if_there(root / "scenes/sweeps");
}

fs::path Catalogue::sweep_file(const std::string& name) const {
    return root / "scenes/sweeps" / (name + ".toml");
}

Radar Catalogue::radar(Section& section, const std::string& key) const {
    const std::string name = section.text(key);
    if (fs::path(name).extension() == ".toml" || is_ti_config(name)) {
        const fs::path file = fs::path(section.file()).parent_path() / name;
        if (!fs::exists(file))
            section.fail(key, "no such file beside this one", "give a path relative to this file");
        return radar_of_file(file);
    }
    const auto known = radar_names();
    section.choice(key, known);
    return read_radar(root / "scenes/radars" / (name + ".toml"));
}

Radar Catalogue::radar_of_file(const fs::path& file) const {
    return is_ti_config(file) ? read_ti_config(file, root / "scenes/radars/iwrl6432boost.toml")
                              : read_radar(file);
}

Radar Catalogue::radar_called(const std::string& name) const {
    const fs::path file = name;
    if (file.extension() == ".toml" || is_ti_config(file)) return radar_of_file(file);
    const auto known = radar_names();
    if (std::find(known.begin(), known.end(), name) != known.end())
        return read_radar(root / "scenes/radars" / (name + ".toml"));
    const std::string near = nearest_word(name, known);
    throw InputError(format("radar = \"{}\": is not known; {}", name,
                            near.empty() ? "see specula list radars, or name a .toml or .cfg file"
                                         : "did you mean \"" + near + "\"?"));
}

std::string Catalogue::material_name(Section& section, const std::string& key) const {
    return section.choice(key, materials.names());
}

std::string Catalogue::backing_name(Section& section, const std::string& key) const {
    std::vector<std::string> options{"air", "metal"};
    for (const auto& name : materials.names())
        if (name != "air") options.push_back(name);
    return section.choice(key, options, "air");
}

}  // namespace specula
