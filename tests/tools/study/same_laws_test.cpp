#include "tools/study/same_laws.hpp"

#include "sim/core/random.hpp"
#include "tests/check.hpp"

namespace specula {
namespace {

/// Sessions of three classes, all drawn alike; class 2's heights moved by `shift_m`.
std::vector<Truth> sessions(double shift_m) {
    Stream stream({.seed = 3, .purpose = "sessions"});
    std::vector<Truth> truth;
    for (int i = 0; i < 300; ++i) {
        Truth frame;
        frame.label = static_cast<std::uint8_t>(i % 3);
        frame.height_m = 0.45 + 0.002 * stream.normal() + (frame.label == 2 ? shift_m : 0.0);
        frame.gain_db = 0.3 * stream.normal();
        frame.yaw_rad = stream.uniform();
        truth.push_back(frame);
        frame.frame = 1;  // further frames of the session count for nothing
        frame.height_m += 1.0;
        truth.push_back(frame);
    }
    return truth;
}

TEST_CASE("nuisance drawn alike for all classes is not called different", "[study]") {
    const SameLaws laws = compare_nuisance(sessions(0.0), 3);
    CHECK(laws.n_tests == 24);  // eight columns, three classes
    CHECK(laws.corrected_p() > 0.05);
}

TEST_CASE("a class whose sessions stand higher is found, by column and class", "[study]") {
    // Half a standard deviation in a hundred sessions against two hundred: x = 0.2 sqrt(67) = 1.6,
    // p = 0.01; a whole one: x = 3.1, p = 1e-8.
    const SameLaws laws = compare_nuisance(sessions(0.002), 3);
    CHECK(laws.corrected_p() < 0.001);
    CHECK(laws.column == "height_m");
    CHECK(laws.label == 2);
}

TEST_CASE("laws that are fixed values are alike", "[study]") {
    const std::vector<Truth> still(10);
    const SameLaws laws = compare_nuisance(still, 2);  // no frame of class 1 at all
    CHECK(laws.corrected_p() == 1.0);
}

}  // namespace
}  // namespace specula
