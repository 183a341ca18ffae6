#include "classifier/train_options.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/fw_mlp.h"
#include "sim/core/error.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

constexpr int max_units = 1024;
constexpr int max_channels = 64;

std::string listed(const std::vector<int>& numbers) {
    std::string text = "[";
    for (const int number : numbers) text += format("{}{}", text.size() > 1 ? ", " : "", number);
    return text + "]";
}

void check_layers(const TrainOptions& options) {
    const auto is_width = [](int units) { return units >= 1 && units <= max_units; };
    if (options.hidden.size() + 1 > FW_MLP_MAX_LAYERS)
        throw InputError(format("hidden = {}: too many layers; the firmware runs at most {}",
                                listed(options.hidden), FW_MLP_MAX_LAYERS - 1));
    if (!std::ranges::all_of(options.hidden, is_width))
        throw InputError(format("hidden = {}: a layer is out of range; use 1 to {} units",
                                listed(options.hidden), max_units));
}

void check_convolution(const TrainOptions& options, std::size_t n_features) {
    if (options.convolution.empty()) return;
    const auto is_width = [](int channels) { return channels >= 1 && channels <= max_channels; };
    const std::string value = listed(options.convolution);
    if (options.convolution.size() + options.hidden.size() + 1 > FW_MLP_MAX_LAYERS)
        throw InputError(
            format("convolution = {}: too many layers with the {} hidden ones; the firmware runs "
                   "at most {} together",
                   value, options.hidden.size(), FW_MLP_MAX_LAYERS - 1));
    if (!std::ranges::all_of(options.convolution, is_width))
        throw InputError(format("convolution = {}: a layer is out of range; use 1 to {} channels",
                                value, max_channels));
    if (options.kernel < 1 || options.kernel % 2 == 0 ||
        static_cast<std::size_t>(options.kernel) > n_features)
        throw InputError(format("kernel = {}: is even or wider than the {} features; use 3",
                                options.kernel, n_features));
}

void check_share(const char* what, double value, const char* remedy) {
    if (value >= 0.0 && value < 1.0) return;
    throw InputError(format("{} = {}: is not within 0 and 1; {}", what, value, remedy));
}

void check_regularisers(const TrainOptions& options) {
    if (!(options.weight_decay >= 0.0 && options.weight_decay <= 1.0))
        throw InputError(format("weight_decay = {}: is not within 0 and 1; use about 0.01",
                                options.weight_decay));
    check_share("label_smoothing", options.label_smoothing, "use about 0.1");
    if (options.mixup != 0.0 && !(options.mixup >= 0.05 && options.mixup <= 1.0))
        throw InputError(format("mixup = {}: is out of range; use 0, or 0.05 to 1", options.mixup));
    if (options.patience < 0)
        throw InputError(
            format("patience = {}: is negative; use 0 for a fixed number of epochs, or about 10",
                   options.patience));
    check_share("held_out", options.held_out, "use about 0.2");
    if (options.patience > 0 && options.held_out == 0.0)
        throw InputError("held_out = 0: nothing to be patient about; use about 0.2");
}

}  // namespace

std::string optimiser_name(const TrainOptions& options) {
    return options.weight_decay > 0.0 ? "adamw" : "adam";
}

void check_options(const TrainOptions& options, std::size_t n_features) {
    check_layers(options);
    check_convolution(options, n_features);
    if (options.epochs < 1)
        throw InputError(format("epochs = {}: too few; use 1 or more", options.epochs));
    if (options.batch_size < 2)
        throw InputError(format("batch_size = {}: too small; use 2 or more", options.batch_size));
    if (!(options.learning_rate > 0.0 && std::isfinite(options.learning_rate)))
        throw InputError(format("learning_rate = {}: is not a positive number; use about 0.001",
                                options.learning_rate));
    check_regularisers(options);
}

std::vector<std::pair<std::string, std::string>> option_list(const TrainOptions& options) {
    std::vector<std::pair<std::string, std::string>> list;
    const auto add = [&list](const char* what, const std::string& value) {
        list.emplace_back(what, value);
    };
    if (!options.convolution.empty())
        add("convolution", format("{} of {}", listed(options.convolution), options.kernel));
    add("hidden", listed(options.hidden));
    add("epochs", format("{}", options.epochs));
    add("batch size", format("{}", options.batch_size));
    add("optimiser", optimiser_name(options));
    add("learning rate", format("{}", options.learning_rate));
    add("schedule", schedule_names()[static_cast<std::size_t>(options.schedule)]);
    if (options.weight_decay > 0.0) add("weight decay", format("{}", options.weight_decay));
    if (options.label_smoothing > 0.0)
        add("label smoothing", format("{}", options.label_smoothing));
    if (options.mixup > 0.0) add("mixup", format("{}", options.mixup));
    if (options.patience > 0) {
        add("patience", format("{}", options.patience));
        add("held-out share of sessions", format("{}", options.held_out));
    }
    add("precision", options.precision == Precision::float64 ? "float64" : "float32");
    return list;
}

}  // namespace specula
