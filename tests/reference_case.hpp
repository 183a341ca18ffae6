#pragma once

#include <complex>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace specula {

/// One file of tests/reference by its id, e.g. "M03_slab": numbers made without any code of this
/// project. `points` holds objects {inp, expect}; SI units, complex numbers as [re, im].
inline nlohmann::json reference_case(const std::string& id) {
    const std::string file = std::string(SPECULA_SOURCE_DIR) + "/tests/reference/" + id + ".json";
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": no such reference case");
    return nlohmann::json::parse(in);
}

/// A number that is either real or [re, im].
inline std::complex<double> complex_of(const nlohmann::json& number) {
    if (number.is_number()) return number.get<double>();
    return {number.at(0).get<double>(), number.at(1).get<double>()};
}

}  // namespace specula
