#include "materials/library.hpp"

#include <algorithm>
#include <cmath>

#include "materials/stack.hpp"
#include "sim/core/literals.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_library.hpp"

namespace specula {
namespace {

using namespace literals;

TEST_CASE("every material of the library says where its numbers are from and where they hold",
          "[library]") {
    CHECK(library().names().size() >= 5);
    for (const std::string& name : library().names()) {
        INFO(name);
        const Material& material = *library().find(name);
        CHECK(material.name == name);
        CHECK_FALSE(material.title.empty());
        CHECK(material.source.size() >= 20);
        CHECK(material.valid_min_hz >= 0.0);
        CHECK(material.valid_min_hz < material.valid_max_hz);
    }
}

TEST_CASE("no material of the library gives power back", "[library]") {
    for (const std::string& name : library().names()) {
        INFO(name);
        const Material& material = *library().find(name);
        double most = 0.0;
        bool decays = true;
        for (double f_hz = 57.0_GHz; f_hz <= 64.0_GHz; f_hz += 1.0_GHz) {
            const Electrics medium = material.at(f_hz);
            decays = decays && medium.permittivity.imag() <= 0.0 && medium.permeability >= 1.0;
            const Stack slab{.layers = {{.medium = medium, .thickness_m = 5.0_mm}},
                             .frequency_hz = f_hz};
            for (int theta_deg = 0; theta_deg <= 80; theta_deg += 5) {
                const Reflection r = stack_reflection(slab, std::cos(theta_deg * 1.0_deg));
                most = std::max({most, std::abs(r.te), std::abs(r.tm)});
            }
        }
        CHECK(decays);
        CHECK(most <= 1.0 + 1e-14);  // rounding of a metal's, which is 1 - 1e-3
    }
}

TEST_CASE("a name that the library lacks is found nowhere", "[library]") {
    CHECK(library().find("unobtainium") == nullptr);
    CHECK(library().find("") == nullptr);
    const auto names = library().names();
    CHECK(std::is_sorted(names.begin(), names.end()));
}

TEST_CASE("a library reads the .toml files of its folder and refuses a wrong one", "[library]") {
    const MadeUpFolder folder;
    const std::string text = project_file("materials/library/plexiglass.toml");
    folder.with("mine.toml", text);
    folder.with("notes.md", "no material");
    std::filesystem::create_symlink("someone@somewhere.1", folder / ".#mine.toml");  // an editor's
    CHECK(Library(folder.path()).names() == std::vector<std::string>{"mine"});
    folder.with("broken.toml", "title = 3\n");
    CHECK(message_of([&] { return Library(folder.path()); }) ==
          (folder / "broken.toml").string() + ":1: title = 3: is not text; put it in quotes");
    CHECK(message_of([&] { return Library(folder / "none"); }) ==
          (folder / "none").string() + ": no such folder of materials; check SPECULA_HOME");
}

}  // namespace
}  // namespace specula
