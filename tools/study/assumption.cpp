#include "tools/study/assumption.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/fw_window.h"
#include "tools/study/experiment.hpp"

namespace specula {

namespace {

/// The same law, moved by `by`.
Distribution moved(const Distribution& law, double by) {
    struct Move {
        double by;
        Distribution operator()(const Distribution::Fixed& l) const {
            return Distribution(l.value + by);
        }
        Distribution operator()(const Distribution::Uniform& l) const {
            return Distribution(Distribution::Uniform{l.low + by, l.high + by});
        }
        Distribution operator()(const Distribution::Normal& l) const {
            return Distribution(Distribution::Normal{l.mean + by, l.sd});
        }
        Distribution operator()(const Distribution::Factor& l) const {
            return Distribution(Distribution::Factor{l.median * std::exp(by), l.ratio});
        }
        Distribution operator()(Distribution::Choice l) const {
            for (double& value : l.values) value += by;
            return Distribution(std::move(l));
        }
    };
    return std::visit(Move{by}, law.law());
}

/// The same law, spread `factor` times as wide about its middle.
Distribution widened(const Distribution& law, double factor) {
    struct Widen {
        double factor;
        Distribution operator()(const Distribution::Fixed& l) const {
            return Distribution(l.value);
        }
        Distribution operator()(const Distribution::Uniform& l) const {
            const double middle = 0.5 * (l.low + l.high), half = 0.5 * factor * (l.high - l.low);
            return Distribution(Distribution::Uniform{middle - half, middle + half});
        }
        Distribution operator()(const Distribution::Normal& l) const {
            return Distribution(Distribution::Normal{l.mean, factor * l.sd});
        }
        Distribution operator()(const Distribution::Factor& l) const {
            return Distribution(Distribution::Factor{l.median, std::pow(l.ratio, factor)});
        }
        Distribution operator()(Distribution::Choice l) const {
            double middle = 0.0;
            for (const double value : l.values)
                middle += value / static_cast<double>(l.values.size());
            for (double& value : l.values) value = middle + factor * (value - middle);
            return Distribution(std::move(l));
        }
    };
    return std::visit(Widen{factor}, law.law());
}

fw_window window_named(const std::string& name) {
    return name == "blackman" ? FW_WINDOW_BLACKMAN
           : name == "hann"   ? FW_WINDOW_HANN
                              : FW_WINDOW_RECT;
}

void loosen(SessionLaw& session, double factor) {
    for (Distribution* law :
         {&session.height_m, &session.tilt_rad, &session.offset_m, &session.yaw_rad,
          &session.gain_db, &session.leakage_db, &session.leakage_rad})
        *law = widened(*law, factor);
}

}  // namespace

Assumption read_assumption(Section section) {
    Assumption assumption;
    assumption.name = section.text("name");
    assumption.title = section.text("title");
    const Range level = Range::between(-60.0, 60.0), factor = Range::between(0.1, 10.0);
    assumption.snr_db = section.quantity("snr", Unit::ratio_db, level, 0.0);
    assumption.gain_db = section.quantity("gain", Unit::ratio_db, level, 0.0);
    assumption.clutter_db = section.quantity("clutter", Unit::ratio_db, level, 0.0);
    assumption.spread_factor = section.number("spread_factor", factor, 1.0);
    assumption.slope_factor = section.number("slope_factor", factor, 1.0);
    if (section.has_quantity("size", Unit::length)) {
        const auto size = section.quantities("size", Unit::length, 2, Range::inside(0.0, 10.0));
        assumption.size_m = {size[0], size[1]};
    }
    if (section.has_quantity("pivot", Unit::length)) {
        const auto p = section.quantities("pivot", Unit::length, 3, Range::between(-10.0, 10.0));
        assumption.pivot_m = Vector3(p[0], p[1], p[2]);
    }
    if (section.has("sessions"))
        assumption.sessions =
            section.count("sessions", Range::between(1, Condition::most_sessions));
    if (section.has("first_bin"))
        assumption.first_bin = section.count("first_bin", Range::between(0, 4096));
    if (section.has("window"))
        assumption.window = section.choice("window", {"blackman", "hann", "rectangular"});
    section.finish();
    return assumption;
}

Experiment under(const Assumption& assumption, const Experiment& experiment) {
    Experiment other = experiment;
    other.radar.receiver.noise_figure_db -= assumption.snr_db;
    other.radar.chirp.slope_hz_s *= assumption.slope_factor;
    SessionLaw& session = other.population.session;
    if (assumption.spread_factor != 1.0) loosen(session, assumption.spread_factor);
    if (assumption.gain_db != 0.0) session.gain_db = moved(session.gain_db, assumption.gain_db);
    other.population.world_clutter.level_db += assumption.clutter_db;
    other.population.session_clutter.level_db += assumption.clutter_db;
    if (assumption.size_m)
        for (SampleLaw& law : other.population.classes) {
            law.nominal.face.size_x_m = (*assumption.size_m)[0];
            law.nominal.face.size_y_m = (*assumption.size_m)[1];
        }
    if (assumption.pivot_m)
        for (Condition& condition : other.conditions)
            if (!condition.tilts_sensor) condition.pivot_m = *assumption.pivot_m;
    if (assumption.sessions) {
        const int frames = other.training.sessions * other.training.frames;
        other.training.sessions = *assumption.sessions;
        other.training.frames = std::max(1, frames / *assumption.sessions);
    }
    if (assumption.first_bin)
        other.descriptor.first_bin = static_cast<std::uint16_t>(*assumption.first_bin);
    if (assumption.window) other.descriptor.window = window_named(*assumption.window);
    return other;
}

}  // namespace specula
