#include <cmath>
#include <fstream>

#include "sim/core/error.hpp"
#include "sim/dataset/dataset.hpp"
#include "sim/dataset/hdf5_file.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/hdf5_probe.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

// A file that is no dataset, or no longer one, is refused in one line that names it and the object
// that is wrong; nothing is read beyond what is there.

namespace specula {
namespace {

namespace fs = std::filesystem;

bool names(const std::string& message, const fs::path& file, const std::string& object) {
    return message.rfind(file.string() + ": ", 0) == 0 &&
           message.find(object) != std::string::npos && message.find('\n') == std::string::npos;
}

TEST_CASE("a missing file and a folder are refused by name", "[dataset]") {
    const TemporaryFolder folder;
    CHECK(names(refusal_of(folder / "none.h5"), folder / "none.h5", "no such file"));
    CHECK(names(refusal_of(folder.path()), folder.path(), "is no regular file"));
}

TEST_CASE("a file that is not HDF5 is refused", "[dataset]") {
    const TemporaryFolder folder;
    for (const std::string content : {"", "title = 5\n", "\x89HDF\r\n\x1a\n and then nothing"}) {
        std::ofstream(folder / "a.h5", std::ios::trunc) << content;
        CHECK(names(refusal_of(folder / "a.h5"), folder / "a.h5", "HDF5"));
    }
}

TEST_CASE("a file cut short is refused wherever the cut falls", "[dataset]") {
    const TemporaryFolder folder;
    write_dataset(folder / "whole.h5", made_up_dataset());
    const std::string whole = bytes_of(folder / "whole.h5");
    for (std::size_t kept = 0; kept < whole.size(); kept += 1 + whole.size() / 40) {
        std::ofstream(folder / "cut.h5", std::ios::binary | std::ios::trunc)
            << whole.substr(0, kept);
        INFO(kept << " of " << whole.size() << " bytes");
        CHECK(names(refusal_of(folder / "cut.h5"), folder / "cut.h5", ""));
    }
}

TEST_CASE("a flipped bit in the recordings is noticed", "[dataset]") {
    const TemporaryFolder folder;
    const Dataset dataset = made_up_dataset(60);
    write_dataset(folder / "whole.h5", dataset);
    const std::string whole = bytes_of(folder / "whole.h5");
    // Random codes do not get smaller, so a third of the file is chunks of /adc.
    int refused = 0, unharmed = 0, tried = 0;
    for (std::size_t at = 0; at < whole.size(); at += 307, ++tried) {
        std::string spoilt = whole;
        spoilt[at] = static_cast<char>(spoilt[at] ^ 0x10);
        std::ofstream(folder / "a.h5", std::ios::binary | std::ios::trunc) << spoilt;
        try {
            unharmed += read_dataset(folder / "a.h5").adc == dataset.adc;
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(refused + unharmed == tried);  // what is read is right, or nothing is read
    CHECK(refused > tried / 3);
}

TEST_CASE("another program's file is refused for what it lacks", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "foreign.h5";
    {
        Hdf5File out = Hdf5File::create(file);
        out.write<float>("/signal", {3}, 3, {1.0f, 2.0f, 3.0f});
        out.publish();
    }
    CHECK(names(refusal_of(file), file, "/@format: is missing"));
    {
        Hdf5File out = Hdf5File::create(file);
        out.set_text("/", "format", "somebody-elses");
        out.publish();
    }
    CHECK(names(refusal_of(file), file, "/@format: is not a dataset of this program"));
}

#ifdef SPECULA_TEST_HAS_HDF5

struct Damage {
    std::string what;
    std::function<void(Hdf5Probe&)> spoil;
    std::string named;  ///< what the message must name
};

std::vector<Damage> damages() {
    std::vector<Damage> list{
        {"no adc", [](Hdf5Probe& h5) { h5.remove("/adc"); }, "/adc: is missing"},
        {"a group as adc",
         [](Hdf5Probe& h5) {
             h5.remove("/adc");
             h5.add_group("/adc");
         },
         "/adc: is missing"},
        {"a version to come", [](Hdf5Probe& h5) { h5.put_numbers("/", "format_version", {4.0}); },
         "/@format_version = 4"},
        {"a version in between",
         [](Hdf5Probe& h5) { h5.put_numbers("/", "format_version", {1.5}); },
         "/@format_version = 1.5"},
        {"features said to be there",
         [](Hdf5Probe& h5) { h5.put_variable_text("/", "left_out", "/probability"); },
         "/@left_out: is not text of fixed length"},
        {"many versions",
         [](Hdf5Probe& h5) {
             h5.put_numbers("/", "format_version", std::vector<double>(100, 1.0));
         },
         "/@format_version: is not a number"},
        {"a version in words",
         [](Hdf5Probe& h5) { h5.put_variable_text("/", "format_version", "one"); },
         "/@format_version: is not a number"},
        {"text of variable length",
         [](Hdf5Probe& h5) { h5.put_variable_text("/", "radar", "toy"); },
         "/@radar: is not text of fixed length"},
        {"a number for a text", [](Hdf5Probe& h5) { h5.put_numbers("/", "condition", {1.0}); },
         "/@condition: is not text of fixed length"},
        {"adc of three axes",
         [](Hdf5Probe& h5) {
             h5.put_claim("/adc", {7, 2, 3});
         },
         "/adc: is not"},
        {"adc never written",
         [](Hdf5Probe& h5) {
             h5.put_claim("/adc", {7, 2, 3, 16});
         },
         "/adc: is larger than what the file holds"},
        {"adc of a billion frames",
         [](Hdf5Probe& h5) {
             h5.put_claim("/adc", {1u << 30, 2, 3, 16});
         },
         "/adc"},
        {"adc beyond all numbers",
         [](Hdf5Probe& h5) {
             h5.put_claim("/adc", {1ull << 40, 65535, 65535, 65535});
         },
         "/adc"},
        {"too many samples for a frame",
         [](Hdf5Probe& h5) {
             h5.put_claim("/adc", {1, 1, 1, 65536});
         },
         "/adc: is not"},
        {"labels of another type", [](Hdf5Probe& h5) { h5.put_claim("/label", {7}); },
         "/label: holds another type"},
    };
    for (const std::string column :
         {"/label", "/group/world", "/group/frame", "/truth/bow_m", "/frame_hash"})
        list.push_back(
            {"no " + column, [=](Hdf5Probe& h5) { h5.remove(column); }, column + ": is missing"});
    for (const std::string name :
         {"software_version", "condition", "experiment_toml", "seed", "radar", "range_bin_m",
          "class_names", "format_version", "source", "sample_axis", "left_out", "recipe"})
        list.push_back({"no " + name, [=](Hdf5Probe& h5) { h5.remove_attribute("/", name); },
                        "/@" + name + ": is missing"});
    return list;
}

TEST_CASE("each object that is missing or of another kind is named", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.h5";
    for (const Damage& damage : damages()) {
        write_dataset(file, made_up_dataset());
        {
            Hdf5Probe h5(file);
            damage.spoil(h5);
        }
        INFO(damage.what << ": " << refusal_of(file));
        CHECK(names(refusal_of(file), file, damage.named));
    }
}

#endif

TEST_CASE("class names that are empty, twice there or not the labels' are refused", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.h5";
    Dataset dataset = made_up_dataset();
    dataset.class_names = {"iron", "wood", "iron"};
    write_dataset(file, dataset);
    CHECK(names(refusal_of(file), file, "/@class_names: name 2 = \"iron\": is the name of"));
    dataset.class_names = {"iron", "", "wood"};
    write_dataset(file, dataset);
    CHECK(names(refusal_of(file), file, "/@class_names: name 1 is empty"));
#ifdef SPECULA_TEST_HAS_HDF5
    write_dataset(file, made_up_dataset());
    Hdf5Probe(file).put_texts("/label", "class_names", {"iron", "other"});
    CHECK(names(refusal_of(file), file, "/label@class_names: name 1 is \"other\", and in /@c"));
    Hdf5Probe(file).put_texts("/label", "class_names", {"iron"});
    CHECK(names(refusal_of(file), file, "/label@class_names: name 1 is not there"));
    Hdf5Probe(file).remove_attribute("/label", "class_names");
    CHECK(refusal_of(file) == "(no error)");
#endif
}

TEST_CASE("a label that names no class is refused", "[dataset]") {
    const TemporaryFolder folder;
    Dataset dataset = made_up_dataset();
    dataset.truth[4].label = 3;
    write_dataset(folder / "a.h5", dataset);
    CHECK(names(refusal_of(folder / "a.h5"), folder / "a.h5",
                "/label: row 4 = 3: is none of the 3 classes"));
}

TEST_CASE("a truth that cannot be is refused with its row and value", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.h5";
    struct Case {
        double Truth::*member;
        double value;
        std::string named;
    };
    for (const auto& [member, value, named] : std::vector<Case>{
             {&Truth::height_m, -0.3, "/truth/height_m: row 4 = -0.3: is not between 0 and 1000"},
             {&Truth::sample_tilt_y_rad, 90.0, "/truth/sample_tilt_y_rad: row 4 = 90: is not betw"},
             {&Truth::size_x_m, NAN, "/truth/size_x_m: row 4 = nan: is not finite"},
             {&Truth::gain_db, INFINITY, "/truth/gain_db: row 4 = inf: is not finite"},
             {&Truth::loss_factor, -1e-9, "/truth/loss_factor: row 4 = -1e-09: is not between"}}) {
        Dataset dataset = made_up_dataset();
        dataset.truth[4].*member = value;
        write_dataset(file, dataset);
        INFO(refusal_of(file));
        CHECK(names(refusal_of(file), file, named));
    }
    Dataset unknown = made_up_dataset();  // what nobody measured is not in the file
    unknown.unknown_truth.set(0);
    unknown.truth[4].height_m = -1.0;
    write_dataset(file, unknown);
    CHECK(refusal_of(file) == "(no error)");
}

TEST_CASE("a range bin that cannot be is refused", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.h5";
    for (const double bin_m : {-0.04, static_cast<double>(NAN), 1e6}) {
        Dataset dataset = made_up_dataset();
        dataset.origin.bin_m = bin_m;
        write_dataset(file, dataset);
        CHECK(names(refusal_of(file), file, "/@range_bin_m = "));
        dataset = made_up_recording();
        dataset.profile_bin_m = bin_m;
        write_dataset(file, dataset);
        CHECK(names(refusal_of(file), file, "/profile@bin_m = "));
    }
    Dataset dataset = made_up_recording();
    dataset.features[9] = NAN;
    write_dataset(file, dataset);
    CHECK(names(refusal_of(file), file, "/features: row 2 = nan: is not finite"));
}

TEST_CASE("columns of another length than the frames are refused", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.h5";
    const Dataset dataset = made_up_dataset(2);
    {
        Hdf5File out = Hdf5File::create(file);
        for (const auto* name : {"software_version", "condition", "experiment_toml", "radar"})
            out.set_text("/", name, "x");
        out.set_text("/", "format", "specula-dataset");
        out.set_text("/", "seed", "7");
        out.set_number("/", "format_version", 1);
        out.set_number("/", "range_bin_m", 0.04);
        out.set_texts("/", "class_names", {"a", "b"});
        out.write("/adc", {2, 2, 3, 16}, 1, dataset.adc);
        out.write<std::uint8_t>("/label", {3}, 3, {0, 1, 0});
        out.publish();
    }
    CHECK(names(refusal_of(file), file, "/label of 3 rows beside 2 frames"));
}

TEST_CASE("a seed that is no number is refused", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.h5";
    for (const auto* seed : {"", "seven", "7x", "-1", "18446744073709551616"}) {
        Hdf5File out = Hdf5File::create(file);
        for (const auto* name : {"software_version", "condition", "experiment_toml", "radar"})
            out.set_text("/", name, "x");
        out.set_text("/", "format", "specula-dataset");
        out.set_text("/", "seed", seed);
        out.set_number("/", "format_version", 1);
        out.set_number("/", "range_bin_m", 0.04);
        out.publish();
        INFO(seed);
        CHECK(names(refusal_of(file), file, "/@seed"));
    }
}

}  // namespace
}  // namespace specula
