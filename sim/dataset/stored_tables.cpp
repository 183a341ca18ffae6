#include "sim/dataset/stored_tables.hpp"

#include <algorithm>
#include <array>

namespace specula {

namespace {

struct Optional {
    const char* table;
    bool StoredTables::*stored;
};
constexpr std::array<Optional, 6> optional_tables{{
    {"/adc", &StoredTables::adc},
    {"/adc_quadrature", &StoredTables::adc_quadrature},
    {"/profile", &StoredTables::profile},
    {"/features", &StoredTables::features},
    {"/probability", &StoredTables::probability},
    {"/group/view", &StoredTables::views},
}};

std::string truth_table(std::size_t i) {
    return std::string("/truth/") + truth_columns[i].name;
}

}  // namespace

StoredTables tables_of(const Dataset& dataset) {
    return {.adc = !dataset.adc.empty(),
            .adc_quadrature = !dataset.adc_quadrature.empty(),
            .profile = !dataset.profile.empty(),
            .features = !dataset.features.empty(),
            .probability = !dataset.probability.empty(),
            .views = dataset.has_views,
            .unknown_truth = dataset.unknown_truth};
}

std::string left_out(const StoredTables& tables) {
    std::string list;
    const auto leave_out = [&list](const std::string& table) {
        list += (list.empty() ? "" : ",") + table;
    };
    for (const Optional& optional : optional_tables)
        if (!(tables.*optional.stored)) leave_out(optional.table);
    for (std::size_t i = 0; i < truth_columns.size(); ++i)
        if (tables.unknown_truth[i]) leave_out(truth_table(i));
    return list;
}

StoredTables tables_without(const std::set<std::string>& left_out) {
    StoredTables tables;
    for (const Optional& optional : optional_tables)
        tables.*optional.stored = !left_out.contains(optional.table);
    for (std::size_t i = 0; i < truth_columns.size(); ++i)
        tables.unknown_truth[i] = left_out.contains(truth_table(i));
    return tables;
}

std::set<std::string> parted_names(const std::string& list) {
    std::set<std::string> names;
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        names.insert(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

}  // namespace specula
