#pragma once

#include <string>

#include "classifier/feature_table.hpp"
#include "sim/core/random.hpp"

namespace specula {

/// Classes as round clouds of unit spread: class c lies at `distance` along feature c.
struct Blobs {
    std::size_t n_rows = 300;
    std::uint32_t n_classes = 3;
    std::size_t n_features = 4;
    double distance = 6.0;
    std::uint32_t item = 0;  ///< another item, other draws of the same clouds
};

inline FeatureTable draw(const Blobs& blobs) {
    Stream stream({.seed = 11, .purpose = "blobs", .item = blobs.item});
    FeatureTable table;
    table.extractor = "blobs";
    table.n_features = blobs.n_features;
    for (std::uint32_t c = 0; c < blobs.n_classes; ++c)
        table.class_names.push_back("cloud " + std::to_string(c));
    for (std::size_t i = 0; i < blobs.n_rows; ++i) {
        const std::uint32_t label = stream.below(blobs.n_classes);
        for (std::size_t f = 0; f < blobs.n_features; ++f)
            table.features.push_back(
                static_cast<float>(stream.normal() + (f == label ? blobs.distance : 0.0)));
        table.label.push_back(static_cast<std::uint8_t>(label));
        table.world.push_back(static_cast<std::int32_t>(i % 2));
        table.session.push_back(static_cast<std::int32_t>(i % 5));
    }
    return table;
}

}  // namespace specula
