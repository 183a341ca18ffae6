#include "classifier/training_rows.hpp"

#include <algorithm>
#include <cmath>

#include "classifier/standardiser.hpp"
#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

void check_finite(const FeatureTable& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t f = 0; f < rows.n_features; ++f)
            if (!std::isfinite(rows.row(i)[f]))
                throw InputError(
                    format("features: number {} of example {} is {}; remove the example, or look "
                           "at the recording",
                           f, i, rows.row(i)[f]));
}

void check_training_rows(const FeatureTable& rows) {
    if (rows.size() < 2)
        throw InputError(format("training set: has {} rows; at least 2 are needed", rows.size()));
    SPECULA_EXPECT(rows.n_features > 0 && rows.features.size() == rows.size() * rows.n_features);
    SPECULA_EXPECT(*std::ranges::max_element(rows.label) < rows.class_names.size());
    check_finite(rows);
    const auto is_first = [&](std::uint8_t label) { return label == rows.label.front(); };
    if (std::ranges::all_of(rows.label, is_first))
        throw InputError(
            format("training set: all rows are of class \"{}\"; give examples of two or more "
                   "classes",
                   rows.class_names[rows.label.front()]));
    const Standardiser standardiser = fit_standardiser(rows);
    if (std::ranges::all_of(standardiser.scale, [](float scale) { return scale == 0.0f; }))
        throw InputError(
            "features: every one has the same value in all rows; choose other bins, or look at "
            "the recording");
}

}  // namespace specula
