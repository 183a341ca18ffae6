#include <nlohmann/json.hpp>

#include "tests/check.hpp"
#include "tests/run_program.hpp"
#include "tests/tools/specula/small_study.hpp"

namespace specula {
namespace {

TEST_CASE("a study writes what its help promises, below the folder asked for", "[program][study]") {
    const MadeUpFolder folder;
    folder.with("My study-2.toml", small_study);
    const Ended ended = specula_in(folder.path(), {"study", "My study-2.toml", "--quick", "--seed",
                                                   "18446744073709551615", "-o", "deep/out"});
    INFO(ended.errors);
    REQUIRE(ended.status == 0);
    for (const char* file : {"report.html", "results.json", "figures/macro_f1.svg",
                             "datasets/training.h5", "datasets/higher.h5", "models/world_000.json",
                             // A C name, whatever the experiment's file is called.
                             "firmware/fw_model_my_study_2.c", "firmware/fw_model_my_study_2.h"})
        CHECK(std::filesystem::exists(folder / "deep/out" / file));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
        CHECK(entry.path().string().find(".draft-") == std::string::npos);
    CHECK(ended.output.find("Open deep/out/report.html in a browser.") != std::string::npos);

    const auto results = nlohmann::json::parse(content_of(folder / "deep/out/results.json"));
    CHECK(results.at("command") ==
          "specula study 'My study-2.toml' --quick --seed 18446744073709551615");
    CHECK(results.at("conditions").size() == 2);
    CHECK(results.at("seed") == 18446744073709551615u);
}

TEST_CASE("a study that cannot write names the path and exits 2", "[program][study]") {
    const MadeUpFolder folder;
    folder.with("x.toml", small_study);
    folder.with("file", "kept");
    const Ended ended = specula_in(folder.path(), {"study", "x.toml", "-o", "file/out"});
    CHECK(ended.status == 2);
    CHECK(ended.errors ==
          "specula: error: file/out/datasets: cannot create: Not a directory; give another "
          "place\n");
    CHECK(content_of(folder / "file") == "kept");
}

struct StudyMistake {
    std::string from, to;
    std::string message;  ///< is in what is said
};

const std::vector<StudyMistake> study_mistakes{
    {"worlds = 2", "worlds = 0",
     "x.toml:4: worlds = 0: is out of range; give a value at least 1 and at most 1000"},
    {"worlds = 2", "wolrds = 2",
     "x.toml:1: worlds: is missing; add it, or is it meant by wolrds in line 4?"},
    {"seed = 1", "seed = -1", "x.toml:3: seed = -1: is not a whole number from 0 to"},
    {"[descriptor]", "[extra]\n[descriptor]",
     "extra = {...}: is not a key of this file; remove it"},
    {"nominal_height_mm = 450", "nominal_height_m = 5",
     "is beyond the farthest range of the chirp of iwrl6432boost, 2.25 m"},
    {"height_mm = [550]", "height_mm = [50]", "among bins 0 to 2"},
    {"[\"wood\", \"iron\"]", "[\"wood\", \"gold\"]",
     "\"gold\" is no class of this experiment; use \"wood\" or \"iron\""},
    {"[\"wood\", \"iron\"]", "[\"wood\", \"wood\"]",
     "merged_classes = [\"wood\", \"wood\"]: \"wood\" is in it twice; remove one"},
    {"name = \"iron\"", "name = \"wood\"",
     "class.name = \"wood\": names an earlier class too; give each class its own name"},
    {"material = \"iron\"", "material = \"irn\"", "class.material = \"irn\": is not known; "},
    {"name = \"higher\"", "name = \"training\"",
     "condition.name = \"training\": is the name of the training recordings"},
    {"name = \"higher\"", "name = \"nominal\"", "condition.name = \"nominal\": is the name of"},
    {"name = \"higher\"", "name = \"../higher\"",
     "condition.name = \"../higher\": cannot name a file; use up to 64 of a-z, 0-9, _ and -"},
    {"name = \"training\"", "name = \"a/b\"", "training.name = \"a/b\": cannot name a file; "},
    {"hidden = [4]", "hidden = [4.5]",
     "classifier.hidden = [4.5]: holds a number that is not whole; give whole numbers"},
    {"hidden = [4]", "hidden = [4, 4, 4, 4]",
     "classifier.hidden = [4, 4, 4, 4]: is more layers than the firmware runs; give at most 3"},
    {"first_bin = 6", "first_bin = 64",
     "descriptor.first_bin = 64: is out of range; give a value at least 0 and at most 63"},
    {"first_bin = 6", "first_bin = 60\nn_bins = 5",
     "descriptor.n_bins = 5: bins 60 to 64 run beyond the last, 63; begin lower, or take fewer"},
    {"first_bin = 6", "first_bin = 60",  // the usual 12
     "descriptor.first_bin = 60: bins 60 to 71 run beyond the last, 63; begin lower"},
    {"window = \"blackman\"", "window = \"hamming\"",
     "descriptor.window = \"hamming\": is not known"},
    {"validation_title = \"Held back\"", "validation_title = \"Held back\"\nvalidation_share = 1",
     "training.validation_share = 1: is out of range; give a value above 0 and below 1"},
    {"thickness_mm = 10", "thickness_mm = { normal = [10, -1] }",
     "class.thickness_mm.normal = [10, -1]: is out of range; give [mean, standard deviation]"},
    {"[quick]\nworlds = 1\nepochs = 1\n", "", "x.toml:1: quick: is missing; add it"},
};

TEST_CASE("a study of a file with a mistake says so in one line and writes nothing",
          "[program][study]") {
    for (const StudyMistake& mistake : study_mistakes) {
        const MadeUpFolder folder;
        folder.with("x.toml", edited(small_study, mistake.from, mistake.to));
        const Ended ended = specula_in(folder.path(), {"study", "x.toml", "--quick"});
        INFO(ended.errors);
        CHECK(ended.status == 2);
        CHECK(ended.output.empty());
        CHECK(ended.errors.rfind("specula: error: x.toml:", 0) == 0);
        CHECK(ended.errors.find(mistake.message) != std::string::npos);
        CHECK(ended.errors.find('\n') == ended.errors.size() - 1);
        const std::filesystem::directory_iterator left(folder.path());
        CHECK(std::distance(begin(left), end(left)) == 1);
    }
}

TEST_CASE("a window that the firmware lacks is refused before anything is recorded",
          "[program][study]") {
    const MadeUpFolder folder;
    folder.with("short.toml", edited(project_file("scenes/radars/iwrl6432boost.toml"),
                                     "n_samples        = 128", "n_samples = 32"));
    const std::string text = edited(edited(small_study, "\"iwrl6432boost\"", "\"short.toml\""),
                                    "first_bin = 6", "first_bin = 3");
    folder.with("x.toml", edited(text, "_mm = 450", "_mm = 500"));
    const Ended ended = specula_in(folder.path(), {"study", "x.toml"});
    CHECK(ended.status == 2);
    CHECK(ended.errors.find("descriptor.window = \"blackman\": the firmware has no blackman window "
                            "of 32 samples; write \"rectangular\", or choose a radar with 64, 128, "
                            "256 or 512 samples") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("an experiment that is neither a name nor a file is refused", "[program][study]") {
    const MadeUpFolder folder;
    CHECK(specula_in(folder.path(), {"study", "papr"}).errors ==
          "specula: error: \"papr\": no such experiment; did you mean paper? "
          "use \"paper\" or a .toml file\n");
    CHECK(specula_in(folder.path(), {"study", "none.toml"}).errors ==
          "specula: error: none.toml: no such file; check the path\n");
    CHECK(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace specula
