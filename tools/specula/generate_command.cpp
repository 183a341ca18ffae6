#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/generate/generate.hpp"
#include "tools/generate/merge.hpp"
#include "tools/generate/preflight.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/dataset_commands.hpp"

namespace specula {

namespace fs = std::filesystem;

namespace {

fs::path recipe_file(const std::string& wanted, const Catalogue& catalogue) {
    if (fs::path(wanted).extension() == ".toml") return wanted;
    const auto datasets = catalogue.dataset_names(), experiments = catalogue.experiment_names();
    const auto holds = [&](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), wanted) != names.end();
    };
    if (holds(datasets)) return catalogue.dataset_file(wanted);
    if (holds(experiments)) return catalogue.experiment_file(wanted);
    std::vector<std::string> names = datasets;
    names.insert(names.end(), experiments.begin(), experiments.end());
    const std::string near = nearest_word(wanted, names);
    throw InputError(format("\"{}\": no such dataset or experiment; {}use {} or a .toml file",
                            wanted, near.empty() ? "" : "did you mean " + near + "? ",
                            quoted_list(names)));
}

std::string environment(const std::string& name) {
    const char* value = std::getenv(name.c_str());
    return value ? value : "";
}

void print_report(const GenerateReport& report, const Share& share, const fs::path& out) {
    if (report.file.empty()) {
        std::printf("Share %zu/%zu is done; of the whole run, %zu of %zu shards are in %s\n",
                    share.index, share.count, report.n_shards_finished, report.n_shards,
                    is_folder_output(out) ? out.c_str() : (out.string() + ".parts").c_str());
        std::printf("When all shares are: specula merge %s -o %s\n",
                    is_folder_output(out) ? out.c_str() : (out.string() + ".parts").c_str(),
                    out.c_str());
        return;
    }
    if (report.n_recorded == 0) std::printf("Everything was recorded already.\n");
    if (report.is_undocumented)
        std::printf(
            "No Croissant metadata beside it told its SHA-256: codes, profiles, features and labels "
            "were held against the hash of each frame, /truth and /group against HDF5's checksums "
            "alone.\n");
    std::printf("Wrote %s: %zu frames, %s", report.file.c_str(), report.n_frames,
                bytes_text(report.bytes).c_str());
    if (report.n_recorded > 0)
        std::printf("; %zu recorded in %s, %.0f/s, %s at most in memory", report.n_recorded,
                    seconds_text(report.seconds).c_str(),
                    static_cast<double>(report.n_recorded) / report.seconds,
                    bytes_text(report.peak_resident_bytes).c_str());
    std::printf("\nfingerprint %s\n", report.fingerprint.c_str());
}

}  // namespace

void generate_command(const GenerateArguments& arguments, const Catalogue& catalogue) {
    const Share share = read_share(arguments.share, environment);
    const Recipe recipe = read_recipe({.file = recipe_file(arguments.experiment, catalogue),
                                       .condition = arguments.condition,
                                       .seed = arguments.seed,
                                       .worlds = arguments.worlds,
                                       .store = arguments.store},
                                      catalogue);
    const fs::path out =
        arguments.out.empty() ? fs::path("out") / (recipe.name + ".h5") : arguments.out;
    const auto say = [](const std::string& line) {
        std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    };
    const GenerateReport report =
        run_generate(recipe, {.out = out, .share = share, .threads = arguments.threads, .say = say},
                     catalogue.materials);
    print_report(report, share, out);
    if (!report.file.empty()) describe_written(report.file, arguments.threads);
}

void merge_command(const MergeArguments& arguments) {
    const MergeReport report = run_merge({.folders = arguments.folders, .out = arguments.out});
    std::printf("Wrote %s: %zu frames of %zu shards, %s\nfingerprint %s\n", report.file.c_str(),
                report.n_frames, report.n_shards, bytes_text(report.bytes).c_str(),
                report.fingerprint.c_str());
    describe_written(report.file, arguments.threads);
    if (!is_folder_output(arguments.out)) std::printf("The shards are no longer needed.\n");
}

}  // namespace specula
