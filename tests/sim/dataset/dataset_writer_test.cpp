#include "sim/dataset/dataset_writer.hpp"

#include "sim/core/error.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/hdf5_probe.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

namespace specula {
namespace {

DatasetHead head_of(const Dataset& dataset) {
    return {
        .form = dataset, .tables = tables_of(dataset), .n_frames = dataset.n_frames(), .shard = {}};
}

/// Small frames, so that there can be more of them than a chunk of any table but columns holds.
Dataset many_small_frames() {
    Dataset dataset = made_up_recording();
    Dataset many = dataset;
    while (many.n_frames() < 4500) {
        const auto repeat = [](auto& to, const auto& from) {
            to.insert(to.end(), from.begin(), from.end());
        };
        repeat(many.adc, dataset.adc);
        repeat(many.adc_quadrature, dataset.adc_quadrature);
        repeat(many.profile, dataset.profile);
        repeat(many.features, dataset.features);
        repeat(many.probability, dataset.probability);
        repeat(many.truth, dataset.truth);
        for (std::int16_t& code : dataset.adc) code = static_cast<std::int16_t>(code * 3 + 1);
    }
    return many;
}

TEST_CASE("a file's bytes do not depend on how its frames were parted", "[dataset]") {
    const TemporaryFolder folder;
    const Dataset dataset = many_small_frames();
    write_dataset(folder / "whole.h5", dataset);
    const std::string whole = bytes_of(folder / "whole.h5");
    for (const std::size_t step : {std::size_t{37}, dataset.n_frames()}) {
        DatasetWriter out(folder / "parts.h5", head_of(dataset));
        for (std::size_t first = 0; first < dataset.n_frames(); first += step)
            out.append(pack_frames(dataset, {first, std::min(first + step, dataset.n_frames())}));
        CHECK(out.publish() == fingerprint(dataset));
        INFO(step << " frames at a time");
        CHECK(bytes_of(folder / "parts.h5") == whole);
    }
    CHECK(read_dataset(folder / "whole.h5").features == dataset.features);
}

TEST_CASE("frames copied in their packed form make the same file", "[dataset]") {
    const TemporaryFolder folder;
    const Dataset dataset = made_up_recording();
    write_dataset(folder / "a.h5", dataset);
    {
        const DatasetReader in(folder / "a.h5");
        CHECK(in.tables().adc_quadrature);
        CHECK_FALSE(in.shard());
        DatasetWriter out(folder / "b.h5", {in.form(), in.tables(), in.n_frames(), {}});
        out.append(in.read_packed({0, 3}));
        out.append(in.read_packed({3, 7}));
        CHECK(out.publish() == fingerprint(dataset));
    }
    CHECK(bytes_of(folder / "b.h5") == bytes_of(folder / "a.h5"));
}

TEST_CASE("any rows of a file can be read alone", "[dataset]") {
    const TemporaryFolder folder;
    const Dataset dataset = made_up_recording();
    write_dataset(folder / "a.h5", dataset);
    const DatasetReader in(folder / "a.h5");
    const Dataset middle = in.read({2, 5});
    const auto codes = static_cast<std::ptrdiff_t>(dataset.codes_per_frame());
    CHECK(middle.n_frames() == 3);
    CHECK(std::equal(middle.adc.begin(), middle.adc.end(), dataset.adc.begin() + 2 * codes));
    CHECK(middle.features[0] == dataset.features[2 * 4]);
    CHECK(middle.truth[2].session == dataset.truth[4].session);
    CHECK(in.frame_hashes({0, 7}).size() == 7);
    CHECK(message_of([&] { return in.read({5, 8}); }).find("too few rows") != std::string::npos);
}

TEST_CASE("a shard says which sessions it holds", "[dataset]") {
    const TemporaryFolder folder;
    const Dataset dataset = made_up_dataset();
    DatasetHead head = head_of(dataset);
    head.shard = SessionSpan{.first = 20, .count = 5, .n_in_all = 4'000'000'000};
    DatasetWriter out(folder / "a.h5", head);
    out.append(pack_frames(dataset, {0, 7}));
    out.publish();
    CHECK(DatasetReader(folder / "a.h5").shard() == head.shard);
    CHECK(read_dataset(folder / "a.h5").adc == dataset.adc);  // and is a dataset by itself
}

TEST_CASE("a frame's hash is that of its rows, whatever the file around it", "[dataset]") {
    const Dataset dataset = made_up_dataset();
    FrameHash hash;
    Sha256 by_hand;
    const std::size_t n = dataset.codes_per_frame();
    by_hand.add(bytes_of_values(std::span(dataset.adc).subspan(3 * n, n)));
    by_hand.add({&dataset.truth[3].label, 1});
    const Sha256::Digest digest = by_hand.finish();
    CHECK((hash.of(dataset, 3) & 0xff) == digest[0]);  // little-endian
    CHECK(hash.of(dataset, 3) >> 56 == digest[7]);
    CHECK(hash.of(dataset, 2) != hash.of(dataset, 3));
}

#ifdef SPECULA_TEST_HAS_HDF5

TEST_CASE("a frame that another program changed is refused, although HDF5 reads it", "[dataset]") {
    const TemporaryFolder folder;
    write_dataset(folder / "a.h5", made_up_dataset());
    {
        const Hdf5File whole = Hdf5File::open(folder / "a.h5");
        std::vector<std::uint8_t> labels = whole.read<std::uint8_t>("/label");
        labels[4] = static_cast<std::uint8_t>((labels[4] + 1) % 3);
        std::filesystem::copy_file(folder / "a.h5", folder / "b.h5");
        const hid_t other = H5Fopen((folder / "b.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        const hid_t table = H5Dopen2(other, "/label", H5P_DEFAULT);
        H5Dwrite(table, H5T_NATIVE_UINT8, H5S_ALL, H5S_ALL, H5P_DEFAULT, labels.data());
        H5Dclose(table);
        H5Fclose(other);
    }
    CHECK(message_of([&] { return read_dataset(folder / "b.h5"); }) ==
          (folder / "b.h5").string() + ": /frame_hash: does not fit frame 4; the file is damaged");
}

#endif

}  // namespace
}  // namespace specula
