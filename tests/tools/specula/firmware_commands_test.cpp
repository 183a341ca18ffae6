#include <cstdlib>

#include "classifier/measurement.hpp"
#include "classifier/model_file.hpp"
#include "scenes/catalogue.hpp"
#include "sim/core/error.hpp"
#include "sim/dataset/dataset.hpp"
#include "tests/check.hpp"
#include "tests/classifier/whole_model.hpp"
#include "tests/contains.hpp"
#include "tests/run_program.hpp"
#include "tools/firmware/process.hpp"
#include "tools/firmware/target_build.hpp"

// The firmware's commands as their user meets them.

namespace specula {
namespace {

const std::filesystem::path runner =
    std::filesystem::path(SPECULA_BINARY).parent_path() / "fw_runner";

/// A model of whole_model's shape that was trained on what the catalogue's IWRL6432BOOST sees.
Model model_of_board() {
    const Catalogue catalogue = Catalogue::open(SPECULA_SOURCE_DIR);
    Model model = whole_model();
    model.extractor = "range_bins";
    model.provenance = {{"descriptor", "range_bins 6 12 blackman"}};
    model.measurement =
        measurement_of(catalogue.radar_called("iwrl6432boost"), model.measurement->descriptor);
    return model;
}

/// A simulated plate twice, as first frames of two sessions, and a second frame of other codes.
Dataset three_frames(const std::filesystem::path& folder) {
    const std::string plate = SPECULA_SOURCE_DIR "/scenes/examples/metal_plate.toml";
    REQUIRE(specula_in(folder, {"simulate", plate, "-o", "plate.h5"}).status == 0);
    Dataset dataset = read_dataset(folder / "plate.h5");
    const std::vector<std::int16_t> codes = dataset.adc;
    const Truth truth = dataset.truth.front();
    for (std::int32_t frame = 0; frame < 2; ++frame) {
        for (const std::int16_t code : codes)
            dataset.adc.push_back(static_cast<std::int16_t>(frame == 0 ? code : code / 3));
        dataset.truth.push_back(truth);
        dataset.truth.back().session = truth.session + 1;
        dataset.truth.back().frame = frame;
    }
    write_dataset(folder / "three.h5", dataset);
    return dataset;
}

Ended run_runner(const std::filesystem::path& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), runner.string());
    return run_program({.arguments = std::move(arguments), .folder = folder});
}

TEST_CASE("an exported UART stream is the firmware's, byte for byte", "[program][firmware]") {
    const MadeUpFolder folder;
    Model model = model_of_board();
    const auto [window, word] = GENERATE(table<fw_window, std::string>(
        {{FW_WINDOW_BLACKMAN, "blackman"}, {FW_WINDOW_HANN, "hann"}, {FW_WINDOW_RECT, "rect"}}));
    model.measurement->descriptor.window = window;
    model.provenance = {{"descriptor", "range_bins 6 12 " + word}};
    write_model(model, folder / "m.json");
    three_frames(folder.path());
    const auto run = [&](const std::vector<std::string>& arguments) {
        const Ended ended = specula_in(folder.path(), arguments);
        INFO(ended.errors);
        CHECK(ended.status == 0);
    };
    run({"export", "uart", "three.h5", "--model", "m.json", "-o", "ours.uart"});
    run({"export", "injection", "three.h5", "-o", "frames.bin"});
    run({"export", "model", "m.json", "--blob", "m.rfwm"});
    CHECK(
        run_runner(folder.path(), {"run", "m.rfwm", "frames.bin", "records", "chip.uart"}).status ==
        0);
    const std::string ours = content_of(folder / "ours.uart");
    CHECK(ours.size() == 3 * 352);
    CHECK((ours == content_of(folder / "chip.uart")));
}

