#include "materials/rough_face.hpp"

#include <cmath>

#include "materials/stack.hpp"
#include "sim/core/constants.hpp"
#include "tests/check.hpp"
#include "tests/reference_case.hpp"

namespace specula {
namespace {

TEST_CASE("a rough face dims its mirror image as Ament says", "[rough_face][reference]") {
    const auto reference = reference_case("M08_roughness");
    const double tolerance = reference.at("tolerance").at("rel");
    for (const auto& point : reference.at("points")) {
        const auto &inp = point.at("inp"), &expect = point.at("expect");
        INFO(inp.dump());
        const double f_hz = inp.at("f_hz"), roughness_m = inp.at("rms_m");
        const double cosine = std::cos(inp.at("theta_deg").get<double>() * pi / 180.0);
        const Electrics air, stone{Complex(7.5, -0.15)};
        const FaceLoss loss = face_loss({air, stone, roughness_m},
                                        two_pi * f_hz / speed_of_light_m_s, 1.0 - cosine * cosine);
        CHECK(loss.reflect_above ==
              Approx(expect.at("field_factor").get<double>()).epsilon(tolerance));
        const double parameter = rayleigh_parameter(
            {.frequency_hz = f_hz, .roughness_m = roughness_m, .cos_incidence = cosine});
        CHECK(parameter ==
              Approx(expect.at("rayleigh_parameter_2ks_cos").get<double>()).epsilon(tolerance));
        CHECK((parameter < pi / 2.0) == expect.at("is_rayleigh_smooth").get<bool>());

        const auto of = [&](double rms_m) {
            return stack_reflection({{}, HalfSpace{stone, rms_m}, f_hz}, cosine).te;
        };
        CHECK(20.0 * std::log10(std::abs(of(roughness_m) / of(0.0))) ==
              Approx(expect.at("power_db").get<double>()).epsilon(tolerance));
    }
}

TEST_CASE("a smooth face loses nothing", "[rough_face]") {
    const FaceLoss loss = face_loss({Electrics{}, Electrics{2.6}, 0.0}, 1257.0, 0.3);
    CHECK(loss.reflect_above == 1.0);
    CHECK(loss.reflect_below == 1.0);
    CHECK(loss.transmit_twice == 1.0);
}

TEST_CASE("roughness between media that hardly differ hardly shows in transmission",
          "[rough_face]") {
    const Electrics thin{1.0}, like_it{1.0001}, dense{4.0};
    CHECK(face_loss({thin, like_it, 1e-4}, 1257.0, 0.0).transmit_twice > 1.0 - 1e-10);
    const FaceLoss loss = face_loss({thin, dense, 1e-4}, 1257.0, 0.0);
    CHECK(loss.transmit_twice > loss.reflect_above);  // a phase of 2 (n - 1) against twice 1
    CHECK(loss.reflect_above > loss.reflect_below);   // against twice n
}

}  // namespace
}  // namespace specula
