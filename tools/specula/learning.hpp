#pragma once

#include "classifier/descriptor.hpp"
#include "tools/specula/commands.hpp"

namespace specula {

/// The options of a training, with the choices that the command line holds as words.
TrainOptions training_options(const Learning& learning);

/// What frames are described by: --descriptor, or what fits them with --bins.
Descriptor chosen_descriptor(const Learning& learning, const Dataset& dataset);

/// describe, with a progress line where there are frames enough to wait for.
FeatureTable described(const Dataset& dataset, const Descriptor& descriptor, int threads);

/// (row): the first of the frames that make it.
std::vector<std::size_t> first_frames(const Dataset& dataset, const Descriptor& descriptor);

/// read_dataset, which says so where the file is a model.
Dataset dataset_from(const std::filesystem::path& file);

/// Counts the dataset's classes as the model does: classes are the same by their names, in whatever
/// order and however few of them. Throws InputError with both lists where a frame is of a class
/// that the model does not know.
/// @in  file  of the model
void count_classes_as(const Model& model, const std::string& file, Dataset& dataset);

/// Throws InputError where an option was given that changes nothing without another.
/// @in  given    names of options
/// @in  holdout  TrainArguments::holdout
void expect_heeded(const std::vector<std::string>& given, const Learning& learning,
                   const std::string& holdout);

/// Names of the columns that a descriptor takes; none where it makes its numbers itself.
std::vector<std::string> feature_names_of(const Dataset& dataset, const Descriptor& descriptor);

/// Throws InputError where the frames' radar is known to be another than the model's.
void expect_measured_for(const Model& model, const Dataset& dataset, const Catalogue& catalogue);

/// Rows as a model wants them. Throws InputError where its features are others, or have other names
/// or another order, or are not finite.
FeatureTable rows_for(const Model& model, const Dataset& dataset, int threads);

}  // namespace specula
