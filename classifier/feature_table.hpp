#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace specula {

/// Examples to learn from or to judge: what the firmware's extractor made of frames, and their
/// truth. All vectors over examples have the same length.
struct FeatureTable {
    std::string extractor;  ///< name of the firmware's extractor
    std::size_t n_features = 0;
    std::vector<float> features;           ///< (example, feature), row-major, finite
    std::vector<std::uint8_t> label;       ///< (example), index into class_names
    std::vector<std::int32_t> world;       ///< (example)
    std::vector<std::int32_t> session;     ///< (example)
    std::vector<std::string> class_names;  ///< (class)

    std::size_t size() const { return label.size(); }
    std::span<const float> row(std::size_t i) const {
        return std::span(features).subspan(i * n_features, n_features);
    }
};

/// The rows named, in that order; a row may be named twice.
/// @in  indices  each < table.size()
FeatureTable select_rows(const FeatureTable& table, std::span<const std::size_t> indices);

/// The rows i for which keep(i), in their order.
template <typename Predicate>
FeatureTable select_rows_where(const FeatureTable& table, Predicate keep) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < table.size(); ++i)
        if (keep(i)) indices.push_back(i);
    return select_rows(table, indices);
}

}  // namespace specula
