#include "sim/session_drift.hpp"

#include "tests/check.hpp"

namespace specula {
namespace {

TEST_CASE("drift goes from minus half to plus half of what was drawn", "[session]") {
    SessionLaw law;
    law.gain_drift_db = Distribution(0.4);
    law.leakage_drift_db = Distribution(0.2);
    law.leakage_drift_rad = Distribution(0.1);
    Stream stream({.seed = 1, .purpose = "drift"});
    const SessionDrift drift(law, 3, stream);
    CHECK(drift.gain_db(0.0) == Approx(-0.2));
    CHECK(drift.gain_db(0.5) == 0.0);
    CHECK(drift.gain_db(1.0) == Approx(0.2));
    REQUIRE(drift.board_factor(0.5).size() == 3);
    for (const Complex factor : drift.board_factor(0.5)) CHECK(factor == 1.0);
    for (const Complex factor : drift.board_factor(1.0)) {
        CHECK(20.0 * std::log10(std::abs(factor)) == Approx(0.1));
        CHECK(std::arg(factor) == Approx(-0.05));  // of the beat: the conjugate of the wave
    }
}

TEST_CASE("a law that says nothing drifts nowhere, one that says something does", "[session]") {
    SessionLaw law;
    CHECK_FALSE(law.board_drifts());
    law.leakage_drift_rad = Distribution(Distribution::Normal{0.0, 0.01});
    CHECK(law.board_drifts());
}

TEST_CASE("receivers drift on their own", "[session]") {
    SessionLaw law;
    law.leakage_drift_db = Distribution(Distribution::Normal{0.0, 0.1});
    Stream stream({.seed = 1, .purpose = "drift"});
    const auto factors = SessionDrift(law, 2, stream).board_factor(1.0);
    CHECK(factors[0] != factors[1]);
}

}  // namespace
}  // namespace specula
