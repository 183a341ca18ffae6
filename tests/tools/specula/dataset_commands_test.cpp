#include <cmath>
#include <set>

#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/hdf5_file.hpp"
#include "sim/dataset/sha256.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/run_program.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

// The commands on dataset files, from outside.

namespace specula {
namespace {

/// A dataset as a board gives it: 12 frames of an echo in noise, in four sessions of two classes.
Dataset board(std::size_t n_frames = 12) {
    Stream stream({.seed = 5, .purpose = "board"});
    Dataset dataset;
    dataset.origin = {.condition = "desk",
                      .experiment = "title = 'desk'\n",
                      .seed = 1,
                      .version = "1.0",
                      .radar = "iwrl6432boost",
                      .bin_m = 0.0390354,
                      .recipe = ""};
    dataset.class_names = {"iron", "wood"};
    dataset.n_chirps = 1;
    dataset.n_rx = 3;
    dataset.n_samples = 128;
    for (std::size_t i = 0; i < n_frames; ++i) {
        Truth truth;
        truth.session = truth.sample = static_cast<std::int32_t>(i / 3);
        truth.label = static_cast<std::uint8_t>(truth.session % 2);
        truth.frame = static_cast<std::int32_t>(i % 3);
        truth.height_m = 0.44 + 0.002 * static_cast<double>(i);
        dataset.truth.push_back(truth);
        for (int k = 0; k < 3 * 128; ++k)
            dataset.adc.push_back(static_cast<std::int16_t>(
                300.0 * std::cos(0.566 * (k % 128) + 0.1 * static_cast<double>(i)) +
                4.0 * stream.normal()));
    }
    return dataset;
}

struct Bench {
    Bench() { write_dataset(folder / "a.h5", board()); }
    Ended run(std::vector<std::string> arguments) const {
        return specula_in(folder.path(), std::move(arguments));
    }
    const MadeUpFolder folder;
};

TEST_CASE("diff ends with 0, 1 or 2 and names frame, field and values", "[program][diff]") {
    const Bench bench;
    Dataset changed = board();
    changed.adc[5 * 384 + 128 + 7] = 1234;
    write_dataset(bench.folder / "b.h5", changed);
    const Ended same = bench.run({"diff", "a.h5", "a.h5"});
    CHECK(same.status == 0);
    CHECK(same.output == "the same: 12 frames\n");
    const Ended other = bench.run({"diff", "a.h5", "b.h5"});
    CHECK(other.status == 1);
    CHECK(contains(other.output, "first difference: frame 5, /adc[5, 0, 1, 7]: "));
    CHECK(contains(other.output, "against 1234 LSB"));
    CHECK(contains(other.output, "1 of 12 frames differ"));
    CHECK(bench.run({"diff", "a.h5", "b.h5", "--ignore", "/adc,/frame_hash"}).status == 0);
    for (const auto& [file, problem] : {std::pair{"none.h5", "none.h5: no such file"},
                                        {".", ".: is a folder without index.h5"}}) {
        const Ended bad = bench.run({"diff", "a.h5", file});
        CHECK(bad.status == 2);
        CHECK(contains(bad.errors, problem));
        CHECK(bad.output.empty());
    }
    CHECK(bench.run({"diff", "a.h5", "b.h5", "--lsb", "-1"}).status == 2);
}

TEST_CASE("show prints distributions of a dataset and draws them", "[program][show]") {
    const Bench bench;
    const Ended shown = bench.run({"show", "a.h5", "--figure", "f.svg"});
    CHECK(shown.status == 0);
    CHECK(contains(shown.output, "12 frames x 1 chirps x 3 RX x 128 samples"));
    CHECK(
        contains(shown.output, "iron                        6 frames of    2 samples,     2 sess"));
    CHECK(contains(shown.output, "\nheight (mm)\n"));
    CHECK(contains(shown.output, "\nSNR (dB)\n"));
    CHECK(contains(shown.output, "sample tilt: 0 deg in all 12 frames"));
    CHECK(contains(shown.output, "\nWrote f.svg\n"));
    const std::string svg = content_of(bench.folder / "f.svg");
    for (const char* text : {"iron (6)", "wood (6)", "height (mm), frames", "range bin"})
        CHECK(contains(svg, text));
    CHECK(bench.run({"show", "a.h5", "--figure", "folder"}).status == 0);
    for (const char* kind : {".svg", ".png", ".csv"})
        CHECK(std::filesystem::exists(bench.folder / ("folder/dataset" + std::string(kind))));
}

TEST_CASE("augment keeps groups, notes what it drew, and does not depend on threads",
          "[program][augment]") {
    const Bench bench;
    const std::vector<std::string> work{"augment", "a.h5",      "--copies", "2",
                                        "--step",  "noise=0:3", "--step",   "range=-20:20",
                                        "--step",  "gain=-1:1", "--seed",   "9"};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = work;
        all.insert(all.end(), more.begin(), more.end());
        return bench.run(all);
    };
    const Ended done = with({"-o", "b.h5", "-j", "1"});
    INFO(done.errors);
    REQUIRE(done.status == 0);
    CHECK(contains(done.output, "Wrote b.h5: 36 frames of 12"));
    REQUIRE(with({"-o", "c.h5", "-j", "2"}).status == 0);
    CHECK(bytes_of(bench.folder / "b.h5") == bytes_of(bench.folder / "c.h5"));

