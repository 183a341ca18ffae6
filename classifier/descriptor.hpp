#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "classifier/feature_table.hpp"
#include "classifier/model.hpp"
#include "firmware/fw_extract.h"
#include "firmware/fw_normalise.h"
#include "sim/dataset/dataset.hpp"

namespace specula {

/// Which bins, windows or columns: count of them from the first.
struct BinChoice {
    int first = 0;
    int count = 0;
};

/// What numbers of a frame a classifier sees, and how they are made of it.
struct Descriptor {
    /// range_bins        the firmware's extractor: amplitudes of range bins of beat samples
    /// relative_profile  complex range bins around the peak, relative to it (relative_profile.hpp)
    /// peak_shape        the same as the firmware computes it, by fw_relative (peak_shape.hpp)
    /// range_windows     of samples that are range themselves: their mean magnitude in equal
    /// windows columns           features that the recording brought
    std::string extractor = "range_bins";
    fw_extract_config bins{.first_bin = FW_DEFAULT_FIRST_BIN,
                           .n_bins = FW_DEFAULT_N_BINS,
                           .window = FW_WINDOW_BLACKMAN,
                           .integration = FW_INTEGRATE_MEAN,
                           .path = FW_RANGE_FLOAT};
    fw_normalise_config normalise{};  ///< of range_bins, by fw_normalise; target_bin of both
    BinChoice search{};               ///< bins in which the peak is looked for; count 0: `bins`
    bool unit_energy = false;         ///< range_bins over the root of their sum of squares
    int angle_rx = 0;     ///< receivers whose phases at the peak are added (angle_cue); 0: none
    int looks = 1;        ///< consecutive frames of a session that make one row (looks.hpp)
    bool spread = false;  ///< with looks, also the standard deviations over them

    /// One line that parse_descriptor takes back: "range_bins 6 12 blackman", then what is on of
    ///
    ///   single, exported  integration; hwa: the accelerator's arithmetic (fw_extract.h)
    ///   align BIN         the peak is shifted to that bin
    ///   range BIN         amplitude times peak / BIN
    ///   log FLOOR         natural logarithm of at least FLOOR (LSB)
    ///   search FIRST N    where the peak is looked for
    ///   unit              unit energy
    ///   angle RX          phases of RX receivers
    ///   looks N [spread]  N frames a row
    std::string text() const;

    /// Numbers of a row.
    std::size_t n_features() const;
    bool uses_peak() const {
        return normalise.align || normalise.compensate_range || angle_rx > 0 || is_relative();
    }
    bool is_relative() const {
        return extractor == "relative_profile" || extractor == "peak_shape";
    }
    /// The bins that a peak is looked for in, or those of the descriptor.
    BinChoice profile() const {
        return uses_peak() && search.count > 0 ? search : BinChoice{bins.first_bin, bins.n_bins};
    }
};

/// Reads a descriptor's line. Throws InputError `descriptor = "...": problem; remedy`.
Descriptor parse_descriptor(const std::string& text);

/// What fits a dataset: range_bins 6 to 17 of beat samples (without window where the firmware has
/// none of that length), 12 range_windows, or all columns; `choice` overrules the bins.
/// Throws InputError for complex beat samples, which the firmware does not take, and for bins that
/// do not exist.
Descriptor descriptor_for(const Dataset& dataset, const std::optional<BinChoice>& choice = {});

/// The one a model was trained with: its provenance says it; without, that of a study.
/// Throws InputError where it says nonsense.
Descriptor descriptor_of(const Model& model);

/// One row per frame, or per `looks` of them. Throws InputError where the frames cannot be
/// described so.
/// @in  frames_done  counted up, if given
FeatureTable describe(const Dataset& dataset, const Descriptor& descriptor, int threads,
                      std::atomic<std::size_t>* frames_done = nullptr);

}  // namespace specula
