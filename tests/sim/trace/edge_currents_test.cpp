#include "sim/trace/edge_currents.hpp"

#include "sim/core/constants.hpp"
#include "tests/check.hpp"

// Against Sommerfeld's half-plane: its diffraction coefficients f (E along the edge) and g (H along
// it), and those of physical optics, in the form of Ufimtsev.

namespace specula {
namespace {

const EdgeFrame axes{.inward = Vector3::UnitX(), .normal = Vector3::UnitY()};

/// Angles in the plane across the edge, from the half-plane.
struct Angles {
    double arriving;
    double leaving;
};

double sommerfeld_f(const Angles& a) {
    return 0.5 * (1.0 / std::cos(0.5 * (a.leaving + a.arriving)) -
                  1.0 / std::cos(0.5 * (a.leaving - a.arriving)));
}
double sommerfeld_g(const Angles& a) {
    return -0.5 * (1.0 / std::cos(0.5 * (a.leaving + a.arriving)) +
                   1.0 / std::cos(0.5 * (a.leaving - a.arriving)));
}

/// On Keller's cone of half angle beta about the edge.
EdgeBounce on_cone(const Angles& a, double beta) {
    return {{-std::sin(beta) * std::cos(a.arriving), -std::sin(beta) * std::sin(a.arriving),
             std::cos(beta)},
            {std::sin(beta) * std::cos(a.leaving), std::sin(beta) * std::sin(a.leaving),
             std::cos(beta)}};
}

/// What physical optics ends with at the edge: the integral of 2 n x H along the grazing ray.
Vector3 optics_current(const EdgeBounce& bounce, const Vector3& field) {
    const double sine = std::sqrt(1.0 - std::pow(bounce.arriving.z(), 2));
    const double sum = (bounce.leaving.x() - bounce.arriving.x()) / sine;  // on the cone
    return -2.0 / (sine * sum) * Vector3::UnitY().cross(bounce.arriving.cross(field));
}

/// Components along the edge of the E and the eta0 H that a current radiates, as f and g.
struct Radiated {
    double f, g;
};
Radiated radiated(const EdgeBounce& bounce, const Vector3& current) {
    const Vector3 across = current - bounce.leaving * bounce.leaving.dot(current);
    return {-0.5 * across.z(), -0.5 * bounce.leaving.cross(across).z()};
}

/// Unit field whose E, or whose H, has the part sin(beta) along the edge and the other none.
Vector3 field_with_e_along(const EdgeBounce& bounce) {
    const Vector3 e = Vector3::UnitZ() - bounce.arriving.z() * bounce.arriving;
    return e.normalized();
}
Vector3 field_with_h_along(const EdgeBounce& bounce) {
    return field_with_e_along(bounce).cross(bounce.arriving);
}

std::vector<Angles> many_angles() {
    std::vector<Angles> all;
    for (const double arriving : {0.2, 0.9, 1.5, 2.2, 2.9})
        for (const double leaving : {0.1, 0.7, 1.5, 2.3, 3.0})
            if (std::abs(arriving + leaving - pi) > 0.05) all.push_back({arriving, leaving});
    return all;
}

TEST_CASE("across the edge the fringe is Sommerfeld's coefficient less that of physical optics",
          "[edges]") {
    for (const Angles& a : many_angles()) {
        const EdgeBounce bounce = on_cone(a, 0.5 * pi);
        const double sum = std::cos(a.arriving) + std::cos(a.leaving);
        const Vector3 soft = fringe_current(axes, bounce, field_with_e_along(bounce));
        const Vector3 hard = fringe_current(axes, bounce, field_with_h_along(bounce));
        INFO(a.arriving << " to " << a.leaving);
        // Two rounded divisions by the distance from the pole of the closed form, 0.05 or more.
        CHECK(radiated(bounce, soft).f ==
              Approx(sommerfeld_f(a) - std::sin(a.arriving) / sum).margin(1e-12));
        CHECK(radiated(bounce, hard).g ==
              Approx(sommerfeld_g(a) + std::sin(a.leaving) / sum).margin(1e-12));
    }
}

TEST_CASE("at any slant fringe and physical optics together do not turn E along the edge into H",
          "[edges]") {
    for (const double beta : {0.4, 0.9, 1.3, 2.0, 2.7}) {
        for (const Angles& a : many_angles()) {
            const EdgeBounce bounce = on_cone(a, beta);
            const auto both = [&](const Vector3& field) {
                return radiated(bounce, Vector3(fringe_current(axes, bounce, field) +
                                                optics_current(bounce, field)));
            };
            const Radiated soft = both(field_with_e_along(bounce));
            const Radiated hard = both(field_with_h_along(bounce));
            INFO("slant " << beta << ", " << a.arriving << " to " << a.leaving);
            CHECK(soft.f == Approx(sommerfeld_f(a) * std::sin(beta)).margin(1e-11));
            CHECK(std::abs(soft.g) < 1e-11);
            CHECK(hard.g == Approx(sommerfeld_g(a) * std::sin(beta)).margin(1e-11));
            CHECK(std::abs(hard.f) < 1e-11);
        }
    }
}

TEST_CASE("at the edges of shadow and mirror the fringe stays small where both parts are infinite",
          "[edges]") {
    for (const double arriving : {0.3, 1.0, 0.5 * pi, 2.0, 2.8}) {
        for (const double away : {1e-3, 1e-6, 0.0}) {
            const EdgeBounce bounce = on_cone({arriving, pi - arriving + away}, 1.1);
            for (const Vector3& field : {field_with_e_along(bounce), field_with_h_along(bounce)}) {
                const Vector3 current = fringe_current(axes, bounce, field);
                CHECK(current.allFinite());
                CHECK(current.norm() < 20.0);
            }
        }
    }
}

TEST_CASE("a wave along the edge drives no fringe and gives no number that is none", "[edges]") {
    const EdgeBounce along{Vector3::UnitZ(), Vector3::UnitY()};
    CHECK(fringe_current(axes, along, Vector3::UnitX()) == Vector3::Zero());
    const EdgeBounce grazing{-Vector3::UnitY(), Vector3::UnitX()};
    CHECK(fringe_current(axes, grazing, Vector3::UnitX()).allFinite());
}

}  // namespace
}  // namespace specula