TEST_CASE("the runner complains of frames cut short, frames too many, and repeats that are none",
          "[program][firmware]") {
    const MadeUpFolder folder;
    write_model(model_of_board(), folder / "m.json");
    three_frames(folder.path());
    REQUIRE(specula_in(folder.path(), {"export", "injection", "three.h5", "-o", "f.bin"}).status ==
            0);
    REQUIRE(specula_in(folder.path(), {"export", "model", "m.json", "--blob", "m.rfwm"}).status ==
            0);
    const std::string frames = content_of(folder / "f.bin");
    folder.with("cut.bin", frames.substr(0, frames.size() - 2));
    folder.with("head.bin", frames.substr(0, 20));
    folder.with("long.bin", frames + "x");
    for (const auto& [arguments, complaint] :
         std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"run", "m.rfwm", "cut.bin", "r", "u"}, "cut.bin: ends before the last frame"},
             {{"run", "m.rfwm", "long.bin", "r", "u"}, "long.bin: goes on behind the last frame"},
             {{"bench", "m.rfwm", "head.bin", "5"}, "head.bin: ends inside its first frame"},
             {{"bench", "m.rfwm", "f.bin", "5x"}, "5x: is no number of repeats"},
             {{"bench", "m.rfwm", "f.bin", ""}, ": is no number of repeats"},
             {{"bench", "m.rfwm", "f.bin", "0"}, "0: is no number of repeats"},
             {{"bench", "m.rfwm", "f.bin", "123456"}, "123456: is no number of repeats"}}) {
        const Ended ended = run_runner(folder.path(), arguments);
        INFO(complaint);
        CHECK(ended.status == 2);
        CHECK(contains(ended.output, "fw_runner: " + complaint));
    }
    CHECK(run_runner(folder.path(), {"bench", "m.rfwm", "f.bin", "2"}).status == 0);
}

TEST_CASE("a model is refused where another chirp or shape made the frames",
          "[program][firmware]") {
    const MadeUpFolder folder;
    three_frames(folder.path());
    const auto refused = [&](auto change, const std::string& message) {
        Model model = model_of_board();
        change(*model.measurement);
        write_model(model, folder / "other.json");
        for (const auto& arguments : std::vector<std::vector<std::string>>{
                 {"export", "uart", "three.h5", "--model", "other.json", "-o", "out.uart"},
                 {"verify-firmware", "three.h5", "other.json"}}) {
            const Ended ended = specula_in(folder.path(), arguments);
            INFO(ended.errors);
            CHECK(ended.status == 2);
            CHECK(contains(ended.errors, message));
            CHECK(contains(ended.errors, "three.h5: "));
            CHECK_FALSE(std::filesystem::exists(folder / "out.uart"));
        }
    };
    refused([](Measurement& m) { m.chirp.n_samples = 256; },
            "samples per chirp = 128: the model was trained on 256");
    refused([](Measurement& m) { m.chirp.n_rx = 1; }, "antennas = 3: the model was trained on 1");
    refused([](Measurement& m) { m.chirp.slope_khz_us += 29; }, "slope_khz_us = ");
    refused([](Measurement& m) { m.chirp.gain_db_100 -= 200; }, "gain_db_100 = ");
}

TEST_CASE("export model gives every output a file and every C array a name of its own",
          "[program][firmware]") {
    const MadeUpFolder folder;
    write_model(model_of_board(), folder / "m.json");
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"export", "model", "m.json"});
        return specula_in(folder.path(), arguments);
    };
    const Ended twice = run({"--blob", "same", "--onnx", "./same"});
    CHECK(twice.status == 2);
    CHECK(contains(twice.errors, "--onnx = ./same: is the file of --blob too"));
    CHECK_FALSE(std::filesystem::exists(folder / "same"));
    CHECK(run({"--c", "Bench-2.c"}).status == 0);
    CHECK(contains(content_of(folder / "Bench-2.c"), "const size_t fw_model_bench_2_bytes = "));
    CHECK(run({"--c", "b.c", "--symbol", "lab"}).status == 0);
    CHECK(contains(content_of(folder / "b.c"), "const unsigned char lab["));
    CHECK(run({"--c", "d.c", "--symbol", "two words"}).status == 2);
    const std::string both = "cd '" + folder.path().string() +
                             "' && cc -c Bench-2.c b.c && "
                             "echo 'extern const char fw_model_bench_2[], lab[]; int main(void) "
                             "{ return fw_model_bench_2[0] != lab[0]; }' > main.c && "
                             "cc main.c Bench-2.o b.o -o linked && ./linked";
    CHECK(std::system(both.c_str()) == 0);
}

