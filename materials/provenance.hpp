#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/document.hpp"

namespace specula {

/// Where a number comes from, from the firmest to the softest.
enum class Evidence { recommendation, literature, estimate };
std::string_view evidence_name(Evidence evidence);

struct FrequencyBand {
    double min_hz = 0.0;
    double max_hz = std::numeric_limits<double>::infinity();

    bool holds(const FrequencyBand& other) const {
        return min_hz <= other.min_hz && other.max_hz <= max_hz;
    }
    std::string text() const;  ///< "57 to 64 GHz"

    /// Keys: valid_ghz = [min, max].
    static FrequencyBand read(Section& section);
};

/// A number of a material file that has another origin, or holds in another band, than the rest.
struct NumberOrigin {
    std::string key;  ///< as the file calls it
    std::string source;
    Evidence evidence = Evidence::estimate;
    FrequencyBand valid;
};

/// Keys of each [[number]]: key, source, evidence ("estimate" where nothing is said), and valid_ghz
/// where its band is not that of the file.
std::vector<NumberOrigin> read_number_origins(Section& file, const FrequencyBand& of_file);

/// Key: evidence. Whoever does not say where a number comes from is estimating.
Evidence read_evidence(Section& section);

}  // namespace specula
