#include "tools/specula/learning_options.hpp"

#include <set>

#include "tools/specula/command_options.hpp"

namespace specula {

namespace {

void add_descriptor(CLI::App* command, Learning& learning) {
    command
        ->add_option("--bins", learning.bins,
                     "FIRST:COUNT of range bins, windows or features; default 6:12 of beat samples")
        ->type_name("BINS");
    command
        ->add_option("--descriptor", learning.descriptor,
                     "the whole line instead, e.g. \"range_bins 6 12 blackman align 12 range 12 "
                     "log 1 search 5 20\" (classifier/README.md); bins, LSB")
        ->excludes("--bins")
        ->type_name("LINE");
}

void add_network(CLI::App* command, Learning& learning) {
    TrainOptions& options = learning.options;
    auto* hidden = command->add_option("--hidden", options.hidden, "units of the hidden layers")
                       ->delimiter(',')
                       ->capture_default_str();
    command->add_flag("--logistic", learning.logistic, "no hidden layer: logistic regression")
        ->excludes(hidden);
    command
        ->add_option("--convolution", options.convolution,
                     "channels of convolutions over neighbouring features, before the hidden "
                     "layers; default none")
        ->delimiter(',');
    command->add_option("--kernel", options.kernel, "features that a convolution sees, odd")
        ->capture_default_str();
}

void add_steps(CLI::App* command, Learning& learning) {
    TrainOptions& options = learning.options;
    command->add_option("--epochs", options.epochs, "passes over the frames")
        ->check(CLI::Range(1, 100000).description(""))
        ->capture_default_str();
    command->add_option("--batch-size", options.batch_size, "frames a step, about")
        ->check(CLI::Range(2, 65536).description(""))
        ->capture_default_str();
    command->add_option("--learning-rate", options.learning_rate, "of Adam; of a schedule, its top")
        ->capture_default_str();
    command->add_option("--schedule", learning.schedule, "constant, cosine or one-cycle")
        ->check(CLI::IsMember(schedule_names()).description(""))
        ->capture_default_str();
    command->add_option("--precision", learning.precision, "float32 or float64, while training")
        ->check(CLI::IsMember({"float32", "float64"}).description(""))
        ->capture_default_str();
}

void add_regularisers(CLI::App* command, Learning& learning) {
    TrainOptions& options = learning.options;
    command->add_option("--weight-decay", options.weight_decay, "0 to 1; above 0, AdamW")
        ->capture_default_str();
    command
        ->add_option("--label-smoothing", options.label_smoothing,
                     "0 to 1: share of a label spread over all classes")
        ->capture_default_str();
    command
        ->add_option("--mixup", options.mixup,
                     "0: none, or 0.05 to 1: frames are mixed in shares of Beta(a, a)")
        ->capture_default_str();
    command
        ->add_option("--patience", options.patience,
                     "0: never, or epochs without a lower loss on held-out sessions, then stop")
        ->capture_default_str();
    command
        ->add_option("--held-out", options.held_out,
                     "0 to 1: share of the sessions of each class to hold out, for --patience "
                     "or --holdout")
        ->capture_default_str();
}

void add_learning(CLI::App* command, Learning& learning) {
    add_descriptor(command, learning);
    add_network(command, learning);
    add_steps(command, learning);
    add_regularisers(command, learning);
    command->add_option("--seed", learning.seed, "of weights, order and shuffles")
        ->check(seed_problem)
        ->capture_default_str();
    add_threads(command, learning.threads);
}

/// Keeps the names of those options given that make a model, and a finished one does not heed.
void note_training_options(CLI::App* command, std::vector<std::string>& given) {
    static const std::set<std::string> heeded{"--leave-out", "--json", "--figure",  "--merge",
                                              "--nominal",   "--seed", "--threads", "--help"};
    command->parse_complete_callback([command, &given] {
        for (const CLI::Option* option : command->get_options())
            if (option->count() > 0 && !option->get_positional() &&
                !heeded.contains(option->get_name()))
                given.push_back(option->get_name());
    });
}

void add_outputs(CLI::App* command, EvaluateArguments& arguments) {
    command->add_option("--json", arguments.json, "write every number, also of --leave-out")->type_name("FILE");
    command
        ->add_option("--figure", arguments.figure,
                     "draw confusion, reliability and risk over coverage as SVG, PNG and CSV")
        ->type_name("FOLDER");
    command
        ->add_option("--merge", arguments.merged,
                     "classes that count as one in a second macro-F1, e.g. aluminium,iron")
        ->delimiter(',');
    command
        ->add_option("--nominal", arguments.nominal,
                     "nominal data recorded anew (.h5): what is familiar to the monitors, and "
                     "where the temperature is fitted")
        ->type_name("FILE");
}

}  // namespace

void add_train(CLI::App& program, TrainArguments& arguments) {
    CLI::App* command =
        add_command(program, "train", "Train the classifier on a dataset",
                    "specula train materials.h5 -o materials.json --holdout session\n"
                    "  Without --holdout all frames are learnt from. The model is JSON to read.");
    command->add_option("DATASET", arguments.data, "dataset (.h5)")->required();
    command->add_option("-o,--out", arguments.out, "model to write (.json)")
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--holdout", arguments.holdout,
                     "session: judge the model on sessions it did not learn from (--held-out)")
        ->check(CLI::IsMember({"session"}).description(""));
    command
        ->add_option("--radar", arguments.radar,
                     "that recorded the frames: a name, a .toml or .cfg file; export model --blob "
                     "needs to know. Default the dataset's")
        ->type_name("NAME");
    add_learning(command, arguments.learning);
    note_training_options(command, arguments.given);
}

