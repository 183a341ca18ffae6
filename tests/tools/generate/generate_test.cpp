#include "tools/generate/generate.hpp"

#include <fstream>

#include "sim/core/error.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/dataset_reader.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "sim/dataset/sha256.hpp"
#include "sim/generate.hpp"
#include "tests/check.hpp"
#include "tests/message_of.hpp"
#include "tests/sim/dataset/made_up_dataset.hpp"
#include "tests/tools/generate/small_recipe.hpp"
#include "tools/generate/merge.hpp"
#include "sim/core/output_lock.hpp"
#include "tools/generate/record_session.hpp"

namespace specula {
namespace {

namespace fs = std::filesystem;

/// The dataset in one go by one thread: what all other ways must come to.
class Reference {
  public:
    Reference() : recipe(small.read()) {
        report = run_generate(recipe, {.out = small.folder / "one.h5", .say = {}},
                              own_catalogue().materials);
        bytes = bytes_of(small.folder / "one.h5");
    }
    SmallRecipe small;
    Recipe recipe;
    GenerateReport report;
    std::string bytes;
};

const Reference& reference() {
    static const Reference made;
    return made;
}

GenerateReport run(const fs::path& out, const Share& share = {}, int threads = 2) {
    return run_generate(reference().recipe,
                        {.out = out, .share = share, .threads = threads, .say = {}},
                        own_catalogue().materials);
}

TEST_CASE("the file is that of the whole dataset, simulated at once and written at once",
          "[generate]") {
    const Recipe& recipe = reference().recipe;
    Dataset whole =
        generate(bench_of(recipe, own_catalogue().materials), recipe.condition, recipe.worlds, 2);
    const Dataset made = read_dataset(reference().report.file);
    CHECK(made.adc == whole.adc);
    CHECK(made.truth.size() == whole.truth.size());
    whole.origin = made.origin;
    whole.feature_names = made.feature_names;
    whole.features = made.features;
    write_dataset(reference().small.folder / "whole.h5", whole);
    CHECK(bytes_of(reference().small.folder / "whole.h5") == reference().bytes);
    CHECK(reference().report.fingerprint == fingerprint(whole));
    CHECK(reference().report.n_frames == whole.n_frames());
    CHECK(reference().report.n_shards > 1);
    CHECK_FALSE(fs::exists(reference().small.folder / "one.h5.parts"));
}

TEST_CASE("any number of threads and any shares make the same bytes", "[generate]") {
    const TemporaryFolder folder;
    run(folder / "threads.h5", {}, 3);
    CHECK(bytes_of(folder / "threads.h5") == reference().bytes);
    for (const std::size_t index : {2u, 0u, 1u}) {
        const GenerateReport share = run(folder / "shared.h5", {index, 3});
        CHECK(share.file.empty());
    }
    const MergeReport merged = run_merge({{folder / "shared.h5.parts"}, folder / "shared.h5"});
    CHECK(bytes_of(folder / "shared.h5") == reference().bytes);
    CHECK(merged.fingerprint == reference().report.fingerprint);
}

TEST_CASE("shards that are there are kept, drafts go, and the end is the same", "[generate]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "resumed.h5", parts = folder / "resumed.h5.parts";
    run(out, {0, 2});  // every second shard, as if killed
    const auto before = fs::last_write_time(parts / "shard-000000.h5");
    std::ofstream(parts / "shard-000001.h5.draft-123") << "half";
    std::ofstream(folder / "resumed.h5.draft-124") << "half";
    fs::remove(parts / "manifest-0-of-2.sha256");  // killed before it was written
    std::ofstream(parts / "manifest-0-of-2.sha256") << "0123";
    {
        const GenerateReport again = run(out, {0, 2});
        CHECK(again.n_recorded == 0);
        CHECK(fs::last_write_time(parts / "shard-000000.h5") == before);
    }
    const GenerateReport report = run(out);
    CHECK(report.n_recorded < report.n_frames);
    CHECK(bytes_of(out) == reference().bytes);
    CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a shard cut short is named with what to do, one that is no part of the run with its name",
          "[generate]") {
    const TemporaryFolder folder;
    const fs::path out = folder / "a.h5", parts = folder / "a.h5.parts";
    run(out, {0, 2});
    const fs::path shard = parts / "shard-000002.h5", stray = parts / "shard-000009.h5";
    fs::copy_file(parts / "shard-000000.h5", stray);
    const std::string said = [&] {
        std::string lines;
        run_generate(reference().recipe,
                     {.out = out,
                      .share = {0, 2},
                      .threads = 1,
                      .say = [&](const std::string& line) { lines += line + "\n"; }},
                     own_catalogue().materials);
        return lines;
    }();
    CHECK(said == stray.string() + ": is no part of this run and is passed over; remove it\n");
    CHECK(message_of([&] { return run_merge({{parts}, out}); }) ==
          stray.string() + ": is no part of this run: remove it");
    fs::resize_file(shard, fs::file_size(shard) / 2);
    const std::string message = message_of([&] { return run(out, {0, 2}); });
    INFO(message);
    CHECK(message.rfind(shard.string() + ": ", 0) == 0);
    CHECK(message.find("; remove it, and the same command makes it again") != std::string::npos);
    fs::remove(shard);
    run(out);
    CHECK(bytes_of(out) == reference().bytes);
}

TEST_CASE("a finished file is left alone, another recipe's never overwritten", "[generate]") {
    const TemporaryFolder folder;
    fs::copy_file(reference().report.file, folder / "a.h5");
    fs::create_directory(folder / "a.h5.parts");  // killed before it was removed
    const GenerateReport again = run(folder / "a.h5");
    CHECK(again.n_recorded == 0);
    CHECK(again.fingerprint == reference().report.fingerprint);
    CHECK_FALSE(fs::exists(folder / "a.h5.parts"));

    const Recipe other = reference().small.read({.seed = 6});
    const auto refusal = [&](const fs::path& out) {
        return message_of([&] {
            return run_generate(other, {.out = out, .say = {}}, own_catalogue().materials);
        });
    };
    CHECK(refusal(folder / "a.h5").find("was made otherwise: seed = 5 there, 6 here") !=
          std::string::npos);
    CHECK(bytes_of(folder / "a.h5") == reference().bytes);
    run(folder / "b.h5", {0, 2});
    CHECK(refusal(folder / "b.h5").find("shard-000000.h5: was made otherwise: seed = 5") !=
          std::string::npos);
}

TEST_CASE("a folder keeps its shards behind an index that reads as one dataset", "[generate]") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "kept");
    const GenerateReport report = run(folder / "kept");
    CHECK(report.file == folder / "kept" / "index.h5");
    CHECK(report.fingerprint == reference().report.fingerprint);
    const Dataset indexed = read_dataset(report.file);
    const Dataset whole = read_dataset(reference().report.file);
    CHECK(indexed.adc == whole.adc);
    CHECK(indexed.features == whole.features);
    CHECK(fingerprint(indexed) == fingerprint(whole));
    const std::string command =
        "cd '" + (folder / "kept").string() + "' && sha256sum --quiet -c manifest.sha256";
    CHECK(std::system(command.c_str()) == 0);
    CHECK(run(folder / "kept").n_recorded == 0);

