#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "sim/dataset/hdf5_file.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/sim/dataset/hdf5_probe.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

// sim/dataset/FORMAT.md against a file that was just written: what the one lists, the other holds.

namespace specula {
namespace {

using Row = std::vector<std::string>;

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" `");
    const auto last = text.find_last_not_of(" `");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> parted(const std::string& text, char by) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, by);) parts.push_back(trimmed(part));
    return parts;
}

/// The rows of the table of FORMAT.md under a heading, without its head lines.
std::vector<Row> table_under(const std::string& heading) {
    std::ifstream stream(SPECULA_SOURCE_DIR "/sim/dataset/FORMAT.md");
    std::vector<Row> rows;
    bool here = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.rfind("#", 0) == 0) here = trimmed(line.substr(line.find(' '))) == heading;
        if (here && line.rfind("|", 0) == 0) rows.push_back(parted(line.substr(1), '|'));
    }
    REQUIRE(rows.size() > 2);
    return {rows.begin() + 2, rows.end()};
}

TEST_CASE("units and columns in FORMAT.md are those of the truth", "[dataset]") {
    const auto documented = table_under("What they mean");
    std::map<std::string, std::string> units;
    for (const Row& row : documented) units[row[0]] = row[1];
    CHECK(units.size() == documented.size());  // no table twice
    for (const TruthColumn& column : truth_columns)
        CHECK(units[std::string("/truth/") + column.name] == column.unit);
    std::set<std::string> listed;
    for (const Row& row : table_under("Tables")) listed.insert(row[0]);
    CHECK(listed.size() == units.size());
    for (const auto& [table, unit] : units) CHECK(listed.count(table) == 1);
}

#ifdef SPECULA_TEST_HAS_HDF5

class WrittenFile {
  public:
    WrittenFile() { write_dataset(file, dataset); }
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.h5";
    const Dataset dataset = made_up_recording();
};

TEST_CASE("the attributes of the file are those that FORMAT.md lists", "[dataset]") {
    const WrittenFile written;
    std::set<std::string> documented;
    for (const Row& row : table_under("Root attributes")) documented.insert(row[0]);
    std::set<std::string> found;
    for (const auto& name : Hdf5Probe(written.file).attributes("/")) found.insert(name);
    CHECK(found == documented);

    const Hdf5File in = Hdf5File::open(written.file);
    for (const Row& row : table_under("Root attributes")) {
        INFO(row[0]);
        if (row[1] == "text")
            CHECK_NOTHROW(in.text("/", row[0]));
        else if (row[1] == "texts")
            CHECK(in.texts("/", row[0]) == written.dataset.class_names);
        else
            CHECK_NOTHROW(in.number("/", row[0]));
    }
    CHECK(in.text("/", "format") == "specula-dataset");
    CHECK(in.number("/", "format_version") == 3.0);
    CHECK(in.text("/", "software") == "specula");
}

TEST_CASE("the tables of the file are those that FORMAT.md lists", "[dataset]") {
    const WrittenFile written;
    const Hdf5Probe probe(written.file);
    const std::map<std::string, std::size_t> lengths{{"N", 7},          {"n_chirps", 2},
                                                     {"n_rx", 3},       {"n_samples", 16},
                                                     {"n_features", 4}, {"n_answers", 2},
                                                     {"n_bins", 8}};

    std::set<std::string> documented;
    const Hdf5File in = Hdf5File::open(written.file);
    for (const Row& row : table_under("Tables")) {
        INFO(row[0]);
        REQUIRE(documented.insert(row[0]).second);
        std::vector<std::size_t> shape;
        for (const std::string& axis : parted(row[2], ',')) shape.push_back(lengths.at(axis));
        CHECK(in.shape(row[0]) == shape);

        const Hdf5Probe::Layout layout = probe.layout(row[0]);
        CHECK(layout.type == row[1]);
        CHECK(layout.little_endian);
        CHECK(layout.filters == "shuffle, gzip 4, fletcher32");
        REQUIRE(layout.chunk.size() == shape.size());
        CHECK(layout.chunk[0] == std::min<std::size_t>(std::stoul(row[3]), shape[0]));
        for (std::size_t axis = 1; axis < shape.size(); ++axis)
            CHECK(layout.chunk[axis] == shape[axis]);

        auto attributes = parted(row[4], ','), present = probe.attributes(row[0]);
        std::sort(attributes.begin(), attributes.end());
        std::sort(present.begin(), present.end());
        CHECK(present == attributes);
    }
    for (const std::string& object : probe.objects()) {
        INFO(object);
        CHECK((probe.is_group(object) || documented.count(object) == 1));
    }
    for (const Row& row : table_under("What they mean"))
        if (row[1] != "-") CHECK(in.text(row[0], "units") == row[1]);
    CHECK(in.texts("/adc", "axis_labels") == Row{"frame", "chirp", "rx", "sample"});
    CHECK(in.texts("/profile", "axis_labels") == Row{"frame", "rx", "bin"});
    CHECK(in.text("/profile", "window") == "blackman");
    CHECK(in.number("/profile", "bin_m") == 0.0375);
}

#endif

TEST_CASE("h5dump, where there is one, reads the file", "[dataset]") {
    if (std::system("command -v h5dump > /dev/null 2>&1") != 0) {
        WARN("h5dump (Debian: hdf5-tools) is not installed: not tried");
        return;
    }
    const TemporaryFolder folder;
    write_dataset(folder / "a.h5", made_up_dataset());
    const std::string command =
        "h5dump -H '" + (folder / "a.h5").string() + "' > '" + (folder / "dump").string() + "'";
    REQUIRE(std::system(command.c_str()) == 0);
    const std::string dump = bytes_of(folder / "dump");
    for (const TruthColumn& column : truth_columns)
        CHECK(dump.find(column.name) != std::string::npos);
}

}  // namespace
}  // namespace specula
