#pragma once

#include <optional>
#include <string>

#include "classifier/feature_table.hpp"
#include "classifier/model.hpp"
#include "firmware/fw_extract.h"
#include "sim/dataset/dataset.hpp"

namespace specula {

/// Which bins, windows or columns: count of them from the first.
struct BinChoice {
    int first = 0;
    int count = 0;
};

/// What numbers of a frame a classifier sees, and how they are made of it.
struct Descriptor {
    /// range_bins     the firmware's extractor: amplitudes of range bins of beat samples
    /// range_windows  of samples that are range themselves: their mean magnitude in equal windows
    /// columns        features that the recording brought
    std::string extractor = "range_bins";
    fw_extract_config bins{.first_bin = FW_DEFAULT_FIRST_BIN,
                           .n_bins = FW_DEFAULT_N_BINS,
                           .window = FW_WINDOW_BLACKMAN,
                           .integration = FW_INTEGRATE_MEAN,
                           .path = FW_RANGE_FLOAT};

    /// One line that read_descriptor takes back, e.g. "range_bins 6 12 blackman".
    std::string text() const;
};

/// What fits a dataset: range_bins 6 to 17 of beat samples (without window where the firmware has
/// none of that length), 12 range_windows, or all columns; `choice` overrules the bins.
/// Throws InputError for complex beat samples, which the firmware does not take, and for bins that
/// do not exist.
Descriptor descriptor_for(const Dataset& dataset, const std::optional<BinChoice>& choice = {});

/// The one a model was trained with: its provenance says it; without, that of a study.
/// Throws InputError where it says nonsense.
Descriptor descriptor_of(const Model& model);

/// One row per frame. Throws InputError where the frames cannot be described so.
FeatureTable describe(const Dataset& dataset, const Descriptor& descriptor, int threads);

}  // namespace specula
