#include "classifier/mlp_network.ipp"

namespace specula {

template struct MlpWorkspace<float>;
template MlpNetwork<float> initial_network(const std::vector<int>&, Stream&);
template MlpNetwork<float> initial_network(const NetworkShape&, Stream&);
template void load_batch(const Matrix<float>&, std::span<const std::uint8_t>,
                         std::span<const std::uint32_t>, MlpWorkspace<float>&);
template void load_mixed_batch(const Matrix<float>&, std::span<const std::uint8_t>,
                               const MixedRows&, MlpWorkspace<float>&);
template double forward_train(MlpNetwork<float>&, MlpWorkspace<float>&);
template void backward(const MlpNetwork<float>&, MlpWorkspace<float>&);
template Matrix<float> eval_logits(const MlpNetwork<float>&, const Matrix<float>&);

}  // namespace specula
