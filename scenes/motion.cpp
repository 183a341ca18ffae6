#include "scenes/motion.hpp"

namespace specula {

Motion Motion::read(Section section) {
    Motion motion{
        .velocity_m_s = section.quantity("velocity", Unit::speed, Range::between(-50.0, 50.0), 0.0),
        .vibration_m = section.quantity("vibration", Unit::length, Range::between(0.0, 1e-2), 0.0),
        .vibration_hz =
            section.quantity("vibration_frequency", Unit::frequency, Range::between(0.0, 1e5), 0.0),
        .vibration_rad =
            section.quantity("vibration_phase", Unit::angle, Range::between(-two_pi, two_pi), 0.0),
    };
    if (motion.vibration_m > 0.0 && motion.vibration_hz == 0.0)
        section.fail_quantity("vibration", Unit::length, "has no frequency",
                              "add vibration_frequency_hz");
    section.finish();
    return motion;
}

}  // namespace specula
