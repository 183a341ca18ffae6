#include "classifier/adam.hpp"

#include <cmath>

#include "tests/check.hpp"

namespace specula {
namespace {

MlpNetwork<double> one_weight(double value) {
    MlpNetwork<double> network;
    MlpLayer<double> layer;
    layer.weight = Matrix<double>::Constant(1, 1, value);
    layer.bias = ColumnVector<double>::Zero(1);
    network.layers.push_back(layer);
    return network;
}

TEST_CASE("the first step is the learning rate against the sign of the gradient", "[adam]") {
    const double gradient = GENERATE(-1e3, -1e-3, 2e-4, 5.0);
    auto network = one_weight(0.5);
    Adam<double> adam(network);
    adam.learning_rate = 0.01;
    adam_step(one_weight(gradient).layers, adam, network);
    const double step = network.layers[0].weight(0, 0) - 0.5;
    CHECK(step == Approx(-0.01 * gradient / std::abs(gradient)).epsilon(1e-4));  // epsilon / |g|
}

TEST_CASE("steps follow the published recurrence", "[adam]") {
    auto network = one_weight(1.0);
    Adam<double> adam(network);
    double weight = 1.0, mean = 0.0, square = 0.0;
    for (int t = 1; t <= 50; ++t) {
        const double g = std::sin(0.7 * t);
        adam_step(one_weight(g).layers, adam, network);
        mean = 0.9 * mean + 0.1 * g;
        square = 0.999 * square + 0.001 * g * g;
        const double corrected_mean = mean / (1.0 - std::pow(0.9, t));
        const double corrected_square = square / (1.0 - std::pow(0.999, t));
        weight -= 1e-3 * corrected_mean / (std::sqrt(corrected_square) + 1e-8);
        REQUIRE(network.layers[0].weight(0, 0) == Approx(weight).epsilon(1e-13));
    }
    CHECK(network.layers[0].bias(0) == 0.0);  // no gradient, no step
}

}  // namespace
}  // namespace specula
