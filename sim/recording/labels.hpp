#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/recording/manifest.hpp"

namespace specula {

/// Labels as a file gives them: for class, world, sample, session, view and frame, one text per
/// frame; what it does not give is not in the map.
using LabelColumns = std::map<std::string, std::vector<std::string>>;

/// Fills in classes and groups of a dataset whose frames are there, from its columns and from the
/// parts of the manifest.
///
/// Whole numbers are ids as they are; other words are numbered as they come. A sample's number that
/// occurs in two classes names two pieces: all are numbered anew. Without sessions, each recording
/// is one, or each view of a sample. A frame of no part and no column has the class "unlabelled".
/// @in  n_recordings  > 0, of equal length
/// Throws InputError for parts beyond the recording and classes that are not in class_names.
void apply_labels(const RecordingManifest& manifest, const LabelColumns& columns,
                  std::size_t n_recordings, Dataset& dataset);

}  // namespace specula
