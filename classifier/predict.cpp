#include "classifier/predict.hpp"

#include "firmware/fw_softmax.h"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

Predictions predict(const FoldedModel& model, const FeatureTable& rows) {
    const fw_mlp mlp = model.view();
    const std::size_t n_classes = model.n_classes();
    SPECULA_EXPECT(rows.n_features == model.n_features());
    SPECULA_EXPECT(n_classes <= 256);
    const std::size_t scratch_bytes = fw_mlp_scratch(&mlp);
    SPECULA_EXPECT(scratch_bytes > 0);
    std::vector<float> scratch((scratch_bytes + sizeof(float) - 1) / sizeof(float));
    std::vector<float> probabilities(n_classes);
    Predictions result{.n_classes = n_classes,
                       .label = std::vector<std::uint8_t>(rows.size()),
                       .probability = std::vector<float>(rows.size()),
                       .logits = std::vector<float>(rows.size() * n_classes)};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        float* const logits = result.logits.data() + i * n_classes;
        const fw_status status = fw_mlp_run(&mlp, rows.row(i).data(), scratch.data(), scratch_bytes,
                                            logits, probabilities.data());
        if (status == FW_ERR_NONFINITE)
            throw InputError(
                format("features of example {}: not finite, or too large for the "
                       "classifier; look at the recording",
                       i));
        SPECULA_EXPECT(status == FW_OK);
        const std::uint16_t best = fw_argmax(logits, static_cast<std::uint16_t>(n_classes));
        result.label[i] = static_cast<std::uint8_t>(best);
        result.probability[i] = probabilities[best];
    }
    return result;
}

}  // namespace specula
