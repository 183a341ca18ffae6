#pragma once

#include <map>
#include <string>
#include <vector>

#include "classifier/train.hpp"
#include "firmware/fw_extract.h"
#include "scenes/solver.hpp"
#include "sim/condition.hpp"
#include "sim/population.hpp"
#include "sim/session.hpp"
#include "tools/study/protocol.hpp"

namespace specula {

/// A study as its file states it: what is recorded, what is learnt, what is asked.
struct Experiment {
    std::string name;    ///< the file's stem
    std::string file;    ///< path
    std::string source;  ///< the file's whole text
    std::string title;
    std::string question;
    std::uint64_t seed = 0;

    Radar radar;
    double nominal_height_m = 0.45;
    Solver solver;
    Population population;
    Condition training;
    double validation_share = 0.2;  ///< of the training frames, drawn at random as the paper does
    std::string validation_title;
    std::vector<Condition> conditions;

    fw_extract_config descriptor{};
    TrainOptions classifier;
    std::vector<std::size_t> merged_classes;
    Protocol protocol;
    Extent usual;
    Extent quick;
    Extent full;

    std::string paper_reference;
    std::map<std::string, double> paper_macro_f1;  ///< condition name -> published value
};

/// What its sessions are simulated from, under the experiment's own seed. Borrows both.
Bench bench_of(const Experiment& experiment, const Library& materials);

/// Reads [descriptor]; refuses bins and windows that a radar's frames do not have.
fw_extract_config read_descriptor(Section section, const Radar& radar);

/// Reads an experiment file; each section is read by the module that owns it.
Experiment read_experiment(const std::filesystem::path& file, const Catalogue& catalogue);

}  // namespace specula
