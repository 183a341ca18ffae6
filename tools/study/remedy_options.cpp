#include "tools/study/remedy_options.hpp"

namespace specula {

namespace {

std::vector<int> read_units(Section& section, const std::string& key) {
    std::vector<int> units;
    for (const double number : section.numbers(key, 0, Range::between(1, 1024))) {
        units.push_back(static_cast<int>(number));
        if (units.back() != number)
            section.fail(key, "holds a number that is not whole", "give whole numbers");
    }
    return units;
}

}  // namespace

void read_remedy_options(Section& section, TrainOptions& options) {
    if (section.has("hidden")) options.hidden = read_units(section, "hidden");
    if (section.has("convolution")) options.convolution = read_units(section, "convolution");
    options.weight_decay =
        section.number("weight_decay", Range::between(0.0, 1.0), options.weight_decay);
    options.label_smoothing =
        section.number("label_smoothing", Range::between(0.0, 0.9), options.label_smoothing);
    options.mixup = section.number("mixup", Range::between(0.0, 1.0), options.mixup);
    const std::string schedule =
        section.choice("schedule", {"constant", "one_cycle", "cosine"}, "constant");
    options.schedule = schedule == "one_cycle" ? Schedule::one_cycle
                       : schedule == "cosine"  ? Schedule::cosine
                                               : Schedule::constant;
}

}  // namespace specula
