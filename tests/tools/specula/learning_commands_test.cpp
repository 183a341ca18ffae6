#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/core/constants.hpp"
#include "sim/core/random.hpp"
#include "sim/dataset/dataset.hpp"
#include "tests/check.hpp"
#include "tests/run_program.hpp"

// train, evaluate and predict as their user meets them.

namespace specula {
namespace {

using Arguments = std::vector<std::string>;

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

struct Made {
    int n_sessions = 4;  ///< of each of three classes
    double moved = 0.0;  ///< added to the second feature
    std::uint64_t seed = 1;
};

/// Features of three classes: the first tells the class, the second is noise.
Dataset made(const Made& law) {
    Stream stream({.seed = law.seed, .purpose = "learning commands test"});
    Dataset dataset;
    dataset.class_names = {"glass", "iron", "wood"};
    dataset.feature_names = {"x", "y"};
    for (int session = 0; session < 3 * law.n_sessions; ++session)
        for (int frame = 0; frame < 10; ++frame) {
            dataset.truth.push_back({.label = static_cast<std::uint8_t>(session % 3),
                                     .sample = session % 3,
                                     .session = session,
                                     .frame = frame});
            dataset.features.push_back(2.0 * (session % 3) + 0.3 * stream.normal());
            dataset.features.push_back(law.moved + stream.normal());
        }
    dataset.unknown_truth.set();
    return dataset;
}

/// a.h5 to learn from, b.h5 recorded anew, c.h5 moved away.
struct Folder : MadeUpFolder {
    Folder() {
        write_dataset(path() / "a.h5", made({}));
        write_dataset(path() / "b.h5", made({.seed = 2}));
        write_dataset(path() / "c.h5", made({.moved = 8.0, .seed = 3}));
    }
    std::string run(const Arguments& arguments) const {
        const Ended ended = specula_in(path(), arguments);
        INFO(ended.errors);
        REQUIRE(ended.status == 0);
        return ended.output;
    }
    /// The one line of a refusal; nothing may be written.
    std::string refusal(const Arguments& arguments) const {
        const auto n_before = n_entries();
        const Ended ended = specula_in(path(), arguments);
        CHECK(ended.status == 2);
        CHECK(n_entries() == n_before);
        CHECK(ended.errors.find('\n') == ended.errors.size() - 1);
        const std::string start = "specula: error: ";
        REQUIRE(ended.errors.rfind(start, 0) == 0);
        return ended.errors.substr(start.size(), ended.errors.size() - start.size() - 1);
    }
    std::ptrdiff_t n_entries() const {
        const std::filesystem::directory_iterator entries(path());
        return std::distance(begin(entries), end(entries));
    }
};

const Arguments quick{"--epochs", "60", "--learning-rate", "0.01", "--batch-size", "16"};

Arguments with(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST_CASE("a model is trained with every option, judged on held-out sessions, and says so",
          "[program][learning]") {
    const Folder folder;
    const std::string said = folder.run(with({"train",
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
                                             quick));
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
    const Folder folder;
    folder.run(with({"train", "a.h5", "-o", "one.json", "-j", "1", "--mixup", "0.2"}, quick));
    folder.run(with({"train", "a.h5", "-o", "two.json", "-j", "2", "--mixup", "0.2"}, quick));
    CHECK(content_of(folder / "one.json") == content_of(folder / "two.json"));
}

TEST_CASE("convolutions and no hidden layer at all learn the same easy thing",
          "[program][learning]") {
    const Folder folder;
    for (const Arguments& network :
         {Arguments{"--logistic"}, Arguments{"--convolution", "4", "--kernel", "1"},
          Arguments{"--hidden", "8"}}) {
        folder.run(with(with({"train", "a.h5", "-o", "m.json"}, network), quick));
        const std::string said = folder.run({"evaluate", "m.json", "b.h5"});
        // Classes are 6.7 spreads apart: a frame errs with probability 8e-4.
        CHECK((contains(said, "accuracy 100") || contains(said, "accuracy 99")));
    }
}

TEST_CASE("evaluate writes every number and draws every figure", "[program][learning]") {
    const Folder folder;
    folder.run(with({"train", "a.h5", "-o", "m.json"}, quick));
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
    CHECK(departure["mean_shift_sd"][1].get<double>() == Approx(8.0).margin(0.9));
    CHECK(departure["mean_shift_sd"][0].get<double>() < 0.1);
    CHECK(departure["population_stability"][1].get<double>() > 2.0);
    for (const std::string name : {"confusion", "reliability", "risk_coverage"})
        for (const std::string form : {".svg", ".png", ".csv"})
            CHECK(std::filesystem::file_size(folder / "figures" / (name + form)) > 100);
}

TEST_CASE("predict has a row per frame whose probabilities add up to 1", "[program][learning]") {
    const Folder folder;
    folder.run(with({"train", "a.h5", "-o", "m.json"}, quick));
    folder.run({"predict", "m.json", "c.h5", "-o", "answers.json"});
    const auto answers = nlohmann::json::parse(content_of(folder / "answers.json"));
    REQUIRE(answers["frames"].size() == 120);
    int n_suspicious = 0;
    for (const auto& frame : answers["frames"]) {
        double sum = 0.0;
        for (const double p : frame["probabilities"]) sum += p;
        CHECK(sum == Approx(1.0).epsilon(1e-12));
        n_suspicious += frame["suspicious"].get<bool>();
    }
    CHECK(n_suspicious > 110);  // 8 spreads away; the limit is passed by 1 % of familiar frames
    const std::string table = folder.run({"predict", "m.json", "b.h5"});
    CHECK(table.rfind("frame,world,session,class,probability,p_glass,p_iron,p_wood,max-logit,msp,"
                      "energy,mahalanobis,suspicious\n0,0,0,",
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
    const Folder folder;
    write_dataset(folder / "known.h5", recorded_by("iwrl6432boost"));
    write_dataset(folder / "other.h5", recorded_by("my own"));
    const std::string aligned = "range_bins 6 12 blackman align 12 range 12 log 1 search 5 20";
    folder.run(with({"train", "known.h5", "-o", "m.json", "--descriptor", aligned}, quick));
    folder.run({"export", "model", "m.json", "--blob", "m.rfwm"});
    CHECK(std::filesystem::file_size(folder / "m.rfwm") > 1000);
    folder.run(with({"train", "other.h5", "-o", "o.json"}, quick));
    const std::string untold = folder.refusal({"export", "model", "o.json", "--blob", "o.rfwm"});
    CHECK(untold.rfind("o.json: measurement: is missing", 0) == 0);
    CHECK(contains(untold, "--radar NAME"));
    folder.run(with({"train", "other.h5", "-o", "o.json", "--radar", "iwrl6432boost"}, quick));
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
    const Folder folder;
    const std::string said = folder.run({"evaluate", "a.h5", "--leave-out", "session",
                                         "--neighbours", "5", "--folds", "4", "--repeats", "1"});
    CHECK((contains(said, "100.0 +- 0.0 %") || contains(said, "99.")));
    CHECK(folder.refusal({"evaluate", "m.json", "a.h5", "--neighbours", "5"}) ==
          "--neighbours goes with --leave-out: there is no model to judge");
}

TEST_CASE("data that nothing can be learnt from are refused in one line", "[program][learning]") {
    const Folder folder;
    Dataset single = made({});
    for (Truth& truth : single.truth) truth.label = 1;
    write_dataset(folder / "single.h5", single);
    Dataset constant = made({});
    constant.features.assign(constant.features.size(), 1.5);
    write_dataset(folder / "constant.h5", constant);
    Dataset ungrouped = made({});
    for (Truth& truth : ungrouped.truth) truth.session = 0;
    write_dataset(folder / "ungrouped.h5", ungrouped);
    write_dataset(folder / "few.h5", made({.n_sessions = 1}));
    Dataset large = made({});
    large.features[7] = 1e300;
    write_dataset(folder / "large.h5", large);
    const auto train = [&](const std::string& data, const Arguments& more = {}) {
        return folder.refusal(with({"train", data, "-o", "m.json"}, more));
    };
    CHECK(train("single.h5") ==
          "single.h5: training set: all rows are of class \"iron\"; give examples of two or more "
          "classes");
    CHECK(train("constant.h5") ==
          "constant.h5: features: every one has the same value in all rows; choose other bins, or "
          "look at the recording");
    CHECK(train("large.h5") ==
          "large.h5: features: some are too large for a float; scale them down");
    CHECK(train("few.h5", {"--holdout", "session"}) ==
          "few.h5: sessions: class \"glass\" has 1 of them, too few to hold one out; record more, "
          "or train without holding out");
    CHECK(train("few.h5", {"--patience", "5"}).rfind("few.h5: sessions: class \"glass\"", 0) == 0);
    CHECK(train("ungrouped.h5", {"--holdout", "session"})
              .rfind("ungrouped.h5: sessions: class \"glass\" has 1 of them", 0) == 0);
    CHECK(folder.refusal({"evaluate", "ungrouped.h5", "--leave-out", "session"}) ==
          "ungrouped.h5: there is only one group to leave out; record more than one");
    CHECK(train("a.h5", {"--mixup", "7"}) ==
          "a.h5: mixup = 7: is out of range; use 0, or 0.05 to 1");
    CHECK(train("a.h5", {"--descriptor", "range_bins 6 12 blackman"})
              .rfind("a.h5: range_bins: does not fit such frames", 0) == 0);
    CHECK(train("a.h5", {"--descriptor", "bins"}).rfind("a.h5: descriptor = \"bins\": ", 0) == 0);
}

TEST_CASE("data that do not fit a model are refused in one line", "[program][learning]") {
    const Folder folder;
    folder.run(with({"train", "a.h5", "-o", "m.json"}, quick));
    Dataset renamed = made({});
    renamed.class_names = {"glass", "steel", "wood"};
    write_dataset(folder / "renamed.h5", renamed);
    Dataset fewer = made({});
    fewer.feature_names = {"x"};
    fewer.features.resize(fewer.n_frames());
    write_dataset(folder / "fewer.h5", fewer);
    CHECK(folder.refusal({"evaluate", "m.json", "renamed.h5"}) ==
          "renamed.h5: class_names: are not those of m.json; use data of the same classes in the "
          "same order");
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--nominal", "renamed.h5"})
              .rfind("renamed.h5: class_names: are not those of m.json", 0) == 0);
    const std::string too_few = "fewer.h5: bins 0:2: there are 1 features; choose among them";
    CHECK(folder.refusal({"evaluate", "m.json", "fewer.h5"}) == too_few);
    CHECK(folder.refusal({"predict", "m.json", "fewer.h5", "-o", "x.csv"}) == too_few);
    CHECK(folder.refusal({"predict", "m.json", "b.h5", "-o", "x.txt"}) ==
          "--out = x.txt: its name does not tell its form; end it in .csv or .json");
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--merge", "steel"}) ==
          "--merge: \"steel\" is no class of the data; use \"glass\", \"iron\" or \"wood\"");
    CHECK(folder.refusal({"train", "a.h5", "-o", "a.h5"}) ==
          "a.h5: is an input of this command; give --out another name");
    CHECK(folder.refusal({"predict", "m.json", "b.h5", "-o", "m.json"}).rfind("m.json: is an", 0) ==
          0);
    CHECK(
        folder.refusal({"evaluate", "m.json", "b.h5", "--json", "b.h5"}).rfind("b.h5: is an", 0) ==
        0);
    CHECK(folder.refusal({"evaluate", "a.h5", "--leave-out", "frame", "--json", "x.json"}) ==
          "--json, --figure, --merge and --nominal go with a model, not with --leave-out");
}

}  // namespace
}  // namespace specula
