#include "classifier/mlp_network.ipp"

namespace specula {

template struct MlpWorkspace<double>;
template MlpNetwork<double> initial_network(const std::vector<int>&, Stream&);
template MlpNetwork<double> initial_network(const NetworkShape&, Stream&);
template void load_batch(const Matrix<double>&, std::span<const std::uint8_t>,
                         std::span<const std::uint32_t>, MlpWorkspace<double>&);
template void load_mixed_batch(const Matrix<double>&, std::span<const std::uint8_t>,
                               const MixedRows&, MlpWorkspace<double>&);
template double forward_train(MlpNetwork<double>&, MlpWorkspace<double>&);
template void backward(const MlpNetwork<double>&, MlpWorkspace<double>&);
template Matrix<double> eval_logits(const MlpNetwork<double>&, const Matrix<double>&);

}  // namespace specula
