#include "tools/dataset/dataset_documents.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/core/error.hpp"
#include "sim/dataset/sha256.hpp"
#include "tests/check.hpp"
#include "tests/contains.hpp"
#include "tests/made_up_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/hdf5_probe.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

namespace specula {
namespace {

using Json = nlohmann::json;

const DocumentOptions licensed{.license = "CC-BY-4.0", .creator = "", .url = ""};

struct Described {
    explicit Described(const Dataset& dataset = made_up_dataset()) {
        ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
        write_dataset(file, dataset);
    }
    ~Described() { ::unsetenv("SOURCE_DATE_EPOCH"); }
    const MadeUpFolder folder;
    const std::filesystem::path file = folder / "set.h5";
};

TEST_CASE("Croissant metadata have every key that version 1.0 requires", "[documents]") {
    const Described set;
    const Json json =
        Json::parse(croissant_of(set.file, {.license = "https://spdx.org/licenses/MIT",
                                            .creator = "A. Name",
                                            .url = "https://example.org/set"}));
    // The required properties of a dataset, the one it modifies, and its declaration.
    for (const char* key : {"@context", "@type", "description", "license", "name", "url", "creator",
                            "datePublished", "distribution", "conformsTo"})
        CHECK(json.contains(key));
    CHECK(json["@type"] == "sc:Dataset");
    CHECK(json["conformsTo"] == "http://mlcommons.org/croissant/1.0");
    CHECK(json["@context"]["conformsTo"] == "dct:conformsTo");
    CHECK(json["license"] == "https://spdx.org/licenses/MIT");
    CHECK(json["datePublished"] == "1970-01-02");
    CHECK(json["creator"]["name"] == "A. Name");
    const Json& file = json["distribution"][0];
    for (const char* key : {"name", "contentUrl", "contentSize", "encodingFormat", "sha256"})
        CHECK(file.contains(key));
    CHECK(file["@type"] == "cr:FileObject");
    CHECK(file["sha256"] == sha256_of_file(set.file));
    CHECK(file["contentSize"] == std::to_string(std::filesystem::file_size(set.file)) + " B");
}

TEST_CASE("the record sets of Croissant name each table and class, ids and references meet",
          "[documents]") {
    const Described set(made_up_recording());
    const Json json = Json::parse(croissant_of(set.file, {}));
    std::set<std::string> ids, references;
    const std::function<void(const Json&)> collect = [&](const Json& node) {
        if (node.is_object() && node.contains("@id")) {
            const bool is_reference = node.size() == 1;
            if (!is_reference) CHECK(ids.insert(node["@id"]).second);  // no id twice
            if (is_reference) references.insert(node["@id"]);
        }
        for (const Json& each : node)
            if (each.is_structured()) collect(each);
    };
    for (const char* part : {"distribution", "recordSet"}) collect(json[part]);
    for (const std::string& each : references) {
        INFO(each);
        CHECK(ids.count(each) == 1);
    }
    for (const char* table : {"/adc", "/label", "/features", "/truth/height_m", "/group/session"})
        CHECK(ids.count(std::string("frames") + table) == 1);
    const Json& classes = json["recordSet"][1];
    CHECK(classes["data"][2]["classes/name"] == "Nüsse");
    for (const Json& field : json["recordSet"][0]["field"]) {
        CHECK(field["@type"] == "cr:Field");
        CHECK(field["source"]["fileObject"]["@id"] == "set.h5");
        CHECK(field.contains("dataType"));
    }
}

TEST_CASE("a datasheet answers every question with the numbers of the file", "[documents]") {
    const Described set;
    const std::string sheet = datasheet_of(set.file, licensed, 1);
    for (const char* section :
         {"# Datasheet of set.h5", "## Motivation", "## Composition", "## Collection",
          "## Preprocessing", "## Uses and limits", "## Distribution", "## Maintenance"})
        CHECK(contains(sheet, section));
    CHECK(contains(sheet, "- 7 frames, each of 2 chirps x 3 receivers x 16 samples"));
    CHECK(contains(sheet, sha256_of_file(set.file)));
    CHECK(contains(sheet, "licence: CC-BY-4.0"));
    CHECK(contains(sheet, "| a much longer name | 1 |"));
    CHECK(contains(sheet, "seed 18446744073709551615"));
    CHECK(contains(sheet, "    size_mm = [300, 300]\n"));  // the experiment, whole
    CHECK_FALSE(contains(sheet, " nan "));
    CHECK_FALSE(contains(sheet, " inf "));
    CHECK(datasheet_of(set.file, licensed, 2) == sheet);  // threads
}

TEST_CASE("a datasheet of a recording says what nobody measured", "[documents]") {
    Dataset recording = made_up_recording();
    recording.unknown_truth.set();
    const Described set(recording);
    const std::string sheet = datasheet_of(set.file, {}, 1);
    CHECK(contains(sheet, "Not known, and left out instead of guessed: height_m,"));
    CHECK(contains(sheet, "Imported (`import npz`)"));
    CHECK(contains(sheet, "not chosen by the maker yet"));
}

TEST_CASE("documents lie beside their dataset under its name", "[documents]") {
    const Described set;
    CHECK(write_datasheet(set.file, set.folder.path(), {}, 1) == set.folder / "set.DATASHEET.md");
    CHECK(write_croissant(set.file, set.folder.path(), {}) == set.folder / "set.croissant.json");
    CHECK(contains(content_of(set.folder / "set.croissant.json"), "set.DATASHEET.md says more"));
    write_datasheet(set.file, set.folder.path(), {}, 1);  // again: its own
    write_croissant(set.file, set.folder.path(), {});
    const std::string before = content_of(set.folder / "set.DATASHEET.md");
    write_dataset(set.folder / "other.h5", made_up_dataset(3));
    CHECK(write_documents(set.folder / "other.h5", 1));
    CHECK(contains(content_of(set.folder / "other.croissant.json"), "\"other.h5\""));
    CHECK(content_of(set.folder / "set.DATASHEET.md") == before);

    write_dataset(set.folder / "set.hdf5", made_up_dataset(3));  // would have the same names
    for (const auto& work : std::vector<std::function<void()>>{
             [&] { write_datasheet(set.folder / "set.hdf5", set.folder.path(), {}, 1); },
             [&] { write_croissant(set.folder / "set.hdf5", set.folder.path(), {}); },
             [&] { write_documents(set.folder / "set.hdf5", 1); }})
        CHECK(message_of([&] { return work(), 0; }).find(": describes another dataset") !=
              std::string::npos);
    CHECK(content_of(set.folder / "set.DATASHEET.md") == before);
}

TEST_CASE("documents are written once for the same bytes, and anew for others", "[documents]") {
    const Described set;
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    ::waitpid(child, nullptr, 0);
    const auto left = set.folder.with("set.croissant.json.draft-" + std::to_string(child) + "-0", "{");
    CHECK(write_documents(set.file, 1));
    CHECK_FALSE(std::filesystem::exists(left));
    CHECK_FALSE(write_documents(set.file, 1));
    write_dataset(set.file, made_up_dataset(3));
    CHECK(write_documents(set.file, 1));
    CHECK(contains(content_of(set.folder / "set.DATASHEET.md"), sha256_of_file(set.file)));
    std::filesystem::remove(set.folder / "set.croissant.json");
    CHECK(write_documents(set.file, 1));
}

TEST_CASE("a damaged dataset is described by neither document", "[documents]") {
    const auto refused = [](const Dataset& dataset, const std::string& named) {
        const Described set(dataset);
        for (const auto& describe : std::vector<std::function<std::string()>>{
                 [&] { return datasheet_of(set.file, {}, 1); },
                 [&] { return croissant_of(set.file, {}); }}) {
            const std::string message = message_of(describe);
            INFO(message);
            CHECK(contains(message, named));
        }
    };
    Dataset wrong = made_up_recording();
    wrong.features[5] = std::numeric_limits<double>::quiet_NaN();
    refused(wrong, "/features: row 1 = nan");
    wrong = made_up_dataset();
    wrong.truth[2].label = 3;
    refused(wrong, "/label: row 2 = 3");
    wrong = made_up_dataset();
    wrong.truth[6].height_m = -1.0;
    refused(wrong, "/truth/height_m: row 6 = -1");
}

#ifdef SPECULA_TEST_HAS_HDF5

TEST_CASE("both documents read a file as all commands do", "[documents]") {
    const auto message = [](const std::function<void(Hdf5Probe&)>& spoil) {
        const Described set;
        {
            Hdf5Probe h5(set.file);
            spoil(h5);
        }
        const std::string sheet = message_of([&] { return datasheet_of(set.file, {}, 1); });
        const std::string json = message_of([&] { return croissant_of(set.file, {}); });
        CHECK(sheet == json);
        return json;
    };
    CHECK(contains(message([](Hdf5Probe& h5) { h5.remove("/label"); }), "/label: is missing"));
    CHECK(contains(message([](Hdf5Probe& h5) { h5.put_claim("/adc", {1u << 30, 2, 3, 16}); }),
                   "/adc: is larger than what the file holds"));
    CHECK(contains(message([](Hdf5Probe& h5) { h5.add_number("/frame_hash", 3, 1); }),
                   "/frame_hash: does not fit frame 3"));
    // A stranger's table in a form of its own is nobody's business.
    CHECK(message([](Hdf5Probe& h5) { h5.add_plain_table("/notes"); }) == "(no error)");
}

#endif

}  // namespace
}  // namespace specula
