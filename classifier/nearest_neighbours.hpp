#pragma once

#include "classifier/feature_table.hpp"
#include "classifier/matrix.hpp"
#include "classifier/predict.hpp"
#include "classifier/standardiser.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// A baseline that learns nothing: the classes of the nearest training rows, by Euclidean distance
/// of standardised features.
class NearestNeighbours {
  public:
    /// @in  rows  as `train` takes them
    /// @in  k     neighbours that vote, 1 to rows.size()
    NearestNeighbours(const FeatureTable& rows, int k = 5);

    /// The class of most of the k votes; of equals, that of the nearest neighbour. The probability
    /// is the share of votes, one more vote being spread over the classes, and logits are its
    /// logarithm: never minus infinity.
    Predictions predict(const FeatureTable& rows) const;

  private:
    Standardiser standardiser_;
    Matrix<float> inputs_;  // (feature, training row)
    std::vector<std::uint8_t> label_;
    std::size_t n_classes_;
    std::size_t k_;
};

/// A few points that stand for training rows; cheap enough for the chip.
struct Prototypes {
    Standardiser standardiser;
    Matrix<float> centre;  ///< (feature, prototype), standardised
};

struct PrototypeOptions {
    int per_class = 4;  ///< >= 1; a class of fewer rows gets one each
    int rounds = 20;    ///< of moving centres to the means of their rows
    int starts = 4;     ///< of which the one with the nearest centres is kept
};

/// k-means of each class (Lloyd's rounds from centres spread as k-means++ has it).
/// @eq  Arthur and Vassilvitskii 2007, SODA, section 2.2
Prototypes fit_prototypes(const FeatureTable& rows, const PrototypeOptions& options,
                          const StreamKey& key);

/// The same as a model keeps it, and back, bit for bit.
InputPrototypes kept(const Prototypes& prototypes);
Prototypes prototypes_of(const InputPrototypes& kept);

/// Distance of each row from its nearest prototype, in standard deviations.
std::vector<double> prototype_distances(const Prototypes& prototypes, const FeatureTable& rows);

}  // namespace specula