void add_evaluate(CLI::App& program, EvaluateArguments& arguments) {
    CLI::App* command = add_command(
        program, "evaluate", "Judge a model on a dataset, or a dataset by cross-validation",
        "specula evaluate materials.json others.h5 --merge aluminium,iron --figure figures\n"
        "  specula evaluate materials.h5 --leave-out frame,view,object --leak-check\n"
        "  Scores are shares of frames; losses are in nats.");
    command->add_option("WHAT", arguments.what, "MODEL DATASET, or DATASET with --leave-out")
        ->required()
        ->expected(1, 2);
    command
        ->add_option("--leave-out", arguments.leave_out,
                     "what is never on both sides: frame, session, view or object; or several")
        ->delimiter(',')
        ->check(CLI::IsMember({"frame", "session", "view", "object"}).description(""));
    command->add_option("--folds", arguments.folds, "models per cross-validation, 2 to 1000")
        ->check(CLI::Range(2, 1000).description(""))
        ->capture_default_str();
    command->add_option("--repeats", arguments.repeats, "cross-validations, each of another seed")
        ->check(CLI::Range(1, 1000).description(""))
        ->capture_default_str();
    command->add_flag("--leak-check", arguments.leak_check,
                      "also with the classes of the objects shuffled");
    command
        ->add_option("--neighbours", arguments.neighbours,
                     "with --leave-out: so many nearest frames vote, in place of a network")
        ->check(CLI::Range(1, 1000).description(""));
    add_outputs(command, arguments);
    add_learning(command, arguments.learning);
    note_training_options(command, arguments.given);
}

void add_predict(CLI::App& program, PredictArguments& arguments) {
    CLI::App* command = add_command(
        program, "predict", "Say what a model makes of every frame of a dataset",
        "specula predict materials.json others.h5 -o answers.csv\n"
        "  A row per frame: class and probabilities (0 to 1), then what monitors look at: max_logit\n"
        "  (lower is less familiar), energy_nepers, mahalanobis_squared (of the inputs) and\n"
        "  prototype_distance_sd (higher is less familiar); suspicious is 1 beyond the model's own\n"
        "  limit of mahalanobis_squared. Without -o, CSV on standard output.");
    command->add_option("MODEL", arguments.model, "model (.json)")->required();
    command
        ->add_option("DATASET", arguments.data,
                     "dataset (.h5); its /label must be there, but is not looked at")
        ->required();
    command->add_option("-o,--out", arguments.out, "table to write: .csv or .json")
        ->type_name("FILE");
    add_threads(command, arguments.threads);
}

}  // namespace specula
