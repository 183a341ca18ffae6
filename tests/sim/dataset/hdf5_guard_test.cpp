#include <algorithm>
#include <functional>

#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/hdf5_file.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/hdf5_probe.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

// HDF5 files can point anywhere and be packed by anything. What a dataset of ours never does is
// refused before HDF5's code follows it.

namespace specula {
namespace {

namespace fs = std::filesystem;

TEST_CASE("all tables are found, with type and attributes", "[dataset]") {
    const TemporaryFolder folder;
    write_dataset(folder / "a.h5", made_up_recording());
    const Hdf5File in = Hdf5File::open(folder / "a.h5");
    const std::vector<std::string> tables = in.tables();
    CHECK(std::is_sorted(tables.begin(), tables.end()));
    const auto has = [&](const std::string& name) {
        return std::find(tables.begin(), tables.end(), name) != tables.end();
    };
    for (const char* name : {"/adc", "/label", "/frame_hash", "/group/world", "/truth/bow_m"})
        CHECK(has(name));
    CHECK_FALSE(has("/truth"));  // a group
    CHECK(in.number_type("/adc") == "int16");
    CHECK(in.number_type("/frame_hash") == "uint64");
    CHECK(in.number_type("/truth/bow_m") == "float64");
    CHECK(in.attributes("/adc") == std::vector<std::string>{"axis_labels", "units"});
    CHECK(in.attribute_text("/adc", "axis_labels") == "frame,chirp,rx,sample");
    CHECK(in.attribute_text("/", "format_version") == "3");
}

#ifdef SPECULA_TEST_HAS_HDF5

/// What a file of ours becomes when somebody else's code lays hands on it.
fs::path spoilt(const TemporaryFolder& folder, const std::function<void(hid_t)>& spoil) {
    const fs::path file = folder / "a.h5";
    write_dataset(file, made_up_dataset());
    const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    spoil(id);
    H5Fclose(id);
    return file;
}

TEST_CASE("a file whose structure has no checksums is refused, with the way out", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "old.h5";
    H5Fclose(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    CHECK(refusal_of(file).find("old.h5: file: is HDF5 of an old form") != std::string::npos);
    CHECK(refusal_of(file).find("h5repack --latest") != std::string::npos);
}

TEST_CASE("links that lead elsewhere are not followed", "[dataset]") {
    const TemporaryFolder folder;
    write_dataset(folder / "other.h5", made_up_dataset());
    const std::string other = (folder / "other.h5").string();
    const fs::path external = spoilt(folder, [&](hid_t file) {
        H5Ldelete(file, "/label", H5P_DEFAULT);
        H5Lcreate_external(other.c_str(), "/label", file, "/label", H5P_DEFAULT, H5P_DEFAULT);
    });
    CHECK(refusal_of(external).find("/label: is missing") != std::string::npos);
    const fs::path soft = spoilt(folder, [](hid_t file) {
        H5Ldelete(file, "/truth/bow_m", H5P_DEFAULT);
        H5Lcreate_soft("/truth/height_m", file, "/truth/bow_m", H5P_DEFAULT, H5P_DEFAULT);
    });
    CHECK(refusal_of(soft).find("/truth/bow_m: is missing") != std::string::npos);
    const auto tables = Hdf5File::open(soft).tables();
    CHECK(std::find(tables.begin(), tables.end(), "/truth/bow_m") == tables.end());
}

TEST_CASE("a table whose numbers lie in another file is not read", "[dataset]") {
    const TemporaryFolder folder;
    const fs::path secret = folder / "secret";
    std::ofstream(secret) << std::string(7 * 96 * 2, 's');
    const fs::path file = spoilt(folder, [&](hid_t id) {
        H5Ldelete(id, "/adc", H5P_DEFAULT);
        const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_external(creation, secret.c_str(), 0, 7 * 96 * 2);
        const hsize_t size[4] = {7, 2, 3, 16};
        const hid_t space = H5Screate_simple(4, size, nullptr);
        H5Dclose(H5Dcreate2(id, "/adc", H5T_STD_I16LE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
        H5Sclose(space);
        H5Pclose(creation);
    });
    CHECK(refusal_of(file).find("/adc: is stored in a way") != std::string::npos);
}

#endif

}  // namespace
}  // namespace specula
