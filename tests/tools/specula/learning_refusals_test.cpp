#include "tests/check.hpp"
#include "tests/tools/specula/learning_folder.hpp"

// What train, evaluate and predict refuse, and how they say so.

namespace specula {
namespace {

TEST_CASE("data that nothing can be learnt from are refused in one line", "[program][learning]") {
    const LearningFolder folder;
    Dataset single = made_up_classes({});
    for (Truth& truth : single.truth) truth.label = 1;
    write_dataset(folder / "single.h5", single);
    Dataset constant = made_up_classes({});
    constant.features.assign(constant.features.size(), 1.5);
    write_dataset(folder / "constant.h5", constant);
    Dataset ungrouped = made_up_classes({});
    for (Truth& truth : ungrouped.truth) truth.session = 0;
    write_dataset(folder / "ungrouped.h5", ungrouped);
    write_dataset(folder / "few.h5", made_up_classes({.n_sessions = 1}));
    Dataset large = made_up_classes({});
    large.features[7] = 1e300;
    write_dataset(folder / "large.h5", large);
    const auto train = [&](const std::string& data, const Arguments& more = {}) {
        return folder.refusal(joined({"train", data, "-o", "m.json"}, more));
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
    CHECK(folder.refusal({"evaluate", "ungrouped.h5", "--leave-out", "session"})
              .rfind("ungrouped.h5: /session: all frames have one session, 0: the dataset tells no "
                     "groups apart",
                     0) == 0);
    CHECK(folder.refusal({"evaluate", "few.h5", "--leave-out", "session"})
              .rfind("few.h5: /session: all frames of class \"glass\" have one session, 0: left out, "
                     "nothing of the class is left to learn from",
                     0) == 0);
    CHECK(folder.refusal({"evaluate", "a.h5", "--leave-out", "object"})
              .rfind("a.h5: /sample: all frames of class \"glass\" have one sample", 0) == 0);
    CHECK(train("a.h5", {"--mixup", "7"}) ==
          "a.h5: mixup = 7: is out of range; use 0, or 0.05 to 1");
    CHECK(train("a.h5", {"--descriptor", "range_bins 6 12 blackman"})
              .rfind("a.h5: range_bins: takes beat samples (/adc), and the dataset holds none; ", 0) ==
          0);
    CHECK(train("a.h5", {"--descriptor", "bins"}).rfind("a.h5: descriptor = \"bins\": ", 0) == 0);
}

TEST_CASE("data that do not fit a model are refused in one line", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    Dataset renamed = made_up_classes({});
    renamed.class_names = {"glass", "steel", "wood"};
    write_dataset(folder / "renamed.h5", renamed);
    Dataset fewer = made_up_classes({});
    fewer.feature_names = {"x"};
    fewer.features.resize(fewer.n_frames());
    write_dataset(folder / "fewer.h5", fewer);
    CHECK(folder.refusal({"evaluate", "m.json", "renamed.h5"}) ==
          "renamed.h5: class_names: \"steel\" is no class of m.json; the model knows \"glass\", "
          "\"iron\" or \"wood\", the data name \"glass\", \"steel\" or \"wood\"");
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--nominal", "renamed.h5"})
              .rfind("renamed.h5: class_names: \"steel\" is no class of m.json", 0) == 0);
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
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--json", "b.h5"}) ==
          "b.h5: is an input of this command; give --json another name");
    for (const std::string option : {"--blob", "--c", "--onnx"})
        CHECK(folder.refusal({"export", "model", "m.json", option, "m.json"}) ==
              "m.json: is an input of this command; give " + option + " another name");
    CHECK(folder.refusal({"evaluate", "a.h5", "--leave-out", "frame", "--figure", "x"}) ==
          "--figure, --merge and --nominal go with a model, not with --leave-out");
    CHECK(folder.refusal({"evaluate", "a.h5", "--leave-out", "frame", "--json", "a.h5"}) ==
          "a.h5: is an input of this command; give --json another name");
}

TEST_CASE("columns that were swapped or renamed are refused, the first of them named",
          "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    Dataset swapped = made_up_classes({});
    swapped.feature_names = {"y", "x"};
    write_dataset(folder / "swapped.h5", swapped);
    Dataset renamed = made_up_classes({});
    renamed.feature_names = {"x", "z"};
    write_dataset(folder / "renamed.h5", renamed);
    const std::string there =
        " there; use data with the same columns in the same order";
    CHECK(folder.refusal({"evaluate", "m.json", "swapped.h5"}) ==
          "swapped.h5: features: column 0 is \"y\", and the model was trained on \"x\"" + there);
    CHECK(folder.refusal({"predict", "m.json", "renamed.h5"}) ==
          "renamed.h5: features: column 1 is \"z\", and the model was trained on \"y\"" + there);
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--nominal", "renamed.h5"})
              .rfind("renamed.h5: features: column 1 is \"z\"", 0) == 0);
}

