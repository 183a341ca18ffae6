#include "sim/trace/edge_currents.hpp"

#include <algorithm>
#include <cmath>

namespace specula {

namespace {

constexpr double least_sine = 0.0175;       ///< of the angle between wave and edge: one degree
constexpr double least_separation = 1e-12;  ///< of the leaving ray from the grazing one

}  // namespace

Vector3 fringe_current(const EdgeFrame& edge, const EdgeBounce& bounce, const Vector3& field) {
    const Vector3 along = edge.along();
    const double cos_beta = bounce.arriving.dot(along);  // Michaeli's beta'
    const double sin_beta = std::sqrt(std::max(0.0, 1.0 - cos_beta * cos_beta));
    if (sin_beta < least_sine) return Vector3::Zero();
    const double cos_phi = -bounce.arriving.dot(edge.inward) / sin_beta;  // Michaeli's phi'
    // Cosine of the angle at which the exact half-plane's spectrum is read.
    const double mu = (sin_beta * bounce.leaving.dot(edge.inward) +
                       cos_beta * (bounce.leaving.dot(along) - cos_beta)) /
                      (sin_beta * sin_beta);
    const double leaving = std::sqrt(std::max(least_separation, 1.0 - mu));
    const double arriving = std::sqrt(std::max(0.0, 1.0 + cos_phi));
    const double electric = field.dot(along);
    const double magnetic = bounce.arriving.cross(field).dot(along);  // eta0 H
    const double sum = leaving + arriving;
    const double inwards = -2.0 * magnetic / (sin_beta * leaving * sum);
    const double alongside = 2.0 *
                             (electric * std::sqrt(std::max(0.0, 1.0 - cos_phi)) / sum -
                              cos_beta * magnetic * (1.0 + mu / (leaving * sum))) /
                             (sin_beta * sin_beta);
    return inwards * edge.inward + alongside * along;
}

}  // namespace specula
