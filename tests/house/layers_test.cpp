#include <optional>

#include "tests/check.hpp"
#include "tests/house/source_tree.hpp"

// Two laws about includes. The order of the folders: a file includes only from its own place or
// from places to its left. The doors: each third party enters through one place.

namespace specula {
namespace {

// Left to right; folders of one row may include each other. A folder that is not listed belongs to
// the nearest listed one above it (materials/models, tools/specula).
const std::vector<std::vector<std::string>> order{
    {"firmware"},
    {"sim/core"},
    {"materials"},
    {"scenes"},
    {"sim/trace"},
    {"sim/channel"},
    {"sim/signal"},
    {"sim/adc"},
    {"sim/dataset"},
    {"sim/recording"},
    {"sim"},
    {"classifier"},
    {"tools/report", "tools/study", "tools/sweep", "tools/validate"},
    {"tools"},
};

/// A file's place in the order, from the left; nothing if it has none.
std::optional<std::size_t> place(const std::filesystem::path& file) {
    for (auto folder = file.parent_path(); !folder.empty(); folder = folder.parent_path()) {
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (const auto& name : order[i]) {
                if (folder != name) continue;
                // The stages of sim have an order of their own: a new one must be given its place.
                if (name == "sim" && folder != file.parent_path()) return std::nullopt;
                return i;
            }
        }
    }
    return std::nullopt;
}

bool is_c_or_cpp(const SourceFile& file) {
    static const std::set<std::string> extensions{".c", ".h", ".cpp", ".hpp"};
    return extensions.count(std::filesystem::path(file.path).extension().string()) != 0;
}

bool begins_with(const std::string& text, const std::string& beginning) {
    return text.rfind(beginning, 0) == 0;
}

bool is_test(const SourceFile& file) {
    return begins_with(file.path, "tests/");
}

Breaches against_the_order(const SourceTree& tree) {
    Breaches breaches;
    for (const auto& file : tree.files()) {
        if (!is_c_or_cpp(file) || is_test(file)) continue;
        const auto own = place(file.path);
        if (!own) {
            breaches.push_back(breach(file.path, 1,
                                      "its folder has no place in the order; "
                                      "give it one in tests/house/layers_test.cpp"));
            continue;
        }
        for (const auto& include : tree.includes(file)) {
            if (include.path.empty()) continue;
            const auto other = place(include.path);
            if (!other || *other > *own) {
                breaches.push_back(
                    breach(file.path, include.line,
                           "includes " + include.path + ", which lies to its right"));
            }
        }
    }
    return breaches;
}

struct Door {
    std::vector<std::string> headers;  // how the headers begin that it lets in
    std::vector<std::string> files;    // how the paths begin that may include them
    bool for_tests;                    // does it bind tests too?
};
const std::vector<Door> doors{
    {{"embree"}, {"sim/trace/geometry.cpp"}, false},
    {{"hdf5", "H5"}, {"sim/dataset/hdf5_"}, false},
    {{"openssl/"}, {"sim/dataset/sha256.cpp"}, false},
    {{"libdeflate"}, {"sim/dataset/chunk_packer.cpp"}, false},
    {{"zlib", "zconf"}, {"sim/recording/zip_archive.cpp"}, false},
    {{"toml++/", "toml.hpp"}, {"sim/core/document_table."}, false},
    {{"omp.h"}, {"sim/parallel.cpp"}, false},
    {{"CLI/"}, {"tools/specula/"}, false},
    {{"spdlog/"}, {"tools/console/console.cpp"}, false},
    {{"fmt/"}, {"sim/core/format.hpp"}, false},
    {{"Random123/"}, {"sim/core/random.cpp"}, false},
    {{"microhttpd"}, {"tools/serve/http_server.cpp"}, false},
    {{"Eigen/", "unsupported/Eigen/"},
     {"classifier/", "scenes/vector3.hpp", "tools/likeness/least_squares.cpp"},
     false},
    {{"catch2/", "catch.hpp"}, {"tests/check.hpp"}, true},
};

Breaches beside_the_doors(const SourceTree& tree) {
    Breaches breaches;
    for (const auto& file : tree.files()) {
        if (!is_c_or_cpp(file)) continue;
        for (const auto& include : tree.includes(file)) {
            if (!include.path.empty()) continue;
            for (const auto& door : doors) {
                if (is_test(file) && !door.for_tests) continue;
                const bool its_own = std::any_of(
                    door.headers.begin(), door.headers.end(),
                    [&](const auto& header) { return begins_with(include.header, header); });
                const bool through_the_door =
                    std::any_of(door.files.begin(), door.files.end(),
                                [&](const auto& way) { return begins_with(file.path, way); });
                if (!its_own || through_the_door) continue;
                breaches.push_back(
                    breach(file.path, include.line,
                           "includes " + include.header + "; its door is " + door.files.front()));
            }
        }
    }
    return breaches;
}

TEST_CASE("files include only from their own place or from places to its left", "[house]") {
    const auto breaches = against_the_order(SourceTree(SPECULA_SOURCE_DIR));
    INFO(one_per_line(breaches));
    CHECK(breaches.empty());
}

TEST_CASE("each third party enters through its own door", "[house]") {
    const auto breaches = beside_the_doors(SourceTree(SPECULA_SOURCE_DIR));
    INFO(one_per_line(breaches));
    CHECK(breaches.empty());
}

TEST_CASE("the scanner finds the project it is meant to watch", "[house]") {
    const SourceTree tree(SPECULA_SOURCE_DIR);
    std::set<std::string> seen;
    for (const auto& file : tree.files()) {
        const auto own = is_c_or_cpp(file) ? place(file.path) : std::nullopt;
        if (own) seen.insert(order[*own].front());
    }
    CHECK(seen.count("firmware") == 1);
    CHECK(seen.count("sim/core") == 1);
    CHECK(seen.count("materials") == 1);
}

TEST_CASE("includes are found however they are written, and nothing else", "[house]") {
    MadeUpTree made_up;
    made_up.with("firmware/fw_fft.h", "");
    made_up.with("firmware/fw_fft.c",
                 "/* text */\n"
                 "#include \"fw_fft.h\"\n"             // beside the file
                 "  #  include <firmware/fw_fft.h>\n"  // from the root
                 "#include \"../firmware/fw_fft.h\" // why\n"
                 "#include <fw_fft.h>\n"  // not found by brackets
                 "#include <math.h>\n"
                 "// #include \"fw_fft.h\"\n"
                 "const char *text = \"#include <math.h>\";\n"
                 "#if __has_include(<math.h>)\n");
    const auto tree = made_up.read();
    const auto& file = tree.files().front();
    REQUIRE(file.path == "firmware/fw_fft.c");

    const auto includes = tree.includes(file);
    std::vector<std::pair<std::size_t, std::string>> found;
    for (const auto& include : includes) found.emplace_back(include.line, include.path);
    CHECK(found == decltype(found){{2, "firmware/fw_fft.h"},
                                   {3, "firmware/fw_fft.h"},
                                   {4, "firmware/fw_fft.h"},
                                   {5, ""},
                                   {6, ""}});
}

TEST_CASE("outputs, hidden folders and folders CMake builds in are not scanned", "[house]") {
    MadeUpTree made_up;
    for (const auto* folder : {"build", "build-dev", "out", ".cache", "sim/elsewhere"}) {
        made_up.with(std::string(folder) + "/generated.cpp", "");
    }
    made_up.with("sim/elsewhere/CMakeCache.txt", "").with("sim/builder/kept.cpp", "");
    const auto tree = made_up.read();
    REQUIRE(tree.files().size() == 1);
    CHECK(tree.files().front().path == "sim/builder/kept.cpp");
}

TEST_CASE("an include to the right is found with file and line", "[house]") {
    struct Case {
        std::string from, to;
        bool allowed;
    };
    const auto example = GENERATE(values<Case>({
        {"firmware/fw_fft.c", "sim/core/error.hpp", false},
        {"sim/core/error.cpp", "firmware/fw_status.h", true},
        {"materials/models/debye.hpp", "materials/material.hpp", true},
        {"materials/material.cpp", "materials/models/debye.hpp", true},
        {"materials/models/debye.hpp", "scenes/scene.hpp", false},
        {"scenes/shapes/slab.cpp", "materials/slab.hpp", true},
        {"sim/channel/channel.cpp", "sim/trace/scatter.hpp", true},
        {"sim/trace/scatter.cpp", "sim/channel/channel.hpp", false},
        {"sim/dataset/dataset.cpp", "sim/simulate.hpp", false},
        {"sim/simulate.cpp", "sim/dataset/dataset.hpp", true},
        {"sim/simulate.cpp", "classifier/model.hpp", false},
        {"sim/new_stage/stage.cpp", "sim/core/error.hpp", false},
        {"classifier/train.cpp", "tools/report/report.hpp", false},
        {"tools/report/figure.cpp", "tools/study/cell.hpp", true},
        {"tools/report/figure.cpp", "tools/specula/console.hpp", false},
        {"tools/study/cell.cpp", "tools/specula/console.hpp", false},
        {"tools/specula/list.cpp", "tools/report/figure.hpp", true},
        {"tools/main.cpp", "tools/specula/console.hpp", true},
        {"classifier/train.cpp", "tests/check.hpp", false},
        {"unknown/file.cpp", "sim/core/error.hpp", false},
        {"tests/core/error_test.cpp", "tools/specula/console.hpp", true},
    }));
    MadeUpTree made_up;
    made_up.with(example.to, "#pragma once\n");
    made_up.with(example.from, "// first line\n#include \"" + example.to + "\"\n");

    INFO(example.from << " includes " << example.to);
    auto breaches = against_the_order(made_up.read());
    // A made-up file without a place is a breach of its own; only the includer's is looked at here.
    breaches.erase(
        std::remove_if(breaches.begin(), breaches.end(),
                       [&](const auto& text) { return !begins_with(text, example.from); }),
        breaches.end());
    CHECK(breaches.empty() == example.allowed);
    const bool has_place = place(example.from).has_value();
    if (!example.allowed && has_place) {
        CHECK(breaches ==
              Breaches{example.from + ":2: includes " + example.to + ", which lies to its right"});
    }
}

TEST_CASE("a third party beside its door is found with file and line", "[house]") {
    struct Case {
        std::string file, header;
        bool allowed;
    };
    const auto example = GENERATE(values<Case>({
        {"sim/trace/geometry.cpp", "embree3/rtcore.h", true},
        {"sim/trace/facets.cpp", "embree4/rtcore.h", false},
        {"sim/trace/geometry.hpp", "embree3/rtcore.h", false},
        {"sim/dataset/hdf5_file.cpp", "hdf5.h", true},
        {"sim/dataset/dataset.cpp", "hdf5.h", false},
        {"sim/hdf5_file.cpp", "H5Cpp.h", false},
        {"sim/dataset/sha256.cpp", "openssl/evp.h", true},
        {"tools/generate/manifest.cpp", "openssl/evp.h", false},
        {"sim/dataset/chunk_packer.cpp", "libdeflate.h", true},
        {"sim/recording/zip_archive.cpp", "libdeflate.h", false},
        {"sim/recording/zip_archive.cpp", "zlib.h", true},
        {"sim/recording/npy_array.cpp", "zlib.h", false},
        {"tests/check.hpp", "catch2/catch.hpp", true},
        {"tests/sim/simulate_test.cpp", "catch2/catch_test_macros.hpp", false},
        {"sim/core/document_table.hpp", "toml++/toml.h", true},
        {"sim/core/document.hpp", "toml++/toml.hpp", false},
        {"sim/parallel.cpp", "omp.h", true},
        {"sim/trace/facets.cpp", "omp.h", false},
        {"tools/specula/command_line.cpp", "CLI/CLI.hpp", true},
        {"tools/main.cpp", "CLI/App.hpp", false},
        {"tools/console/console.cpp", "spdlog/spdlog.h", true},
        {"tools/specula/list.cpp", "spdlog/spdlog.h", false},
        {"sim/core/format.hpp", "fmt/format.h", true},
        {"sim/simulate.cpp", "fmt/core.h", false},
        {"sim/core/random.cpp", "Random123/philox.h", true},
        {"sim/core/random.hpp", "Random123/philox.h", false},
        {"classifier/train.cpp", "Eigen/Dense", true},
        {"sim/signal/dechirp.cpp", "unsupported/Eigen/FFT", false},
        {"tests/classifier/train_test.cpp", "Eigen/Dense", true},
        {"sim/simulate.cpp", "complex", true},
    }));
    MadeUpTree made_up;
    made_up.with(example.file, "// first line\n#include <" + example.header + ">\n");

    INFO(example.file << " includes " << example.header);
    const auto breaches = beside_the_doors(made_up.read());
    REQUIRE(breaches.size() == (example.allowed ? 0 : 1));
    if (!example.allowed) {
        CHECK(begins_with(breaches.front(), example.file + ":2: includes " + example.header));
    }
}

}  // namespace
}  // namespace specula
