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
    std::vector<std::string> monitor;
    std::vector<std::vector<double>> score;  ///< (monitor, row)
    std::optional<double> suspicious_squared;

    bool suspicious(std::size_t row) const {
        return suspicious_squared && score.back()[row] > *suspicious_squared;
    }
};

Answers answers_of(const Model& model, const Dataset& dataset, int threads) {
    Answers answers;
    answers.frame = first_frames(dataset, descriptor_of(model));
    answers.rows = rows_for(model, dataset, threads);
    answers.predictions = predict(fold(model), answers.rows);
    answers.probabilities =
        softmax({.values = answers.predictions.logits, .n_classes = answers.predictions.n_classes});
    const Observed observed{.rows = answers.rows,
                            .predictions = answers.predictions,
                            .spread = model.monitor ? &*model.monitor : nullptr};
    for (const Monitor monitor : {Monitor::max_logit, Monitor::softmax_probability, Monitor::energy,
                                  Monitor::mahalanobis}) {
        if (monitor == Monitor::mahalanobis && !model.monitor) continue;
        answers.monitor.push_back(monitor_names()[static_cast<std::size_t>(monitor)]);
        answers.score.push_back(unfamiliarity(monitor, observed));
    }
    if (model.monitor)
        answers.suspicious_squared = static_cast<double>(model.monitor->suspicious_squared);
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
        row.push_back(answers.suspicious_squared ? (answers.suspicious(i) ? "1" : "0") : "");
        table.add(row);
    }
    return table.text();
}

std::string json_of(const Answers& answers, const Model& model, const Dataset& dataset) {
    nlohmann::ordered_json json{{"format", "specula-predictions"},
                                {"format_version", 1},
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
        if (answers.suspicious_squared) frame["suspicious"] = answers.suspicious(i);
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
    const Dataset dataset = read_dataset(arguments.data);
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
