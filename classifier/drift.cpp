#include "classifier/drift.hpp"

#include <algorithm>
#include <cmath>

#include "classifier/matrix.hpp"
#include "sim/core/expect.hpp"

namespace specula {

namespace {

void check(const TablePair& tables) {
    SPECULA_EXPECT(tables.familiar.n_features == tables.asked.n_features);
    SPECULA_EXPECT(tables.familiar.size() >= 2 && tables.asked.size() >= 2);
}

std::vector<double> column(const FeatureTable& table, std::size_t feature) {
    std::vector<double> values;
    for (std::size_t i = 0; i < table.size(); ++i)
        values.push_back(static_cast<double>(table.row(i)[feature]));
    return values;
}

/// Counts per bin; a value equal to an edge belongs below it.
std::vector<double> counts_between(const std::vector<double>& values,
                                   const std::vector<double>& edges) {
    std::vector<double> counts(edges.size() + 1, 0.5);
    for (const double value : values) {
        const auto place = std::lower_bound(edges.begin(), edges.end(), value) - edges.begin();
        counts[static_cast<std::size_t>(place)] += 1.0;
    }
    return counts;
}

struct Moments {
    double mean, sd;
};

Moments moments_of(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double sum = 0.0, squares = 0.0;
    for (const double value : values) sum += value;
    for (const double value : values) squares += (value - sum / n) * (value - sum / n);
    return {sum / n, std::sqrt(squares / n)};
}

/// (feature, row): rows spread evenly over the table, standardised.
Matrix<double> chosen_rows(const FeatureTable& table, const std::vector<Moments>& familiar,
                           std::size_t max_rows) {
    const std::size_t n = std::min(table.size(), max_rows);
    Matrix<double> rows(static_cast<Eigen::Index>(table.n_features), static_cast<Eigen::Index>(n));
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t f = 0; f < table.n_features; ++f) {
            const auto value = static_cast<double>(table.row(k * table.size() / n)[f]);
            const double sd = familiar[f].sd > 0.0 ? familiar[f].sd : 1.0;
            rows(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(k)) =
                (value - familiar[f].mean) / sd;
        }
    return rows;
}

/// (row of a, row of b)
Matrix<double> squared_distances(const Matrix<double>& a, const Matrix<double>& b) {
    Matrix<double> squared(a.cols(), b.cols());
    for (Eigen::Index j = 0; j < b.cols(); ++j)
        squared.col(j) = (a.colwise() - b.col(j)).colwise().squaredNorm().transpose();
    return squared;
}

double median_of_pairs(const Matrix<double>& squared) {
    std::vector<double> pairs;
    pairs.reserve(static_cast<std::size_t>(squared.size() / 2));
    for (Eigen::Index j = 1; j < squared.cols(); ++j)
        for (Eigen::Index i = 0; i < j; ++i) pairs.push_back(squared(i, j));
    const auto middle = pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 2);
    std::nth_element(pairs.begin(), middle, pairs.end());
    return *middle;
}

}  // namespace

std::vector<double> population_stability(const TablePair& tables) {
    check(tables);
    constexpr std::size_t n_bins = 10;
    std::vector<double> result;
    for (std::size_t f = 0; f < tables.familiar.n_features; ++f) {
        std::vector<double> familiar = column(tables.familiar, f);
        const std::vector<double> asked = column(tables.asked, f);
        std::ranges::sort(familiar);
        std::vector<double> edges;
        for (std::size_t b = 1; b < n_bins; ++b)
            edges.push_back(familiar[(b * familiar.size() + n_bins - 1) / n_bins - 1]);
        const std::vector<double> p = counts_between(familiar, edges);
        const std::vector<double> q = counts_between(asked, edges);
        double index = 0.0;
        for (std::size_t b = 0; b < n_bins; ++b) {
            const double share = p[b] / (static_cast<double>(familiar.size()) + 0.5 * n_bins);
            const double now = q[b] / (static_cast<double>(asked.size()) + 0.5 * n_bins);
            index += (now - share) * std::log(now / share);
        }
        result.push_back(index);
    }
    return result;
}

std::vector<double> mean_shift(const TablePair& tables) {
    check(tables);
    constexpr double finest_share = 1e-6;  // 16 roundings of a float, as fit_standardiser has it
    std::vector<double> result;
    for (std::size_t f = 0; f < tables.familiar.n_features; ++f) {
        const Moments familiar = moments_of(column(tables.familiar, f));
        const double away = std::abs(moments_of(column(tables.asked, f)).mean - familiar.mean);
        const double finest = std::max(finest_share * std::abs(familiar.mean), 1e-30);
        result.push_back(away == 0.0 ? 0.0 : away / std::max(familiar.sd, finest));
    }
    return result;
}

double mean_discrepancy(const TablePair& tables, const MmdOptions& options) {
    check(tables);
    SPECULA_EXPECT(options.max_rows >= 2);
    std::vector<Moments> familiar;
    for (std::size_t f = 0; f < tables.familiar.n_features; ++f)
        familiar.push_back(moments_of(column(tables.familiar, f)));
    const Matrix<double> x = chosen_rows(tables.familiar, familiar, options.max_rows);
    const Matrix<double> y = chosen_rows(tables.asked, familiar, options.max_rows);
    Matrix<double> all(x.rows(), x.cols() + y.cols());
    all << x, y;
    const Matrix<double> squared = squared_distances(all, all);
    const double median = median_of_pairs(squared);
    if (!(median > 0.0)) return 0.0;  // more than half of all pairs are the same row
    const Matrix<double> kernel = (squared.array() / (-2.0 * median)).exp();
    const auto m = static_cast<double>(x.cols()), n = static_cast<double>(y.cols());
    const double within_x = kernel.topLeftCorner(x.cols(), x.cols()).sum() - m;
    const double within_y = kernel.bottomRightCorner(y.cols(), y.cols()).sum() - n;
    const double between = kernel.topRightCorner(x.cols(), y.cols()).sum();
    return within_x / (m * (m - 1.0)) + within_y / (n * (n - 1.0)) - 2.0 * between / (m * n);
}

}  // namespace specula
