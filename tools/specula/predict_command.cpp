#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "classifier/class_probabilities.hpp"
#include "classifier/model_file.hpp"
#include "classifier/unfamiliarity.hpp"
#include "sim/core/atomic_file.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "tools/report/csv_table.hpp"
#include "tools/specula/commands.hpp"
#include "tools/specula/learning.hpp"
#include "tools/specula/output_place.hpp"

namespace specula {

namespace {

/// What a model makes of a dataset, row by row.
struct Answers {
    std::vector<std::size_t> frame;  ///< (row), the first of those that make it
    FeatureTable rows;
    Predictions predictions;
    ClassProbabilities probabilities;
    std::vector<std::string> monitor;        ///< names with units, as help explains them
    std::vector<std::vector<double>> score;  ///< (monitor, row)
    std::vector<bool> suspicious;            ///< (row); empty: the model has no limit
};

/// What a monitor looks at, under a name of its own: the plain quantity, not how unfamiliar it is.
struct Column {
    Monitor monitor;
    const char* name;
    double sign;  ///< of the quantity over its unfamiliarity
};
constexpr Column columns_of_monitors[] = {
    {Monitor::max_logit, "max_logit", -1.0},
    {Monitor::energy, "energy_nepers", 1.0},
    {Monitor::mahalanobis, "mahalanobis_squared", 1.0},
    {Monitor::prototypes, "prototype_distance_sd", 1.0}};

void add_monitors(const Model& model, Answers& answers) {
    std::optional<Prototypes> prototypes;
    if (model.prototypes) prototypes = prototypes_of(*model.prototypes);
    const Observed observed{.rows = answers.rows,
                            .predictions = answers.predictions,
                            .spread = model.monitor ? &*model.monitor : nullptr,
                            .prototypes = prototypes ? &*prototypes : nullptr};
    for (const Column& column : columns_of_monitors) {
        if (column.monitor == Monitor::mahalanobis && !model.monitor) continue;
        if (column.monitor == Monitor::prototypes && !prototypes) continue;
        std::vector<double> scores = unfamiliarity(column.monitor, observed);
        if (column.monitor == Monitor::mahalanobis)
            for (const double squared : scores)
                answers.suspicious.push_back(
                    squared > static_cast<double>(model.monitor->suspicious_squared));
        for (double& score : scores) score *= column.sign;
        answers.monitor.emplace_back(column.name);
        answers.score.push_back(std::move(scores));
    }
}

Answers answers_of(const Model& model, const Dataset& dataset, int threads) {
    Answers answers;
    answers.frame = first_frames(dataset, descriptor_of(model));
    answers.rows = rows_for(model, dataset, threads);
    answers.predictions = predict(fold(model), answers.rows);
    answers.probabilities =
        softmax({.values = answers.predictions.logits, .n_classes = answers.predictions.n_classes});
    add_monitors(model, answers);
    return answers;
}

std::string csv_of(const Answers& answers, const Model& model) {
    std::vector<std::string> header{"frame", "world", "session", "class", "probability"};
    for (const std::string& name : model.class_names) header.push_back("p_" + name);
    for (const std::string& name : answers.monitor) header.push_back(name);
    header.push_back("suspicious");
    CsvTable table(header);
    for (std::size_t i = 0; i < answers.rows.size(); ++i) {
        std::vector<std::string> row{
            format("{}", answers.frame[i]), format("{}", answers.rows.world[i]),
            format("{}", answers.rows.session[i]), model.class_names[answers.predictions.label[i]],
            format("{:.6g}", answers.predictions.probability[i])};
        for (const double p : answers.probabilities.row(i)) row.push_back(format("{:.6g}", p));
        for (const auto& score : answers.score) row.push_back(format("{:.6g}", score[i]));
        row.push_back(answers.suspicious.empty() ? "" : answers.suspicious[i] ? "1" : "0");
        table.add(row);
    }
    return table.text();
}

std::string json_of(const Answers& answers, const Model& model, const Dataset& dataset) {
    nlohmann::ordered_json json{{"format", "specula-predictions"},
                                {"format_version", 2},
                                {"data_fingerprint", fingerprint(dataset)},
                                {"class_names", model.class_names},
                                {"monitors", answers.monitor}};
    nlohmann::ordered_json provenance = nlohmann::ordered_json::object();
    for (const auto& [what, value] : model.provenance) provenance[what] = value;
    json["model"] = provenance;
    nlohmann::ordered_json frames = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < answers.rows.size(); ++i) {
        nlohmann::ordered_json frame{{"frame", answers.frame[i]},
                                     {"world", answers.rows.world[i]},
                                     {"session", answers.rows.session[i]},
                                     {"class", model.class_names[answers.predictions.label[i]]}};
        const auto p = answers.probabilities.row(i);
        frame["probabilities"] = std::vector<double>(p.begin(), p.end());
        for (std::size_t m = 0; m < answers.monitor.size(); ++m)
            frame[answers.monitor[m]] = answers.score[m][i];
        if (!answers.suspicious.empty()) frame["suspicious"] = bool(answers.suspicious[i]);
        frames.push_back(frame);
    }
    json["frames"] = frames;
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

void predict_command(const PredictArguments& arguments, const Catalogue& catalogue) {
    const std::string form = arguments.out.empty() ? ".csv" : arguments.out.extension().string();
    if (form != ".csv" && form != ".json")
        throw InputError(
            format("--out = {}: its name does not tell its form; end it in .csv or .json",
                   arguments.out.string()));
    if (!arguments.out.empty()) prepare_output(arguments.out, {arguments.model, arguments.data});
    const Model model = read_model(arguments.model);
    const Dataset dataset = dataset_from(arguments.data);
    std::string text;
    try {
        expect_measured_for(model, dataset, catalogue);
        const Answers answers = answers_of(model, dataset, arguments.threads);
        text = form == ".csv" ? csv_of(answers, model) : json_of(answers, model, dataset);
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", arguments.data.string(), error.what()));
    }
    if (arguments.out.empty()) {
        std::fwrite(text.data(), 1, text.size(), stdout);
        return;
    }
    write_file_atomically(arguments.out, text);
    std::printf("Wrote %s\n", arguments.out.c_str());
}

}  // namespace specula
