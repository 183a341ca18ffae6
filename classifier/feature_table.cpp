#include "classifier/feature_table.hpp"

#include "sim/core/expect.hpp"

namespace specula {

FeatureTable select_rows(const FeatureTable& table, std::span<const std::size_t> indices) {
    FeatureTable selected;
    selected.extractor = table.extractor;
    selected.n_features = table.n_features;
    selected.class_names = table.class_names;
    selected.features.reserve(indices.size() * table.n_features);
    selected.label.reserve(indices.size());
    selected.world.reserve(indices.size());
    selected.session.reserve(indices.size());
    for (const std::size_t i : indices) {
        SPECULA_EXPECT(i < table.size());
        const std::span<const float> row = table.row(i);
        selected.features.insert(selected.features.end(), row.begin(), row.end());
        selected.label.push_back(table.label[i]);
        selected.world.push_back(table.world[i]);
        selected.session.push_back(table.session[i]);
    }
    return selected;
}

}  // namespace specula
