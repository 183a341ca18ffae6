#pragma once

#include <string>
#include <vector>

#include "sim/core/random.hpp"
#include "sim/dataset/dataset.hpp"
#include "tests/check.hpp"
#include "tests/run_program.hpp"

// A folder of made-up datasets in which the learning commands are run.

namespace specula {

using Arguments = std::vector<std::string>;

struct MadeUpClasses {
    int n_sessions = 4;  ///< of each of three classes
    double moved = 0.0;  ///< added to the second feature
    std::uint64_t seed = 1;
};

/// Features of three classes: the first tells the class, the second is noise.
inline Dataset made_up_classes(const MadeUpClasses& law) {
    Stream stream({.seed = law.seed, .purpose = "learning commands test"});
    Dataset dataset;
    dataset.class_names = {"glass", "iron", "wood"};
    dataset.feature_names = {"x", "y"};
    for (int session = 0; session < 3 * law.n_sessions; ++session)
        for (int frame = 0; frame < 10; ++frame) {
            dataset.truth.push_back({.label = static_cast<std::uint8_t>(session % 3),
                                     .sample = session % 3,
                                     .session = session,
                                     .frame = frame});
            dataset.features.push_back(2.0 * (session % 3) + 0.3 * stream.normal());
            dataset.features.push_back(law.moved + stream.normal());
        }
    dataset.unknown_truth.set();
    return dataset;
}

/// a.h5 to learn from, b.h5 recorded anew, c.h5 moved away.
struct LearningFolder : MadeUpFolder {
    LearningFolder() {
        write_dataset(path() / "a.h5", made_up_classes({}));
        write_dataset(path() / "b.h5", made_up_classes({.seed = 2}));
        write_dataset(path() / "c.h5", made_up_classes({.moved = 8.0, .seed = 3}));
    }
    std::string run(const Arguments& arguments) const {
        const Ended ended = specula_in(path(), arguments);
        INFO(ended.errors);
        REQUIRE(ended.status == 0);
        return ended.output;
    }
    /// The one line of a refusal; nothing may be written.
    std::string refusal(const Arguments& arguments) const {
        const auto n_before = n_entries();
        const Ended ended = specula_in(path(), arguments);
        CHECK(ended.status == 2);
        CHECK(n_entries() == n_before);
        CHECK(ended.errors.find('\n') == ended.errors.size() - 1);
        const std::string start = "specula: error: ";
        REQUIRE(ended.errors.rfind(start, 0) == 0);
        return ended.errors.substr(start.size(), ended.errors.size() - start.size() - 1);
    }
    std::ptrdiff_t n_entries() const {
        const std::filesystem::directory_iterator entries(path());
        return std::distance(begin(entries), end(entries));
    }
};

inline const Arguments quick_training{"--epochs", "60",           "--learning-rate",
                                      "0.01",     "--batch-size", "16"};

inline Arguments joined(Arguments arguments, const Arguments& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

}  // namespace specula
