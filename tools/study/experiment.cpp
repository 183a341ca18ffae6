#include "tools/study/experiment.hpp"

#include <algorithm>

#include "firmware/fw_mlp.h"
#include "sim/core/document_seed.hpp"
#include "sim/core/format.hpp"
#include "tools/report/study_summary.hpp"

namespace specula {

namespace {

fw_integration integration_of(const std::string& name) {
    return name == "mean"     ? FW_INTEGRATE_MEAN
           : name == "single" ? FW_INTEGRATE_SINGLE
                              : FW_INTEGRATE_EXPORTED;
}

}  // namespace

fw_extract_config read_descriptor(Section section, const Radar& radar) {
    const int last_bin = radar.chirp.n_samples / 2;
    const int first =
        section.count("first_bin", Range::between(0, last_bin - 1), FW_DEFAULT_FIRST_BIN);
    const int n = section.count("n_bins", Range::between(1, last_bin), FW_DEFAULT_N_BINS);
    if (first + n > last_bin)
        section.fail(
            section.has("n_bins") ? "n_bins" : "first_bin",
            format("bins {} to {} run beyond the last, {}", first, first + n - 1, last_bin - 1),
            "begin lower, or take fewer (n_bins)");
    const std::string name =
        section.choice("window", {"blackman", "hann", "rectangular"}, "blackman");
    const fw_window window = name == "blackman" ? FW_WINDOW_BLACKMAN
                             : name == "hann"   ? FW_WINDOW_HANN
                                                : FW_WINDOW_RECT;
    fw_window_shape shape;
    if (fw_window_find(window, static_cast<std::uint16_t>(radar.chirp.n_samples), &shape) != FW_OK)
        section.fail(
            "window",
            format("the firmware has no {} window of {} samples", name, radar.chirp.n_samples),
            "write \"rectangular\", or choose a radar with 64, 128, 256 or 512 samples");
    const std::string integration =
        section.choice("integration", {"mean", "single", "exported"}, "mean");
    const std::string path = section.choice("range_fft", {"float", "hwa-like"}, "float");
    section.finish();
    return {.first_bin = static_cast<std::uint16_t>(first),
            .n_bins = static_cast<std::uint16_t>(n),
            .window = window,
            .integration = integration_of(integration),
            .path = path == "float" ? FW_RANGE_FLOAT : FW_RANGE_HWA_LIKE};
}

namespace {

TrainOptions read_classifier(Section section) {
    TrainOptions options;
    options.hidden.clear();
    for (const double units : section.numbers("hidden", 0, Range::between(1, 1024))) {
        options.hidden.push_back(static_cast<int>(units));
        if (options.hidden.back() != units)
            section.fail("hidden", "holds a number that is not whole", "give whole numbers");
    }
    if (options.hidden.size() >= FW_MLP_MAX_LAYERS)
        section.fail("hidden", "is more layers than the firmware runs",
                     format("give at most {}", FW_MLP_MAX_LAYERS - 1));
    options.batch_size = section.count("batch_size", Range::between(2, 65536), options.batch_size);
    options.learning_rate =
        section.number("learning_rate", Range::inside(0.0, 1.0), options.learning_rate);
    section.finish();
    return options;
}

std::vector<std::size_t> read_merged(Section& section, const std::vector<std::string>& classes) {
    std::vector<std::size_t> merged;
    if (!section.has("merged_classes")) return merged;
    for (const std::string& name : section.texts("merged_classes")) {
        const auto found = std::find(classes.begin(), classes.end(), name);
        if (found == classes.end())
            section.fail("merged_classes", format("\"{}\" is no class of this experiment", name),
                         "use " + quoted_list(classes));
        const auto label = static_cast<std::size_t>(found - classes.begin());
        if (std::find(merged.begin(), merged.end(), label) != merged.end())
            section.fail("merged_classes", format("\"{}\" is in it twice", name), "remove one");
        merged.push_back(label);
    }
    return merged;
}

/// A condition's name becomes the name of its dataset.
void check_file_name(const Section& section, const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    };
    if (name.size() > 64 || !std::all_of(name.begin(), name.end(), plain))
        section.fail("name", "cannot name a file",
                     "use up to 64 of a-z, 0-9, _ and -, no spaces; the title is free text");
}

std::vector<Condition> read_conditions(Section& root, const Experiment& experiment) {
    std::vector<Condition> conditions;
    for (Section& section : root.sections("condition")) {
        const int number = static_cast<int>(conditions.size()) + 1;
        if (number >= Condition::most_conditions)
            root.fail("condition", "too many conditions",
                      format("describe at most {}", Condition::most_conditions - 1));
        conditions.push_back(
            read_condition(section, experiment.radar, experiment.nominal_height_m, number));
        section.finish();
        const std::string& name = conditions.back().name;
        check_file_name(section, name);
        const auto same = [&](const Condition& other) { return other.name == name; };
        if (std::any_of(conditions.begin(), conditions.end() - 1, same))
            section.fail("name", "names an earlier condition too", "give it a name of its own");
        if (name == experiment.training.name || name == nominal_condition)
            section.fail("name",
                         "is the name of the training recordings or of their held-back part",
                         "give it a name of its own");
    }
    return conditions;
}

void read_paper(Section section, Experiment& experiment) {
    experiment.paper_reference = section.text("reference");
    std::vector<std::string> names{std::string(nominal_condition)};
    for (const Condition& condition : experiment.conditions) names.push_back(condition.name);
    for (const std::string& name : names)
        if (section.has("macro_f1_" + name))
            experiment.paper_macro_f1[name] =
                section.number("macro_f1_" + name, Range::between(0.0, 1.0));
    section.finish();
}

}  // namespace

