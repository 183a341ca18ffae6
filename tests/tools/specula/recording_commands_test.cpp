#include <algorithm>

#include "sim/dataset/dataset.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/run_program.hpp"

// import, export, train and evaluate as their user meets them.

namespace specula {
namespace {

/// Three classes of four boards, two sides, five frames: the class is in x, the board in y.
std::string table() {
    std::string text = "class,sample,view,x,y\n";
    for (int c = 0; c < 3; ++c)
        for (int board = 0; board < 4; ++board)
            for (int view = 0; view < 2; ++view)
                for (int i = 0; i < 5; ++i)
                    text += std::string(1, static_cast<char>('a' + c)) + "," +
                            std::to_string(board) + "," + std::to_string(view) + "," +
                            std::to_string(c + 0.01 * i + 0.02 * view) + "," +
                            std::to_string(4 * c + board + 0.01 * i) + "\n";
    return text;
}

TEST_CASE("a table goes from import to a judged model", "[program][recording]") {
    const MadeUpFolder folder;
    folder.with("boards.csv", table());
    const auto run = [&](const std::vector<std::string>& arguments) {
        const Ended ended = specula_in(folder.path(), arguments);
        INFO(ended.errors);
        CHECK(ended.status == 0);
        return ended.output;
    };
    CHECK(contains(run({"import", "boards.csv"}), "120 frames of 3 classes\nWrote boards.h5"));
    const std::string shown = run({"show", "boards.h5"});
    CHECK(contains(shown, "120 frames of 2 features"));
    CHECK(contains(shown, "12 samples, 24 sessions, 2 views"));
    CHECK(contains(shown, "no truth beyond the class is known"));
    const std::string trained =
        run({"train", "boards.h5", "-o", "m.json", "--epochs", "200", "--hidden", "8"});
    CHECK(contains(trained, "descriptor columns 0 2"));
    CHECK(contains(run({"evaluate", "m.json", "boards.h5"}), "accuracy 100.0 %, macro-F1 100.0 %"));
    const std::string judged =
        run({"evaluate", "boards.h5", "--leave-out", "frame,object", "--leak-check", "--epochs",
             "200", "--hidden", "8", "--folds", "4", "--repeats", "1"});
    CHECK(contains(judged, "left out"));
    CHECK(contains(judged, "\nframe "));
    CHECK(contains(judged, "\nobject "));
    CHECK(contains(judged, "33 % is chance"));
}

TEST_CASE("a simulated chirp leaves for a board and comes back the same", "[program][recording]") {
    const MadeUpFolder folder;
    const std::string plate = SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml";
    REQUIRE(specula_in(folder.path(), {"simulate", plate, "-o", "a.h5"}).status == 0);
    const Dataset given = read_dataset(folder / "a.h5");
    for (const std::string format : {"injection", "rdif", "infineon", "npy", "adc", "dca1000"}) {
        INFO(format);
        const Ended out = specula_in(folder.path(), {"export", format, "a.h5", "-o", format});
        INFO(out.errors);
        REQUIRE(out.status == 0);
        REQUIRE(specula_in(folder.path(), {"import", format, format, "-o", "b.h5"}).status == 0);
        const Dataset back = read_dataset(folder / "b.h5");
        CHECK(back.adc == given.adc);
        CHECK(back.class_names == given.class_names);
        CHECK(back.origin.bin_m == given.origin.bin_m);
    }
    REQUIRE(specula_in(folder.path(), {"export", "uart", "a.h5", "-o", "u.bin"}).status == 0);
    REQUIRE(specula_in(folder.path(), {"import", "uart", "u.bin", "-o", "u.h5"}).status == 0);
    REQUIRE(specula_in(folder.path(), {"export", "uart", "u.h5", "-o", "v.bin"}).status == 0);
    const bool same = content_of(folder / "u.bin") == content_of(folder / "v.bin");
    CHECK(same);
    // The strongest bin behind the leakage is that of the plate, 11.5 bins away.
    const Dataset profile = read_dataset(folder / "u.h5");
    REQUIRE(profile.feature_names.size() == 64);
    const auto strongest = std::max_element(profile.features.begin() + 9, profile.features.end()) -
                           profile.features.begin();
    CHECK((strongest == 11 || strongest == 12));
}

TEST_CASE("what cannot be imported leaves nothing behind", "[program][recording]") {
    const MadeUpFolder folder;
    folder.with("a.bin", "0123456789");
    folder.with("a.toml", "[layout]\nrx = 1\nsamples = 4\n");
    folder.with("a.npy", "\x93NUMPY");
    for (const auto& [arguments, message] :
         std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"import", "a.bin"}, "a.bin: its name does not tell its format; put one of "},
             {{"import", "none.csv"}, "none.csv: no such file or folder; check the path"},
             {{"import", "wav", "a.bin"}, "\"wav\": no such format; use \"adc\""},
             {{"import", "adc", "a.bin", "--manifest", "a.toml"},
              "a.bin: byte 8: the data end inside frame 1; is the file whole"},
             {{"import", "uart", "a.bin"}, "a.bin: byte 0: of 0 packets none has a range profile"},
             {{"import", "npz", "a.bin"}, "a.bin: byte 10: no ZIP directory ends here"},
             {{"import", "a.npy"}, "a.npy: byte 6: the data end inside the version"},
             {{"export", "adc", "a.bin", "-o", "x"}, "a.bin: file: cannot be opened as HDF5"},
             {{"evaluate", "a.h5"}, "name a model and a dataset, or a dataset with --leave-out"},
             {{"train", "a.h5", "-o", "m.json"}, "a.h5: no such file; check the path"}}) {
        const Ended ended = specula_in(folder.path(), arguments);
        INFO(ended.errors);
        CHECK(ended.status == 2);
        CHECK(ended.errors.rfind("specula: error: " + message, 0) == 0);
        CHECK(ended.errors.find('\n') == ended.errors.size() - 1);
        CHECK(n_entries(folder.path()) == 3);
    }
}

}  // namespace
}  // namespace specula
