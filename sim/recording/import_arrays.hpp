#pragma once

#include "sim/recording/axis_order.hpp"
#include "sim/recording/labels.hpp"
#include "sim/recording/npy_array.hpp"
#include "sim/recording/zip_archive.hpp"

namespace specula {

/// Whole numbers of an array -> ADC codes; complex ones in-phase and quadrature in turn.
/// @in  wrapped  whether 32768 to 65535 stand for negative codes
/// Throws InputError with the byte of a value that is no code.
std::vector<std::int16_t> codes_of(const NpyArray& array, bool wrapped);

/// Names and lengths of an array's axes, the slowest first; "iq" is added to a complex array's. By
/// default (frame, chirp, rx, sample), with iq behind where there are five.
AxisOrder order_of(const NpyArray& array, const RecordingManifest& manifest);

/// Whether an array is a feature table: two axes, and no axis of codes is named.
bool is_feature_table(const NpyArray& array, const RecordingManifest& manifest);

/// (frame, feature), row-major. Throws InputError with the byte of a value that is not finite.
void take_features(const NpyArray& array, Dataset& dataset);

/// The label members that the manifest names, one text per frame.
/// Throws InputError where one has neither one element per frame nor one per recording.
LabelColumns label_members(const ZipArchive& archive, const RecordingManifest& manifest,
                           std::size_t n_frames, std::size_t n_recordings);

}  // namespace specula
