#include <charconv>
#include <cstdio>

#include "classifier/cross_validation.hpp"
#include "classifier/model_file.hpp"
#include "classifier/predict.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "sim/dataset/fingerprint.hpp"
#include "tools/specula/bin_choice.hpp"
#include "tools/specula/commands.hpp"
#include "tools/study/progress.hpp"

namespace specula {

void train_command(const TrainArguments& arguments) {
    const Dataset dataset = read_dataset(arguments.data);
    try {
        const Descriptor descriptor =
            descriptor_for(dataset, parse_bin_choice(arguments.learning.bins));
        const FeatureTable rows = describe(dataset, descriptor, arguments.learning.threads);
        Model model;
        {
            Progress progress("Training", "models", 1);
            model = train(rows, arguments.learning.options,
                          {.seed = arguments.learning.seed, .purpose = "training"});
            ++progress.done();
        }
        model.provenance.emplace_back("descriptor", descriptor.text());
        model.provenance.emplace_back("dataset", fingerprint(dataset));
        write_model(model, arguments.out);
        const Predictions own = predict(fold(model), rows);
        std::printf(
            "%zu frames, descriptor %s\nof the frames it learnt from, %.1f %% are "
            "recognised; that says nothing about others:\n"
            "see specula evaluate %s --leave-out session\nWrote %s\n",
            rows.size(), descriptor.text().c_str(), 100.0 * accuracy(rows.label, own.label),
            arguments.data.c_str(), arguments.out.c_str());
    } catch (const InputError& error) {
        throw InputError(format("{}: {}", arguments.data.string(), error.what()));
    }
}

}  // namespace specula
