#include <optional>

#include "sim/core/format.hpp"
#include "tools/validate/cases/cases.hpp"
#include "tools/validate/cases/strip_echo.hpp"
#include "tools/validate/comparison.hpp"
#include "tools/validate/read_inputs.hpp"

namespace specula {

namespace {

/// With the currents of the edges, half of what physical optics alone is allowed.
constexpr double share_with_edges = 0.5;
/// Down here TE keeps all of it: a wave runs from edge to edge, which nothing here follows.
constexpr double shadow_db = -10.0;

Stack perfect_conductor_at(double frequency_hz) {
    return {{}, PerfectConductor{}, frequency_hz};
}

/// Full-wave echoes are compared by level; how far apart the phases are is shown.
class EchoComparison {
  public:
    EchoComparison(Comparison& compare, const CasePoint& point)
        : compare_(compare), point_(point) {}

    /// How an echo was computed. One with a polarisation is held to a share of the tolerance.
    struct Way {
        std::string how = "";
        std::optional<LinePolarisation> polarisation = std::nullopt;

        double share(double expected_db) const {
            if (!polarisation) return 1.0;
            const bool all = *polarisation == LinePolarisation::te && expected_db < shadow_db;
            return all ? 1.0 : share_with_edges;
        }
    };
    /// What the point expects under `prefix`, beside a computed echo.
    void echo(const std::string& prefix, Complex computed, const Way& way) {
        const std::string h = prefix + "h", level = prefix + "abs_db", phase = prefix + "phase_deg";
        const std::string added = way.how.empty() ? "" : " (" + way.how + ")";
        const std::string part = way.how.empty() ? "" : ", " + way.how;
        const auto beside = [&](const std::string& name, double expected_db) {
            beside_level(name, {amplitude_db(computed), expected_db}, way.share(expected_db));
        };
        if (compare_.wants(h)) {
            const Complex expected = point_.expect.complex(h);
            beside(h + " (level" + part + ")", amplitude_db(expected));
            compare_.show_angle(h + " (phase" + part + ")",
                                {phase_deg(computed), phase_deg(expected)});
        }
        if (compare_.wants(level)) beside(level + added, point_.expect.number(level));
        if (compare_.wants(phase))
            compare_.show_angle(phase + added, {phase_deg(computed), point_.expect.number(phase)});
    }
    void level(const std::string& name, double computed_db) {
        if (compare_.wants(name))
            beside_level(name, {computed_db, point_.expect.number(name)}, 1.0);
    }

  private:
    /// `db`, or one tolerance above -10 dB and another below.
    double allowed_db(double expected_db) const {
        const char* key = expected_db > shadow_db ? "db_if_above_minus10" : "db_if_below_minus10";
        if (point_.tolerance.has("db")) key = "db";
        return point_.tolerance.number(key, Range::at_least(0.0));
    }
    void beside_level(const std::string& name, const NumberPair& levels_db, double share) {
        compare_.beside(name, levels_db, {share * allowed_db(levels_db.expected), "dB"});
    }

    Comparison& compare_;
    const CasePoint& point_;
};

}  // namespace

std::vector<Quantity> conducting_strip_point(const CasePoint& point) {
    const StripScene scene = strip_scene_of(point.inp, {"strip_width_m", "width_m"});
    point.inp.describe({"geometry"});
    Comparison compare(point);
    EchoComparison echoes(compare, point);
    for (const auto polarisation : {LinePolarisation::tm, LinePolarisation::te}) {
        const std::string name = polarisation_name(polarisation);
        const std::string prefix = name + "_rel_infinite_plane.";
        const StripEcho strip(scene, {.polarisation = polarisation});
        const Complex optics = strip.of(perfect_conductor_at);
        echoes.level("PO_" + name + "_db", amplitude_db(optics));
        echoes.echo(prefix, strip.with_edge_currents(perfect_conductor_at),
                    {.how = "with edge currents", .polarisation = polarisation});
        compare.not_judged();
        echoes.echo(prefix, optics, {.how = "physical optics alone"});
        compare.judged_again();
    }
    return compare.finish();
}

std::vector<Quantity> dielectric_strip_point(const CasePoint& point) {
    const StripScene scene = strip_scene_of(point.inp, {"width_m", "strip_width_m"});
    const Stack slab = slab_of(point.inp);
    point.inp.describe({"material", "geometry"});
    point.expect.describe({"gmres_info"});
    const std::string pol =
        point.inp.has("pol") ? lower_case(point.inp.text("pol")).substr(0, 2) : "tm";
    if (pol != "tm" && pol != "te")
        throw NotComputable(format("knows the polarisations TM and TE, not \"{}\"", pol));
    const auto polarisation = pol == "tm" ? LinePolarisation::tm : LinePolarisation::te;

    Comparison compare(point);
    EchoComparison echoes(compare, point);
    const Complex echo =
        StripEcho(scene, {.polarisation = polarisation}).of([&](double) { return slab; });
    echoes.echo("rel_infinite_pec_plane.", echo, {});
    echoes.level("PO_slab_db", amplitude_db(echo));
    const Reflection straight = stack_reflection(slab, 1.0);
    echoes.level("infinite_slab_r0_db", amplitude_db(straight.te));
    return compare.finish();
}

}  // namespace specula
