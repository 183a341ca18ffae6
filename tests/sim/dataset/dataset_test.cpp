#include "sim/dataset/dataset.hpp"

#include "sim/dataset/fingerprint.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

namespace specula {
namespace {

TEST_CASE("a dataset comes back from its file bit by bit", "[dataset]") {
    const TemporaryFolder folder;
    const Dataset written = made_up_dataset();
    write_dataset(folder / "a.h5", written);
    const Dataset read = read_dataset(folder / "a.h5");

    CHECK(read.origin.condition == written.origin.condition);
    CHECK(read.origin.experiment == written.origin.experiment);
    CHECK(read.origin.recipe == written.origin.recipe);
    CHECK(read.origin.seed == written.origin.seed);
    CHECK(read.origin.version == written.origin.version);
    CHECK(read.origin.radar == written.origin.radar);
    CHECK(read.origin.bin_m == written.origin.bin_m);
    CHECK(read.class_names == written.class_names);
    CHECK(read.n_chirps == written.n_chirps);
    CHECK(read.n_rx == written.n_rx);
    CHECK(read.n_samples == written.n_samples);
    CHECK(read.adc == written.adc);
    REQUIRE(read.n_frames() == written.n_frames());
    for (std::size_t i = 0; i < read.n_frames(); ++i) {
        const Truth &found = read.truth[i], &expected = written.truth[i];
        CHECK(found.label == expected.label);
        CHECK(found.world == expected.world);
        CHECK(found.sample == expected.sample);
        CHECK(found.session == expected.session);
        CHECK(found.frame == expected.frame);
        for (const TruthColumn& column : truth_columns)
            CHECK(found.*column.member == expected.*column.member);
    }
}

TEST_CASE("a recording comes back with what it has and without what it lacks", "[dataset]") {
    const TemporaryFolder folder;
    Dataset written = made_up_recording();
    for (std::size_t i = 1; i < truth_columns.size(); ++i) written.unknown_truth.set(i);
    write_dataset(folder / "a.h5", written);
    Dataset read = read_dataset(folder / "a.h5");
    CHECK(read.origin.source == "import npz");
    CHECK(read.sample_axis == SampleAxis::range);
    CHECK(read.adc == written.adc);
    CHECK(read.adc_quadrature == written.adc_quadrature);
    CHECK(read.feature_names == written.feature_names);
    CHECK(read.features == written.features);
    CHECK(read.profile == written.profile);
    CHECK(read.n_profile_bins == 8);
    CHECK(read.profile_bin_m == 0.0375);
    CHECK(read.profile_window == "blackman");
    CHECK(read.answer_names == written.answer_names);
    CHECK(read.probability == written.probability);
    CHECK(read.unknown_truth == written.unknown_truth);
    REQUIRE(read.has_views);
    for (std::size_t i = 0; i < read.n_frames(); ++i) {
        CHECK(read.truth[i].view == written.truth[i].view);
        CHECK(read.truth[i].height_m == written.truth[i].height_m);
        CHECK(read.truth[i].bow_m == Truth{}.bow_m);  // not known, so not written
    }

    written.adc.clear();
    written.adc_quadrature.clear();
    written.n_chirps = written.n_samples = 0;
    write_dataset(folder / "a.h5", written);
    read = read_dataset(folder / "a.h5");
    CHECK(read.adc.empty());
    CHECK(read.profile == written.profile);
    CHECK(read.n_rx == 3);

    written.profile.clear();  // of a sensor that sends range profiles as it likes
    written.n_profile_bins = written.n_rx = 0;
    write_dataset(folder / "a.h5", written);
    read = read_dataset(folder / "a.h5");
    CHECK(read.adc.empty());
    CHECK(read.n_samples == 0);
    CHECK(read.n_frames() == 7);
    CHECK(read.features == written.features);
}

TEST_CASE("no two columns of the truth are the same field", "[dataset]") {
    Truth truth;
    for (std::size_t i = 0; i < truth_columns.size(); ++i)
        truth.*truth_columns[i].member = static_cast<double>(i) + 1.0;
    for (std::size_t i = 0; i < truth_columns.size(); ++i)
        CHECK(truth.*truth_columns[i].member == static_cast<double>(i) + 1.0);
    // All of Truth's numbers are columns: the doubles, five ids and the label.
    CHECK(sizeof(Truth) == sizeof(double) * truth_columns.size() + 6 * sizeof(std::int32_t));
}

TEST_CASE("equal content makes equal bytes, another bit other bytes", "[dataset]") {
    const TemporaryFolder folder;
    Dataset dataset = made_up_dataset();
    write_dataset(folder / "a.h5", dataset);
    const std::string before = bytes_of(folder / "a.h5");
    write_dataset(folder / "b.h5", dataset);
    CHECK(bytes_of(folder / "b.h5") == before);
    write_dataset(folder / "a.h5", dataset);  // over the old one
    CHECK(bytes_of(folder / "a.h5") == before);
    dataset.adc.back() ^= 1;
    write_dataset(folder / "b.h5", dataset);
    CHECK(bytes_of(folder / "b.h5") != before);
}

TEST_CASE("no object in the file holds a time", "[dataset]") {
    // HDF5 marks an object header (OHDR, version 2) that holds times by bit 5 of its flags. The
    // superblock's extension has one too, which no property turns off.
    const TemporaryFolder folder;
    write_dataset(folder / "a.h5", made_up_dataset());
    const std::string bytes = bytes_of(folder / "a.h5");
    std::size_t n_headers = 0;
    for (auto at = bytes.find("OHDR\x02"); at != bytes.npos; at = bytes.find("OHDR\x02", at + 1)) {
        CHECK((bytes.at(at + 5) & 0x20) == 0);
        ++n_headers;
    }
    CHECK(n_headers >=
          1 + 1 + 1 + 2 + 4 + truth_columns.size());  // root, adc, label, groups, columns
}

TEST_CASE("an experiment of a megabyte travels in the file", "[dataset]") {
    const TemporaryFolder folder;
    Dataset dataset = made_up_dataset(1);
    while (dataset.origin.experiment.size() < (1u << 20) - 30)
        dataset.origin.experiment +=
            "# line " + std::to_string(dataset.origin.experiment.size()) + "\n";
    write_dataset(folder / "a.h5", dataset);
    CHECK(read_dataset(folder / "a.h5").origin.experiment == dataset.origin.experiment);
}

TEST_CASE("empty texts stay empty", "[dataset]") {
    const TemporaryFolder folder;
    Dataset dataset = made_up_dataset(1);
    dataset.origin.experiment.clear();
    dataset.origin.condition.clear();
    write_dataset(folder / "a.h5", dataset);
    CHECK(read_dataset(folder / "a.h5").origin.experiment.empty());
    CHECK(read_dataset(folder / "a.h5").origin.condition.empty());
}

TEST_CASE("a frame of the dataset is the firmware's frame", "[dataset]") {
    const Dataset dataset = made_up_dataset();
    const fw_frame frame = dataset.frame(3);
    CHECK(frame.n_chirps == 2);
    CHECK(frame.n_rx == 3);
    CHECK(frame.n_samples == 16);
    CHECK(frame.samples == dataset.adc.data() + 3 * 2 * 3 * 16);
}

TEST_CASE("a fingerprint knows codes, features, labels and nothing else", "[dataset]") {
    const Dataset dataset = made_up_dataset();
    const std::string before = fingerprint(dataset);
    CHECK(before.size() == 16);
    CHECK(before.find_first_not_of("0123456789abcdef") == std::string::npos);

    Dataset changed = dataset;
    changed.adc[5] ^= 1;
    CHECK(fingerprint(changed) != before);
    changed = dataset;
    std::swap(changed.adc[0], changed.adc[1]);
    CHECK(fingerprint(changed) != before);
    changed = dataset;
    changed.truth[2].label ^= 1;
    CHECK(fingerprint(changed) != before);
    changed = dataset;
    changed.origin.condition = "another file of the same recording";
    changed.truth[0].height_m += 1.0;
    CHECK(fingerprint(changed) == before);

    changed = made_up_recording();
    const std::string recorded = fingerprint(changed);
    changed.features[0] += 1.0;
    CHECK(fingerprint(changed) != recorded);
    changed.features[0] -= 1.0;
    changed.adc_quadrature[0] ^= 1;
    CHECK(fingerprint(changed) != recorded);

    changed = made_up_recording();
    changed.profile[0] += 1.0f;
    CHECK(fingerprint(changed) != recorded);
    CHECK(fingerprint(Dataset{}) == "e3b0c44298fc1c14");  // SHA-256 of nothing, FIPS 180-4
}

}  // namespace
}  // namespace specula
