#include "tools/dataset/dataset_diff.hpp"

#include <algorithm>

#include "sim/core/error.hpp"
#include "tests/check.hpp"
#include "tests/classifier/temporary_folder.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"

namespace specula {
namespace {

/// Two files, the second as `change` makes it.
struct Pair {
    template <typename Change>
    explicit Pair(const Change& change) {
        Dataset dataset = made_up_recording();
        write_dataset(folder / "a.h5", dataset);
        change(dataset);
        write_dataset(folder / "b.h5", dataset);
    }
    DatasetDiff diff(const DiffOptions& options = {}) const {
        return diff_datasets(folder / "a.h5", folder / "b.h5", options);
    }
    const TemporaryFolder folder;
};

/// /frame_hash differs wherever codes do; most tests are about the rest.
const DiffOptions but_hashes{.ignored = {"/frame_hash"}};

TEST_CASE("a dataset does not differ from itself", "[diff]") {
    const Pair pair([](Dataset&) {});
    CHECK(pair.diff().same());
    CHECK(pair.diff().n_frames == 7);
    CHECK(pair.diff().first() == nullptr);
}

TEST_CASE("the first differing frame and field are named with both values", "[diff]") {
    const Pair pair([](Dataset& dataset) {
        // frame 4, chirp 1, rx 0, sample 13; then more of it and of a later frame
        std::int16_t* const codes = &dataset.adc[4 * dataset.codes_per_frame()];
        codes[48 + 13] = static_cast<std::int16_t>(codes[48 + 13] ^ 0x40);
        codes[48 + 15] = static_cast<std::int16_t>(codes[48 + 15] ^ 1);
        dataset.adc[6 * dataset.codes_per_frame()] ^= 1;
        dataset.truth[5].bow_m += 0.25;
    });
    const DatasetDiff diff = pair.diff(but_hashes);
    REQUIRE(diff.fields.size() == 2);
    CHECK(diff.heads.empty());
    const FieldDifference& first = *diff.first();
    CHECK(first.table == "/adc");
    CHECK(first.first_place == "/adc[4, 1, 0, 13]");
    CHECK(first.unit == "LSB");
    CHECK(first.n_frames == 2);
    CHECK(first.n_values == 3);
    CHECK(first.largest == 64.0);
    CHECK(std::abs(std::stoi(first.value_a) - std::stoi(first.value_b)) == 64);
    CHECK(diff.fields[1].table == "/truth/bow_m");
    CHECK(diff.fields[1].largest == Approx(0.25));
    CHECK(diff.n_different_frames == 3);
    CHECK(pair.diff().fields.size() == 3);  // with /frame_hash
}

TEST_CASE("an LSB is let pass where it is asked for, two are not", "[diff]") {
    const Pair pair([](Dataset& dataset) {
        for (const std::size_t at : {5u, 100u})
            dataset.adc[at] = static_cast<std::int16_t>(dataset.adc[at] > 0 ? dataset.adc[at] - 1
                                                                            : dataset.adc[at] + 1);
    });
    DiffOptions options = but_hashes;
    CHECK(pair.diff(options).fields.front().n_values == 2);
    options.tolerance_lsb = 1.0;
    CHECK(pair.diff(options).same());
    CHECK(pair.diff(options).n_tolerated == 2);
    options.tolerance_lsb = 0.5;
    CHECK_FALSE(pair.diff(options).same());
}

TEST_CASE("a relative tolerance is one of floating-point tables only", "[diff]") {
    const Pair pair([](Dataset& dataset) {
        dataset.features[3] *= 1.0 + 1e-12;
        dataset.truth[2].label = static_cast<std::uint8_t>(2 - dataset.truth[2].label);
    });
    DiffOptions options = but_hashes;
    options.relative = 1e-9;
    const DatasetDiff diff = pair.diff(options);
    REQUIRE(diff.fields.size() <= 1);
    if (!diff.fields.empty()) CHECK(diff.fields.front().table == "/label");
    CHECK(diff.n_tolerated == 1);
}

TEST_CASE("attributes, shapes and missing tables are told", "[diff]") {
    const Pair pair([](Dataset& dataset) {
        dataset.origin.seed = 17;
        dataset.unknown_truth[3] = true;
        dataset.truth.pop_back();
        dataset.adc.resize(6 * dataset.codes_per_frame());
        dataset.adc_quadrature.resize(dataset.adc.size());
        dataset.profile.resize(6 * dataset.profile_per_frame());
        dataset.features.resize(24);
        dataset.probability.resize(12);
    });
    const DatasetDiff diff = pair.diff();
    const auto has = [&](const std::string& text) {
        return std::any_of(diff.heads.begin(), diff.heads.end(), [&](const std::string& head) {
            return head.find(text) != std::string::npos;
        });
    };
    CHECK(has("@seed: \"18446744073709551615\" against \"17\""));
    CHECK(has("rows of tables: 7 against 6"));
    CHECK(has(std::string("/truth/") + truth_columns[3].name + ": only in A"));
    CHECK(has("@left_out"));
    CHECK(diff.fields.empty());  // the six frames that both have are the same
    CHECK(diff.n_frames == 6);
}

TEST_CASE("tables of other widths are told and not compared", "[diff]") {
    const Pair pair([](Dataset& dataset) {
        dataset.n_chirps = 1;
        dataset.adc.resize(dataset.adc.size() / 2);
        dataset.adc_quadrature.resize(dataset.adc.size());
    });
    const DatasetDiff diff = pair.diff(but_hashes);
    CHECK(diff.heads ==
          std::vector<std::string>{"/adc: 7 x 2 x 3 x 16 against 7 x 1 x 3 x 16",
                                   "/adc_quadrature: 7 x 2 x 3 x 16 against 7 x 1 x 3 x 16"});
    CHECK(diff.fields.empty());
}

TEST_CASE("what is ignored is not compared, and what is nowhere cannot be ignored", "[diff]") {
    const Pair pair([](Dataset& dataset) {
        dataset.origin.seed = 1;
        dataset.truth[0].height_m += 1.0;
        dataset.truth[1].bow_m += 1.0;
    });
    CHECK(pair.diff({.ignored = {"@seed", "/truth"}}).same());
    CHECK_FALSE(pair.diff({.ignored = {"@seed", "/truth/bow_m"}}).same());
    CHECK(message_of([&] {
              return pair.diff({.ignored = {"/truht"}});
          }).rfind("--ignore /truht: no such table", 0) == 0);
}

TEST_CASE("the file that cannot be read is named, whichever of the two", "[diff]") {
    const Pair pair([](Dataset&) {});
    const auto bad = pair.folder / "bad.h5";
    std::ofstream(bad) << "not HDF5";
    const auto good = pair.folder / "a.h5";
    for (const auto& [a, b] : {std::pair{bad, good}, {good, bad}})
        CHECK(message_of([&, a = a, b = b] {
                  return diff_datasets(a, b, {});
              }).rfind(bad.string() + ": file: ", 0) == 0);
}

}  // namespace
}  // namespace specula
