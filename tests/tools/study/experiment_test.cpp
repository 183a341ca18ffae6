#include "tools/study/experiment.hpp"

#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"
#include "tests/tools/study/toy_experiment.hpp"

namespace specula {
namespace {

Experiment read(const std::string& text) {
    const MadeUpFolder folder;
    return read_experiment(folder.with("toy.toml", text), catalogue());
}

/// What is said of the toy experiment with one place in it changed.
std::string refusal(const std::string& from, const std::string& to) {
    return message_of([&] { return read(edited(toy_experiment, from, to)); });
}

TEST_CASE("an experiment is read whole, section by section", "[study]") {
    const Experiment toy = read(toy_experiment);
    CHECK(toy.name == "toy");
    CHECK(toy.source == toy_experiment);
    CHECK(toy.seed == 7);
    CHECK(toy.radar.name == "iwrl6432boost");
    CHECK(toy.nominal_height_m == Approx(0.45));
    CHECK(toy.usual.worlds == 2);
    CHECK(toy.usual.epochs == 4);
    CHECK(toy.quick.worlds == 1);
    CHECK(toy.quick.epochs == 1);
    CHECK(toy.population.class_names() == std::vector<std::string>{"metal", "sheet"});
    CHECK(toy.merged_classes == std::vector<std::size_t>{0, 1});
    CHECK(toy.training.number == 0);
    CHECK(toy.validation_share == 0.3);
    REQUIRE(toy.conditions.size() == 2);
    CHECK(toy.conditions[0].number == 1);
    CHECK(toy.conditions[1].number == 2);
    CHECK(toy.conditions[1].heights_m.size() == 2);
    CHECK(toy.descriptor.first_bin == 6);
    CHECK(toy.descriptor.n_bins == 12);
    CHECK(toy.descriptor.window == FW_WINDOW_BLACKMAN);
    CHECK(toy.descriptor.integration == FW_INTEGRATE_MEAN);
    CHECK(toy.classifier.hidden == std::vector<int>{6});
    CHECK(toy.classifier.batch_size == 16);
    CHECK(toy.paper_macro_f1 == std::map<std::string, double>{{"nominal", 0.9}, {"height", 0.5}});
}

TEST_CASE("every experiment of the catalogue can be read", "[study]") {
    for (const std::string& name : catalogue().experiment_names()) {
        INFO(name);
        const Experiment experiment =
            read_experiment(catalogue().experiment_file(name), catalogue());
        CHECK(experiment.name == name);
        CHECK_FALSE(experiment.conditions.empty());
    }
}

TEST_CASE("a published figure must belong to a condition", "[study]") {
    const std::string message = refusal("macro_f1_height = 0.5", "macro_f1_heigth = 0.5");
    CHECK(contains(message, "paper.macro_f1_heigth = 0.5"));
    CHECK(contains(message, "did you mean macro_f1_height?"));
    CHECK(contains(refusal("macro_f1_height = 0.5", "macro_f1_height = 50"),
                   "paper.macro_f1_height"));
}

TEST_CASE("merged classes are classes of the experiment, each once", "[study]") {
    CHECK(contains(refusal("[\"metal\", \"sheet\"]", "[\"metal\", \"wood\"]"),
                   "\"wood\" is no class of this experiment; use \"metal\" or \"sheet\""));
    CHECK(contains(refusal("[\"metal\", \"sheet\"]", "[\"metal\", \"metal\"]"), "merged_classes"));
}

TEST_CASE("two conditions, or a condition and the training, do not share a name", "[study]") {
    for (const auto* name : {"rerecorded", "training", "nominal"}) {
        const std::string message =
            refusal("name = \"height\"", std::string("name = \"") + name + "\"");
        INFO(message);
        CHECK(contains(message, ":52: condition.name = \"" + std::string(name) + "\""));
    }
    CHECK(contains(refusal("name = \"sheet\"", "name = \"metal\""), "class.name"));
}

TEST_CASE("a name that leads out of the folder of datasets is refused", "[study]") {
    for (const auto* name : {"../height", "a/b", "a b", ""}) {
        INFO(name);
        CHECK(contains(refusal("name = \"height\"", std::string("name = \"") + name + "\""),
                       "condition.name"));
        CHECK(contains(refusal("name = \"training\"", std::string("name = \"") + name + "\""),
                       "training.name"));
    }
}

TEST_CASE("bins beyond the spectrum are refused", "[study]") {
    // 128 samples have 64 bins below half the rate.
    CHECK(contains(refusal("first_bin = 6", "first_bin = 64"), "descriptor.first_bin = 64"));
    CHECK(contains(refusal("n_bins = 12", "n_bins = 59"), "descriptor.n_bins = 59"));
    CHECK(refusal("n_bins = 12", "n_bins = 58") == "(no error)");
    CHECK(contains(refusal("n_bins = 12", "n_bins = 0"), "descriptor.n_bins = 0"));
}

TEST_CASE("what the firmware cannot run is refused before anything is recorded", "[study]") {
    CHECK(contains(refusal("hidden = [6]", "hidden = [6, 6, 6, 6, 6, 6, 6, 6]"),
                   "classifier.hidden"));
    CHECK(contains(refusal("hidden = [6]", "hidden = [6.5]"), "classifier.hidden"));
    CHECK(contains(refusal("hidden = [6]", "hidden = [0]"), "classifier.hidden"));
}

TEST_CASE("the training recordings are what known samples are known from", "[study]") {
    CHECK(contains(refusal("validation_share = 0.3", "validation_share = 0.3\nsamples = \"new\""),
                   "training.samples"));
}

TEST_CASE("shares, worlds and keys that make no sense are refused", "[study]") {
    CHECK(
        contains(refusal("validation_share = 0.3", "validation_share = 1.0"), "validation_share"));
    CHECK(contains(refusal("worlds = 2", "worlds = 0"), "worlds = 0"));
    CHECK(contains(refusal("worlds = 2", "worlds = 1001"), "worlds = 1001"));
    CHECK(contains(refusal("seed = 7", "seed = -7"), "seed = -7"));
    CHECK(contains(refusal("seed = 7", "seed = 7\nsede = 8"), "did you mean seed?"));
}

}  // namespace
}  // namespace specula
