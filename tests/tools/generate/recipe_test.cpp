#include "tools/generate/recipe.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/tools/generate/small_recipe.hpp"

namespace specula {
namespace {

std::string with(std::string text, const std::string& old, const std::string& instead) {
    const auto at = text.find(old);
    REQUIRE(at != std::string::npos);
    return text.replace(at, old.size(), instead);
}

TEST_CASE("a dataset's file says how many pieces, sessions and frames there are", "[generate]") {
    const Recipe recipe = SmallRecipe().read();
    CHECK(recipe.n_sessions() == 2u * 5u * 2u * 8u);  // classes, worlds, pieces, sessions
    CHECK(recipe.n_frames() == recipe.n_sessions() * 2);
    CHECK(recipe.stored == StoredForms{.adc = true, .features = true});
    CHECK(recipe.condition.geometry_law->n_sessions == 5 * 16);
    CHECK(recipe.name == "small");
}

TEST_CASE("what is said on the command line goes before the file", "[generate]") {
    const Recipe recipe = SmallRecipe().read({.seed = 9, .worlds = 2, .store = {"profiles"}});
    CHECK(recipe.seed == 9);
    CHECK(recipe.n_sessions() == 64);
    CHECK(recipe.stored == StoredForms{.adc = false, .profiles = true});
    CHECK(recipe.condition.geometry_law->n_sessions == 32);
}

TEST_CASE("a study gives any of its conditions, by default the training recordings", "[generate]") {
    const auto file = own_catalogue().experiment_file("paper");
    CHECK(read_recipe({.file = file}, own_catalogue()).condition.name == "training");
    const Recipe height = read_recipe({.file = file, .condition = "height"}, own_catalogue());
    CHECK(height.condition.heights_m.size() == 2);
    CHECK(height.worlds == 20);
    CHECK(message_of([&] {
              return read_recipe({.file = file, .condition = "hight"}, own_catalogue());
          }).find("\"height\"") != std::string::npos);
}

TEST_CASE("every dataset of the catalogue can be read", "[generate]") {
    REQUIRE(own_catalogue().dataset_names().size() >= 2);
    for (const std::string& name : own_catalogue().dataset_names()) {
        INFO(name);
        CHECK(
            read_recipe({.file = own_catalogue().dataset_file(name)}, own_catalogue()).n_frames() >
            0);
    }
}

TEST_CASE("a recipe's text changes with all that decides frames, and with nothing else",
          "[generate]") {
    const std::string plain = SmallRecipe().read().text;
    CHECK(SmallRecipe(std::string("# a remark\n") + small_recipe_text).read().text == plain);
    CHECK(SmallRecipe(with(small_recipe_text, "\"small\"", "\"other\"")).read().text == plain);
    for (const auto& [old, instead, difference] : std::vector<std::array<const char*, 3>>{
             {"seed = 5", "seed = 6", "seed = 5 there, 6 here"},
             {"worlds = 5", "worlds = 6", "worlds = 5 there, 6 here"},
             {"frames = 2", "frames = 3", "experiment.recordings.frames = 2 there, 3 here"},
             {"[18, 1]", "[18, 2]", "experiment.class[1].thickness_mm.normal[1] = 1 there, 2 here"},
             {"[40, 40]", "[41, 40]", "experiment.sample.size_mm[0] = 40 there, 41 here"}}) {
        const std::string other = SmallRecipe(with(small_recipe_text, old, instead)).read().text;
        INFO(recipe_difference(plain, other));
        CHECK(recipe_difference(plain, other).rfind(difference, 0) == 0);
    }
    CHECK(recipe_difference(plain, plain).empty());
    CHECK(plain.find("material.wood.") != std::string::npos);
    CHECK(plain.find("material.glass.") == std::string::npos);
    CHECK(plain.find("\nradar.chirp.") != std::string::npos);
}

TEST_CASE("forms that do not exist are refused with those that do", "[generate]") {
    CHECK(message_of([] {
              return SmallRecipe(with(small_recipe_text, "\"features\"", "\"feature\"")).read();
          }).find("holds \"feature\"; use some of \"adc\"") != std::string::npos);
    CHECK(message_of([] {
              return SmallRecipe().read({.store = {"adc", "adc"}});
          }) == "--store: holds \"adc\" twice; use some of adc, profiles and features");
    CHECK(message_of([] {
              return SmallRecipe().read({.condition = "height"});
          }).find("has no conditions") != std::string::npos);
    CHECK(message_of([] {
              return SmallRecipe(with(small_recipe_text, "samples = 2", "samples = 200")).read();
          }).find("makes 1600 sessions") != std::string::npos);
}

TEST_CASE("an empty list of forms is told once", "[generate]") {
    const SmallRecipe small(with(small_recipe_text, "[\"adc\", \"features\"]", "[]"));
    const std::string message = message_of([&] { return small.read(); });
    CHECK(message.find("small.toml:6: store = []: is empty") != std::string::npos);
    CHECK(message.find("small.toml", message.find("small.toml") + 1) == std::string::npos);
}

TEST_CASE("a seed is any whole number of 64 bits, large ones in quotes", "[generate]") {
    for (const auto& [text, seed] : std::vector<std::pair<std::string, std::uint64_t>>{
             {"0", 0},
             {"2147483648", 2147483648ull},
             {"9223372036854775807", 9223372036854775807ull},
             {"\"18446744073709551615\"", 18446744073709551615ull}}) {
        INFO(text);
        CHECK(SmallRecipe(with(small_recipe_text, "seed = 5", "seed = " + text)).read().seed ==
              seed);
    }
    for (const std::string text : {"-1", "2.5", "[5]", "\"18446744073709551616\"", "\"\"", "true"}) {
        INFO(text);
        CHECK(message_of([&] {
                  return SmallRecipe(with(small_recipe_text, "seed = 5", "seed = " + text)).read();
              }).find("is not a whole number from 0 to 18446744073709551615") != std::string::npos);
    }
    CHECK(message_of([] {
              return SmallRecipe(with(small_recipe_text, "seed = 5\n", "")).read();
          }).find("seed: is missing") != std::string::npos);
}

TEST_CASE("sessions and frames without laws of their own are all as meant", "[generate]") {
    const auto without = [](std::string text, const std::string& section) {
        const auto at = text.find(section);
        REQUIRE(at != std::string::npos);
        return text.substr(0, at);
    };
    const Recipe recipe = SmallRecipe(without(small_recipe_text, "[session]")).read();
    CHECK(recipe.population.session.gain_db.spread() == 0.0);
    CHECK(recipe.population.session.gain_db.median() == 0.0);
    CHECK(recipe.population.frame.displacement_m.spread() == 0.0);
    CHECK(SmallRecipe(without(small_recipe_text, "[frame]")).read().population.session.gain_db
              .spread() == Approx(0.3));
}

}  // namespace
}  // namespace specula
