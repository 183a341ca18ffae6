#include <algorithm>

#include "classifier/folded_model.hpp"
#include "classifier/integer_model.hpp"
#include "classifier/trained_model.hpp"
#include "firmware/fw_softmax.h"
#include "tests/check.hpp"
#include "tests/classifier/golden_run.hpp"

// What integers cost a trained network, on the reference run: labels there follow the inputs only
// loosely, so many of the 640 examples lie near a border.

namespace specula {
namespace {

/// The reference network after its 200 steps, seeing the inputs as they are.
Model trained_reference() {
    GoldenRun<double> run(false);
    for (std::size_t i = 0; i < run.order.size(); ++i) run.step();
    Model model = model_of(run.network);
    model.input_mean.assign(12, 0.0f);
    model.input_scale.assign(12, 1.0f);
    return model;
}

using Classes = std::vector<std::uint16_t>;

Classes classes_by(const auto& run) {
    Classes classes;
    for (const auto& row : golden()["X"]) {
        const auto input = row.template get<std::vector<float>>();
        std::vector<float> logits(5);
        REQUIRE(run(input.data(), logits.data()) == FW_OK);
        classes.push_back(fw_argmax(logits.data(), 5));
    }
    return classes;
}

std::size_t n_different(const Classes& a, const Classes& b) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) n += a[i] != b[i];
    return n;
}

double share_right(const Classes& classes) {
    const auto truth = golden()["y"].get<Classes>();
    return 1.0 - double(n_different(classes, truth)) / double(truth.size());
}

TEST_CASE("integers turn few answers of the reference network, and cost half a point at most",
          "[integer]") {
    const Model model = trained_reference();
    const FoldedModel folded = fold(model);
    const fw_mlp real = folded.view();
    std::vector<float> scratch(256);
    const Classes exact = classes_by([&](const float* in, float* logits) {
        return fw_mlp_run(&real, in, scratch.data(), 4 * scratch.size(), logits, nullptr);
    });
    // A plain restatement of the arithmetic gives 3 of 640 for weights in 8 bits alone, and 12 with
    // the values between layers in 8 bits too; in 16 bits, rounding is 256 times finer.
    const auto width = GENERATE(FW_INT16, FW_INT8);
    const IntegerModel integers = quantise(model, width);
    const fw_int_mlp whole = integers.view();
    std::vector<float> space(fw_int_mlp_scratch(&whole) / sizeof(float) + 1);
    const Classes rounded = classes_by([&](const float* in, float* logits) {
        return fw_int_mlp_run(&whole, in, space.data(), 4 * space.size(), logits, nullptr);
    });
    CAPTURE(n_different(exact, rounded));
    CHECK(n_different(exact, rounded) <= (width == FW_INT16 ? 1u : 16u));
    CHECK(share_right(rounded) > share_right(exact) - 0.005);
}

}  // namespace
}  // namespace specula
