#include "classifier/looks.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "sim/core/error.hpp"
#include "sim/core/expect.hpp"
#include "sim/core/format.hpp"

namespace specula {

namespace {

/// Groups of `count` rows of one session and class, in the order of their last rows.
std::vector<std::vector<std::size_t>> groups_of(const FeatureTable& rows, std::size_t count) {
    std::vector<std::vector<std::size_t>> groups;
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::size_t>> open;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        std::vector<std::size_t>& group = open[{rows.world[i], rows.session[i]}];
        if (!group.empty() && rows.label[group.front()] != rows.label[i]) group.clear();
        group.push_back(i);
        if (group.size() < count) continue;
        groups.push_back(group);
        group.clear();
    }
    return groups;
}

void append_moments(const FeatureTable& rows, const std::vector<std::size_t>& group, bool spread,
                    std::vector<float>& features) {
    const auto n = static_cast<double>(group.size());
    std::vector<double> mean(rows.n_features), square(rows.n_features);
    for (const std::size_t i : group)
        for (std::size_t f = 0; f < rows.n_features; ++f)
            mean[f] += static_cast<double>(rows.row(i)[f]) / n;
    for (const std::size_t i : group)
        for (std::size_t f = 0; f < rows.n_features; ++f) {
            const double away = static_cast<double>(rows.row(i)[f]) - mean[f];
            square[f] += away * away / n;
        }
    for (const double value : mean) features.push_back(static_cast<float>(value));
    if (!spread) return;
    for (const double value : square) features.push_back(static_cast<float>(std::sqrt(value)));
}

}  // namespace

FeatureTable combine_looks(const FeatureTable& rows, const Looks& looks) {
    SPECULA_EXPECT(looks.count >= 2);
    const auto groups = groups_of(rows, looks.count);
    if (groups.empty())
        throw InputError(format("descriptor: looks {}: no session has that many frames; use fewer",
                                looks.count));
    FeatureTable table;
    table.extractor = rows.extractor;
    table.class_names = rows.class_names;
    table.n_features = rows.n_features * (looks.spread ? 2 : 1);
    for (const std::vector<std::size_t>& group : groups) {
        append_moments(rows, group, looks.spread, table.features);
        table.label.push_back(rows.label[group.front()]);
        table.world.push_back(rows.world[group.front()]);
        table.session.push_back(rows.session[group.front()]);
    }
    return table;
}

std::vector<std::size_t> first_rows(const FeatureTable& rows, const Looks& looks) {
    std::vector<std::size_t> first;
    for (const auto& group : groups_of(rows, looks.count)) first.push_back(group.front());
    return first;
}

}  // namespace specula
