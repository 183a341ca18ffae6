#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "classifier/adam.hpp"
#include "classifier/mlp_network.hpp"

namespace specula {

/// A training run of torch 1.13 in double: tests/reference/mlp_golden.json. Its hidden layers have
/// a bias before the batch normalisation.
inline const nlohmann::json& golden() {
    static const auto json = nlohmann::json::parse(
        std::ifstream(std::string(SPECULA_SOURCE_DIR) + "/tests/reference/mlp_golden.json"));
    return json;
}

template <typename Scalar>
ColumnVector<Scalar> to_vector(const nlohmann::json& json) {
    ColumnVector<Scalar> vector(json.size());
    for (Eigen::Index i = 0; i < vector.size(); ++i)
        vector(i) = static_cast<Scalar>(json[static_cast<std::size_t>(i)].get<double>());
    return vector;
}

/// Rows as they are in the file.
template <typename Scalar>
Matrix<Scalar> to_matrix(const nlohmann::json& json) {
    Matrix<Scalar> matrix(json.size(), json[0].size());
    for (Eigen::Index i = 0; i < matrix.rows(); ++i)
        matrix.row(i) = to_vector<Scalar>(json[static_cast<std::size_t>(i)]).transpose();
    return matrix;
}

/// One of the states "init", "grad0" or "final". torch counts modules: linear 0, normalisation 1,
/// ReLU 2, linear 3, ...
template <typename Scalar>
MlpNetwork<Scalar> to_network(const nlohmann::json& state, bool with_hidden_bias) {
    MlpNetwork<Scalar> network;
    for (int module = 0; module <= 6; module += 3) {
        const auto name = [&](int offset, const char* what) {
            return std::to_string(module + offset) + "." + what;
        };
        MlpLayer<Scalar> layer;
        layer.weight = to_matrix<Scalar>(state[name(0, "weight")]);
        if (with_hidden_bias || module == 6) layer.bias = to_vector<Scalar>(state[name(0, "bias")]);
        if (module < 6) {
            layer.gamma = to_vector<Scalar>(state[name(1, "weight")]);
            layer.beta = to_vector<Scalar>(state[name(1, "bias")]);
        }
        if (state.contains(name(1, "running_mean")))
            network.running.push_back(
                {.mean = to_vector<Scalar>(state[name(1, "running_mean")]),
                 .variance = to_vector<Scalar>(state[name(1, "running_var")])});
        network.layers.push_back(layer);
    }
    return network;
}

/// The run repeated with our own code: the same start, the same batches.
template <typename Scalar>
struct GoldenRun {
    explicit GoldenRun(bool with_hidden_bias)
        : network(to_network<Scalar>(golden()["init"], with_hidden_bias)),
          inputs(to_matrix<Scalar>(golden()["X"]).transpose()),
          labels(golden()["y"].get<std::vector<std::uint8_t>>()),
          order(golden()["order"].get<std::vector<std::vector<std::uint32_t>>>()),
          workspace(network, static_cast<Eigen::Index>(order[0].size())),
          adam(network) {}

    /// Loads the next batch; goes through them again after the last one.
    void load() {
        const auto& batch = order[static_cast<std::size_t>(adam.n_steps) % order.size()];
        load_batch<Scalar>(inputs, labels, batch, workspace);
    }

    void learn() {
        backward(network, workspace);
        adam_step(workspace.gradient, adam, network);
    }

    double step() {
        load();
        const double loss = forward_train(network, workspace);
        learn();
        return loss;
    }

    MlpNetwork<Scalar> network;
    Matrix<Scalar> inputs;  // (feature, example)
    std::vector<std::uint8_t> labels;
    std::vector<std::vector<std::uint32_t>> order;  // (step, example)
    MlpWorkspace<Scalar> workspace;
    Adam<Scalar> adam;
};

/// Largest difference over the largest reference value.
template <typename A, typename B>
double relative_difference(const A& a, const B& reference) {
    return static_cast<double>((a - reference).cwiseAbs().maxCoeff()) /
           static_cast<double>(reference.cwiseAbs().maxCoeff());
}

}  // namespace specula
