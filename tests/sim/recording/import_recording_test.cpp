#include "sim/recording/import_recording.hpp"

#include "sim/recording/npy_array.hpp"
#include "tests/check.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/project_catalogue.hpp"

// From files and a manifest to a dataset: layouts, labels, and what is refused.

namespace specula {
namespace {

RecordingManifest manifest(const std::string& text) {
    return read_manifest(Section::parse(text, "m.toml"), catalogue());
}

std::string codes(std::size_t n) {
    std::string bytes;
    for (std::size_t i = 0; i < n; ++i) append_number(bytes, i, 2);
    return bytes;
}

Dataset imported(const std::string& format, const std::string& content,
                 const std::string& manifest_text) {
    const MadeUpFolder folder;
    return import_recording(format, folder.with("r", content), manifest(manifest_text)).dataset;
}

std::string import_refusal(const std::string& format, const std::string& content,
                           const std::string& manifest_text) {
    const MadeUpFolder folder;
    const auto file = folder.with("r", content);
    const std::string message = message_of(
        [&] { return import_recording(format, file, manifest(manifest_text)).notes.size(); });
    REQUIRE(message.rfind(file.string() + ": ", 0) == 0);
    return message.substr(file.string().size() + 2);
}

TEST_CASE("a flat file is read in the order its manifest declares", "[recording]") {
    const Dataset dataset = imported("adc", codes(24),
                                     "condition = 'desk'\nrange_bin_mm = 23.4\n[layout]\n"
                                     "axes = ['frame', 'sample', 'rx']\nrx = 2\nsamples = 4\n");
    CHECK(dataset.n_frames() == 3);
    CHECK(dataset.n_rx == 2);
    CHECK(dataset.adc == std::vector<std::int16_t>{0, 2,  4,  6,  1,  3,  5,  7,  8,  10, 12, 14,
                                                   9, 11, 13, 15, 16, 18, 20, 22, 17, 19, 21, 23});
    CHECK(dataset.origin.condition == "desk");
    CHECK(dataset.origin.bin_m == Approx(0.0234));
    CHECK(dataset.class_names == std::vector<std::string>{"unlabelled"});
    CHECK(dataset.unknown_truth.all());
    CHECK(dataset.truth[2].frame == 2);
}

TEST_CASE("a radar of the catalogue says the layout", "[recording]") {
    const Radar radar = read_radar(SPECULA_SOURCE_DIR "/scenes/radars/iwrl6432boost.toml");
    const auto n = static_cast<std::size_t>(radar.chirp.n_samples) * radar.rx.size() *
                   static_cast<std::size_t>(radar.chirps_per_frame);
    const Dataset dataset = imported("adc", codes(2 * n), "radar = 'iwrl6432boost'");
    CHECK(dataset.n_frames() == 2);
    CHECK(dataset.n_samples == radar.chirp.n_samples);
    CHECK(dataset.origin.bin_m == radar.chirp.bin_m());
}

TEST_CASE("parts label frames, and truth is known where all parts know it", "[recording]") {
    const std::string layout = "[layout]\nrx = 1\nsamples = 2\n";
    const std::string parts =
        "class_names = ['wood', 'iron']\npart = [\n"
        " {frames = [0, 1], class = 'iron', sample = 4, session = 7, height_mm = 450, bow_m = 0},\n"
        " {frames = [2, 3], class = 'wood', sample = 5, session = 9, height_mm = 300}]\n";
    const Dataset dataset = imported("adc", codes(8), parts + layout);
    CHECK(dataset.class_names == std::vector<std::string>{"wood", "iron"});
    CHECK(dataset.truth[0].label == 1);
    CHECK(dataset.truth[3].label == 0);
    CHECK(dataset.truth[3].session == 9);
    CHECK(dataset.truth[3].frame == 1);
    CHECK(dataset.truth[0].height_m == Approx(0.45));
    CHECK(dataset.truth[2].height_m == Approx(0.3));
    for (std::size_t k = 0; k < truth_columns.size(); ++k)
        CHECK(dataset.unknown_truth[k] == (std::string(truth_columns[k].name) != "height_m"));

    const Dataset longer = imported("adc", codes(10), parts + layout);
    CHECK(longer.class_names.back() == "unlabelled");
    CHECK(longer.truth[4].label == 2);
    CHECK(longer.unknown_truth.all());
    CHECK(import_refusal("adc", codes(6), parts + layout) ==
          "frames = [2, 3]: the recording has 3 frames; end at 2");
    CHECK(message_of([] {
              return manifest("class_names = ['wood', 'iron', 'wood']\n").condition;
          }).find("\"wood\" is there twice; give each class a name of its own") !=
          std::string::npos);
    CHECK(message_of([] {
              return manifest("class_names = ['wood', '']\n").condition;
          }).find("name 1 is empty; give each class a name of its own") != std::string::npos);
}

TEST_CASE("a sample's number in two classes names two pieces", "[recording]") {
    const Dataset dataset =
        imported("csv", "x,class,sample,view\n1,a,0,0\n2,a,1,0\n3,b,0,1\n4,b,1,1\n", "");
    CHECK(dataset.class_names == std::vector<std::string>{"a", "b"});
    std::vector<std::int32_t> samples, sessions;
    for (const Truth& truth : dataset.truth) {
        samples.push_back(truth.sample);
        sessions.push_back(truth.session);
    }
    CHECK(samples == std::vector<std::int32_t>{0, 1, 2, 3});
    CHECK(sessions == std::vector<std::int32_t>{0, 1, 2, 3});
    CHECK(dataset.has_views);
    CHECK(dataset.features == std::vector<double>{1, 2, 3, 4});
    CHECK(dataset.feature_names == std::vector<std::string>{"x"});
}

TEST_CASE("columns may have other names, and words for numbers", "[recording]") {
    const Dataset dataset =
        imported("csv", "f1;material;board;note;f2\n1;oak;A;x;5\n2;pine;B;y;6\n",
                 "[layout]\nfeatures = ['f2']\n"
                 "[labels]\nclass = 'material'\nsample = 'board'\n");
    CHECK(dataset.features == std::vector<double>{5, 6});
    CHECK(dataset.class_names == std::vector<std::string>{"oak", "pine"});
    CHECK(dataset.truth[1].sample == 1);
    CHECK(import_refusal("csv", "a,b\n1,x\n", "") ==
          "byte 4: b = \"x\": is not a finite number; write it as 1.5e-3");
    CHECK(import_refusal("csv", "a,b\n1,2\n", "[labels]\nclass = 'c'\n") ==
          "byte 0: no column is called \"c\"; use \"a\" or \"b\"");
}

TEST_CASE("arrays are read by their axes, wrapped codes on request", "[recording]") {
    std::string data;
    for (const unsigned code : {1u, 65535u, 40000u, 2u}) append_number(data, code, 2);
    const std::string array = write_npy("<u2", {2, 1, 2}, data);
    const std::string axes = "[layout]\naxes = ['frame', 'rx', 'sample']\n";
    CHECK(imported("npy", array, axes + "wrapped = true\n").adc ==
          std::vector<std::int16_t>{1, -1, -25536, 2});
    CHECK(import_refusal("npy", array, axes) ==
          "byte 130: 65535: is not an ADC code of 16 bits; if it stands for a negative one, say "
          "wrapped = true in [layout]");
    CHECK(import_refusal("npy", array, "").rfind("axes: 0 names for an array of 3 axes", 0) == 0);
}

TEST_CASE("a torn or unknown layout is refused", "[recording]") {
    CHECK(import_refusal("adc", codes(10), "[layout]\nrx = 2\nsamples = 4\n") ==
          "byte 16: the data end inside frame 1; is the file whole, and are the lengths right?");
    CHECK(import_refusal("adc", codes(10), "")
              .rfind("rx: its length is not known; give chirps, rx and samples", 0) == 0);
    CHECK(import_refusal("adc", "", "").rfind("is empty or cannot be read", 0) == 0);
    CHECK(import_refusal("uart", "garbage", "")
              .rfind("byte 0: of 0 packets none has a range profile", 0) == 0);
    const auto wrong = [](const std::string& text) {
        return message_of([&] { return manifest(text).parts.size(); });
    };
    CHECK(wrong("range_bin_mm = -1").find("m.toml:1: range_bin_mm = -1: ") == 0);
    CHECK(wrong("[layout]\nsampels = 4").find("m.toml:2: layout.sampels = 4: ") == 0);
    CHECK(wrong("part = [{frames = [0, 3], class = 'a'}, {frames = [3, 4], class = 'b'}]")
              .find("frame 3 belongs to two parts") != std::string::npos);
    CHECK(wrong("part = [{frames = [3, 2], class = 'a'}]").find("ends before it begins") !=
          std::string::npos);
}

}  // namespace
}  // namespace specula