TEST_CASE("verify-firmware tells how it is to train where it trains, and only there",
          "[program][firmware]") {
    const MadeUpFolder folder;
    three_frames(folder.path());
    write_model(model_of_board(), folder / "m.json");
    const auto refused = [&](std::vector<std::string> arguments, const std::string& message) {
        arguments.insert(arguments.begin(), {"verify-firmware", "three.h5"});
        const Ended ended = specula_in(folder.path(), arguments);
        INFO(ended.errors);
        CHECK(ended.status == 2);
        CHECK(contains(ended.errors, message));
    };
    refused({"m.json", "--hidden", "8"}, "m.json: is trained already; leave out --descriptor");
    refused({"--descriptor", "nonsense"}, "descriptor = \"nonsense\": begins with none of");
    refused({"--descriptor", "relative_profile 6 12 blackman align 12 range 12 search 5 20"},
            "train on peak_shape");
}

TEST_CASE("a model without a measurement is told what is missing, by every command the same",
          "[program][firmware]") {
    const MadeUpFolder folder;
    three_frames(folder.path());
    Model model = model_of_board();
    model.measurement.reset();
    write_model(model, folder / "old.json");
    for (const auto& arguments :
         std::vector<std::vector<std::string>>{{"export", "model", "old.json", "--blob", "x"},
                                               {"verify-firmware", "three.h5", "old.json"}}) {
        const Ended ended = specula_in(folder.path(), arguments);
        CHECK(ended.status == 2);
        CHECK(contains(ended.errors, "old.json: measurement: is missing"));
        CHECK(contains(ended.errors, "specula study"));
    }
}

TEST_CASE("a build for the chip that was moved or copied is configured anew", "[firmware]") {
    const MadeUpFolder folder;
    const auto home = folder / "home", build = folder / "build";
    const auto configured = [&](const std::filesystem::path& of, const std::filesystem::path& in) {
        folder.with("build/CMakeCache.txt", "CMAKE_CACHEFILE_DIR:INTERNAL=" + in.string() +
                                                "\nCMAKE_HOME_DIRECTORY:INTERNAL=" + of.string() +
                                                "\n");
        folder.with("build/build.ninja", "x");
        folder.with("build/CMakeFiles/x", "x");
    };
    std::filesystem::create_directories(home);
    std::filesystem::create_directory_symlink(home, folder / "link");
    for (const auto& own : {home, folder / "link"}) {
        configured(own, build);
        forget_build_of_another_place(home, build);
        CHECK(n_entries(build) == 3);
    }
    for (const auto& [of, in] : {std::pair{folder / "gone", build}, {home, folder / "gone"}}) {
        configured(of, in);
        forget_build_of_another_place(home, build);
        CHECK(n_entries(build) == 0);
    }
}

TEST_CASE("a missing program is named with its package or, having none, with the remedy",
          "[firmware]") {
    const auto complaint = [](const Command& command) {
        try {
            return output_of(command);
        } catch (const SystemError& error) {
            return std::string(error.what());
        }
    };
    CHECK(complaint({{"/none/nm"}, {}, "binutils"}) ==
          "/none/nm: program not found; install binutils (apt-get install binutils)");
    CHECK(complaint({{"/none/nm"}, {}, {}, "build it"}) ==
          "/none/nm: program not found; build it");
}

}  // namespace
}  // namespace specula
