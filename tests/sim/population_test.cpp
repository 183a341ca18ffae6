#include "sim/population.hpp"

#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"

namespace specula {
namespace {

const std::string two_classes = R"([sample]
size_mm = [200, 100]
backing = "metal"

[[class]]
name = "sheet"
material = "plexiglass"
thickness_mm = { factor = [5.0, 1.04] }
bow_mm = { uniform = [-0.5, 0.5] }
permittivity_factor = { normal = [1.0, 0.01] }

[[class]]
name = "board"
material = "wood"
thickness_mm = 18
)";
const std::string laws = R"(
[session]
height_mm = { normal = [0.0, 2.0] }
leakage_phase_deg = { normal = [0.0, 5.0] }

[frame]
displacement_um = { normal = [0.0, 35.0] }
)";

Population population_in(const std::string& text) {
    Section section = Section::parse(text, "p.toml");
    const Population population = read_population(section, catalogue());
    section.finish();
    return population;
}

std::string population_refusal(const std::string& text) {
    return message_of([&] { return population_in(text); });
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    return text.replace(text.find(what), what.size(), by);
}

TEST_CASE("classes keep their order, their laws and what they have in common", "[sim]") {
    const Population population = population_in(two_classes + laws);
    CHECK(population.class_names() == std::vector<std::string>{"sheet", "board"});
    const SampleLaw& sheet = population.classes[0];
    CHECK(sheet.nominal.material == "plexiglass");
    CHECK(sheet.nominal.backing == "metal");
    CHECK(sheet.nominal.face.size_x_m == Approx(0.2));
    CHECK(sheet.nominal.face.size_y_m == Approx(0.1));
    CHECK(sheet.thickness_m.median() == Approx(0.005));
    CHECK(sheet.thickness_m.spread() == Approx(std::log(1.04)));
    CHECK(sheet.bow_m.spread() == Approx(1e-3 / std::sqrt(12.0)));
    CHECK(sheet.permittivity_factor.spread() == Approx(0.01));
    CHECK(population.classes[1].thickness_m.median() == Approx(0.018));
}

TEST_CASE("a law that is not given is the nominal value alone", "[sim]") {
    const Population population = population_in(two_classes + laws);
    const SampleLaw& board = population.classes[1];
    CHECK(board.bow_m.spread() == 0.0);
    CHECK(board.bow_m.median() == 0.0);
    CHECK(board.roughness_m.median() == 0.0);
    CHECK(board.permittivity_factor.median() == 1.0);
    CHECK(board.loss_factor.median() == 1.0);
    CHECK(population.session.height_m.spread() == Approx(0.002));
    CHECK(population.session.leakage_rad.spread() == Approx(5.0 * 3.14159265358979 / 180.0));
    CHECK(population.session.tilt_rad.spread() == 0.0);
    CHECK(population.frame.displacement_m.spread() == Approx(35e-6));
    CHECK(population.world_clutter.points == 0);
    CHECK(population.session_clutter.points == 0);
}

TEST_CASE("heights of a class have a law of their correlation", "[sim]") {
    const std::string text = replaced(two_classes, "thickness_mm = 18",
                                      "thickness_mm = 18\n"
                                      "correlation_length_mm = { factor = [2.0, 1.5] }");
    const Population population = population_in(text + laws);
    CHECK(population.classes[0].correlation_m.median() == SampleLayer::usual_correlation_m);
    CHECK(population.classes[1].correlation_m.median() == Approx(0.002));
    CHECK(population.classes[1].correlation_m.spread() == Approx(std::log(1.5)));
}

TEST_CASE("the room's two laws are told apart", "[sim]") {
    const Population population = population_in(
        two_classes + laws +
        "[world_clutter]\npoints = 6\nlevel_db = -45\nrange_mm = { uniform = [250, 2000] }\n"
        "[session_clutter]\npoints = 3\nlevel_db = -50\nrange_mm = 700\n");
    CHECK(population.world_clutter.points == 6);
    CHECK(population.world_clutter.level_db == -45.0);
    CHECK(population.world_clutter.range_m.median() == Approx(1.125));
    CHECK(population.session_clutter.points == 3);
    CHECK(population.session_clutter.level_db == -50.0);
    CHECK(population.session_clutter.range_m.median() == Approx(0.7));
}

TEST_CASE("classes of one name, of no material or too few are refused by line", "[sim]") {
    CHECK(contains(population_refusal(replaced(two_classes, "\"board\"", "\"sheet\"") + laws),
                   "p.toml:13: class.name"));
    CHECK(contains(population_refusal(replaced(two_classes, "\"wood\"", "\"wod\"") + laws),
                   "did you mean \"wood\"?"));
    const std::string one = two_classes.substr(0, two_classes.rfind("[[class]]"));
    CHECK(contains(population_refusal(one + laws), "1 classes"));
    CHECK(contains(
        population_refusal(replaced(two_classes, "thickness_mm = 18", "thickness_mm = 0") + laws),
        "p.toml:15: class.thickness_mm = 0"));
    CHECK(contains(population_refusal(replaced(two_classes, "bow_mm", "bow_m") + laws),
                   "class.bow_m"));
    CHECK(contains(population_refusal(two_classes + replaced(laws, "height_mm", "hight_mm")),
                   "height"));
}

TEST_CASE("a law that lies below zero by more than 2 % is refused with its share", "[sim]") {
    const auto with = [](const std::string& law) {
        return replaced(two_classes, "thickness_mm = 18", "thickness_mm = " + law);
    };
    // One standard deviation above zero: Phi(-1) = 15.9 %.
    CHECK(population_refusal(with("{ normal = [3.0, 3.0] }"))
              .rfind("p.toml:15: class.thickness_mm = {...}: would be below zero in 16 % of all "
                     "draws, which are folded back; keep that below 2 %", 0) == 0);
    CHECK(population_in(with("{ normal = [3.0, 1.4] }")).classes.size() == 2);  // Phi(-2.14) = 1.6 %
    CHECK(contains(population_refusal(with("18\nloss_factor = { normal = [1, 0.6] }")),
                   "class.loss_factor = {...}: would be below zero in 5 %"));
}

TEST_CASE("placements and frames without laws are all alike", "[sim]") {
    const Population population = population_in(two_classes);
    CHECK(population.session.height_m.spread() == 0.0);
    CHECK(population.session.gain_db.median() == 0.0);
    CHECK(population.frame.displacement_m.spread() == 0.0);
}

}  // namespace
}  // namespace specula
