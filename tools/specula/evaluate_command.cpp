#include <algorithm>
#include <cstdio>
#include <set>

#include "classifier/assessment.hpp"
#include "classifier/model_file.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/document.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "tools/report/confusion_figure.hpp"
#include "tools/report/reliability_figure.hpp"
#include "tools/report/render_figure.hpp"
#include "tools/report/risk_coverage_figure.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/evaluation_json.hpp"
#include "tools/specula/evaluation_text.hpp"
#include "tools/specula/learning.hpp"
#include "tools/specula/leave_out_report.hpp"
#include "tools/specula/output_place.hpp"

namespace specula {

namespace {

/// Rows of a file and what the model says about them.
struct Answered {
    FeatureTable rows;
    Predictions answers;
    std::string fingerprint;
};

/// A model, its file, and what its answers need besides.
struct Judge {
    const Model& model;
    const std::string& file;
    const Catalogue& catalogue;
    int threads;
};

Answered answer(const std::string& file, const Judge& judge) {
    const Model& model = judge.model;
    Dataset dataset = dataset_from(file);
    const std::string hash = fingerprint(dataset);
    try {
        count_classes_as(model, judge.file, dataset);
        expect_measured_for(model, dataset, judge.catalogue);
        Answered answered{.rows = rows_for(model, dataset, judge.threads),
                          .answers = {},
                          .fingerprint = hash};
        answered.answers = predict(fold(model), answered.rows);
        return answered;
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", file, error.what()));
    }
}

/// Class -> merged class: the named ones together, the others each alone.
std::vector<int> merged_map(const std::vector<std::string>& merged,
                            const std::vector<std::string>& class_names) {
    if (merged.empty()) return {};
    for (const std::string& name : merged)
        if (std::ranges::find(class_names, name) == class_names.end())
            throw InputError(format("--merge: \"{}\" is no class of the data; use {}", name,
                                    quoted_list(class_names)));
    if (std::set<std::string>(merged.begin(), merged.end()).size() < 2)
        throw InputError(format("--merge = {}: is one class; name two or more that count as one, "
                                "e.g. aluminium,iron",
                                merged.front()));
    std::vector<int> map;
    int next = 1;
    for (const std::string& name : class_names)
        map.push_back(std::ranges::find(merged, name) != merged.end() ? 0 : next++);
    return map;
}

std::string merged_text(const std::vector<std::string>& merged) {
    std::string text;
    for (const std::string& name : merged) text += (text.empty() ? "  " : "+") + name;
    return merged.empty() ? "" : text + " as one";
}

void draw_figures(const std::filesystem::path& folder, const Assessment& assessment,
                  const EvaluationFacts& facts) {
    ConditionReport condition;
    condition.name = "evaluation";
    condition.title = std::filesystem::path(facts.data).filename().string();
    condition.confusion = assessment.confusion;
    condition.macro_f1 = assessment.macro_f1;
    condition.macro_f1_per_world.resize(assessment.n_worlds);
    write_figure(folder, confusion_figure("confusion", condition, facts.class_names));
    write_figure(folder, reliability_figure("reliability", condition.title,
                                            {.raw = assessment.reliability,
                                             .scaled = assessment.reliability_scaled,
                                             .temperature = facts.temperature}));
    write_figure(folder,
                 risk_coverage_figure("risk_coverage", condition.title, assessment.risk_coverage));
    std::printf("\nWrote confusion, reliability and risk_coverage (.svg, .png, .csv) to %s\n",
                folder.c_str());
}

std::optional<Departure> compared(const std::optional<Answered>& nominal, const Answered& asked,
                                  const Model& model) {
    if (!nominal) return std::nullopt;
    const InputMonitor* const spread = model.monitor ? &*model.monitor : nullptr;
    std::optional<Prototypes> kept;
    if (model.prototypes) kept = prototypes_of(*model.prototypes);
    const Prototypes* const prototypes = kept ? &*kept : nullptr;
    const auto observed = [&](const Answered& answered) {
        return Observed{.rows = answered.rows,
                        .predictions = answered.answers,
                        .spread = spread,
                        .prototypes = prototypes};
    };
    return departure_from(observed(*nominal), observed(asked));
}

/// A model of specula train says of which dataset it is.
bool learnt_from(const Model& model, const std::string& fingerprint) {
    return std::ranges::find(model.provenance, std::pair<std::string, std::string>{
                                                   "dataset", fingerprint}) !=
           model.provenance.end();
}

void check_nominal(const EvaluateArguments& arguments, const Judge& judge, const Answered& nominal,
                   const Answered& asked) {
    if (nominal.fingerprint == asked.fingerprint)
        throw InputError(format("--nominal = {}: holds the frames of {}, and nothing departs from "
                                "itself; name nominal data of other sessions",
                                arguments.nominal, arguments.what[1]));
    if (learnt_from(judge.model, nominal.fingerprint))
        throw InputError(format("--nominal = {}: holds the frames that {} learnt from, which are "
                                "more familiar than any others; name nominal data recorded anew",
                                arguments.nominal, judge.file));
}

void evaluate_model(const EvaluateArguments& arguments, const Catalogue& catalogue) {
    const std::string& model_file = arguments.what[0];
    const std::string& data = arguments.what[1];
    if (!arguments.figure.empty()) make_output_folder(arguments.figure);
    if (!arguments.json.empty())
        prepare_output(arguments.json, {model_file, data, arguments.nominal}, "--json");
    const Model model = read_model(model_file);
    const Judge judge{model, model_file, catalogue, arguments.learning.threads};
    const std::vector<int> merged = merged_map(arguments.merged, model.class_names);
    const Answered asked = answer(data, judge);
    std::optional<Answered> nominal;
    if (!arguments.nominal.empty()) nominal = answer(arguments.nominal, judge);
    if (nominal) check_nominal(arguments, judge, *nominal, asked);

    EvaluationFacts facts{.model = model_file,
                          .data = data,
                          .fingerprint = asked.fingerprint,
                          .is_training_data = learnt_from(model, asked.fingerprint),
                          .nominal = arguments.nominal,
                          .class_names = model.class_names,
                          .merged = arguments.merged};
    if (nominal)
        facts.temperature =
            fit_temperature({.values = nominal->answers.logits, .n_classes = model.n_classes()},
                            nominal->rows.label);
    const Assessment assessment =
        assess(asked.rows, asked.answers,
               {.merged_class = merged,
                .temperature = facts.temperature,
                .resampling = {.key = {.seed = arguments.learning.seed, .purpose = "bootstrap"}}});
    const std::optional<Departure> departure = compared(nominal, asked, model);

    if (facts.is_training_data)
        std::printf("NOTE: these are the frames the model learnt from: this says nothing about "
                    "others.\n\n");
    print_assessment(assessment, {.class_names = model.class_names,
                                  .merged_label = merged_text(arguments.merged),
                                  .has_temperature = nominal.has_value()});
    if (departure) print_departure(*departure);
    if (!arguments.json.empty()) {
        write_file_atomically(arguments.json, evaluation_json(facts, assessment, departure));
        std::printf("\nWrote %s\n", arguments.json.c_str());
    }
    if (!arguments.figure.empty()) draw_figures(arguments.figure, assessment, facts);
}

/// An option that changes nothing here would be thought to have done something.
void check_given(const EvaluateArguments& arguments) {
    static const std::set<std::string> of_neighbours{
        "--neighbours", "--folds", "--repeats", "--leak-check", "--bins", "--descriptor"};
    for (const std::string& option : arguments.given) {
        if (arguments.leave_out.empty())
            throw InputError(option +
                             ": goes with --leave-out, and a trained model is judged as it is; "
                             "leave the option out");
        if (arguments.neighbours > 0 && !of_neighbours.contains(option))
            throw InputError(option +
                             ": is of a network, and --neighbours trains none; leave one of the "
                             "two out");
    }
}

void check_arguments(const EvaluateArguments& arguments) {
    const bool cross = !arguments.leave_out.empty();
    check_given(arguments);
    expect_heeded(arguments.given, arguments.learning, {});
    if (arguments.what.size() != (cross ? 1u : 2u))
        throw InputError(cross ? "--leave-out trains its own models; name the dataset alone"
                               : "name a model and a dataset, or a dataset with --leave-out");
    if (cross &&
        !(arguments.figure.empty() && arguments.merged.empty() && arguments.nominal.empty()))
        throw InputError("--figure, --merge and --nominal go with a model, not with --leave-out");
}

}  // namespace

void evaluate_command(const EvaluateArguments& arguments, const Catalogue& catalogue) {
    check_arguments(arguments);
    if (arguments.leave_out.empty()) {
        evaluate_model(arguments, catalogue);
        return;
    }
    try {
        evaluate_left_out(arguments);
    } catch (const InputError& error) {
        const std::string problem = error.what();
        const std::string& data = arguments.what.back();
        throw InputError(problem.starts_with(data) ? problem : data + ": " + problem);
    }
}

}  // namespace specula
