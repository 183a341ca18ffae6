#include "materials/library.hpp"

#include "sim/core/error.hpp"

namespace specula {

Library::Library(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder))
        throw InputError(folder.string() + ": no such folder of materials; check SPECULA_HOME");
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        Material material = read_material(entry.path());
        materials_.emplace(material.name, std::move(material));
    }
}

const Material* Library::find(const std::string& name) const {
    const auto found = materials_.find(name);
    return found == materials_.end() ? nullptr : &found->second;
}

std::vector<std::string> Library::names() const {
    std::vector<std::string> names;
    for (const auto& [name, material] : materials_) names.push_back(name);
    return names;
}

}  // namespace specula
