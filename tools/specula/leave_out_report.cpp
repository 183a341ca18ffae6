#include "tools/specula/leave_out_report.hpp"

#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "classifier/cross_validation.hpp"
#include "classifier/metrics.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/format.hpp"
#include "sim/core/version.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "tools/specula/evaluation_json.hpp"
#include "tools/specula/evaluation_text.hpp"
#include "tools/specula/learning.hpp"
#include "tools/specula/output_place.hpp"
#include "tools/study/progress.hpp"

namespace specula {

namespace {

using Json = nlohmann::ordered_json;

const std::map<std::string, LeaveOut> splits{{"frame", LeaveOut::frame},
                                             {"session", LeaveOut::session},
                                             {"view", LeaveOut::view},
                                             {"object", LeaveOut::sample}};

/// Mean and standard deviation over repeats.
struct Score {
    double sum = 0.0, squares = 0.0, n = 0.0;

    void add(double value) {
        sum += value;
        squares += value * value;
        n += 1.0;
    }
    double mean() const { return sum / n; }
    double deviation() const { return std::sqrt(std::max(0.0, squares / n - mean() * mean())); }
    std::string text() const {
        return format("{:5.1f} +- {:.1f} %", 100.0 * mean(), 100.0 * deviation());
    }
    Json json() const { return {{"mean", mean()}, {"standard_deviation", deviation()}}; }
};

/// Share of groups of frames whose most frequent answer is right.
double vote_accuracy(const FeatureTable& rows, std::span<const std::uint8_t> predicted) {
    std::map<std::int32_t, std::map<std::uint8_t, int>> votes;
    std::map<std::int32_t, std::uint8_t> truth;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ++votes[rows.session[i]][predicted[i]];
        truth[rows.session[i]] = rows.label[i];
    }
    double right = 0.0;
    for (const auto& [session, counts] : votes) {
        const auto most =
            std::max_element(counts.begin(), counts.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        right += most->first == truth[session] ? 1.0 : 0.0;
    }
    return right / static_cast<double>(votes.size());
}

struct SplitScores {
    Score frames, sessions, shuffled;
    Confusion confusion;
};

SplitScores cross_validate(const FeatureTable& rows, const Dataset& dataset, LeaveOut what,
                           const EvaluateArguments& arguments, Progress& progress) {
    const Learning& learning = arguments.learning;
    const auto of_rows = [&](LeaveOut kind) {
        const auto of_frames = groups_of(dataset, kind);
        std::vector<std::int32_t> groups;
        for (const std::size_t frame : first_frames(dataset, chosen_descriptor(learning, dataset)))
            groups.push_back(of_frames[frame]);
        return groups;
    };
    const auto group = of_rows(what);
    if (what != LeaveOut::frame) expect_groups_in_classes(rows, group, what);
    const auto pieces =
        arguments.leak_check ? of_rows(LeaveOut::sample) : std::vector<std::int32_t>{};
    CrossValidation how{.fold = deal_folds(rows, group, arguments.folds),
                        .n_folds = arguments.folds,
                        .options = training_options(learning),
                        .neighbours = arguments.neighbours,
                        .seed = learning.seed,
                        .threads = learning.threads};
    SplitScores scores;
    scores.confusion = Confusion(rows.class_names.size());
    for (int repeat = 0; repeat < arguments.repeats; ++repeat) {
        how.seed = learning.seed + static_cast<std::uint64_t>(repeat);
        const auto predicted = cross_predict(rows, how, &progress.done());
        scores.frames.add(accuracy(rows.label, predicted));
        scores.sessions.add(vote_accuracy(rows, predicted));
        const Confusion once = confusion_of(rows.label, predicted, rows.class_names.size());
        for (std::size_t i = 0; i < once.counts.size(); ++i)
            scores.confusion.counts[i] += once.counts[i];
        if (!arguments.leak_check) continue;
        const FeatureTable shuffled =
            with_shuffled_classes(rows, pieces, {.seed = how.seed, .purpose = "leak check"});
        CrossValidation again = how;
        again.fold = deal_folds(shuffled, group, arguments.folds);
        scores.shuffled.add(
            accuracy(shuffled.label, cross_predict(shuffled, again, &progress.done())));
    }
    return scores;
}

void print_scores(const std::map<std::string, SplitScores>& all, const EvaluateArguments& arguments,
                  const std::vector<std::string>& class_names) {
    std::printf("%-10s %16s %16s %s\n", "left out", "frames right", "sessions right",
                arguments.leak_check ? "    shuffled classes" : "");
    for (const std::string& split : arguments.leave_out) {
        const SplitScores& scores = all.at(split);
        std::printf("%-10s %16s %16s %s\n", split.c_str(), scores.frames.text().c_str(),
                    scores.sessions.text().c_str(),
                    arguments.leak_check ? ("    " + scores.shuffled.text()).c_str() : "");
    }
    if (arguments.leak_check)
        std::printf(
            "\nshuffled classes: the classes of the objects exchanged by chance, so that "
            "nothing but the object\ncan be learnt; %.0f %% is chance, and what is above it "
            "a split gives away for knowing the object.\n",
            100.0 / static_cast<double>(class_names.size()));
    for (const std::string& split : arguments.leave_out) {
        std::printf("\n%s left out, all repeats together:", split.c_str());
        print_confusion(all.at(split).confusion, class_names);
    }
}

std::string scores_json(const std::map<std::string, SplitScores>& all,
                        const EvaluateArguments& arguments, const Dataset& dataset,
                        const FeatureTable& rows) {
    Json json{{"format", "specula-cross-validation"},
              {"format_version", 1},
              {"software_version", program_version},
              {"data", arguments.what[0]},
              {"data_fingerprint", fingerprint(dataset)},
              {"descriptor", chosen_descriptor(arguments.learning, dataset).text()},
              {"class_names", dataset.class_names},
              {"frames", rows.size()},
              {"folds", arguments.folds},
              {"repeats", arguments.repeats},
              {"seed", arguments.learning.seed},
              {"neighbours", arguments.neighbours},
              {"left_out", Json::object()}};
    for (const auto& [split, scores] : all) {
        Json& of_split = json["left_out"][split];
        of_split = {{"frames_right", scores.frames.json()},
                    {"sessions_right", scores.sessions.json()}};
        if (arguments.leak_check)
            of_split["frames_right_of_shuffled_classes"] = scores.shuffled.json();
        of_split["confusion_true_by_predicted"] = confusion_json(scores.confusion);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

void evaluate_left_out(const EvaluateArguments& arguments) {
    if (!arguments.json.empty()) prepare_output(arguments.json, {arguments.what[0]}, "--json");
    const Dataset dataset = dataset_from(arguments.what[0]);
    const Descriptor descriptor = chosen_descriptor(arguments.learning, dataset);
    const FeatureTable rows = described(dataset, descriptor, arguments.learning.threads);
    std::map<std::string, SplitScores> all;
    {
        const auto n_models = arguments.leave_out.size() *
                              static_cast<std::size_t>(arguments.folds * arguments.repeats *
                                                       (arguments.leak_check ? 2 : 1));
        Progress progress("Training", "models", n_models);
        for (const std::string& split : arguments.leave_out)
            all[split] = cross_validate(rows, dataset, splits.at(split), arguments, progress);
    }
    std::printf("%zu frames, descriptor %s, %d folds, %d repeats (mean +- standard deviation)\n\n",
                rows.size(), descriptor.text().c_str(), arguments.folds, arguments.repeats);
    print_scores(all, arguments, dataset.class_names);
    if (arguments.json.empty()) return;
    write_file_atomically(arguments.json, scores_json(all, arguments, dataset, rows));
    std::printf("\nWrote %s\n", arguments.json.c_str());
}

}  // namespace specula