Bench bench_of(const Experiment& experiment, const Library& materials) {
    return {.radar = experiment.radar,
            .population = experiment.population,
            .materials = materials,
            .nominal_height_m = experiment.nominal_height_m,
            .seed = experiment.seed,
            .solver = experiment.solver};
}

Experiment read_experiment(const std::filesystem::path& file, const Catalogue& catalogue) {
    Section root = Section::read(file);
    Experiment experiment;
    experiment.name = file.stem().string();
    experiment.file = file.string();
    experiment.source = root.source();
    experiment.title = root.text("title");
    experiment.question = root.text("question");
    experiment.seed = read_seed(root);
    experiment.radar = catalogue.radar(root, "radar");
    experiment.nominal_height_m =
        root.quantity("nominal_height", Unit::length, Range::inside(0.0, 100.0));
    experiment.solver = read_solver(root);
    experiment.usual = read_extent(root, {});
    experiment.merged_classes = {};
    experiment.population = read_population(root, catalogue);
    experiment.merged_classes = read_merged(root, experiment.population.class_names());

    Section training = root.section("training");
    experiment.training =
        read_condition(training, experiment.radar, experiment.nominal_height_m, 0);
    check_file_name(training, experiment.training.name);
    if (experiment.training.new_samples)
        training.fail("samples", "would leave no sample known",
                      "remove it: known samples are those of the training recordings");
    experiment.validation_share =
        training.number("validation_share", Range::inside(0.0, 1.0), experiment.validation_share);
    experiment.validation_title = training.text("validation_title");
    training.finish();
    experiment.conditions = read_conditions(root, experiment);
    experiment.descriptor = read_descriptor(root.section("descriptor"), experiment.radar);
    experiment.classifier = read_classifier(root.section("classifier"));
    Section quick = root.section("quick");
    experiment.quick = read_extent(quick, {});
    quick.finish();
    experiment.full = experiment.usual;
    if (auto full = root.find_section("full")) {
        experiment.full = read_extent(*full, experiment.usual);
        full->finish();
    }
    experiment.protocol = read_protocol(root, experiment);
    if (auto paper = root.find_section("paper")) read_paper(*paper, experiment);
    root.finish();
    return experiment;
}

}  // namespace specula