    const Dataset before = board(), after = read_dataset(bench.folder / "b.h5");
    const Hdf5File in = Hdf5File::open(bench.folder / "b.h5");
    const auto source = in.read<double>("/augmentation/source_frame");
    const auto copy = in.read<double>("/augmentation/copy");
    const auto moved_m = in.read<double>("/augmentation/2_range_m");
    const auto gain_db = in.read<double>("/augmentation/3_gain_db");
    CHECK(in.text("/augmentation", "seed") == "9");
    REQUIRE(after.n_frames() == 36);
    std::set<double> drawn;
    for (std::size_t i = 0; i < 36; ++i) {
        const Truth& own = before.truth[i / 3];
        CHECK(source[i] == static_cast<double>(i / 3));
        CHECK(copy[i] == static_cast<double>(i % 3));
        CHECK(after.truth[i].session == own.session);
        CHECK(after.truth[i].sample == own.sample);
        CHECK(after.truth[i].label == own.label);
        CHECK(after.truth[i].height_m == Approx(own.height_m + moved_m[i]));
        CHECK(after.truth[i].gain_db == Approx(gain_db[i]));
        CHECK(std::abs(moved_m[i]) <= 0.02);
        if (copy[i] > 0) drawn.insert(gain_db[i]);
        if (copy[i] == 0)
            CHECK(std::equal(&after.adc[i * 384], &after.adc[i * 384] + 384,
                             &before.adc[i / 3 * 384]));
    }
    CHECK(drawn.size() == 24);  // no two copies alike
    CHECK(contains(bench.run({"show", "b.h5"}).output, "\naugmented: changed copies"));
    CHECK(contains(done.output, "Beside it b.DATASHEET.md and b.croissant.json\n"));
    CHECK(contains(content_of(bench.folder / "b.DATASHEET.md"), "changed by `specula augment`"));
    CHECK(contains(content_of(bench.folder / "b.croissant.json"),
                   sha256_of_file(bench.folder / "b.h5")));
    CHECK(contains(content_of(bench.folder / "c.DATASHEET.md"), "# Datasheet of c.h5"));
}

TEST_CASE("augment takes a recipe, features alone, and says what it cannot do",
          "[program][augment]") {
    const Bench bench;
    Dataset features = board();
    features.n_samples = features.n_chirps = features.n_rx = 0;
    features.adc.clear();
    features.feature_names = {"bin 8", "bin 9", "bin 10", "bin 11", "bin 12", "bin 13"};
    for (std::size_t i = 0; i < features.n_frames(); ++i)
        for (const double value : {20.0, 80.0, 200.0, 300.0, 190.0, 60.0})
            features.features.push_back(value + static_cast<double>(i));
    write_dataset(bench.folder / "features.h5", features);
    bench.folder.with(
        "r.toml",
        "[[step]]\nkind = \"gain\"\ngain_db = 6.0206\n"
        "[[step]]\nkind = \"shift\"\ndistance_mm = { uniform = [39.0354, 39.0355] }\n");
    const Ended done = bench.run(
        {"augment", "features.h5", "-o", "out.h5", "--recipe", "r.toml", "--without-originals"});
    INFO(done.errors);
    REQUIRE(done.status == 0);
    const Dataset after = read_dataset(bench.folder / "out.h5");
    REQUIRE(after.n_frames() == 12);
    CHECK(after.features[4] == Approx(2.0 * 300.0).epsilon(1e-3));  // bin 12 has what bin 11 had

    bench.folder.with("bad.toml", "[[step]]\nkind = \"gain\"\ngain_db = 99\n");
    for (const auto& [arguments, problem] :
         {std::pair{std::vector<std::string>{"--step", "jam=3"}, "--step jam=3: is no step"},
          {{"--recipe", "bad.toml"}, "bad.toml:3: step.gain_db = 99"},
          {{}, "give either --recipe or one --step or more"},
          {{"--step", "range=-400"}, "to within 3 range bins"},
          {{"--step", "range=5000"}, "beyond the farthest range of the chirp"},
          {{"--step", "gain=1", "--radar", "nobody"}, "radar = \"nobody\": is not known"}}) {
        std::vector<std::string> all{"augment", "a.h5", "-o", "new/none.h5"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Ended bad = bench.run(all);
        INFO(bad.errors);
        CHECK(bad.status == 2);
        CHECK(contains(bad.errors, problem));
        CHECK_FALSE(std::filesystem::exists(bench.folder / "new"));
    }
    CHECK(bench.run({"augment", "a.h5", "-o", "new/deep/b.h5", "--step", "gain=1"}).status == 0);
    const Ended too_long =
        bench.run({"augment", "a.h5", "-o", std::string(300, 'x'), "--step", "gain=1"});
    CHECK(too_long.status == 2);
    CHECK(contains(too_long.errors, "xx: cannot create: File name too long; give another place"));
    CHECK(std::filesystem::exists(bench.folder / "new/deep/b.h5"));
    CHECK(contains(bench.run({"augment", "a.h5", "-o", "a.h5", "--step", "gain=1"}).errors,
                   "a.h5: is the dataset itself"));
    std::filesystem::copy_file(bench.folder / "a.h5", bench.folder / "taken.h5");
    const Ended over = bench.run({"augment", "a.h5", "-o", "taken.h5", "--step", "gain=1"});
    CHECK(over.status == 2);
    CHECK(contains(over.errors, "taken.h5: is there already"));
}

TEST_CASE("a picture in a format that nobody writes is refused before the file is read",
          "[program][show]") {
    const Bench bench;
    for (const char* name : {"x.jpg", "x.pdf", "deep/x.SVG"}) {
        const Ended bad = bench.run({"show", "a.h5", "--figure", name});
        INFO(bad.errors);
        CHECK(bad.status == 2);
        CHECK(contains(bad.errors, std::string("--figure ") + name + ": no figure is written as ."));
        CHECK(bad.output.empty());
        CHECK_FALSE(std::filesystem::exists(bench.folder / name));
    }
    CHECK(bench.run({"show", "plexiglass", "--figure", "x.png"}).status == 2);
    CHECK(contains(bench.run({"show", "a.h5", "--figure", ""}).errors, "--figure: is empty; name a"));
    CHECK(bench.run({"show", "a.h5", "--figure", "v1.2"}).status == 0);  // a folder
    CHECK(std::filesystem::is_directory(bench.folder / "v1.2"));
}

TEST_CASE("an output that is a device, or nothing, is refused as such", "[program]") {
    const Bench bench;
    for (const std::string command : {"augment", "merge", "generate"}) {
        std::vector<std::string> arguments{command, command == "generate" ? "paper" : "a.h5"};
        if (command == "augment") arguments.insert(arguments.end(), {"--step", "gain=1"});
        auto with_out = [&](const std::string& out) {
            std::vector<std::string> all = arguments;
            all.insert(all.end(), {"-o", out});
            return bench.run(all);
        };
        const Ended empty = with_out("");
        INFO(empty.errors);
        CHECK(empty.status == 2);
        CHECK(contains(empty.errors, "--out: is empty; name a file or a folder"));
        if (command == "merge") continue;  // looks at its inputs first
        const Ended device = with_out("/dev/full");
        INFO(device.errors);
        CHECK(device.status == 2);
        CHECK(contains(device.errors, "/dev/full: is there, and is no file; give another name"));
    }
    CHECK(std::distance(std::filesystem::directory_iterator(bench.folder.path()), {}) == 1);
}

TEST_CASE("export writes a datasheet and Croissant beside a dataset", "[program][documents]") {
    const Bench bench;
    for (const char* what : {"datasheet", "croissant"}) {
        const Ended done = bench.run({"export", what, "a.h5"});
        INFO(done.errors);
        CHECK(done.status == 0);
    }
    CHECK(contains(content_of(bench.folder / "a.DATASHEET.md"), "# Datasheet of a.h5"));
    CHECK(contains(content_of(bench.folder / "a.croissant.json"), "\"contentUrl\": \"a.h5\""));
    CHECK(bench.run({"export", "croissant", "none.h5"}).status == 2);
}

}  // namespace
}  // namespace specula
