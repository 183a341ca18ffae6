#include "tools/study/protocol.hpp"

#include <algorithm>

#include "classifier/descriptor.hpp"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"
#include "tools/study/experiment.hpp"
#include "tools/study/remedy_options.hpp"

namespace specula {

namespace {

/// What [descriptor] says, in the words of the rungs.
std::string own_descriptor(const Experiment& experiment) {
    Descriptor own;
    own.bins = experiment.descriptor;
    return own.text();
}

std::array<double, 2> read_span(Section& section, const std::string& name,
                                const std::array<double, 2>& usual) {
    if (!section.has_quantity(name, Unit::ratio_db)) return usual;
    const auto values = section.quantities(name, Unit::ratio_db, 2, Range::between(-60.0, 60.0));
    if (values[0] > values[1])
        section.fail_quantity(name, Unit::ratio_db, "ends before it begins",
                              "give the smaller number first");
    return {values[0], values[1]};
}

CalibrationPlan read_calibration(Section section) {
    CalibrationPlan plan;
    plan.target_macro_f1 = section.number("target_macro_f1", Range::inside(0.0, 1.0));
    plan.tolerance = section.number("tolerance", Range::inside(0.0, 0.5), plan.tolerance);
    plan.admissible_snr_db = read_span(section, "admissible_snr", plan.admissible_snr_db);
    plan.search_snr_db = read_span(section, "search_snr", plan.search_snr_db);
    if (plan.admissible_snr_db[0] > 0.0 || plan.admissible_snr_db[1] < 0.0)
        section.fail_quantity("admissible_snr", Unit::ratio_db, "does not hold 0",
                              "0 is one frame of the radar file; begin at or below it");
    section.finish();
    return plan;
}

TrainingSet read_training_set(Section section, const Experiment& experiment, int number) {
    TrainingSet set;
    set.condition = read_condition(section, experiment.radar, experiment.nominal_height_m, number);
    if (section.has_quantity("spread_height", Unit::length))
        set.height_m =
            section.distribution("spread_height", Unit::length, Range::between(-0.3, 0.3));
    if (section.has_quantity("spread_tilt", Unit::angle))
        set.tilt_rad = section.distribution("spread_tilt", Unit::angle, Range::between(-0.5, 0.5));
    section.finish();
    return set;
}

RungPlan read_rung(Section section, const Experiment& experiment, const Protocol& protocol) {
    std::vector<std::string> sets{experiment.training.name};
    for (const TrainingSet& set : protocol.training_sets) sets.push_back(set.condition.name);
    RungPlan rung{.name = section.text("name"),
                  .title = section.text("title"),
                  .training = section.choice("training", sets, sets.front()),
                  .descriptor = section.text("descriptor", own_descriptor(experiment)),
                  .options = experiment.classifier};
    try {
        parse_descriptor(rung.descriptor);
    } catch (const InputError& error) {
        section.fail("descriptor", "cannot be read", error.what());
    }
    rung.known_gain = section.flag("known_gain", false);
    rung.motion = section.flag("motion", false);
    if (rung.motion && (!protocol.motion || rung.training != sets.front()))
        section.fail("motion", "needs a [motion] and the training recordings",
                     "describe the motion, and name no training set");
    rung.budget = section.number("budget", Range::between(1.0, 100.0), rung.budget);
    read_remedy_options(section, rung.options);
    section.finish();
    return rung;
}

void add_receiver_cells(Section& section, const std::string& what, double Assumption::*member,
                        std::vector<Assumption>& cells) {
    if (!section.has_quantity(what, Unit::ratio_db)) return;
    for (const double value :
         section.quantities(what, Unit::ratio_db, 0, Range::between(-60.0, 60.0))) {
        Assumption cell;
        cell.name = format("{} {:+g} dB", what, value);
        cell.title = cell.name;
        cell.*member = value;
        cells.push_back(cell);
    }
}

/// Values with 0 among them, in rising order.
std::vector<double> with_zero(std::vector<double> values) {
    if (std::find(values.begin(), values.end(), 0.0) == values.end()) values.push_back(0.0);
    std::sort(values.begin(), values.end());
    return values;
}

SeverityPlan read_severity(Section section) {
    SeverityPlan plan;
    plan.height_offsets_m =
        with_zero(section.quantities("height_offset", Unit::length, 0, Range::between(-0.3, 0.3)));
    plan.tilts_rad =
        with_zero(section.quantities("tilt", Unit::angle, 0, Range::between(0.0, 1.0)));
    add_receiver_cells(section, "gain", &Assumption::gain_db, plan.receiver);
    add_receiver_cells(section, "snr", &Assumption::snr_db, plan.receiver);
    add_receiver_cells(section, "clutter", &Assumption::clutter_db, plan.receiver);
    plan.sessions = section.count("sessions", Range::between(1, 16), plan.sessions);
    plan.frames = section.count("frames", Range::between(1, 100), 8);
    section.finish();
    return plan;
}

/// Names of conditions that there are.
std::vector<std::string> read_names(Section& root, const std::string& key,
                                    const Experiment& experiment) {
    std::vector<std::string> known;
    for (const Condition& condition : experiment.conditions) known.push_back(condition.name);
    if (!root.has(key)) return {};
    const auto names = root.texts(key);
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            root.fail(key, format("\"{}\" is no condition of this experiment", name),
                      "use " + quoted_list(known));
    return names;
}

}  // namespace

Extent read_extent(Section& section, const Extent& usual) {
    Extent extent;
    extent.worlds = section.count("worlds", Range::between(1, 1000));
    extent.epochs = section.count("epochs", Range::between(1, 10000));
    const Range few = Range::between(0, 1000);
    extent.seeds = section.count("seeds", Range::between(1, 100), usual.seeds);
    extent.check_worlds = section.count("check_worlds", few, usual.check_worlds);
    extent.variant_worlds = section.count("variant_worlds", few, usual.variant_worlds);
    extent.prior_draws = section.count("prior_draws", few, usual.prior_draws);
    extent.severity_worlds = section.count("severity_worlds", few, usual.severity_worlds);
    extent.ladder = section.flag("ladder", usual.ladder);
    return extent;
}

Protocol read_protocol(Section& root, const Experiment& experiment) {
    Protocol protocol;
    if (auto section = root.find_section("calibration"))
        protocol.calibration = read_calibration(*section);
    int number = static_cast<int>(experiment.conditions.size());
    for (Section& section : root.sections("training_set")) {
        if (++number >=
            Condition::most_conditions - 1)  // the last is kept for recordings in passing
            root.fail("training_set", "too many conditions and training sets",
                      format("describe at most {} in all", Condition::most_conditions - 2));
        protocol.training_sets.push_back(read_training_set(section, experiment, number));
    }
    if (auto section = root.find_section("motion")) protocol.motion = read_frame(*section);
    for (Section& section : root.sections("rung"))
        protocol.rungs.push_back(read_rung(section, experiment, protocol));
    protocol.variant_conditions = read_names(root, "variant_conditions", experiment);
    for (Section& section : root.sections("variant"))
        protocol.variants.push_back(read_assumption(section));
    if (auto section = root.find_section("severity")) protocol.severity = read_severity(*section);
    if (auto section = root.find_section("honesty")) {
        protocol.checks = true;
        section->finish();
    }
    return protocol;
}

}  // namespace specula
