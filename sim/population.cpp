#include "sim/population.hpp"

#include <cmath>

#include "sim/core/constants.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr int most_classes = 64;

constexpr double most_below_zero = 0.02;  ///< share of a law

/// Of a quantity that is never negative: draws below zero are folded back, which bends the law.
/// @in  fail  throws, with a problem and a remedy
template <typename Fail>
void refuse_folded(const Distribution& law, const Fail& fail) {
    const auto* normal = std::get_if<Distribution::Normal>(&law.law());
    if (!normal || law.quantile(most_below_zero) >= 0.0) return;
    const double below = 0.5 * std::erfc(normal->mean / (normal->sd * std::sqrt(2.0)));
    fail(format("would be below zero in {:.0f} % of all draws, which are folded back",
                100.0 * below),
         format("keep that below {:.0f} %: a larger mean, a smaller deviation, or "
                "{{ factor = [median, ratio] }}",
                100.0 * most_below_zero));
}

void refuse_folded_laws(const Section& section, const SampleLaw& law) {
    using Checked = std::pair<const char*, Distribution>;
    for (const Checked& each :
         {Checked("thickness", law.thickness_m), Checked("roughness", law.roughness_m),
          Checked("correlation_length", law.correlation_m)})
        refuse_folded(each.second, [&](const std::string& problem, const std::string& remedy) {
            section.fail_quantity(each.first, Unit::length, problem, remedy);
        });
    for (const Checked& each : {Checked("permittivity_factor", law.permittivity_factor),
                                Checked("loss_factor", law.loss_factor)})
        refuse_folded(each.second, [&](const std::string& problem, const std::string& remedy) {
            section.fail(each.first, problem, remedy);
        });
}

SampleLaw read_class(Section section, const Sample& common, const Catalogue& catalogue) {
    SampleLaw law;
    law.name = section.text("name");
    law.nominal = common;
    law.nominal.material = catalogue.material_name(section, "material");
    law.thickness_m = section.distribution("thickness", Unit::length, Range::inside(0.0, 1.0));
    law.bow_m = section.distribution("bow", Unit::length, Range::between(-0.05, 0.05), 0.0);
    law.roughness_m =
        section.distribution("roughness", Unit::length, Range::between(0.0, 0.002), 0.0);
    law.correlation_m = section.distribution("correlation_length", Unit::length,
                                             Range::between(1e-5, 0.1), law.correlation_m);
    law.permittivity_factor = section.factor("permittivity_factor", Range::inside(0.5, 2.0), 1.0);
    law.loss_factor = section.factor("loss_factor", Range::inside(0.1, 10.0), 1.0);
    refuse_folded_laws(section, law);
    section.finish();
    return law;
}

Sample read_common(Section section, const Catalogue& catalogue) {
    Sample common;
    const auto size = section.quantities("size", Unit::length, 2, Range::inside(0.0, 10.0));
    common.face = {.size_x_m = size[0], .size_y_m = size[1]};
    common.backing = catalogue.backing_name(section, "backing");
    section.finish();
    return common;
}

SessionLaw read_session(Section section) {
    const Range small_m = Range::between(-0.1, 0.1), any = Range::any();
    SessionLaw law{
        .height_m = section.distribution("height", Unit::length, small_m, 0.0),
        .tilt_rad = section.distribution("tilt", Unit::angle, Range::between(-0.2, 0.2), 0.0),
        .offset_m = section.distribution("offset", Unit::length, small_m, 0.0),
        .yaw_rad = section.distribution("yaw", Unit::angle, Range::between(-pi, pi), 0.0),
        .gain_db = section.distribution("gain", Unit::ratio_db, any, 0.0),
        .leakage_db = section.distribution("leakage", Unit::ratio_db, any, 0.0),
        .leakage_rad = section.distribution("leakage_phase", Unit::angle, any, 0.0),
        .gain_drift_db = section.distribution("gain_drift", Unit::ratio_db, any, 0.0),
        .leakage_drift_db = section.distribution("leakage_drift", Unit::ratio_db, any, 0.0),
        .leakage_drift_rad = section.distribution("leakage_drift_phase", Unit::angle, any, 0.0),
    };
    section.finish();
    return law;
}

ClutterLaw read_clutter(Section section) {
    ClutterLaw law{
        .points = section.count("points", Range::between(0, 1000)),
        .level_db = section.quantity("level", Unit::ratio_db, Range::between(-200.0, 40.0)),
        .range_m = section.distribution("range", Unit::length, Range::inside(0.05, 100.0)),
    };
    section.finish();
    return law;
}

}  // namespace

FrameLaw read_frame(Section section) {
    FrameLaw law{
        .displacement_m =
            section.distribution("displacement", Unit::length, Range::between(-1e-3, 1e-3), 0.0),
        .gain_db = section.distribution("gain", Unit::ratio_db, Range::any(), 0.0),
        .velocity_m_s =
            section.distribution("velocity", Unit::speed, Range::between(-50.0, 50.0), 0.0),
        .vibration_m =
            section.distribution("vibration", Unit::length, Range::between(-1e-2, 1e-2), 0.0),
        .vibration_hz = section.distribution("vibration_frequency", Unit::frequency,
                                             Range::between(0.0, 1e5), 0.0),
    };
    section.finish();
    return law;
}

bool SessionLaw::board_drifts() const {
    const auto is_nothing = [](const Distribution& law) {
        return law.median() == 0.0 && law.spread() == 0.0;
    };
    return !is_nothing(leakage_drift_db) || !is_nothing(leakage_drift_rad);
}

std::vector<std::string> Population::class_names() const {
    std::vector<std::string> names;
    for (const SampleLaw& law : classes) names.push_back(law.name);
    return names;
}

Population read_population(Section& experiment, const Catalogue& catalogue) {
    Population population;
    const Sample common = read_common(experiment.section("sample"), catalogue);
    for (Section& section : experiment.sections("class")) {
        population.classes.push_back(read_class(section, common, catalogue));
        for (std::size_t i = 0; i + 1 < population.classes.size(); ++i)
            if (population.classes[i].name == population.classes.back().name)
                section.fail("name", "names an earlier class too", "give each class its own name");
    }
    if (population.classes.size() < 2 || population.classes.size() > most_classes)
        experiment.fail("class", format("{} classes", population.classes.size()),
                        format("describe 2 to {} of them, each as [[class]]", most_classes));
    if (auto section = experiment.find_section("session"))
        population.session = read_session(*section);
    if (auto section = experiment.find_section("frame")) population.frame = read_frame(*section);
    if (auto section = experiment.find_section("world_clutter"))
        population.world_clutter = read_clutter(*section);
    if (auto section = experiment.find_section("session_clutter"))
        population.session_clutter = read_clutter(*section);
    return population;
}

}  // namespace specula