TEST_CASE("what cannot mean what it says is refused", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    std::filesystem::copy_file(folder / "b.h5", folder / "copy.h5");
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--nominal", "copy.h5"}) ==
          "--nominal = copy.h5: holds the frames of b.h5, and nothing departs from itself; name "
          "nominal data of other sessions");
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--merge", "iron,iron"}) ==
          "--merge = iron: is one class; name two or more that count as one, e.g. aluminium,iron");
    for (const Arguments& option : {Arguments{"--epochs", "5"}, {"--neighbours", "5"},
                                    {"--folds", "3"}, {"--leak-check"}, {"--bins", "0:2"}})
        CHECK(folder.refusal(joined({"evaluate", "m.json", "b.h5"}, option)) ==
              option.front() +
                  ": goes with --leave-out, and a trained model is judged as it is; leave the "
                  "option out");
    const std::string no_model =
        "b.h5: is a dataset (HDF5), not a model; a model (.json) belongs here";
    const std::string no_dataset =
        "m.json: is JSON such as a model, not a dataset; a dataset (.h5) belongs here";
    CHECK(folder.refusal({"evaluate", "b.h5", "m.json"}) == no_model);
    CHECK(folder.refusal({"predict", "b.h5", "m.json"}) == no_model);
    CHECK(folder.refusal({"evaluate", "m.json", "m.json"}) == no_dataset);
    CHECK(folder.refusal({"train", "m.json", "-o", "x.json"}) == no_dataset);
    CHECK(folder.refusal({"evaluate", "m.json", "--leave-out", "frame"}) == no_dataset);
}

TEST_CASE("an option that does nothing without another is refused", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    const Arguments train{"train", "a.h5", "-o", "x.json"};
    CHECK(folder.refusal(joined(train, {"--held-out", "0.5"})) ==
          "--held-out: goes with --patience, or of specula train with --holdout session, and holds "
          "nothing out alone; add one or leave it out");
    CHECK(folder.refusal({"evaluate", "a.h5", "--leave-out", "frame", "--held-out", "0.5"})
              .rfind("--held-out: goes with --patience", 0) == 0);
    CHECK(folder.refusal(joined(train, {"--kernel", "5"})) ==
          "--kernel: goes with --convolution; add it or leave --kernel out");
    CHECK(folder.refusal({"export", "model", "m.json", "--blob", "x.rfwm", "--symbol", "lab"}) ==
          "--symbol: goes with --c, whose array it names; add --c FILE");
    CHECK(folder.refusal({"export", "model", "m.json", "--onnx", "x", "--arithmetic", "int8"}) ==
          "--arithmetic: goes with --blob or --c, and ONNX is always float; leave it out");
    for (const std::string word : {"int", "static_assert", "main"})
        CHECK(folder.refusal({"export", "model", "m.json", "--c", "x.c", "--symbol", word}) ==
              "name = " + word + ": means something in C already; use another, e.g. " + word +
                  "_model");
}

TEST_CASE("an output that cannot be is told with status 2 before the work", "[program][learning]") {
    const LearningFolder folder;
    folder.run(joined({"train", "a.h5", "-o", "m.json"}, quick_training));
    for (const Arguments& command : {Arguments{"train", "a.h5", "-o"}, {"predict", "m.json", "b.h5", "-o"},
                                     {"evaluate", "m.json", "b.h5", "--json"}}) {
        const std::string form = command.front() == "predict" ? "x.csv" : "x.json";
        CHECK(folder.refusal(joined(command, {"b.h5/" + form})) ==
              "b.h5: cannot create: Not a directory; give another place");
        CHECK(folder.refusal(joined(command, {"/proc/" + form})) ==
              "/proc/" + form + ": cannot create: No such file or directory; give another place");
    }
    CHECK(folder.refusal({"evaluate", "m.json", "b.h5", "--figure", "a.h5"}) ==
          "a.h5: cannot create: Not a directory; give another place");
}

}  // namespace
}  // namespace specula
