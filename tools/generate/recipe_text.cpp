#include "tools/generate/recipe_text.hpp"

#include <map>
#include <set>
#include <sstream>

#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/dataset_layout.hpp"
#include "sim/dataset/sha256.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

/// Keys of the root that the settings above them say already, or that decide nothing.
const std::set<std::string> said_already{"title", "question", "seed", "worlds", "store"};

std::string key_of(const std::string& line) {
    return line.substr(0, line.find(" = "));
}

/// The text in quotes that is the value of a line; empty where it is no text.
std::string quoted_value(const std::string& line) {
    const auto begin = line.find(" = \"");
    return begin == std::string::npos || line.back() != '"'
               ? ""
               : line.substr(begin + 4, line.size() - begin - 5);
}

class RecipeLines {
  public:
    void add(const std::string& key, const std::string& value) {
        text_ += key + " = " + value + "\n";
    }
    void add_all(const std::string& prefix, const std::vector<std::string>& lines) {
        for (const std::string& line : lines) text_ += prefix + line + "\n";
    }
    /// The hash of a file that one of the lines names, if there is one of that name.
    void add_named_files(const std::string& prefix, const std::vector<std::string>& lines,
                         const fs::path& folder) {
        for (const std::string& line : lines) {
            const std::string name = quoted_value(line);
            if (name.find('.') != std::string::npos && fs::is_regular_file(folder / name))
                add(prefix + key_of(line) + ".sha256", sha256_of_file(folder / name));
        }
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// The materials that a class or backing names, and those they are made of.
void add_material(const std::string& name, const Catalogue& catalogue,
                  std::map<std::string, std::vector<std::string>>& lines) {
    if (!catalogue.materials.find(name) || lines.contains(name)) return;
    auto& own = lines[name] =
        Section::read(catalogue.root / "materials/library" / (name + ".toml")).value_lines();
    const std::vector<std::string> values = own;
    for (const std::string& line : values) add_material(quoted_value(line), catalogue, lines);
}

void add_materials(const Recipe& recipe, const Catalogue& catalogue, RecipeLines& out) {
    std::map<std::string, std::vector<std::string>> lines;
    for (const SampleLaw& law : recipe.population.classes) {
        add_material(law.nominal.material, catalogue, lines);
        add_material(law.nominal.backing, catalogue, lines);
    }
    for (const auto& [name, values] : lines) out.add_all("material." + name + ".", values);
}

}  // namespace

std::string recipe_text(const Recipe& recipe, const Section& experiment,
                        const Catalogue& catalogue) {
    RecipeLines out;
    out.add("software", std::string("specula ") + program_version);
    out.add("format_version", std::to_string(dataset_layout::format_version));
    out.add("seed", std::to_string(recipe.seed));
    out.add("worlds", std::to_string(recipe.worlds));
    out.add("condition", recipe.condition.name);
    out.add("store", format("{}{}{}", recipe.stored.adc ? " adc" : "",
                            recipe.stored.profiles ? " profiles" : "",
                            recipe.stored.features ? " features" : "")
                         .substr(1));
    std::vector<std::string> kept;
    for (const std::string& line : experiment.value_lines())
        if (!said_already.contains(key_of(line).substr(0, key_of(line).find('['))))
            kept.push_back(line);
    out.add_all("experiment.", kept);
    out.add_named_files("experiment.", kept, fs::path(experiment.file()).parent_path());
    const auto radar = Section::parse(recipe.radar.description, recipe.radar.name).value_lines();
    out.add_all("radar.", radar);
    out.add_named_files("radar.", radar, catalogue.root / "scenes/radars");
    add_materials(recipe, catalogue, out);
    return out.text();
}

std::string recipe_difference(const std::string& there, const std::string& here) {
    const auto values_of = [](const std::string& text) {
        std::map<std::string, std::string> values;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);)
            values[key_of(line)] = line.substr(std::min(line.size(), line.find(" = ") + 3));
        return values;
    };
    const auto theirs = values_of(there), ours = values_of(here);
    const auto shown = [](const auto& values, const std::string& key) {
        const auto found = values.find(key);
        return found == values.end() ? std::string("nothing") : found->second;
    };
    std::set<std::string> keys;
    for (const auto& [key, value] : theirs) keys.insert(key);
    for (const auto& [key, value] : ours) keys.insert(key);
    // What a user sets comes first: a run of another seed differs in nothing else.
    for (const std::string key : {"seed", "worlds", "condition", "store", "software"})
        if (shown(theirs, key) != shown(ours, key))
            return format("{} = {} there, {} here", key, shown(theirs, key), shown(ours, key));
    for (const std::string& key : keys)
        if (shown(theirs, key) != shown(ours, key))
            return format("{} = {} there, {} here", key, shown(theirs, key), shown(ours, key));
    return "";
}

}  // namespace specula
