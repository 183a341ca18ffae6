#include "classifier/adam.hpp"

#include <cmath>

namespace specula {

namespace {

constexpr double mean_decay = 0.9;
constexpr double square_decay = 0.999;
constexpr double epsilon = 1e-8;

template <typename Scalar>
std::vector<MlpLayer<Scalar>> zeros_like(std::vector<MlpLayer<Scalar>> layers) {
    for (MlpLayer<Scalar>& layer : layers) {
        layer.weight.setZero();
        layer.bias.setZero();
        layer.gamma.setZero();
        layer.beta.setZero();
    }
    return layers;
}

/// What is the same for all parameters in one step.
template <typename Scalar>
struct StepSize {
    Scalar learning_rate;        ///< over the bias correction of the mean
    Scalar inverse_square_root;  ///< of the bias correction of the square
};

template <typename Array, typename Scalar>
void step_array(const Array& gradient, const StepSize<Scalar>& size, Array& mean, Array& square,
                Array& parameter) {
    const auto g = gradient.array();
    mean.array() = Scalar(mean_decay) * mean.array() + Scalar(1.0 - mean_decay) * g;
    square.array() =
        Scalar(square_decay) * square.array() + Scalar(1.0 - square_decay) * g.square();
    parameter.array() -= size.learning_rate * mean.array() /
                         (square.array().sqrt() * size.inverse_square_root + Scalar(epsilon));
}

}  // namespace

template <typename Scalar>
Adam<Scalar>::Adam(const MlpNetwork<Scalar>& network)
    : mean(zeros_like(network.layers)), square(mean) {}

template <typename Scalar>
void adam_step(const std::vector<MlpLayer<Scalar>>& gradient, Adam<Scalar>& adam,
               MlpNetwork<Scalar>& network) {
    const auto n = static_cast<double>(++adam.n_steps);
    const StepSize<Scalar> size{
        static_cast<Scalar>(adam.learning_rate / (1.0 - std::pow(mean_decay, n))),
        static_cast<Scalar>(1.0 / std::sqrt(1.0 - std::pow(square_decay, n)))};
    const auto kept = static_cast<Scalar>(1.0 - adam.learning_rate * adam.weight_decay);
    for (std::size_t l = 0; l < gradient.size(); ++l) {
        const MlpLayer<Scalar>& g = gradient[l];
        MlpLayer<Scalar>& mean = adam.mean[l];
        MlpLayer<Scalar>& square = adam.square[l];
        MlpLayer<Scalar>& layer = network.layers[l];
        if (adam.weight_decay > 0.0) layer.weight *= kept;
        step_array(g.weight, size, mean.weight, square.weight, layer.weight);
        step_array(g.bias, size, mean.bias, square.bias, layer.bias);
        step_array(g.gamma, size, mean.gamma, square.gamma, layer.gamma);
        step_array(g.beta, size, mean.beta, square.beta, layer.beta);
    }
}

template struct Adam<float>;
template struct Adam<double>;
template void adam_step(const std::vector<MlpLayer<float>>&, Adam<float>&, MlpNetwork<float>&);
template void adam_step(const std::vector<MlpLayer<double>>&, Adam<double>&, MlpNetwork<double>&);

}  // namespace specula
