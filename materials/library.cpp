#include "materials/library.hpp"

#include <algorithm>
#include <set>

#include "sim/core/error.hpp"

namespace specula {

namespace {

using Shelf = std::map<std::string, std::shared_ptr<const Material>>;

/// Reads the files of a folder in the order in which they need each other.
class Reader {
  public:
    Reader(const std::filesystem::path& folder, Shelf& shelf) : folder_(folder), shelf_(shelf) {
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (is_description(entry.path())) names_.insert(entry.path().stem().string());
    }

    void read_all() {
        for (const std::string& name : names_) read(name);
    }

  private:
    std::shared_ptr<const Material> read(const std::string& name) {
        if (const auto known = shelf_.find(name); known != shelf_.end()) return known->second;
        being_read_.push_back(name);
        auto material = std::make_shared<const Material>(read_material(
            folder_ / (name + ".toml"),
            [this](Section& section, const std::string& key) { return part(section, key); }));
        being_read_.pop_back();
        return shelf_.emplace(name, std::move(material)).first->second;
    }

    std::shared_ptr<const Material> part(Section& section, const std::string& key) {
        const std::string name = section.choice(key, {names_.begin(), names_.end()});
        const auto above = std::find(being_read_.begin(), being_read_.end(), name);
        if (above != being_read_.end()) {
            std::string circle;
            for (auto each = above; each != being_read_.end(); ++each) circle += *each + " -> ";
            section.fail(key, "makes the material a part of itself: " + circle + name,
                         "name one that does not contain this one");
        }
        return read(name);
    }

    std::filesystem::path folder_;
    Shelf& shelf_;
    std::set<std::string> names_;
    std::vector<std::string> being_read_;  ///< each is a part of the one before
};

}  // namespace

Library::Library(const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder))
        throw InputError(folder.string() + ": no such folder of materials; check SPECULA_HOME");
    Reader(folder, materials_).read_all();
}

const Material* Library::find(const std::string& name) const {
    const auto found = materials_.find(name);
    return found == materials_.end() ? nullptr : found->second.get();
}

std::vector<std::string> Library::names() const {
    std::vector<std::string> names;
    for (const auto& [name, material] : materials_) names.push_back(name);
    return names;
}

MaterialLookup Library::lookup() const {
    return [this](Section& section, const std::string& key) {
        return materials_.at(section.choice(key, names()));
    };
}

}  // namespace specula
