#include <cctype>
#include <map>

#include "tests/check.hpp"
#include "tests/house/source_tree.hpp"
#include "tests/made_up_folder.hpp"

// Equations and code meet: what the code cites as PHYSICS.md#label stands there as "### label", and
// every label there is cited by the code that implements it.

namespace specula {
namespace {

/// Labels and the line that each stands on.
std::map<std::string, std::size_t> labels_of(const std::string& text) {
    std::map<std::string, std::size_t> labels;
    std::istringstream lines(text);
    std::string line;
    for (std::size_t n = 1; std::getline(lines, line); ++n)
        if (line.rfind("### ", 0) == 0) labels.emplace(line.substr(4), n);
    return labels;
}

std::string word_at(const std::string& line, std::size_t begin) {
    std::size_t end = begin;
    while (end < line.size() &&
           (std::isalnum(static_cast<unsigned char>(line[end])) || line[end] == '-'))
        ++end;
    return line.substr(begin, end - begin);
}

/// "PHYSICS.md#stack, #grain" cites two labels.
std::vector<std::string> cited_in(const std::string& line) {
    std::vector<std::string> cited;
    for (auto at = line.find("PHYSICS.md#"); at != line.npos; at = line.find("PHYSICS.md#", at)) {
        at += 10;
        while (at < line.size() && line[at] == '#') {
            cited.push_back(word_at(line, at + 1));
            at += 1 + cited.back().size();
            if (line.compare(at, 3, ", #") == 0) at += 2;
        }
    }
    return cited;
}

Breaches unmet(const SourceTree& tree, const std::string& physics) {
    Breaches breaches;
    const auto labels = labels_of(physics);
    std::set<std::string> cited;
    for (const auto& file : tree.files()) {
        if (file.path.rfind("tests/", 0) == 0) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i)
            for (const auto& label : cited_in(file.lines[i])) {
                cited.insert(label);
                if (labels.count(label) == 0)
                    breaches.push_back(
                        breach(file.path, i + 1, "cites #" + label + ", which PHYSICS.md has not"));
            }
    }
    for (const auto& [label, line] : labels)
        if (cited.count(label) == 0)
            breaches.push_back(
                breach("sim/PHYSICS.md", line, "#" + label + " is cited by no code"));
    return breaches;
}

TEST_CASE("every equation cited is there, and every one there is cited", "[house]") {
    const auto breaches = unmet(SourceTree(SPECULA_SOURCE_DIR), project_file("sim/PHYSICS.md"));
    INFO(one_per_line(breaches));
    CHECK(breaches.empty());
}

TEST_CASE("a label without code, and a citation without a label, are found", "[house]") {
    MadeUpTree made_up;
    made_up.with("sim/a.hpp",
                 "/// @eq PHYSICS.md#known, #other; A. Author\n"
                 "/// see PHYSICS.md#missing.\n");
    const Breaches breaches =
        unmet(made_up.read(), "# Physics\n\n### known\ntext\n### other\n### lonely\n");
    CHECK(breaches == Breaches{"sim/a.hpp:2: cites #missing, which PHYSICS.md has not",
                               "sim/PHYSICS.md:6: #lonely is cited by no code"});
}

}  // namespace
}  // namespace specula