    fs::remove(folder / "kept" / "shard-000001.h5");  // HDF5 alone would give zeros
    CHECK(message_of([&] {
              return read_dataset(report.file);
          }).find("shows shard-000001.h5, which is not there") != std::string::npos);
}

TEST_CASE("a shard that a finished folder lost is made again, a damaged one is named", "[generate]") {
    const TemporaryFolder folder;
    const fs::path kept = folder / "kept", shard = kept / "shard-000001.h5";
    fs::create_directory(kept);
    const GenerateReport first = run(kept);
    const std::string hash = sha256_of_file(shard);
    fs::remove(shard);
    fs::remove(kept / "manifest.sha256");
    const GenerateReport again = run(kept);
    CHECK(again.n_recorded > 0);
    CHECK(again.n_recorded < first.n_recorded);
    CHECK(again.fingerprint == first.fingerprint);
    CHECK(sha256_of_file(shard) == hash);
    std::fstream(shard, std::ios::in | std::ios::out).seekp(3000).put('X');
    CHECK(message_of([&] { return run(kept).n_recorded; }).find("shard-000001.h5: is damaged") !=
          std::string::npos);
}

TEST_CASE("a finished file that was damaged is named with what to do, and is not touched",
          "[generate]") {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.h5";
    const std::string& whole = reference().bytes;
    const auto refusal_of = [&](const std::string& bytes) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
        const std::string message = message_of([&] { return run(file).n_recorded; });
        CHECK(bytes_of(file) == bytes);
        return message;
    };
    // Codes, which are most of the file: one bit anywhere in them.
    std::size_t named = 0, tried = 0;
    for (std::size_t at = whole.size() / 8; at < whole.size(); at += whole.size() / 8, ++tried) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        const std::string message = refusal_of(damaged);
        INFO(at << ": " << message);
        named += message.rfind(file.string() + ": /", 0) == 0 &&
                 message.find("remove it, and the same command makes it again") !=
                     std::string::npos;
    }
    CHECK(named == tried);
    CHECK(refusal_of(whole.substr(0, whole.size() / 2)).find("name another output, or remove it") !=
          std::string::npos);
    fs::remove(file);
    CHECK(run(file).n_recorded > 0);
    CHECK(bytes_of(file) == whole);
}

