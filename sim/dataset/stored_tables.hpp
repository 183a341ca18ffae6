#pragma once

#include <set>

#include "sim/dataset/dataset.hpp"

namespace specula {

/// Which of the tables that a file may lack it has.
struct StoredTables {
    bool adc = false;
    bool adc_quadrature = false;
    bool profile = false;
    bool features = false;
    bool probability = false;
    bool views = false;
    std::bitset<truth_columns.size()> unknown_truth;  ///< columns left out
};

StoredTables tables_of(const Dataset& dataset);

/// The tables that are not there, as the file says it: `/a,/b`.
std::string left_out(const StoredTables& tables);
StoredTables tables_without(const std::set<std::string>& left_out);
/// The names in a list parted by commas.
std::set<std::string> parted_names(const std::string& list);

}  // namespace specula
