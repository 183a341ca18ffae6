#include "scenes/motion.hpp"

#include "tests/check.hpp"
#include "tests/message_of.hpp"

namespace specula {
namespace {

Motion motion_in(const std::string& text) {
    return Motion::read(Section::parse("[motion]\n" + text, "x.toml").section("motion"));
}

TEST_CASE("a motion is a velocity and a vibration together", "[motion]") {
    const Motion motion =
        motion_in("velocity_mm_per_s = 20\nvibration_um = 50\nvibration_frequency_hz = 25\n");
    CHECK(motion.displacement_m(0.0) == 0.0);
    CHECK(motion.displacement_m(0.01) == Approx(0.2e-3 + 50e-6));  // a quarter of its period
    CHECK(motion.displacement_m(0.02) == Approx(0.4e-3));
    CHECK_FALSE(motion.is_rest());
    CHECK(motion_in("").is_rest());
}

TEST_CASE("a vibration without frequency is refused", "[motion]") {
    CHECK(message_of([] { return motion_in("vibration_um = 50\n"); }) ==
          "x.toml:2: motion.vibration_um = 50: has no frequency; add vibration_frequency_hz");
}

}  // namespace
}  // namespace specula