TEST_CASE("an index that was damaged is named, and made again without simulating", "[generate]") {
    const TemporaryFolder folder;
    const fs::path kept = folder / "kept", index = kept / "index.h5";
    fs::create_directory(kept);
    run(kept);
    const std::string whole = bytes_of(index);
    std::string damaged = whole;
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 4);
    std::ofstream(index, std::ios::binary | std::ios::trunc) << damaged;
    CHECK(message_of([&] { return run(kept).n_recorded; }).find("index.h5: ") !=
          std::string::npos);
    fs::remove(index);
    CHECK(run(kept).n_recorded == 0);
    CHECK(bytes_of(index) == whole);
}

TEST_CASE("an output that is no file is refused, one that a link names is made", "[generate]") {
    CHECK(message_of([] { return run("/dev/full").n_recorded; }) ==
          "/dev/full: is there, and is no file; give another name");
    const TemporaryFolder folder;
    fs::create_symlink("far.h5", folder / "near.h5");
    run(folder / "near.h5");
    CHECK(fs::is_symlink(folder / "near.h5"));
    CHECK(bytes_of(folder / "far.h5") == reference().bytes);
}

TEST_CASE("profiles and features are what the firmware makes of the codes", "[generate]") {
    const TemporaryFolder folder;
    const Recipe recipe = reference().small.read({.worlds = 1, .store = {"profiles", "features"}});
    run_generate(recipe, {.out = folder / "a.h5", .say = {}}, own_catalogue().materials);
    const Dataset made = read_dataset(folder / "a.h5");
    CHECK(made.adc.empty());
    // Sessions of world 0 come first, so the reference's first frames are the same frames.
    const Dataset codes = DatasetReader(reference().report.file).read({0, 1});
    const auto n_rx = static_cast<std::size_t>(codes.n_rx);
    const auto n_bins = static_cast<std::size_t>(made.n_profile_bins);
    CHECK(made.profile_bin_m == Approx(codes.origin.bin_m));
    for (std::size_t k = 0; k < made.feature_names.size(); ++k) {
        double mean = 0.0;  // the descriptor is the mean over receivers too
        for (std::size_t rx = 0; rx < n_rx; ++rx)
            mean +=
                made.profile[rx * n_bins + FW_DEFAULT_FIRST_BIN + k] / static_cast<double>(n_rx);
        CHECK(made.features[k] == Approx(mean).epsilon(1e-5));
        CHECK(made.features[k] == codes.features[k]);
    }
}

TEST_CASE("a second process is refused by the name of the first", "[generate]") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "a.h5.parts");
    const OutputLock held(folder / "a.h5.parts" / "lock", OutputLock::Kind::alone);
    for (const Share& share : {Share{}, Share{1, 2}})
        CHECK(message_of([&] { return run(folder / "a.h5", share); }) ==
              (folder / "a.h5.parts").string() + ": process " + std::to_string(::getpid()) +
                  " on " +
                  [] {
                      char host[256] = {};
                      ::gethostname(host, sizeof host - 1);
                      return std::string(host);
                  }() +
                  " is writing here; wait for it, or stop it first");
}

}  // namespace
}  // namespace specula
