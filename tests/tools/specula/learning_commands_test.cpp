#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/core/constants.hpp"
#include "sim/core/random.hpp"
#include "sim/dataset/dataset.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/tools/specula/learning_folder.hpp"

// train, evaluate and predict as their user meets them.

namespace specula {
namespace {

TEST_CASE("a model is trained with every option, judged on held-out sessions, and says so",
          "[program][learning]") {
    const LearningFolder folder;
    const std::string said = folder.run(joined({"train",
                                                "a.h5",
                                                "-o",
                                                "m.json",
                                                "--holdout",
                                                "session",
                                                "--held-out",
                                                "0.25",
                                                "--schedule",
                                                "one-cycle",
                                                "--weight-decay",
                                                "0.01",
                                                "--label-smoothing",
                                                "0.05",
                                                "--mixup",
                                                "0.2",
                                                "--patience",
                                                "20",
                                                "--precision",
                                                "float64",
                                                "--seed",
                                                "3"},
                                               quick_training));
    CHECK(contains(said, "90 frames of 3 classes, descriptor columns 0 2"));
    CHECK(contains(said, "On the sessions held out:\n30 frames: accuracy"));
    const auto model = nlohmann::json::parse(content_of(folder / "m.json"));
    const auto& provenance = model["provenance"];
    CHECK(provenance["optimiser"] == "adamw");
    CHECK(provenance["schedule"] == "one-cycle");
    CHECK(provenance["precision"] == "float64");
    CHECK(provenance["label smoothing"] == "0.05");
    CHECK(provenance["mixup"] == "0.2");
    CHECK(provenance["rows held out to judge"] == "30");
    CHECK(provenance["dataset"].get<std::string>().size() == 16);
    CHECK(provenance.contains("held-out loss of the kept epoch, nats"));
    CHECK(contains(provenance["stream"].get<std::string>(), "seed 3"));
}

TEST_CASE("the same command gives the same model, whatever the threads", "[program][learning]") {
    const LearningFolder folder;
    folder.run(
        joined({"train", "a.h5", "-o", "one.json", "-j", "1", "--mixup", "0.2"}, quick_training));
    folder.run(
        joined({"train", "a.h5", "-o", "two.json", "-j", "2", "--mixup", "0.2"}, quick_training));
    CHECK(content_of(folder / "one.json") == content_of(folder / "two.json"));
}

TEST_CASE("convolutions and no hidden layer at all learn the same easy thing",
          "[program][learning]") {
    const LearningFolder folder;
    for (const Arguments& network :
         {Arguments{"--logistic"}, Arguments{"--convolution", "4", "--kernel", "1"},
          Arguments{"--hidden", "8"}}) {
        folder.run(joined(joined({"train", "a.h5", "-o", "m.json"}, network), quick_training));
        const std::string said = folder.run({"evaluate", "m.json", "b.h5"});
        // Classes are 6.7 spreads apart: a frame errs with probability 8e-4.
        CHECK((contains(said, "accuracy 100") || contains(said, "accuracy 99")));
    }
}

TEST_CASE("evaluate writes every number and draws every figure", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    const std::string said =
        folder.run({"evaluate", "m.json", "c.h5", "--nominal", "b.h5", "--merge", "glass,iron",
                    "--json", "scores.json", "--figure", "figures"});
    CHECK(contains(said, "glass+iron as one"));
    CHECK(contains(said, "12 sessions of 1 world\n"));
    const auto scores = nlohmann::json::parse(content_of(folder / "scores.json"));
    CHECK(scores["frames"] == 120);
    CHECK(scores["macro_f1"]["low_95"].get<double>() <= scores["macro_f1"]["mean"].get<double>());
    CHECK(scores["macro_f1_merged"]["mean"].get<double>() >=
          scores["macro_f1"]["mean"].get<double>());
    CHECK(scores["reliability"]["bins"].size() == 15);
    CHECK(scores["temperature"].get<double>() > 0.0);
    // The second feature is 8 of its spreads away, and the first has stayed.
    const auto& departure = scores["departure_from_nominal"];
    CHECK(departure["monitors"]["mahalanobis"]["auroc"].get<double>() > 0.999);
    CHECK(departure["monitors"]["prototypes"]["auroc"].get<double>() > 0.999);
    CHECK(departure["mean_shift_sd"][1].get<double>() == Approx(8.0).margin(0.9));
    CHECK(departure["mean_shift_sd"][0].get<double>() < 0.1);
    CHECK(departure["population_stability"][1].get<double>() > 2.0);
    for (const std::string name : {"confusion", "reliability", "risk_coverage"})
        for (const std::string form : {".svg", ".png", ".csv"})
            CHECK(std::filesystem::file_size(folder / "figures" / (name + form)) > 100);
}

TEST_CASE("evaluate says so where the model learnt from the very frames", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    const std::string note = "NOTE: these are the frames the model learnt from";
    const auto said_of = [&](const std::string& data) {
        const std::string said = folder.run({"evaluate", "m.json", data, "--json", "s.json"});
        const auto scores = nlohmann::json::parse(content_of(folder / "s.json"));
        CHECK(scores["data_is_training_data"].get<bool>() == (said.rfind(note, 0) == 0));
        return said;
    };
    std::filesystem::copy_file(folder / "a.h5", folder / "copy.h5");
    CHECK(said_of("copy.h5").rfind(note, 0) == 0);
    CHECK_FALSE(contains(said_of("b.h5"), note));
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--nominal", "copy.h5"}) ==
          "--nominal = copy.h5: holds the frames that m.json learnt from, which are more familiar "
          "than any others; name nominal data recorded anew");
}

TEST_CASE("classes are the same by their names, in any order and however few",
          "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    Dataset turned = made_up_classes({.seed = 2});  // as b.h5
    turned.class_names = {"wood", "glass", "iron"};
    for (Truth& truth : turned.truth)
        truth.label = static_cast<std::uint8_t>((truth.label + 1) % 3);
    write_dataset(folder / "turned.h5", turned);
    CHECK(folder.run({"evaluate", "m.json", "turned.h5"}) ==
          folder.run({"evaluate", "m.json", "b.h5"}));
    Dataset one = made_up_classes({.seed = 2});
    one.class_names = {"iron", "never seen"};
    for (std::size_t i = 0; i < one.n_frames(); ++i) {
        one.features[2 * i] = 2.0;  // the centre of iron
        one.truth[i].label = 0;
    }
    write_dataset(folder / "one.h5", one);
    CHECK(contains(folder.run({"evaluate", "m.json", "one.h5"}), "120 frames: accuracy 100.0 %"));
}

TEST_CASE("predict has a row per frame whose probabilities add up to 1", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    folder.run({"predict", "m.json", "c.h5", "-o", "answers.json"});
    const auto answers = nlohmann::json::parse(content_of(folder / "answers.json"));
    REQUIRE(answers["frames"].size() == 120);
    int n_suspicious = 0;
    for (const auto& frame : answers["frames"]) {
        double sum = 0.0;
        for (const double p : frame["probabilities"]) sum += p;
        // -ln(sum exp(logit)) = -largest logit + ln(largest probability), by what the two mean.
        const auto shares = frame["probabilities"].get<std::vector<double>>();
        const double surest = *std::max_element(shares.begin(), shares.end());
        CHECK(frame["energy_nepers"].get<double>() ==
              Approx(std::log(surest) - frame["max_logit"].get<double>()).margin(1e-4));
        CHECK(sum == Approx(1.0).epsilon(1e-12));
        n_suspicious += frame["suspicious"].get<bool>();
    }
    CHECK(n_suspicious > 110);  // 8 spreads away; the limit is passed by 1 % of familiar frames
    const std::string table = folder.run({"predict", "m.json", "b.h5"});
    CHECK(table.rfind("frame,world,session,class,probability,p_glass,p_iron,p_wood,max_logit,"
                      "energy_nepers,mahalanobis_squared,prototype_distance_sd,suspicious\n0,0,0,",
                      0) == 0);
    CHECK(std::count(table.begin(), table.end(), '\n') == 121);
    CHECK(folder.run({"predict", "m.json", "b.h5", "-j", "2"}) == table);
}

/// Echoes of two strengths, as the board of the catalogue would record them.
Dataset recorded_by(const std::string& radar) {
    Stream stream({.seed = 4, .purpose = "learning commands test"});
    Dataset dataset;
    dataset.origin.radar = radar;
    dataset.class_names = {"strong", "weak"};
    dataset.n_chirps = 1;
    dataset.n_rx = 3;
    dataset.n_samples = 128;
    for (int frame = 0; frame < 80; ++frame) {
        dataset.truth.push_back(
            {.label = static_cast<std::uint8_t>(frame / 10 % 2), .session = frame / 10});
        const double amplitude = frame / 10 % 2 == 0 ? 900.0 : 500.0;
        for (int i = 0; i < 3 * 128; ++i)
            dataset.adc.push_back(static_cast<std::int16_t>(
                amplitude * std::cos(two_pi * 12.0 * (i % 128) / 128) + 20.0 * stream.normal()));
    }
    return dataset;
}

TEST_CASE("a model of a known radar goes to the chip; of another, the way is told",
          "[program][learning]") {
    const LearningFolder folder;
    write_dataset(folder / "known.h5", recorded_by("iwrl6432boost"));
    write_dataset(folder / "other.h5", recorded_by("my own"));
    const std::string aligned = "range_bins 6 12 blackman align 12 range 12 log 1 search 5 20";
    folder.run(
        joined({"train", "known.h5", "-o", "m.json", "--descriptor", aligned}, quick_training));
    folder.run({"export", "model", "m.json", "--blob", "m.rfwm"});
    CHECK(std::filesystem::file_size(folder / "m.rfwm") > 1000);
    folder.run(joined({"train", "other.h5", "-o", "o.json"}, quick_training));
    const std::string untold = folder.refusal({"export", "model", "o.json", "--blob", "o.rfwm"});
    CHECK(untold.rfind("o.json: measurement: is missing", 0) == 0);
    CHECK(contains(untold, "--radar NAME"));
    folder.run(
        joined({"train", "other.h5", "-o", "o.json", "--radar", "iwrl6432boost"}, quick_training));
    folder.run({"export", "model", "o.json", "--blob", "o.rfwm"});
    Dataset shorter = recorded_by("my own");
    shorter.n_samples = 64;
    shorter.n_rx = 6;
    write_dataset(folder / "shorter.h5", shorter);
    CHECK(folder.refusal({"evaluate", "o.json", "shorter.h5"})
              .rfind("shorter.h5: samples per chirp = 64: the model was trained on 128", 0) == 0);
    CHECK(folder.refusal({"train", "a.h5", "-o", "x.json", "--radar", "iwrl6432boost"})
              .rfind("a.h5: --radar iwrl6432boost: sends 1 chirps of 128 samples to 3 receivers a "
                     "frame, and the frames hold 0 of 0 from 0",
                     0) == 0);
}

TEST_CASE("neighbours answer a cross-validation in place of a network", "[program][learning]") {
    const LearningFolder folder;
    const std::string said = folder.run({"evaluate", "a.h5", "--leave-out", "session",
                                         "--neighbours", "5", "--folds", "4", "--repeats", "1"});
    CHECK((contains(said, "100.0 +- 0.0 %") || contains(said, "99.")));
    CHECK(folder.refusal({"evaluate", "a.h5", "--leave-out", "session", "--neighbours", "5",
                          "--mixup", "0.2"}) ==
          "--mixup: is of a network, and --neighbours trains none; leave one of the two out");
}

TEST_CASE("a cross-validation writes the table it prints", "[program][learning]") {
    const LearningFolder folder;
    const std::string said =
        folder.run({"evaluate", "c.h5", "--leave-out", "session,frame", "--neighbours", "5",
                    "--folds", "4", "--repeats", "2", "--leak-check", "--json", "table.json"});
    const auto table = nlohmann::json::parse(content_of(folder / "table.json"));
    CHECK((table["frames"] == 120 && table["folds"] == 4 && table["repeats"] == 2));
    for (const std::string split : {"session", "frame"}) {
        const auto& scores = table["left_out"][split];
        std::int64_t n = 0, n_right = 0;
        for (std::size_t truth = 0; truth < 3; ++truth)
            for (std::size_t guess = 0; guess < 3; ++guess) {
                const auto cell =
                    scores["confusion_true_by_predicted"][truth][guess].get<std::int64_t>();
                n += cell;
                n_right += truth == guess ? cell : 0;
            }
        CHECK(n == 2 * 120);
        CHECK(scores["frames_right"]["mean"].get<double>() ==
              Approx(static_cast<double>(n_right) / 240.0).epsilon(1e-12));
        CHECK(scores["frames_right_of_shuffled_classes"]["mean"].get<double>() > 0.0);
    }
    CHECK(contains(said, "Wrote table.json"));
}

TEST_CASE("a reader who has seen enough of a long table is no error", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    write_dataset(folder / "long.h5", made_up_classes({.n_sessions = 200}));  // 600 kB of table
    const Ended ended = run_program(
        {.arguments = {"bash", "-c",
                       "set -o pipefail; '" SPECULA_BINARY "' predict m.json long.h5 | head -1"},
         .folder = folder.path(),
         .environment = {{"SPECULA_HOME", SPECULA_SOURCE_DIR}}});
    CHECK(ended.status == 0);
    CHECK(ended.errors.empty());
    CHECK(std::count(ended.output.begin(), ended.output.end(), '\n') == 1);
}

}  // namespace
}  // namespace specula
